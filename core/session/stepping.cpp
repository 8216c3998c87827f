#include "core/session/stepping.hpp"

#include <algorithm>
#include <iterator>

namespace replan {
namespace {

/// Whether position p (0 < p < size) is a stop: the event there begins a line, or an iteration.
bool is_stop(const Timeline& log, std::size_t p, StepUnit unit) {
  const Event& here = log.event(p);
  const bool begins_iteration = here.kind == EventKind::pop || kMilestones.has(here.kind);
  if (unit == StepUnit::expansion || begins_iteration) return begins_iteration;
  return here.line != log.event(p - 1).line;
}

/// The event behind which steps of that unit end.
std::optional<EventKind> milestone_of(StepUnit unit) {
  if (unit == StepUnit::replan) return EventKind::plan_end;
  if (unit == StepUnit::mission) return EventKind::arrival;
  return std::nullopt;
}

std::int64_t clock_at(const Run& run, std::size_t position) {
  const Decision* decision = run.decision_at(position);
  return decision == nullptr ? -1 : decision->clock;
}

}  // namespace

std::size_t next_stop(const Run& run, std::size_t from, StepUnit unit) {
  const Timeline& log = run.timeline();
  if (unit == StepUnit::move) {
    const std::int64_t clock = clock_at(run, from);
    for (const Decision& decision : run.decisions())
      if (decision.event > from && decision.clock > clock) return decision.event;
    return log.size();
  }
  if (const auto milestone_kind = milestone_of(unit)) {
    for (const Milestone& milestone : run.milestones())
      if (milestone.kind == *milestone_kind && milestone.event >= from) return milestone.event + 1;
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
    for (const Decision& decision : run.decisions())
      if (decision.event < from && decision.clock < clock) best = decision.event;
    return best;
  }
  if (const auto milestone_kind = milestone_of(unit)) {
    std::size_t best = 0;
    for (const Milestone& milestone : run.milestones())
      if (milestone.kind == *milestone_kind && milestone.event + 1 < from) best = milestone.event + 1;
    return best;
  }
  for (std::size_t p = std::min(from, log.size()); p-- > 1;)
    if (is_stop(log, p, unit)) return p;
  return 0;
}

bool is_before_repair(const Run& run, std::size_t position) {
  const Timeline& log = run.timeline();
  if (position >= log.size() || log.event(position).kind != EventKind::pop) return false;
  const auto milestones = run.milestones();
  const auto after =
      std::partition_point(milestones.begin(), milestones.end(),
                           [position](const Milestone& each) { return each.event < position; });
  if (after == milestones.begin()) return false;
  const Milestone& begun = *std::prev(after);
  if (begun.kind != EventKind::plan_begin || log.event(begun.event).delta == 0) return false;
  bool jumped = false;
  for (std::size_t at = position; --at > begun.event;) {
    const EventKind kind = log.event(at).kind;
    if (kind == EventKind::pop || kind == EventKind::epoch)
      return false;  // mostly one was taken shortly before
    jumped |= kind == EventKind::rhs;
  }
  if (!jumped) return false;
  for (std::size_t at = begun.event; at-- > 0;) {
    const EventKind kind = log.event(at).kind;
    if (kind == EventKind::known) return true;
    if (kMilestones.has(kind)) return false;
  }
  return false;
}

}  // namespace replan
