// Places and lengths in the map's own frame: metres, where a file says how large a cell is.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/base/point.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// Cells are what everything is counted in; this turns them into what a user reads, and back. The frame is the one of the
/// ROS map_server's yaml file: x to the right and y up from the lower left corner of the map, which lies at `origin` and is
/// turned by its yaw. Heights are those of the layers alone.
class MapFrame {
 public:
  explicit MapFrame(const GridMap& map);

  /// Whether the map's source says how large a cell is, or where it lies: else lengths are in cells.
  [[nodiscard]] bool metric() const { return metric_; }
  [[nodiscard]] double metres_per_cell() const { return resolution_; }
  /// Of the lower left corner: x and y in metres, yaw in radians.
  [[nodiscard]] const std::array<double, 3>& origin() const { return origin_; }
  /// A length in metres.
  [[nodiscard]] double metres(double cells) const { return cells * resolution_; }
  /// A place, given in cells, in metres.
  [[nodiscard]] Point to_metres(const Point& cells) const;
  /// The other way round.
  [[nodiscard]] Point to_cells(const Point& metres) const;

 private:
  double resolution_;
  std::array<double, 3> origin_;
  double sine_, cosine_;  // of its yaw
  int rows_;
  bool metric_;
};

/// The map's frame if it is metric.
std::optional<MapFrame> metric_frame(const GridMap& map);

/// "(1.525, -2.075) m"; of a place in space with its height.
std::string metres_text(const Point& metres, bool solid = false);

}  // namespace replan
