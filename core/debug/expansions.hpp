// Which events of a log are expansions, asked in any order.
#pragma once

#include <cstddef>

#include "core/trace/timeline.hpp"

namespace replan {

/// Tells expansions from what a fresh plan wipes: both are `visit` events, but the wiping comes before the
/// first vertex is taken. Ask in either direction along a log; it remembers the latest stretch of wiping.
class ExpansionTeller {
 public:
  /// Whether the event is an expansion.
  bool operator()(const Timeline& log, std::size_t index);

 private:
  std::size_t wipe_begin_ = 0, wipe_end_ = 0;  // no vertex is taken in between
};

}  // namespace replan
