#include "core/world/map_file.hpp"

#include <algorithm>
#include <array>

#include "core/base/file.hpp"
#include "core/world/ascii_map.hpp"
#include "core/world/image_map.hpp"
#include "core/world/movingai.hpp"
#include "core/world/npy_map.hpp"
#include "core/world/ros_map.hpp"
#include "core/world/sbpl_cfg.hpp"

namespace replan {
namespace {

constexpr std::array kFormats = {
    MapFormat{.extension = ".map", .name = "MovingAI map"},
    MapFormat{.extension = ".yaml", .name = "ROS map", .unknown = true, .resolution = true, .unmapped = true},
    MapFormat{.extension = ".yml", .name = "ROS map", .unknown = true, .resolution = true, .unmapped = true},
    MapFormat{.extension = ".cfg", .name = "SBPL environment", .ends = true},
    MapFormat{.extension = ".txt", .name = "text map", .numbers = true, .unmapped = true, .ends = true},
    MapFormat{.extension = ".csv", .name = "text map", .writes = false, .numbers = true},
    MapFormat{.extension = ".npy", .name = "numpy array", .writes = false, .numbers = true},
    MapFormat{.extension = ".png", .name = "picture", .picture = true},
    MapFormat{.extension = ".bmp", .name = "picture", .picture = true},
    MapFormat{.extension = ".tga", .name = "picture", .picture = true},
    MapFormat{.extension = ".pgm", .name = "picture", .picture = true},
    MapFormat{.extension = ".ppm", .name = "picture", .writes = false, .picture = true},
    MapFormat{.extension = ".pbm", .name = "picture", .writes = false, .picture = true},
    MapFormat{.extension = ".pnm", .name = "picture", .writes = false, .picture = true},
    MapFormat{.extension = ".gif", .name = "picture", .writes = false, .picture = true},
    MapFormat{.extension = ".jpg", .name = "picture", .writes = false, .picture = true},
    MapFormat{.extension = ".jpeg", .name = "picture", .writes = false, .picture = true},
};

Result<MapFile> alone(Result<GridMap> map) {
  if (!map) return Error{map.error()};
  return MapFile{std::move(map.value())};
}

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

std::string map_extensions(bool written) {
  std::string list, last;
  for (const MapFormat& format : kFormats) {
    if (written && !format.writes) continue;
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
    return Error{"cannot read '" + path + "' as a map: its name must end in " + map_extensions(false)};
  if (Result<void> checked = check_reading(path, reading); !checked) return Error{checked.error()};
  if (format->picture) return alone(read_image_map(path, reading.image));
  if (format->unknown) return read_ros_map(path, reading.unknown);
  if (format->extension == ".cfg") return read_sbpl_cfg(path);
  if (format->extension == ".npy") return read_npy_map(path, reading.occupied);
  if (format->numbers) return read_ascii_map(path, reading.occupied);
  return alone(read_movingai_map(path));
}

Result<GridMap> read_map(const std::string& path, const MapReading& reading) {
  Result<MapFile> file = read_map_file(path, reading);
  if (!file) return Error{file.error()};
  return std::move(file->map);
}

Result<void> write_map_file(const MapFile& file, const std::string& path) {
  const MapFormat* format = find_map_format(path);
  if (format == nullptr || !format->writes)
    return Error{"cannot write a map to '" + path + "': its name must end in " + map_extensions(true)};
  if (format->picture) return write_image_map(file.map, path);
  if (format->unknown) return write_ros_map(file, path);
  if (format->extension == ".cfg") return write_sbpl_cfg(file, path);
  if (format->extension == ".txt") return write_file_atomically(path, ascii_text(file));
  return write_movingai_map(file.map, path);
}

Result<void> write_map(const GridMap& map, const std::string& path) {
  return write_map_file({map}, path);
}

}  // namespace replan
