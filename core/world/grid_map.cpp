#include "core/world/grid_map.hpp"

#include <cstring>
#include <utility>

namespace replan {

bool has_unmapped(std::span<const std::uint8_t> cells) {
  return std::memchr(cells.data(), kUnmapped, cells.size()) != nullptr;
}

SharedBytes with_unmapped_as(SharedBytes cells, std::uint8_t value) {
  for (std::size_t first = 0; first < cells.size();) {
    const std::span<const std::uint8_t> stretch = std::as_const(cells).stretch(first);
    const std::size_t end = first + stretch.size();
    if (has_unmapped(stretch))
      for (std::size_t i = first; i < end; ++i)
        if (cells[i] == kUnmapped) cells.edit(i) = value;
    first = end;
  }
  return cells;
}

}  // namespace replan
