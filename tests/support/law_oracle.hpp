// The planners' laws held against a log by brute force: every vertex after every step, by the plainest means,
// and without a line of the checker's code.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/debug/log_view.hpp"

namespace replan::oracle {

/// A law that does not hold.
struct Fault {
  std::size_t position = 0;   ///< where the first step ends after which it does not, or past that plan's end
  std::vector<NodeId> nodes;  ///< all vertices at which some law fails there
};

/// The first place in `events` where a law of the view's planner fails, if any. The view's log gives the map
/// before the run.
std::optional<Fault> first_fault(const LogView& view, std::span<const Event> events);

}  // namespace replan::oracle
