// The cells that a straight segment between any two points of the world passes through.
//
// Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing" (1987), as SupercoverRay (sight.hpp) does it
// between centres: in whole numbers, with points rounded to 1 / 16384 of a cell, so that every machine finds the same
// cells and that passing exactly through a corner is seen as such.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/base/point.hpp"
#include "core/lattice/box.hpp"

namespace replan {

/// A segment on its way from cell to cell.
class SegmentWalk {
 public:
  SegmentWalk(const Point& from, const Point& to);

  [[nodiscard]] bool arrived() const { return at_ == end_; }
  [[nodiscard]] Cell cell() const { return {at_[0], at_[1], at_[2]}; }
  /// Enters the next cell; along several axes at once where the segment passes through a corner or an edge.
  void step();

 private:
  static constexpr std::int64_t kUnits = 1 << 14;  // of a cell; products of two lengths fit 64 bits

  /// Whether the border ahead on axis i comes before that on axis j: crossed at to_border / length of the way.
  [[nodiscard]] bool sooner(std::size_t i, std::size_t j) const {
    return to_border_[i] * length_[j] < to_border_[j] * length_[i];
  }

  std::array<int, 3> at_{}, end_{}, sign_{};
  std::array<std::int64_t, 3> length_{};     // of the way along each axis
  std::array<std::int64_t, 3> to_border_{};  // along each axis, from the segment's beginning
};

inline SegmentWalk::SegmentWalk(const Point& from, const Point& to) {
  const std::array<double, 3> a = {from.x, from.y, from.z}, b = {to.x, to.y, to.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t begin = std::llround(a[i] * kUnits), end = std::llround(b[i] * kUnits);
    const auto cell = [](std::int64_t units) {
      return static_cast<int>(std::floor(static_cast<double>(units) / kUnits));
    };
    at_[i] = cell(begin);
    end_[i] = cell(end);
    sign_[i] = end < begin ? -1 : 1;
    length_[i] = std::abs(end - begin);
    const std::int64_t border = (at_[i] + (sign_[i] > 0 ? 1 : 0)) * kUnits;
    to_border_[i] = std::abs(border - begin);
  }
}

inline void SegmentWalk::step() {
  std::size_t first = 3;
  for (std::size_t i = 0; i < 3; ++i)
    if (at_[i] != end_[i] && (first == 3 || sooner(i, first))) first = i;
  const std::int64_t border = to_border_[first], length = length_[first];
  for (std::size_t i = 0; i < 3; ++i) {
    if (at_[i] == end_[i] || to_border_[i] * length != border * length_[i]) continue;
    at_[i] += sign_[i];
    to_border_[i] += kUnits;
  }
}

/// Walks the cells that the segment passes through, in order, and calls `visit(node)` for each one entered after the
/// first; it returns false to stop. Both ends must lie in the box. Returns false if stopped.
template <class Visit>
bool walk_segment(const Box& box, const Point& from, const Point& to, Visit&& visit) {
  for (SegmentWalk walk(from, to); !walk.arrived();) {
    walk.step();
    if (!visit(box.node(walk.cell()))) return false;
  }
  return true;
}

}  // namespace replan
