// Whether a robot can go straight between any two points of the world: its centre enters no cell that is closed to it, and
// its body, a disc (in space a ball) of its radius, comes into no obstacle's square (cube).
//
// All is decided in whole numbers. Points are rounded to 1 / 16384 of a cell, as SegmentWalk does (segment.hpp). Along a
// segment the squared distance to a box is made of parabolas, one between every two places where the segment passes a
// side's plane; each part's least value is that at one of its ends or at the parabola's own bottom, and either is a ratio
// of whole numbers. The radius' square is rounded up, so that no way is taken that is too near.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/lattice/box_lattice.hpp"
#include "core/lattice/segment.hpp"

namespace replan {

/// Whether a segment keeps a distance from a box.
class BoxGap {
 public:
  static constexpr std::int64_t kUnits = 1 << 14;  // of a cell, as SegmentWalk's
  using Place = std::array<std::int64_t, 3>;

  static Place place_of(const Point& point) {
    return {std::llround(point.x * kUnits), std::llround(point.y * kUnits), std::llround(point.z * kUnits)};
  }
  /// The least whole number that is not below the square of so many cells, in units.
  static std::int64_t squared_units(double cells) {
    const double length = cells * kUnits, square = length * length, above = std::ceil(square);
    const bool short_of = above == square && std::fma(length, length, -square) > 0;
    return static_cast<std::int64_t>(above) + (short_of ? 1 : 0);
  }

  BoxGap(const Place& from, const Place& to) : from_(from) {
    for (std::size_t i = 0; i < 3; ++i) way_[i] = to[i] - from[i];
  }

  /// Whether no point of the segment is nearer to the box than the root of `squared`.
  [[nodiscard]] bool keeps(const Place& low, const Place& high, std::int64_t squared) const {
    std::array<Moment, 8> moments{{{0, 1}, {1, 1}}};
    std::size_t count = 2;
    for (std::size_t i = 0; i < 3; ++i)
      for (const std::int64_t side : {low[i], high[i]}) {
        const Moment at = way_[i] < 0 ? Moment{from_[i] - side, -way_[i]} : Moment{side - from_[i], way_[i]};
        if (at.part <= 0 || at.part >= at.whole) continue;
        std::size_t place = count++;
        for (; at.part * moments[place - 1].whole < moments[place - 1].part * at.whole; --place)
          moments[place] = moments[place - 1];
        moments[place] = at;
      }
    for (std::size_t i = 0; i + 1 < count; ++i)
      if (!part_keeps(moments[i], moments[i + 1], low, high, squared)) return false;
    return true;
  }

 private:
  __extension__ using Wide = __int128;
  /// Where on the segment, as a share of it.
  struct Moment {
    std::int64_t part = 0, whole = 1;
  };

  /// Between two moments, at which and between which no side's plane is passed.
  [[nodiscard]] bool part_keeps(const Moment& from, const Moment& to, const Place& low, const Place& high,
                                std::int64_t squared) const {
    // The squared distance is the sum of (a + b t)^2 over the axes along which the segment is beside the box.
    const Wide middle = Wide{from.part} * to.whole + Wide{to.part} * from.whole,
               whole = Wide{2} * from.whole * to.whole;
    Place a{}, b{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Wide at = from_[i] * whole + way_[i] * middle;
      if (at < low[i] * whole) a[i] = low[i] - from_[i], b[i] = -way_[i];
      if (at > high[i] * whole) a[i] = from_[i] - high[i], b[i] = way_[i];
    }
    for (const Moment& end : {from, to}) {
      Wide sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Wide gap = Wide{a[i]} * end.whole + Wide{b[i]} * end.part;
        sum += gap * gap;
      }
      if (sum < Wide{squared} * end.whole * end.whole) return false;
    }
    Wide aa = 0, ab = 0, bb = 0;
    for (std::size_t i = 0; i < 3; ++i)
      aa += Wide{a[i]} * a[i], ab += Wide{a[i]} * b[i], bb += Wide{b[i]} * b[i];
    const bool bottom = from.part * bb < -ab * from.whole && -ab * to.whole < to.part * bb;
    return !bottom || aa * bb - ab * ab >= squared * bb;
  }

  Place from_, way_{};
};

/// A cell that a way through a corner or an edge, from one cell to the next, squeezes past though the corner rule does not
/// allow that.
template <int D>
std::optional<Cell> squeezed_past(const BoxLattice<D>& known, const Cell& from, const Cell& to) {
  const std::array<int, 3> by = {to.x - from.x, to.y - from.y, to.z - from.z};
  const CornerRule corners = known.has_size() ? CornerRule::none : known.rules().corners;
  const int allowed = corners == CornerRule::none ? 0 : corners == CornerRule::one ? 1 : 8;
  int squeezed = 0;
  std::optional<Cell> past;
  const unsigned axes = (by[0] != 0 ? 1u : 0u) | (by[1] != 0 ? 2u : 0u) | (by[2] != 0 ? 4u : 0u);
  for (unsigned subset = (axes - 1) & axes; subset != 0; subset = (subset - 1) & axes) {
    const auto part = [&](std::size_t axis) { return (subset >> axis & 1u) != 0 ? by[axis] : 0; };
    const Cell beside{from.x + part(0), from.y + part(1), from.z + part(2)};
    if (!known.blocked(known.node(beside))) continue;
    ++squeezed;
    past = beside;
  }
  return squeezed > allowed ? past : std::nullopt;
}

/// The obstacle that a robot which knows this map would come into on the straight way between two points of it, the cell
/// where it begins included; with a size it may be a cell that is too near one. Nothing if the way is free.
template <int D>
std::optional<Cell> hit_on_way(const BoxLattice<D>& known, const Point& from, const Point& to) {
  const double radius = known.has_size() ? known.rules().radius : 0;
  const BoxGap gap(BoxGap::place_of(from), BoxGap::place_of(to));
  const std::int64_t squared = BoxGap::squared_units(radius);
  const int reach = static_cast<int>(std::ceil(radius));
  std::optional<Cell> hit;
  for (SegmentWalk walk(from, to);;) {
    const Cell at = walk.cell();
    if (known.has_size())
      known.box().each_cell_around(at, reach + 1, [&](NodeId node) {
        if (hit || known.obstacles()[node] == 0) return;
        const Cell cell = known.position(node);
        const BoxGap::Place low{cell.x * BoxGap::kUnits, cell.y * BoxGap::kUnits, cell.z * BoxGap::kUnits};
        // A plane's cells are as high as its points may lie.
        const BoxGap::Place high{low[0] + BoxGap::kUnits, low[1] + BoxGap::kUnits, low[2] + BoxGap::kUnits};
        if (!gap.keeps(low, high, squared)) hit = cell;
      });
    if (!hit && known.blocked(known.node(at))) hit = at;
    if (hit || walk.arrived()) return hit;
    walk.step();
    hit = squeezed_past(known, at, walk.cell());
    if (hit) return hit;
  }
}

}  // namespace replan
