// A place in a plane or in space, by whole coordinates.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace replan {

/// A cell of a grid: x to the right, y down, (0, 0) at the top left, as in a `.map` file; z is 0 in the
/// plane.
struct Cell {
  int x = 0;
  int y = 0;
  int z = 0;
  friend constexpr auto operator<=>(const Cell&, const Cell&) = default;
};

enum class Axis : std::uint8_t { x, y, z };

/// The coordinate of a cell, or of a point, along an axis; to write too.
template <class Place>
constexpr auto& coordinate(Place&& place, Axis axis) {
  return axis == Axis::x ? place.x : axis == Axis::y ? place.y : place.z;
}

/// A box of cells, both corners included.
struct CellBox {
  Cell low, high;
  friend constexpr bool operator==(const CellBox&, const CellBox&) = default;
};

/// The one with two opposite corners.
constexpr CellBox box_of(Cell a, Cell b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

/// How many cells it has.
constexpr std::size_t cell_count(const CellBox& box) {
  const auto side = [](int low, int high) { return static_cast<std::size_t>(high - low + 1); };
  return side(box.low.x, box.high.x) * side(box.low.y, box.high.y) * side(box.low.z, box.high.z);
}

/// Whether a box numbers `a` before `b`: layer by layer, row by row.
constexpr bool in_node_order(Cell a, Cell b) {
  if (a.z != b.z) return a.z < b.z;
  return a.y != b.y ? a.y < b.y : a.x < b.x;
}

/// A cell of a box in space.
using Voxel = Cell;

/// The index of a lattice node: row-major, `(z * height + y) * width + x`.
using NodeId = std::uint32_t;
inline constexpr NodeId kNoNode = 0xFFFFFFFFu;

/// The squared distance of two cells' centres. In 64 bits: in a world 60 000 cells wide it is beyond 32.
constexpr std::int64_t squared_distance(Cell a, Cell b) {
  const std::int64_t dx = std::int64_t{a.x} - b.x, dy = std::int64_t{a.y} - b.y, dz = std::int64_t{a.z} - b.z;
  return dx * dx + dy * dy + dz * dz;
}
/// Their distance. A root is the same on every machine, as std::hypot is not.
inline double distance(Cell a, Cell b) {
  return std::sqrt(static_cast<double>(squared_distance(a, b)));
}
/// The scalar product of the ways from `from` to `a` and to `b`.
constexpr std::int64_t scalar_product(Cell from, Cell a, Cell b) {
  return (std::int64_t{a.x} - from.x) * (std::int64_t{b.x} - from.x) +
         (std::int64_t{a.y} - from.y) * (std::int64_t{b.y} - from.y) +
         (std::int64_t{a.z} - from.z) * (std::int64_t{b.z} - from.z);
}

/// The most cells a world may have (8192 x 8192): stated limit of every reader and generator.
inline constexpr std::int64_t kMaxCells = std::int64_t{1} << 26;
/// The most voxels a box may have (512 x 512 x 512).
inline constexpr std::int64_t kMaxVoxels = std::int64_t{1} << 27;

}  // namespace replan
