// A place in a plane or in space, by whole coordinates.
#pragma once

#include <compare>
#include <cstdint>

namespace replan {

/// A cell of a 2D grid: x to the right, y down, (0, 0) at the top left, as in a `.map` file.
struct Cell {
  int x = 0;
  int y = 0;
  friend constexpr auto operator<=>(const Cell&, const Cell&) = default;
};

/// A cell of a 3D grid.
struct Voxel {
  int x = 0;
  int y = 0;
  int z = 0;
  friend constexpr auto operator<=>(const Voxel&, const Voxel&) = default;
};

/// The index of a lattice node: row-major, `y * width + x` in 2D.
using NodeId = std::uint32_t;
inline constexpr NodeId kNoNode = 0xFFFFFFFFu;

/// The most cells a world may have (8192 x 8192): stated limit of every reader and generator.
inline constexpr std::int64_t kMaxCells = std::int64_t{1} << 26;

}  // namespace replan
