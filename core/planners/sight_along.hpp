// Sight checked along a path (`sight_checks=path`): how far the path's vertices see along it.
//
// The search of the D* Lite family never reads a remote parent: g and rhs do not depend on it, it only shapes
// the path that is read out. So the checks can wait until the path is there: from each vertex that is kept,
// the farthest one is looked for by galloping along the chain of local parents and bisecting (ours; Huang &
// Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, name the cost of sight checks in narrow places an open problem).
// Every check is made on the map as it is known then, so nothing can be stale: no leap crosses an obstacle,
// none leads back, and by the triangle inequality none is longer than the chain beneath it. Sight is not
// monotone along the chain, so that a longer leap may be missed.
//
// Line numbers are those of Algorithm 3 in assets/planners/dld-star-lite.md, + 200.
#pragma once

#include <cstddef>

namespace replan {

/// The vertex that vertex `i` of a chain leaps to, `last` being the chain's last one; i < last.
/// `sees(line, j)` says whether i sees j, asked on that line of the pseudo-code; the next one it always does.
template <class Sees>
std::size_t leap_along(std::size_t i, std::size_t last, Sees&& sees) {
  if (i + 1 == last || sees(204, last)) return last;
  std::size_t seen = i + 1, unseen = last;
  for (std::size_t far = 2; i + far < last; far *= 2) {
    if (!sees(207, i + far)) {
      unseen = i + far;
      break;
    }
    seen = i + far;
  }
  while (unseen - seen > 1) {
    const std::size_t middle = seen + (unseen - seen) / 2;
    (sees(209, middle) ? seen : unseen) = middle;
  }
  return seen;
}

}  // namespace replan
