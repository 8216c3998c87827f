#include "core/world/map_frame.hpp"

#include <cstdio>

#include "core/base/trigonometry.hpp"

namespace replan {

MapFrame::MapFrame(const GridMap& map)
    : resolution_(map.resolution),
      origin_(map.origin),
      sine_(sine(map.origin[2])),
      cosine_(cosine(map.origin[2])),
      rows_(map.height),
      metric_(map.resolution != 1 || map.origin != std::array<double, 3>{}) {}

Point MapFrame::to_metres(const Point& cells) const {
  const double along = metres(cells.x), up = metres(rows_ - cells.y);
  return {origin_[0] + cosine_ * along - sine_ * up, origin_[1] + sine_ * along + cosine_ * up,
          metres(cells.z)};
}

Point MapFrame::to_cells(const Point& metres) const {
  const double x = metres.x - origin_[0], y = metres.y - origin_[1];
  const double along = cosine_ * x + sine_ * y, up = cosine_ * y - sine_ * x;
  return {along / resolution_, rows_ - up / resolution_, metres.z / resolution_};
}

std::optional<MapFrame> metric_frame(const GridMap& map) {
  const MapFrame frame(map);
  return frame.metric() ? std::optional(frame) : std::nullopt;
}

std::string metres_text(const Point& metres, bool solid) {
  char text[128];
  if (solid)
    std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f) m", metres.x, metres.y, metres.z);
  else
    std::snprintf(text, sizeof text, "(%.3f, %.3f) m", metres.x, metres.y);
  return text;
}

}  // namespace replan
