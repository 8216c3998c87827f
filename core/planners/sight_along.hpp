// Sight checked along a path (`sight_checks=path`): how far the path's vertices see along it.
//
// The search of the D* Lite family never reads a remote parent: g and rhs do not depend on it, it only shapes
// the path that is read out. So the checks can wait until the path is there: from each vertex that is kept,
// the farthest one is looked for by galloping along the chain of local parents and bisecting (ours; Huang &
// Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, name the cost of sight checks in narrow places an open problem).
// Every check is made on the map as it is known then, or stands since: what two cells see of each other is a
// matter of the cells in the box that they span, so a leap is kept until one of those changes
// (kept_leaps.hpp). Nothing can be stale: no leap crosses an obstacle, none leads back, and by the triangle
// inequality none is longer than the chain beneath it. Sight is not monotone along the chain, so that a
// longer leap may be missed; and so it may where the way goes on along leaps that are kept.
//
// Line numbers are those of Algorithm 3 in assets/planners/dld-star-lite.md, + 200.
#pragma once

#include <cstddef>

namespace replan {

/// Which vertex of a chain the 0th one leaps to. It sees number `seen` and does not see number `unseen`,
/// which comes later; `sees(line, k)` says whether it sees number k, asked on that line of the pseudo-code.
template <class Sees>
std::size_t leap_along(std::size_t seen, std::size_t unseen, Sees&& sees) {
  for (std::size_t far = 2 * seen; far < unseen; far = 2 * seen) (sees(214, far) ? seen : unseen) = far;
  while (unseen - seen > 1) {
    const std::size_t middle = seen + (unseen - seen) / 2;
    (sees(215, middle) ? seen : unseen) = middle;
  }
  return seen;
}

}  // namespace replan
