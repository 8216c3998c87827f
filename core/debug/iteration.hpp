// Where the iteration began that stands at a moment of a log: a planner that samples or breeds writes a `pop` for each sample
// and for each child.
#pragma once

#include <cstddef>
#include <optional>

#include "core/trace/timeline.hpp"

namespace replan {

/// Whether nothing is in hand any more behind such an event.
constexpr bool ends_iteration(EventKind kind) {
  return kind == EventKind::plan_begin || kind == EventKind::plan_end || kind == EventKind::epoch ||
         kind == EventKind::move || kind == EventKind::surprise;
}

/// The latest `pop` before `end`, if that one's iteration stands there still; looked for among the `most` events before.
inline std::optional<std::size_t> pop_before(const Timeline& log, std::size_t end, std::size_t most) {
  const std::size_t first = end > most ? end - most : 0;
  for (std::size_t i = end; i-- > first;) {
    const EventKind kind = log.event(i).kind;
    if (kind == EventKind::pop) return i;
    if (ends_iteration(kind)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace replan
