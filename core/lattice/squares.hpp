// Obstacles of the plane as squares, for ways that may touch them: what a point may pass between, and which cells a robot
// goes through on its way.
//
// What is settled here:
//  * The outside of the map is an obstacle too. A way may touch obstacles, and run along the edge between a free cell and
//    a blocked one; it may not enter one, run between two, or, but with the corner rule `any`, pass through a corner
//    where two meet diagonally. This is the rule of the Grid-Based Path Planning Competition, and under `none` and
//    `one` cells are joined by such ways exactly if the lattice joins them.
//  * Everything is decided in whole numbers: points are centres and corners of cells.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/point.hpp"
#include "core/lattice/box_lattice.hpp"

namespace replan {

/// A point in halves of a cell: centres of cells are odd, corners even.
struct HalfPoint {
  int x = 0, y = 0;
  friend constexpr bool operator==(const HalfPoint&, const HalfPoint&) = default;
};
constexpr HalfPoint half_centre(Cell cell) {
  return {2 * cell.x + 1, 2 * cell.y + 1};
}
constexpr HalfPoint half_corner(Cell cell) {
  return {2 * cell.x, 2 * cell.y};
}
/// Where it lies in the world, and the nearest one to such a place.
constexpr Point point_of(HalfPoint p) {
  return {p.x / 2.0, p.y / 2.0, 0.5};
}
inline HalfPoint half_point(const Point& p) {
  return {static_cast<int>(std::lround(2 * p.x)), static_cast<int>(std::lround(2 * p.y))};
}

/// A look at the cells of a map, which must outlive it.
class Squares {
 public:
  /// Of a box of one layer, nonzero = obstacle.
  Squares(const Box& box, std::span<const std::uint8_t> cells) : box_(box), cells_(cells) {}
  explicit Squares(const Grid2& lattice) : Squares(lattice.box(), lattice.cells()) {}

  [[nodiscard]] int width() const { return box_.width(); }
  [[nodiscard]] int height() const { return box_.height(); }
  [[nodiscard]] bool blocked(int x, int y) const {
    return x < 0 || y < 0 || x >= width() || y >= height() || cells_[box_.node({x, y})] != 0;
  }
  /// Whether two obstacles meet diagonally at that corner of cells, and the other two cells there are free.
  [[nodiscard]] bool pinched(int x, int y) const;
  /// Whether the straight way between two points is free.
  [[nodiscard]] bool clear(HalfPoint a, HalfPoint b, CornerRule corners) const;

  /// The free cells that a robot goes through on the straight way, which must be free, as far as they come after the one
  /// that it is in, which touches the beginning. Each is a neighbour of the one before. Where an obstacle is touched on
  /// the way past its corner, the free cell beside it is one of them, so that no corner is cut.
  [[nodiscard]] std::vector<Cell> cells_along(HalfPoint a, HalfPoint b, Cell in) const;

 private:
  [[nodiscard]] bool clear_along_axis(HalfPoint a, HalfPoint b, CornerRule corners) const;
  [[nodiscard]] std::vector<Cell> cells_along_line(HalfPoint a, HalfPoint b, Cell in) const;

  Box box_;
  std::span<const std::uint8_t> cells_;
};

}  // namespace replan
