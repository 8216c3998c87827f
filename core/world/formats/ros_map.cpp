#include "core/world/formats/ros_map.hpp"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "core/base/file.hpp"
#include "core/world/formats/pnm.hpp"

namespace replan {
namespace {

// What map_saver writes.
constexpr std::uint8_t kFreeShade = 254, kOccupiedShade = 0, kUnknownShade = 205;
constexpr std::int64_t kMaxYamlBytes = 1 << 16;

enum class RosCell : unsigned char { free, occupied, unknown };

/// One pixel by map_server's rules.
RosCell ros_cell(const Picture& picture, const std::uint8_t* pixel, const RosMapInfo& info) {
  const bool scale = info.mode == RosMapInfo::Mode::scale;
  const bool alpha = picture.has_alpha();
  // A map_server of old took transparency for one more colour; in trinary mode that has stayed.
  const int colours = picture.channels - (alpha && scale ? 1 : 0);
  const double shade = std::accumulate(pixel, pixel + colours, 0) / static_cast<double>(colours);
  const double p = (info.negate ? shade : 255 - shade) / 255;
  if (scale && alpha && pixel[picture.channels - 1] < 255) return RosCell::unknown;
  if (p > info.occupied_thresh) return RosCell::occupied;
  return p < info.free_thresh ? RosCell::free : RosCell::unknown;
}

/// What unknown cells are read as.
std::uint8_t kind_of(UnknownCells unknown) {
  return unknown == UnknownCells::blocked ? kObstacle : unknown == UnknownCells::free ? kFree : kUnmapped;
}

}  // namespace

RosCounts count_ros_cells(const Picture& picture, const RosMapInfo& info) {
  RosCounts counts;
  std::int64_t* const by_kind[] = {&counts.free, &counts.occupied, &counts.unknown};
  for (std::size_t i = 0; i < picture.pixels(); ++i)
    ++*by_kind[static_cast<std::size_t>(ros_cell(picture, picture.pixel(i), info))];
  return counts;
}

std::shared_ptr<const std::vector<bool>> unknown_ros_cells(const Picture& picture, const RosMapInfo& info) {
  auto unknown = std::make_shared<std::vector<bool>>(picture.pixels());
  for (std::size_t i = 0; i < unknown->size(); ++i)
    (*unknown)[i] = ros_cell(picture, picture.pixel(i), info) == RosCell::unknown;
  return std::find(unknown->begin(), unknown->end(), true) == unknown->end() ? nullptr : unknown;
}

GridMap ros_cells(const Picture& picture, const RosMapInfo& info, UnknownCells unknown) {
  const std::uint8_t cells[] = {kFree, kObstacle, kind_of(unknown)};
  GridMap map(picture.width, picture.height);
  for (std::size_t i = 0; i < map.blocked.size(); ++i)
    map.blocked[i] = cells[static_cast<std::size_t>(ros_cell(picture, picture.pixel(i), info))];
  map.resolution = info.resolution;
  map.origin = info.origin;
  return map;
}

Result<MapFile> read_ros_map(const std::string& path, UnknownCells unknown) {
  const Result<std::string> text = read_file(path, kMaxYamlBytes);
  if (!text) return Error{text.error()};
  const Result<RosMapInfo> info = parse_ros_yaml(*text, path);
  if (!info) return Error{info.error()};
  const Result<Picture> picture =
      read_picture((std::filesystem::path(file_folder(path)) / info->image).string(), Lying::as_stored);
  if (!picture) return Error{path + ": its image: " + picture.error()};
  MapFile file{ros_cells(*picture, *info, unknown)};
  file.found.notes = info->notes;
  file.found.unknown = unknown_ros_cells(*picture, *info);
  file.found.unknown_as = kind_of(unknown);
  return file;
}

Result<void> write_ros_map(const MapFile& file, const std::string& path) {
  constexpr std::uint8_t kShades[] = {kFreeShade, kOccupiedShade, kUnknownShade};
  const GridMap& map = file.map;
  Picture picture{map.width, map.height, 1, std::vector<std::uint8_t>(map.blocked.size())};
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = file.found.is_unknown(map, i) ? kUnknownShade : kShades[map.blocked[i]];
  RosMapInfo info;
  info.image = file_stem(path) + ".pgm";
  info.resolution = map.resolution;
  info.origin = map.origin;
  const std::string image_path = (std::filesystem::path(file_folder(path)) / info.image).string();
  if (auto written = write_file_atomically(image_path, pgm_text(picture)); !written) return written;
  return write_file_atomically(path, ros_yaml_text(info));
}

}  // namespace replan
