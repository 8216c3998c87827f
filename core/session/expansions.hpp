// Which events of a log are expansions.
#pragma once

#include <cstddef>

#include "core/trace/timeline.hpp"

namespace replan {

/// Goes over a log event by event. A planner that plans afresh wipes its visits on the record before its
/// first iteration; those are no expansions.
class ExpansionCounter {
 public:
  /// Begins at a position of the log.
  ExpansionCounter(const Timeline& log, std::size_t position) {
    while (position-- > 0) {
      const EventKind kind = log.event(position).kind;
      if (kind != EventKind::pop && kind != EventKind::plan_begin) continue;
      iterates_ = kind == EventKind::pop;
      return;
    }
  }
  /// Takes the next event; whether it is an expansion.
  bool take(const Event& event) {
    if (event.kind == EventKind::pop) iterates_ = true;
    if (event.kind == EventKind::plan_begin) iterates_ = false;
    return iterates_ && event.kind == EventKind::visit;
  }

 private:
  bool iterates_ = false;
};

}  // namespace replan
