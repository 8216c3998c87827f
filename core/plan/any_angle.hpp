// The shortest way of a point through the plane, whatever its directions: the yardstick of any-angle paths.
//
// A shortest way is taut: straight but where it bends round a corner of an obstacle. So it is looked for by A* over
// such corners. Which corners a point sees is found row by row, as intervals of what can be seen of each grid line:
//
//  Lozano-Perez & Wesley, "An algorithm for planning collision-free paths among polyhedral obstacles", Comm. ACM 22(10),
//  1979, doi 10.1145/359156.359164 (the visibility graph)
//  Harabor, Grastien, Oz & Aksakalli, "Optimal Any-Angle Pathfinding In Practice", JAIR 56, 2016, doi 10.1613/jair.5007
//  (intervals of grid lines)
//
// What is settled here:
//  * Obstacles are squares, and the outside of the map is one. The way may touch them, and run along the edge between a
//    free cell and a blocked one; it may not enter one, run between two, or, but with the corner rule `any`, pass
//    through a corner where two meet diagonally. This is the rule of the Grid-Based Path Planning Competition, and under
//    `none` and `one` cells are joined by such ways exactly if the lattice joins them.
//  * Under `none` the lattice keeps away from corners, so that the way here is its lower bound and not one of its own.
//  * The intervals are in doubles and a little too wide: they only propose. Whether two points see each other is decided
//    in whole numbers.
//  * Lengths are doubles, made by + - * / and sqrt alone.
#pragma once

#include <cstdint>
#include <vector>

#include "core/lattice/box_lattice.hpp"
#include "core/plan/path.hpp"

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

/// Shortest ways on one map; many can be asked for.
class AnyAngle {
 public:
  explicit AnyAngle(const Grid2& lattice);

  /// From one point to another, over corners of obstacles; empty if there is none. Both are centres of cells, or both
  /// corners; a start or goal on a corner where two obstacles meet diagonally is left or reached to its lower right.
  [[nodiscard]] Path shortest(HalfPoint from, HalfPoint to);
  /// Whether the straight way between two points is free.
  [[nodiscard]] bool sees(HalfPoint a, HalfPoint b) const;
  /// Points taken from the list, since it was made.
  [[nodiscard]] std::int64_t expansions() const { return expansions_; }

 private:
  struct Corner {
    HalfPoint at;
    int quadrant_x = 0;  // where the obstacle lies, seen from the corner: 1 or -1
    int quadrant_y = 0;
    bool twice = false;  // and another one on the other side of it
  };
  /// What is known of a corner, of the start (number 0) or of the goal (number 1).
  struct Reached {
    double g = 0;
    std::uint32_t parent = 0;
    std::uint32_t search = 0;
    bool done = false;
  };
  struct Entry {
    double f, g;
    std::uint32_t point;
    friend bool operator>(const Entry& a, const Entry& b) {
      return a.f != b.f ? a.f > b.f : a.g != b.g ? a.g < b.g : a.point > b.point;
    }
  };
  /// The free cells of a row around one of them, as the x of their borders.
  struct Run {
    int begin = 0, end = 0;
  };
  /// Part of a grid line that can be seen.
  struct Interval {
    double left, right;
  };

  [[nodiscard]] bool blocked(int x, int y) const {
    return x < 0 || y < 0 || x >= width_ || y >= height_ || lattice_.blocked(lattice_.node(Cell{x, y}));
  }
  [[nodiscard]] bool pinched(int x, int y) const;
  [[nodiscard]] bool sees_along_axis(HalfPoint a, HalfPoint b) const;
  [[nodiscard]] HalfPoint at(std::uint32_t point) const;
  [[nodiscard]] bool may_leave(HalfPoint end, HalfPoint other) const;
  [[nodiscard]] bool bends_taut(std::uint32_t before, std::uint32_t corner, HalfPoint next) const;
  void expand(std::uint32_t point);
  void offer(std::uint32_t from, std::uint32_t to);
  void look_sideways(std::uint32_t from);
  void look_vertically(std::uint32_t from, int sign);
  void cross_row(std::uint32_t from, int row, int sign, const std::vector<Interval>& seen,
                 std::vector<Interval>& next) const;
  void offer_corners(std::uint32_t from, int line, Interval part);

  const Grid2& lattice_;
  int width_, height_;
  std::vector<Corner> corners_;             // by line, then from left to right
  std::vector<std::uint32_t> line_begins_;  // of each grid line's, in corners_
  std::vector<Run> runs_;                   // of each cell
  std::vector<Reached> points_;
  std::vector<Entry> open_;
  std::vector<Interval> seen_, next_;
  HalfPoint start_, goal_;
  std::uint32_t search_ = 0;
  std::int64_t expansions_ = 0;
};

}  // namespace replan
