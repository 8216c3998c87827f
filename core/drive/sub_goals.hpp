// The turns of a path as sub-goals, taken in order.
#pragma once

#include <cstddef>
#include <vector>

#include "core/drive/motion.hpp"

namespace replan {

/// Which turn a robot makes for: the next one follows when it is near, or when the one after it is in sight. `at` is
/// the one so far; `sees(spot)` says whether the way there is free. The last turn is the goal and is kept.
template <class Sees>
std::size_t next_sub_goal(const std::vector<Spot>& turns, std::size_t at, Spot robot, double near,
                          Sees&& sees) {
  while (at + 1 < turns.size() && (distance(robot, turns[at]) <= near || sees(turns[at + 1]))) ++at;
  return at;
}

}  // namespace replan
