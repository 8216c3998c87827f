// A small drawing of a map inside a dialog, out of few rectangles.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <imgui.h>

#include "core/world/grid_map.hpp"
#include "ui/look.hpp"

namespace replan::ui {

/// A map seen from afar: a world of layers from above or from the front, each point as dark as there are obstacles in
/// all that lies behind it.
class MapSketch {
 public:
  MapSketch() = default;
  /// Takes over what can be seen of a map in at most `side` points each way, looking along z or along y.
  explicit MapSketch(const GridMap& map, Axis along = Axis::z, int side = 120);

  /// Draws it into a rectangle of the screen, without start and goal.
  void draw(const Look& look, ImDrawList& list, ImVec2 min, ImVec2 max) const;

 private:
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> walls_;  // by point: sixteenths of its cells that are obstacles
};

}  // namespace replan::ui
