#include "core/session/player.hpp"

#include "core/session/stepping.hpp"

namespace replan {

bool is_smooth(const Run& run) {
  const auto decisions = run.decisions();
  return run.scenario().robot.motion == Motion::smooth ||
         (!decisions.empty() && decisions.front().figures.kept);
}

/// How long playing shows what lies between two stops.
double Player::seconds_of(const Run& run, std::size_t from, std::size_t to) const {
  const double speed = state_.expansions_per_second;
  const EventKind kind = run.timeline().event(std::min(from, to)).kind;
  if (speed <= kReadableSpeed && is_before_repair(run, to)) return std::max(1 / speed, kRepairSeconds);
  if (kind != EventKind::move && kind != EventKind::waiting && kind != EventKind::turn)
    return speed < kFullSpeed ? 1 / speed : 0;
  const double step = 1 / std::min(speed, kMovesPerSecond);
  if (!is_smooth(run)) return step;
  const Decision *before = run.decision_at(std::min(from, to)), *after = run.decision_at(std::max(from, to));
  if (before == nullptr || after == nullptr) return step;
  const double driven = static_cast<double>(after->time - before->time) / static_cast<double>(kSecond);
  return std::min(driven, 1.0) / std::clamp(speed / kRealTimeSpeed, 0.125, 8.0);
}

Player::Shown Player::advance(const Run& run, double seconds) {
  owed_ = std::min(owed_ + seconds, 0.1);  // after a stall, go on instead of leaping
  std::size_t cursor = run.timeline().cursor();
  bool moves = forwards() && run.travel() < 1;
  int steps = 200000;  // of one frame, at full speed
  while (owed_ > 0 && steps-- > 0) {
    const bool at_end = forwards() ? cursor >= run.timeline().size() : cursor == 0;
    if (at_end) break;
    const std::size_t next = forwards() ? next_stop(run, cursor, StepUnit::expansion)
                                        : previous_stop(run, cursor, StepUnit::expansion);
    step_seconds_ = seconds_of(run, cursor, next);
    moves = run.timeline().event(std::min(cursor, next)).kind == EventKind::move;
    owed_ -= step_seconds_;
    cursor = next;
  }
  // A robot that drives smoothly is still on its way while time is owed to it.
  const bool smooth = is_smooth(run) && forwards() && moves;
  return {cursor, smooth && owed_ < 0 && step_seconds_ > 0 ? 1 + owed_ / step_seconds_ : 1};
}

}  // namespace replan
