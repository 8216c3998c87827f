#include "core/world/map_file.hpp"

#include <algorithm>
#include <array>

#include "core/base/file.hpp"
#include "core/world/formats/ascii_map.hpp"
#include "core/world/formats/esri_grid.hpp"
#include "core/world/formats/image_map.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/formats/npy_map.hpp"
#include "core/world/formats/ros_map.hpp"
#include "core/world/formats/sbpl_cfg.hpp"
#include "core/world/formats/voxel_map.hpp"

namespace replan {
namespace {

Result<MapFile> alone(Result<GridMap> map) {
  if (!map) return Error{map.error()};
  return MapFile{std::move(map.value())};
}

Result<MapFile> read_picture(const std::string& path, const MapReading& reading) {
  if (reading.heights) return read_height_picture(path, *reading.heights, reading.image.invert);
  return alone(read_image_map(path, reading.image));
}
Result<void> write_picture(const MapFile& file, const std::string& path) {
  return write_image_map(file.map, path);
}
Result<MapFile> read_ros(const std::string& path, const MapReading& reading) {
  return read_ros_map(path, reading.unknown);
}
Result<MapFile> read_numbers(const std::string& path, const MapReading& reading) {
  return read_ascii_map(path, reading.occupied);
}
Result<void> write_ascii(const MapFile& file, const std::string& path) {
  return write_file_atomically(path, ascii_text(file));
}
Result<MapFile> read_array(const std::string& path, const MapReading& reading) {
  return read_npy_map(path, reading.occupied);
}
Result<MapFile> read_sbpl(const std::string& path, const MapReading&) {
  return read_sbpl_cfg(path);
}
Result<MapFile> read_letters(const std::string& path, const MapReading&) {
  return alone(read_movingai_map(path));
}
Result<void> write_letters(const MapFile& file, const std::string& path) {
  return write_movingai_map(file.map, path);
}
Result<MapFile> read_heights(const std::string& path, const MapReading& reading) {
  return read_esri_grid(path, reading.heights.value_or(HeightReading{}));
}
Result<MapFile> read_voxels(const std::string& path, const MapReading&) {
  return alone(read_voxel_map(path));
}
Result<void> write_voxels(const MapFile& file, const std::string& path) {
  return write_voxel_map(file.map, path);
}

constexpr MapFormat picture(std::string_view extension, bool writes) {
  return {.extension = extension,
          .name = "picture",
          .read = read_picture,
          .write = writes ? write_picture : nullptr,
          .picture = true,
          .heights = true};
}
constexpr MapFormat ros(std::string_view extension) {
  return {.extension = extension,
          .name = "ROS map",
          .read = read_ros,
          .write = write_ros_map,
          .unknown = true,
          .resolution = true,
          .unmapped = true};
}

// Listed to users in this order.
constexpr std::array kFormats = {
    MapFormat{.extension = ".map", .name = "MovingAI map", .read = read_letters, .write = write_letters},
    ros(".yaml"),
    ros(".yml"),
    MapFormat{.extension = ".cfg",
              .name = "SBPL environment",
              .read = read_sbpl,
              .write = write_sbpl_cfg,
              .ends = true},
    MapFormat{.extension = ".txt",
              .name = "text map",
              .read = read_numbers,
              .write = write_ascii,
              .numbers = true,
              .unmapped = true,
              .ends = true},
    MapFormat{.extension = ".csv", .name = "text map", .read = read_numbers, .numbers = true},
    MapFormat{.extension = ".npy", .name = "numpy array", .read = read_array, .numbers = true},
    MapFormat{.extension = ".3dmap",
              .name = "voxel map",
              .read = read_voxels,
              .write = write_voxels,
              .solid = true},
    MapFormat{.extension = ".asc", .name = "grid of heights", .read = read_heights, .heights = true},
    picture(".png", true),
    picture(".bmp", true),
    picture(".tga", true),
    picture(".pgm", true),
    picture(".ppm", false),
    picture(".pbm", false),
    picture(".pnm", false),
    picture(".gif", false),
    picture(".jpg", false),
    picture(".jpeg", false),
};

}  // namespace

std::span<const MapFormat> map_formats() {
  return kFormats;
}

const MapFormat* find_map_format(std::string_view path) {
  const std::string extension = file_extension(path);
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const MapFormat& format) { return format.extension == extension; });
  return found == kFormats.end() ? nullptr : &*found;
}

std::string map_extensions(MapUse use) {
  std::string list, last;
  for (const MapFormat& format : kFormats) {
    if (use == MapUse::write && format.write == nullptr) continue;
    if (!last.empty()) list += (list.empty() ? "" : ", ") + last;
    last = format.extension;
  }
  return list + " or " + last;
}

Result<void> check_reading(const std::string& path, const MapReading& reading) {
  const MapFormat* format = find_map_format(path);
  if (format == nullptr) return {};
  const bool image = reading.image != ImageMapOptions{};
  if (image && !format->picture)
    return Error{"threshold and inversion are for pictures; '" + path + "' is none"};
  if (reading.heights && !format->heights)
    return Error{"heights and layers are for a grid of heights (.asc) or a picture; '" + path + "' is none"};
  if (reading.heights && reading.image.threshold != ImageMapOptions{}.threshold)
    return Error{"a picture that is read as heights has no threshold: '" + path + "'"};
  if (reading.unknown != UnknownCells::blocked && !format->unknown)
    return Error{"only a ROS map (.yaml) has unknown cells; '" + path + "' is none"};
  if (reading.occupied && !format->numbers)
    return Error{"only in a file of numbers (.txt, .csv, .npy) is one of them the obstacle; '" + path +
                 "' is none"};
  return {};
}

Result<MapFile> read_map_file(const std::string& path, const MapReading& reading) {
  const MapFormat* format = find_map_format(path);
  if (format == nullptr)
    return Error{"cannot read '" + path + "' as a map: its name must end in " + map_extensions(MapUse::read)};
  if (Result<void> checked = check_reading(path, reading); !checked) return Error{checked.error()};
  return format->read(path, reading);
}

Result<GridMap> read_map(const std::string& path, const MapReading& reading) {
  Result<MapFile> file = read_map_file(path, reading);
  if (!file) return Error{file.error()};
  return std::move(file->map);
}

Result<void> write_map_file(const MapFile& file, const std::string& path) {
  const MapFormat* format = find_map_format(path);
  if (format == nullptr || format->write == nullptr)
    return Error{"cannot write a map to '" + path + "': its name must end in " +
                 map_extensions(MapUse::write)};
  if (file.map.depth > 1 && !format->solid)
    return Error{"'" + path + "' would hold one layer, and the map has " + std::to_string(file.map.depth) +
                 ": choose one of them, or a .3dmap"};
  return format->write(file, path);
}

Result<void> write_map(const GridMap& map, const std::string& path) {
  return write_map_file({map}, path);
}

}  // namespace replan
