#include "core/scene/stale_stretches.hpp"

#include <algorithm>
#include <span>

namespace replan {

void StaleStretches::mark_written(const Timeline& log, KindSet kinds, std::size_t from, std::size_t to) {
  for (std::size_t at = from; at < to;) {
    const std::span<const Event> events = log.peek(at, to);
    for (const Event& event : events)
      if (kinds.has(event.kind)) mark(event.node / stretch_);
    at += events.size();
  }
}

bool StaleStretches::follow(const Place& now, KindSet kinds) {
  const std::size_t from = std::min(position_, now.position), to = std::max(position_, now.position);
  const bool other = log_id_ != now.log_id || nodes_ != now.nodes;
  // Beyond that many events it is cheaper to look at all nodes than to find those that were written: an event, which may
  // have to be unpacked, takes some thirty times as long as a node.
  const bool leap = to - from > now.nodes / 32;
  log_id_ = now.log_id;
  position_ = now.position;
  nodes_ = now.nodes;
  if (other) next_ = 0;
  if (other || leap || !now.log.reversible(from, to))
    mark_all();
  else
    mark_written(now.log, kinds, from, to);
  return other;
}

}  // namespace replan
