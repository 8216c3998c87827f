// Where the centre of a robot with a size may be: the obstacles of a map, each grown by the robot's radius.
//
// A cell is free for the centre exactly if the distance from the cell's centre to the square (cube) of every obstacle
// cell is at least the radius, and the cell is no obstacle itself. For each cell it is counted how many obstacles are
// nearer than that, so that an obstacle that comes or goes is one more or one less in the cells around it, and what
// results is, bit for bit, the inflation of the new map.
//
// What is settled here:
//  * Exactness. Along an axis the square of a cell d away begins |d| - 1/2 from the centre, so four times the squared
//    distance is a sum of squares of the whole numbers max(2 |d| - 1, 0). Such a number is less than (2 r)^2 exactly
//    if it is less than the least whole number that is not below (2 r)^2, which is worked out once, with the rounding
//    error of the square (limit_of()). From there on there are whole numbers alone.
//  * The border of the map is no wall: a robot near it is not kept away from what lies outside, as with the clearance
//    penalties, though its centre stays on the map. Whoever wants a wall there draws one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "core/lattice/lattice.hpp"

namespace replan {

/// The least whole number that is not below (2 radius)^2, of a positive radius.
std::int64_t limit_of(double radius);

/// Four times the squared distance from a cell's centre to the square of a cell so far away.
template <std::size_t D>
std::int64_t quarters_of(const std::array<int, D>& by) {
  std::int64_t sum = 0;
  for (const int part : by) {
    const std::int64_t gap = std::max(2 * std::int64_t{std::abs(part)} - 1, std::int64_t{0});
    sum += gap * gap;
  }
  return sum;
}

template <int D>
class Inflation {
 public:
  using Coordinates = std::array<int, D>;

  /// A cell so far from another, and four times the squared distance of its centre to the other's square.
  struct Offset {
    Coordinates by;
    std::int64_t quarters;
  };

  /// Of the obstacles (nonzero) of a box. The radius is positive and at most MoveRules::kMostRadius.
  Inflation(const Coordinates& size, std::vector<std::uint8_t> obstacles, double radius);

  [[nodiscard]] std::span<const std::uint8_t> obstacles() const { return obstacles_; }
  /// The cells where the centre cannot be, nonzero, as they were before any edit.
  [[nodiscard]] std::vector<std::uint8_t> blocked() const;

  /// Obstacles come and go; of several edits of one cell the last one holds. `blocked` are the cells where the centre
  /// could not be before. Returns those where that changed, each once, valid until the next call.
  std::span<const CellEdit> apply(std::span<const CellEdit> edits, std::span<const std::uint8_t> blocked);
  /// What the latest call of apply() returned.
  [[nodiscard]] std::span<const CellEdit> turned() const { return turned_; }

  static constexpr std::int64_t kClear = std::numeric_limits<std::int64_t>::max();
  /// Four times the squared distance from the cell's centre to the nearest obstacle's square, if that is nearer than
  /// the radius: 0 in an obstacle. Else kClear.
  [[nodiscard]] std::int64_t quarters(NodeId node) const;

 private:
  using Count = std::conditional_t<D == 2, std::uint16_t, std::uint32_t>;
  /// Cells in a row: at `by` from the obstacle along all axes but the first, up to `reach` away along that.
  struct Row {
    Coordinates by;
    int reach;
  };

  void prepare(double radius);
  void count_all();
  [[nodiscard]] Coordinates coordinates(NodeId node) const;
  /// Calls visit(first, last) for each row of cells around the obstacle, cut off at the map's sides.
  template <class Visit>
  void each_row(NodeId obstacle, Visit&& visit) const;

  Coordinates size_;
  std::vector<Row> rows_;
  std::vector<Offset> offsets_;  // by growing distance
  std::vector<std::uint8_t> obstacles_;
  std::vector<Count> counts_;
  std::vector<NodeId> touched_;
  std::vector<CellEdit> turned_;
};

extern template class Inflation<2>;
extern template class Inflation<3>;

}  // namespace replan
