// Numbers and cells as the sentences for users spell them.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cell.hpp"

namespace replan {

/// "(3, 4)", or "(3, 4, 5)" of a cell in space
inline std::string cell_text(Cell cell, bool solid = false) {
  const std::string plane = std::to_string(cell.x) + ", " + std::to_string(cell.y);
  return "(" + plane + (solid ? ", " + std::to_string(cell.z) : "") + ")";
}

/// The cell's coordinates in files: two of them, or three of a cell in space.
inline std::vector<int> coordinates_of(Cell cell, bool solid) {
  std::vector<int> all = {cell.x, cell.y};
  if (solid) all.push_back(cell.z);
  return all;
}

/// "a, b, c"
inline std::string joined(std::span<const std::string_view> words, std::string_view between = ", ") {
  std::string list;
  for (const std::string_view& word : words) {
    if (&word != words.data()) list += between;
    list += word;
  }
  return list;
}

/// "1 cell", "2 cells"
std::string counted(std::integral auto count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace replan
