// Points that lie on the straight way between those before and after them say nothing: left out, a path is told by
// its corners, and the robot drives the same cells.
//
// Between lattice nodes headings are compared in whole numbers; between other points within 1e-9 of a right angle's
// sine.
#pragma once

#include <cmath>

#include "core/plan/stage.hpp"

namespace replan {

struct Collinear {
  static StageInfo describe() {
    return {.name = "Corners only", .summary = "Leaves out the points at which the path goes straight on."};
  }

  template <class L>
  static Path apply(const L&, Path path, const Settings&) {
    std::size_t last = 0;  // of the points before that are kept
    path.keep_if([&](std::size_t i) {
      const bool kept =
          i == 0 || i + 1 == path.size() || !straight(path.point(last), path.point(i), path.point(i + 1));
      if (kept) last = i;
      return kept;
    });
    return path;
  }

 private:
  /// Whether the way from a to b goes straight on to c. Differences of nodes' points are whole numbers, and so are
  /// their products: 0 is exact.
  static bool straight(const Point& a, const Point& b, const Point& c) {
    const Point u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - b.x, c.y - b.y, c.z - b.z};
    const double x = u.y * v.z - u.z * v.y, y = u.z * v.x - u.x * v.z, z = u.x * v.y - u.y * v.x;
    const double along = u.x * v.x + u.y * v.y + u.z * v.z;
    return along > 0 && std::sqrt(x * x + y * y + z * z) <= 1e-9 * along;
  }
};

}  // namespace replan
