// Numbers and cells as the sentences for users spell them.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "core/base/cell.hpp"

namespace replan {

/// "(3, 4)", or "(3, 4, 5)" of a cell in space
inline std::string cell_text(Cell cell, bool solid = false) {
  const std::string plane = std::to_string(cell.x) + ", " + std::to_string(cell.y);
  return "(" + plane + (solid ? ", " + std::to_string(cell.z) : "") + ")";
}

/// "1 cell", "2 cells"
std::string counted(std::integral auto count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace replan
