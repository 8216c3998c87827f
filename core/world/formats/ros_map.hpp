// Maps of the ROS map_server: a `.yaml` that names a picture and says how its grey values are meant.
// https://wiki.ros.org/map_server and nav2_map_server.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/world/formats/picture.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

/// What a map_server `.yaml` says. A pixel of shade v (0..255) is occupied with p = (255 - v) / 255, or v /
/// 255 if `negate` is set.
struct RosMapInfo {
  enum class Mode : std::uint8_t {
    trinary,  ///< occupied, free or unknown, by the thresholds
    scale,    ///< between the thresholds partly occupied, unknown where the picture is transparent
  };
  std::string image;               ///< as written; a relative path starts at the `.yaml`
  double resolution = 0;           ///< metres per cell
  std::array<double, 3> origin{};  ///< pose of the lower left corner: x, y in metres, yaw in radians
  bool negate = false;
  double occupied_thresh = 0.65;  ///< occupied if p is above it
  double free_thresh = 0.196;     ///< free if p is below it
  Mode mode = Mode::trinary;
  std::vector<std::string> notes = {};  ///< keys that are not map_server's and were passed over

  friend bool operator==(const RosMapInfo& a, const RosMapInfo& b) {
    return a.image == b.image && a.resolution == b.resolution && a.origin == b.origin &&
           a.negate == b.negate && a.occupied_thresh == b.occupied_thresh && a.free_thresh == b.free_thresh &&
           a.mode == b.mode;
  }
};

/// Reads the text of a `.yaml`; `origin` names it in errors, which give the line. All keys but `mode` must be
/// there, as map_server has it; `mode` in any case, `negate` as a number or one of YAML's booleans. Keys of
/// others are passed over with a note; `mode: raw` is refused, since its values are costs and not obstacles.
Result<RosMapInfo> parse_ros_yaml(std::string_view text, const std::string& origin);
/// The `.yaml` text that parse_ros_yaml() reads back to an equal one.
std::string ros_yaml_text(const RosMapInfo& info);

/// How many pixels of a ROS map are what, before `unknown` decides.
struct RosCounts {
  std::int64_t free = 0, occupied = 0, unknown = 0;
  friend bool operator==(const RosCounts&, const RosCounts&) = default;
};
RosCounts count_ros_cells(const Picture& picture, const RosMapInfo& info);
/// The cells of a ROS map. What is neither occupied nor free (in `scale` mode also what is partly occupied)
/// becomes what `unknown` says.
GridMap ros_cells(const Picture& picture, const RosMapInfo& info, UnknownCells unknown);

/// Which cells of a ROS map are unknown; nothing if none is.
std::shared_ptr<const std::vector<bool>> unknown_ros_cells(const Picture& picture, const RosMapInfo& info);

/// Reads a `.yaml` and its picture (PGM, PNG, BMP, ...), resolution and origin kept. The picture is taken as
/// it is stored, as map_server takes it.
Result<MapFile> read_ros_map(const std::string& path, UnknownCells unknown = UnknownCells::blocked);
/// Writes NAME.yaml and beside it its picture NAME.pgm, each atomically, the picture first: free 254,
/// obstacle 0, unmapped 205 (unknown), as well as what was unknown when the map was read.
Result<void> write_ros_map(const MapFile& file, const std::string& path);

}  // namespace replan
