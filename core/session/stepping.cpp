#include "core/session/stepping.hpp"

#include <algorithm>
#include <iterator>

namespace replan {
namespace {

const BitRow& stops_of(const Run& run, StepUnit unit) {
  return unit == StepUnit::line ? run.stops().lines() : run.stops().iterations();
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
  if (unit == StepUnit::move) {
    const std::int64_t clock = clock_at(run, from);
    for (const Decision& decision : run.decisions())
      if (decision.event > from && decision.clock > clock) return decision.event;
    return run.timeline().size();
  }
  if (const auto milestone_kind = milestone_of(unit)) {
    for (const Milestone& milestone : run.milestones())
      if (milestone.kind == *milestone_kind && milestone.event >= from) return milestone.event + 1;
    return run.timeline().size();
  }
  return stops_of(run, unit).next(from + 1);
}

std::size_t previous_stop(const Run& run, std::size_t from, StepUnit unit) {
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
  return stops_of(run, unit).previous(from);
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
