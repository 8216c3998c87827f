// How the best path of a plan by samples became shorter, out of its log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/debug/log_view.hpp"

namespace replan {

/// From the event on the best path has that cost.
struct PathGain {
  std::size_t event = 0;
  std::int64_t sample = 0;  ///< of this plan, the first one is 1; 0: before it has drawn any
  Cost cost = {};           ///< infinite: there is none any more
};

/// Those in the events [begin, end), which are one plan's, in their order; none of a planner that draws no samples.
std::vector<PathGain> path_gains(const LogView& view, std::size_t begin, std::size_t end);

}  // namespace replan
