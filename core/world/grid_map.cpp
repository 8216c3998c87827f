#include "core/world/grid_map.hpp"

#include <cstring>
#include <string>
#include <utility>

namespace replan {

Result<void> check_world_size(const Box& size) {
  const std::int64_t most = size.solid() ? kMaxVoxels : kMaxCells;
  const bool sides = size.width() >= 1 && size.height() >= 1 && size.depth() >= 1;
  if (sides && size.width() <= most / size.height() &&
      size.depth() <= most / (std::int64_t{size.width()} * size.height()))
    return {};
  return Error{"a world cannot have " + std::to_string(size.width()) + " x " + std::to_string(size.height()) +
               (size.depth() != 1 ? " x " + std::to_string(size.depth()) : "") +
               " cells: give sides from 1 and at most " + std::to_string(most) + " cells in all"};
}

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
