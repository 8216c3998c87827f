#include "core/session/lockstep.hpp"

#include <algorithm>
#include <limits>

#include "core/trace/expansions.hpp"

namespace replan {
namespace {

/// How many steps of the robot a run that has to go on is taken ahead, so that it is there when play comes.
constexpr std::int64_t kAhead = 4;

bool clock_before(const Decision& decision, std::int64_t clock) {
  return decision.clock < clock;
}

std::size_t index_of(std::span<const Decision> decisions, std::span<const Decision>::iterator decision) {
  return static_cast<std::size_t>(decision - decisions.begin());
}

/// How many decisions come before the robot's clock shows `clock`.
std::size_t decisions_before(const Run& run, std::int64_t clock) {
  const auto decisions = run.decisions();
  return index_of(decisions, std::lower_bound(decisions.begin(), decisions.end(), clock, clock_before));
}

std::size_t decisions_until(const Run& run, std::size_t position) {
  const Decision* decision = run.decision_at(position);
  return decision == nullptr ? 0 : static_cast<std::size_t>(decision - run.decisions().data()) + 1;
}

/// The robot's clock after so many decisions.
std::int64_t clock_after(const Run& run, std::size_t decisions) {
  return decisions == 0 ? -1 : run.decisions()[decisions - 1].clock;
}

std::size_t begin_after(const Run& run, std::size_t decisions) {
  return decisions == 0 ? 0 : run.decisions()[decisions - 1].event;
}

/// Goes over the events from `from` on until `end`, or until behind expansion number `most` if that comes
/// first. Whole chunks are counted by the run's curve.
struct Walk {
  std::size_t position;
  std::int64_t expansions = 0;
};
Walk walk(const Run& run, std::size_t from, std::size_t end, std::int64_t most) {
  constexpr std::size_t kChunk = Run::kCurveChunk;
  Walk walk{from};
  while (walk.position < end && walk.expansions < most) {
    const std::size_t chunk = walk.position / kChunk, chunk_end = std::min((chunk + 1) * kChunk, end);
    const bool whole = walk.position % kChunk == 0 && chunk_end == (chunk + 1) * kChunk;
    if (whole && walk.expansions + run.expansion_curve()[chunk] < most) {
      walk.expansions += run.expansion_curve()[chunk];
      walk.position = chunk_end;
      continue;
    }
    while (walk.position < chunk_end && walk.expansions < most)
      walk.expansions += is_expansion(run.timeline().event(walk.position++)) ? 1 : 0;
  }
  return walk;
}

/// Behind the expansion number `count` after `from`, or `end` if that comes first.
std::size_t behind_expansions(const Run& run, std::size_t from, std::size_t end, std::int64_t count) {
  return walk(run, from, end, count).position;
}

/// Where the next iteration of the main loop begins, or `end` if there is none before it.
std::size_t next_iteration(const Run& run, std::size_t from, std::size_t end) {
  const BitRow& stops = run.stops().iterations();
  for (from = stops.next(from); from < end; from = stops.next(from + 1))
    if (run.timeline().event(from).kind == EventKind::pop) return from;
  return end;
}

/// The decision from which a follower goes on at the leader's step, as a number of decisions made. Nothing
/// if its run ended, or has only come, before that step.
std::optional<std::size_t> decision_at(const Run& run, const Progress& wanted) {
  if (wanted.clock < 0) return 0;
  const std::size_t reached = decisions_before(run, wanted.clock + 1);
  if (reached == 0) return std::nullopt;
  const std::int64_t clock = clock_after(run, reached);
  // A robot that waits may pass over a step: it stood at the earlier one all that time.
  if (clock < wanted.clock) return reached < run.decisions().size() ? std::optional(reached) : std::nullopt;
  return std::min(decisions_before(run, clock) + 1 + static_cast<std::size_t>(wanted.plan), reached);
}

std::size_t position_by_expansions(const Run& run, const Progress& wanted) {
  const auto decision = decision_at(run, wanted);
  if (!decision) return run.timeline().size();
  const std::size_t begin = begin_after(run, *decision);
  if (!wanted.begun) return begin;
  const std::size_t end =
      *decision == run.decisions().size() ? run.timeline().size() : run.decisions()[*decision].event;
  // If nothing but a step of the robot follows the decision, the plan stands and the step is still to come.
  const bool searches = *decision == 0 || next_iteration(run, begin, end) < end;
  if (!searches || clock_after(run, *decision) < wanted.clock) return begin;
  return next_iteration(run, behind_expansions(run, begin, end, wanted.expansions), end);
}

std::size_t position_by_moves(const Run& run, const Progress& wanted) {
  if (wanted.clock < 0 && !wanted.begun) return 0;
  if (wanted.clock < 0)
    return run.decisions().empty() ? run.timeline().size() : run.decisions().front().event;
  const auto decision = decision_at(run, wanted);
  if (!decision) return run.timeline().size();
  return begin_after(run, decisions_before(run, clock_after(run, *decision) + 1));
}

/// What a run has to go on to before its position at `wanted` is final.
std::optional<Target> lacking_for(const Run& run, const Progress& wanted, Lockstep by) {
  if (run.over()) return std::nullopt;
  const std::int64_t clock = run.decisions().empty() ? -1 : run.decisions().back().clock;
  if (wanted.clock < 0) {
    const bool at_start = !wanted.begun;
    return clock >= 0 || at_start ? std::nullopt : std::optional(Target::plan());
  }
  const bool at_decision = by == Lockstep::expansions && wanted.plan == 0 && !wanted.begun;
  if (clock >= wanted.clock + (at_decision ? 0 : 1)) return std::nullopt;
  return Target::clock_at(wanted.clock + kAhead);
}

/// As many expansions, and as many steps of the robot since the last of them.
Standing standing_in_race(const Run& leader, const Run& run) {
  const std::size_t cursor = leader.timeline().cursor(), size = run.timeline().size();
  if (cursor == 0) return {0};
  const std::int64_t count = expansions_until(leader, cursor);
  const std::size_t leader_behind = behind_expansions(leader, 0, cursor, count);
  const std::int64_t steps = clock_after(leader, decisions_until(leader, cursor)) -
                             clock_after(leader, decisions_until(leader, leader_behind));
  Standing standing{size};
  if (expansions_until(run, size) >= count) {
    const std::size_t behind = behind_expansions(run, 0, size, count);
    const std::int64_t clock = clock_after(run, decisions_until(run, behind)) + steps;
    const auto decisions = run.decisions();
    const auto decision = std::partition_point(decisions.begin(), decisions.end(), [&](const Decision& each) {
      return each.event < behind || each.clock < clock;
    });
    standing.position = next_iteration(run, behind, decision == decisions.end() ? size : decision->event);
  }
  if (standing.position == size && !run.over()) standing.lacking = Target::end();
  return standing;
}

}  // namespace

Progress progress(const Run& run, std::size_t position) {
  const std::size_t decisions = decisions_until(run, position);
  const std::int64_t clock = clock_after(run, decisions);
  const std::size_t begin = begin_after(run, decisions);
  const std::size_t first = clock < 0 ? 0 : decisions_before(run, clock) + 1;
  return {clock, static_cast<std::int64_t>(decisions - first), expansions_between(run, begin, position),
          position > begin};
}

std::int64_t expansions_between(const Run& run, std::size_t from, std::size_t to) {
  return walk(run, from, to, std::numeric_limits<std::int64_t>::max()).expansions;
}

std::int64_t expansions_until(const Run& run, std::size_t position) {
  return expansions_between(run, 0, position);
}

Standing standing_beside(const Run& leader, const Run& follower, Lockstep by) {
  const std::size_t cursor = leader.timeline().cursor();
  if (leader.over() && cursor == leader.timeline().size()) {
    const std::size_t end = follower.timeline().size();
    return follower.over() ? Standing{end} : Standing{end, Target::end()};
  }
  if (by == Lockstep::race) return standing_in_race(leader, follower);
  const Progress wanted = progress(leader, cursor);
  const std::size_t position =
      by == Lockstep::moves ? position_by_moves(follower, wanted) : position_by_expansions(follower, wanted);
  return {position, lacking_for(follower, wanted, by)};
}

}  // namespace replan
