// A place in a plane or in space, by whole coordinates.
#pragma once

#include <cmath>
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

/// The squared distance of two cells' centres. In 64 bits: in a world 60 000 cells wide it is beyond 32.
constexpr std::int64_t squared_distance(Cell a, Cell b) {
  const std::int64_t dx = std::int64_t{a.x} - b.x, dy = std::int64_t{a.y} - b.y;
  return dx * dx + dy * dy;
}
/// Their distance. A root is the same on every machine, as std::hypot is not.
inline double distance(Cell a, Cell b) {
  return std::sqrt(static_cast<double>(squared_distance(a, b)));
}
/// The scalar product of the ways from `from` to `a` and to `b`.
constexpr std::int64_t scalar_product(Cell from, Cell a, Cell b) {
  return (std::int64_t{a.x} - from.x) * (std::int64_t{b.x} - from.x) +
         (std::int64_t{a.y} - from.y) * (std::int64_t{b.y} - from.y);
}

/// The most cells a world may have (8192 x 8192): stated limit of every reader and generator.
inline constexpr std::int64_t kMaxCells = std::int64_t{1} << 26;
/// The most voxels a box may have (512 x 512 x 512).
inline constexpr std::int64_t kMaxVoxels = std::int64_t{1} << 27;

}  // namespace replan
