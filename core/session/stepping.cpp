#include "core/session/stepping.hpp"

#include <algorithm>

namespace replan {
namespace {

/// Whether position p (0 < p < size) is a stop: the event there begins a line, or an iteration.
bool is_stop(const Timeline& log, std::size_t p, StepUnit unit) {
  const Event& here = log.event(p);
  const bool begins_iteration = here.kind == EventKind::pop || kMarkers.has(here.kind);
  if (unit == StepUnit::expansion || begins_iteration) return begins_iteration;
  return here.line != log.event(p - 1).line;
}

/// The event behind which steps of that unit end.
std::optional<EventKind> landmark_of(StepUnit unit) {
  if (unit == StepUnit::replan) return EventKind::plan_end;
  if (unit == StepUnit::mission) return EventKind::arrival;
  return std::nullopt;
}

std::int64_t clock_at(const Run& run, std::size_t position) {
  const Mark* mark = run.mark_at(position);
  return mark == nullptr ? -1 : mark->clock;
}

}  // namespace

std::size_t next_stop(const Run& run, std::size_t from, StepUnit unit) {
  const Timeline& log = run.timeline();
  if (unit == StepUnit::move) {
    const std::int64_t clock = clock_at(run, from);
    for (const Mark& mark : run.marks())
      if (mark.event > from && mark.clock > clock) return mark.event;
    return log.size();
  }
  if (const auto landmark = landmark_of(unit)) {
    for (const Marker& marker : run.markers())
      if (marker.kind == *landmark && marker.event >= from) return marker.event + 1;
    return log.size();
  }
  for (std::size_t p = from + 1; p < log.size(); ++p)
    if (is_stop(log, p, unit)) return p;
  return log.size();
}

std::size_t previous_stop(const Run& run, std::size_t from, StepUnit unit) {
  const Timeline& log = run.timeline();
  if (unit == StepUnit::move) {
    const std::int64_t clock = clock_at(run, from);
    std::size_t best = 0;
    for (const Mark& mark : run.marks())
      if (mark.event < from && mark.clock < clock) best = mark.event;
    return best;
  }
  if (const auto landmark = landmark_of(unit)) {
    std::size_t best = 0;
    for (const Marker& marker : run.markers())
      if (marker.kind == *landmark && marker.event + 1 < from) best = marker.event + 1;
    return best;
  }
  for (std::size_t p = std::min(from, log.size()); p-- > 1;)
    if (is_stop(log, p, unit)) return p;
  return 0;
}

}  // namespace replan
