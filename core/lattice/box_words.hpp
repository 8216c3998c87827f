// A box of cells as the sentences for users spell it.
#pragma once

#include <string>

#include "core/base/words.hpp"
#include "core/lattice/box.hpp"

namespace replan {

/// "40 x 30", or "40 x 30 x 8" of a box of more than one layer
inline std::string sides_text(const Box& box) {
  return std::to_string(box.width()) + " x " + std::to_string(box.height()) +
         (box.solid() ? " x " + std::to_string(box.depth()) : "");
}

/// "(3, 4)", or "(3, 4, 5)" in a box of more than one layer.
inline std::string cell_text(Cell cell, const Box& world) {
  return cell_text(cell, world.solid());
}

/// "40 × 30 cells", or "40 × 30 × 8 cells" of several layers: a part of a world.
inline std::string part_text(const CellBox& part) {
  const auto side = [](int low, int high) { return std::to_string(high - low + 1); };
  return side(part.low.x, part.high.x) + " × " + side(part.low.y, part.high.y) +
         (part.low.z < part.high.z ? " × " + side(part.low.z, part.high.z) : "") + " cells";
}

/// "40 x 30 cells", or "40 x 30 x 8 voxels"
inline std::string size_text(const Box& box) {
  return sides_text(box) + (box.solid() ? " voxels" : " cells");
}

/// "x goes from 0 to 39, y from 0 to 29", and z in a box of more than one layer: where its cells lie
inline std::string range_text(const Box& box) {
  const auto to = [](int side) { return " from 0 to " + std::to_string(side - 1); };
  return "x goes" + to(box.width()) + ", y" + to(box.height()) + (box.solid() ? ", z" + to(box.depth()) : "");
}

}  // namespace replan
