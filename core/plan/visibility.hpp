// The visibility graph of a grid: corners of obstacles, and which of them are seen from a point.
//
// A shortest way through the plane is taut: straight but where it bends round a corner of an obstacle. So corners and the
// two ends are all the points that it need be looked for among. Which of them a point may see is found row by row, as
// intervals of what can be seen of each grid line:
//
//  Lozano-Perez & Wesley, "An algorithm for planning collision-free paths among polyhedral obstacles", Comm. ACM 22(10),
//  1979, doi 10.1145/359156.359164 (the visibility graph)
//  Harabor, Grastien, Oz & Aksakalli, "Optimal Any-Angle Pathfinding In Practice", JAIR 56, 2016, doi 10.1613/jair.5007
//  (intervals of grid lines)
//
// What is settled here:
//  * What a way may touch and pass between is told in core/lattice/squares.hpp. Under the corner rule `none` the lattice
//    keeps away from corners, and ways here do not: they are a lower bound of the lattice's.
//  * Edges are found when they are asked for: a graph with all of them would be larger than the map.
//  * The intervals are in doubles and a little too wide: they only propose. Whether two points see each other is decided
//    in whole numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/lattice/squares.hpp"

namespace replan {

/// The points of a map between two ends. Numbers are those of a map as it was looked at last.
class Visibility {
 public:
  static constexpr std::uint32_t kStart = 0, kGoal = 1, kFirstCorner = 2;

  /// The lattice must outlive it.
  explicit Visibility(const Grid2& lattice) : lattice_(lattice) {}

  /// Finds the corners of the map as it is now.
  void look_at_map();
  /// Both are centres of cells, or both corners; one on a corner where two obstacles meet diagonally is left or reached to
  /// its lower right.
  void set_ends(HalfPoint start, HalfPoint goal) {
    start_ = start;
    goal_ = goal;
  }

  [[nodiscard]] std::size_t size() const { return corners_.size() + kFirstCorner; }
  [[nodiscard]] HalfPoint at(std::uint32_t point) const {
    return point == kStart ? start_ : point == kGoal ? goal_ : corners_[point - kFirstCorner].at;
  }
  /// The number of the corner at that place, or that of the start: there is none.
  [[nodiscard]] std::uint32_t corner_at(int x, int y) const;
  /// A free cell that touches it.
  [[nodiscard]] Cell cell_beside(std::uint32_t point) const;

  /// Calls offer(to) for the goal and for the corners that may be seen from there and bent round.
  template <class Offer>
  void each_offered(std::uint32_t from, Offer&& offer);
  /// Whether a string pulled tight from `before` over a corner to another point bends round the corner's obstacle.
  [[nodiscard]] bool bends_taut(std::uint32_t before, std::uint32_t corner, std::uint32_t to) const;
  /// Whether the straight way between two points is free.
  [[nodiscard]] bool sees(std::uint32_t from, std::uint32_t to) const;

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct Corner {
    HalfPoint at;
    int quadrant_x = 0;  // where the obstacle lies, seen from the corner: 1 or -1
    int quadrant_y = 0;
    bool twice = false;  // and another one on the other side of it
  };
  /// The free cells of a row around one of them, as the x of their borders.
  struct FreeRun {
    int begin = 0, end = 0;
  };
  /// Part of a grid line that can be seen.
  struct SeenPart {
    double left, right;
  };
  static constexpr double kSlack = 1e-7;  // cells, by which what is seen is taken too wide

  [[nodiscard]] Squares squares() const { return Squares(lattice_); }
  void add_corner(int x, int y);
  [[nodiscard]] bool may_leave(HalfPoint end, HalfPoint other) const;
  [[nodiscard]] static bool may_bend(HalfPoint from, const Corner& corner);
  [[nodiscard]] SeenPart seen_sideways(HalfPoint from) const;
  void cross_row(HalfPoint from, int row, int sign, const std::vector<SeenPart>& seen,
                 std::vector<SeenPart>& next) const;
  template <class Offer>
  void offer_corners(std::uint32_t from, int line, SeenPart part, Offer&& offer) const;
  template <class Offer>
  void look_vertically(std::uint32_t from, int sign, Offer&& offer);

  const Grid2& lattice_;
  HalfPoint start_, goal_;
  std::vector<Corner> corners_;             // by line, then from left to right
  std::vector<std::uint32_t> line_begins_;  // of each grid line's, in corners_
  std::vector<FreeRun> runs_;               // of each cell
  std::vector<SeenPart> seen_, next_;
};

template <class Offer>
void Visibility::each_offered(std::uint32_t from, Offer&& offer) {
  if (from != kGoal) offer(kGoal);
  const HalfPoint p = at(from);
  if (p.y % 2 == 0) offer_corners(from, p.y / 2, seen_sideways(p), offer);
  look_vertically(from, 1, offer);
  look_vertically(from, -1, offer);
}

template <class Offer>
void Visibility::offer_corners(std::uint32_t from, int line, SeenPart part, Offer&& offer) const {
  const auto begin =
      corners_.begin() + static_cast<std::ptrdiff_t>(line_begins_[static_cast<std::size_t>(line)]);
  const auto end =
      corners_.begin() + static_cast<std::ptrdiff_t>(line_begins_[static_cast<std::size_t>(line) + 1]);
  const auto first = std::lower_bound(begin, end, part.left - kSlack,
                                      [](const Corner& c, double x) { return c.at.x < 2 * x; });
  for (auto c = first; c != end && c->at.x <= 2 * (part.right + kSlack); ++c) {
    const auto to = static_cast<std::uint32_t>(c - corners_.begin()) + kFirstCorner;
    if (to != from && may_bend(at(from), *c)) offer(to);
  }
}

template <class Offer>
void Visibility::look_vertically(std::uint32_t from, int sign, Offer&& offer) {
  const HalfPoint p = at(from);
  seen_.assign(1, {p.x / 2.0, p.x / 2.0});
  int row = sign > 0 ? p.y / 2 : (p.y + 1) / 2 - 1;
  for (; !seen_.empty(); row += sign) {
    cross_row(p, row, sign, seen_, next_);
    for (const SeenPart& part : next_) offer_corners(from, sign > 0 ? row + 1 : row, part, offer);
    std::swap(seen_, next_);
  }
}

}  // namespace replan
