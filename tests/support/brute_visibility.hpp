// Shortest ways through the plane by the plainest means.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "core/lattice/squares.hpp"
#include "tests/support/oracle.hpp"

namespace replan::test {

/// Shortest ways by a visibility graph whose points are all corners of cells, and in which sight is a matter of squares that
/// a segment cuts.
class BruteVisibility {
 public:
  BruteVisibility(const oracle::World& world, CornerRule corners) : world_(world), corners_(corners) {}

  /// Infinite if there is no way.
  double length(HalfPoint from, HalfPoint to) {
    if (buried(from) || buried(to)) return HUGE_VAL;
    std::vector<HalfPoint> points = {from, to};
    for (int y = 0; y <= world_.size[1]; ++y)
      for (int x = 0; x <= world_.size[0]; ++x) points.push_back({2 * x, 2 * y});
    std::vector<double> g(points.size(), HUGE_VAL);
    std::vector<bool> done(points.size());
    g[0] = 0;
    for (;;) {
      std::size_t u = points.size();
      for (std::size_t i = 0; i < points.size(); ++i)
        if (!done[i] && g[i] < HUGE_VAL && (u == points.size() || g[i] < g[u])) u = i;
      if (u == points.size()) return g[1];
      if (u == 1) return g[1];
      done[u] = true;
      for (std::size_t v = 0; v < points.size(); ++v) {
        const double x = points[u].x - points[v].x, y = points[u].y - points[v].y;
        const double sum = g[u] + std::sqrt(x * x + y * y) / 2;
        if (sum < g[v] && sees(points[u], points[v])) g[v] = sum;
      }
    }
  }

  /// Neither through the inside of an obstacle, nor between two, nor through (or out of) a place where two meet.
  [[nodiscard]] bool sees(HalfPoint a, HalfPoint b) const {
    for (int y = -1; y <= world_.size[1]; ++y)
      for (int x = -1; x <= world_.size[0]; ++x)
        if (bad(x, y) && cuts(a, b, x, y)) return false;
    for (int y = 0; y <= world_.size[1]; ++y)
      for (int x = 0; x <= world_.size[0]; ++x) {
        const HalfPoint corner{2 * x, 2 * y};
        if (corners_ != CornerRule::any && meets(x, y) && on_segment(a, b, corner)) return false;
        if (bad(x, y) && bad(x, y - 1) && along(a, b, corner, {2 * x + 2, 2 * y})) return false;
        if (bad(x, y) && bad(x - 1, y) && along(a, b, corner, {2 * x, 2 * y + 2})) return false;
      }
    return true;
  }

 private:
  [[nodiscard]] bool bad(int x, int y) const { return world_.bad({x, y, 0}); }
  [[nodiscard]] bool buried(HalfPoint p) const { return p.x % 2 != 0 && bad((p.x - 1) / 2, (p.y - 1) / 2); }
  [[nodiscard]] bool meets(int x, int y) const {
    return (bad(x, y) && bad(x - 1, y - 1) && !bad(x - 1, y) && !bad(x, y - 1)) ||
           (bad(x - 1, y) && bad(x, y - 1) && !bad(x, y) && !bad(x - 1, y - 1));
  }
  static std::int64_t side(HalfPoint a, HalfPoint b, HalfPoint p) {
    return std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x);
  }
  /// Both ends count: who leaves a pinch chooses a side, and nobody turns in one.
  static bool on_segment(HalfPoint a, HalfPoint b, HalfPoint p) {
    return side(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
  }
  /// Whether the segment runs along that unit edge.
  static bool along(HalfPoint a, HalfPoint b, HalfPoint p, HalfPoint q) {
    if (a == b || side(a, b, p) != 0 || side(a, b, q) != 0) return false;
    const bool across = p.y == q.y;
    const int low = across ? std::min(a.x, b.x) : std::min(a.y, b.y);
    const int high = across ? std::max(a.x, b.x) : std::max(a.y, b.y);
    return low < (across ? q.x : q.y) && high > (across ? p.x : p.y);
  }
  /// Whether the segment passes through the inside of a square: clipped by its four sides, in fractions over a common
  /// denominator.
  static bool cuts(HalfPoint a, HalfPoint b, int x, int y) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const std::int64_t whole =
        std::max<std::int64_t>(std::abs(dx), 1) * std::max<std::int64_t>(std::abs(dy), 1);
    std::int64_t enter = 0, leave = whole;
    for (const auto& [from, by, low] : {std::tuple{std::int64_t{a.x}, dx, std::int64_t{2 * x}},
                                        std::tuple{std::int64_t{a.y}, dy, std::int64_t{2 * y}}}) {
      if (by == 0) {
        if (from <= low || from >= low + 2) return false;
        continue;
      }
      const std::int64_t unit = whole / std::abs(by);
      const std::int64_t t0 = (by > 0 ? low - from : from - low - 2) * unit;
      enter = std::max(enter, t0);
      leave = std::min(leave, t0 + 2 * unit);
    }
    return enter < leave;
  }

  const oracle::World& world_;
  CornerRule corners_;
};

}  // namespace replan::test
