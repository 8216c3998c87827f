// What reads a log in slices while it grows, put to a run that is over.
#pragma once

#include <algorithm>
#include <vector>

#include "core/session/run.hpp"

namespace replan {

/// Calls `read(view)` for the log of the run when it had `slice` events, twice as many, and so on to its end.
template <class Read>
void read_while_growing(const Run& run, std::size_t slice, Read&& read) {
  const Timeline& log = run.timeline();
  const LogView whole = run.log_view();
  Timeline grown(log.state_at(0));
  while (grown.size() < log.size()) {
    std::vector<Event> events;
    const std::size_t end = std::min(grown.size() + slice, log.size());
    for (std::size_t i = grown.size(); i < end; ++i) events.push_back(log.event(i));
    grown.append(events);
    read(LogView{grown, whole.lattice, whole.info, whole.settings, whole.radius});
  }
}

}  // namespace replan
