#include "core/session/reexecution.hpp"

#include <algorithm>
#include <cassert>
#include <span>

namespace replan {

std::vector<Event> Reexecution::events(std::size_t position, const KeyFrame& frame, std::size_t from,
                                       std::size_t to) {
  if (!mission_ || from < begin_ || position > end()) take_up(position, frame);
  while (end() < to) {
    const bool more = mission_->advance(iterations_);
    const std::span<const Event> fresh = recorder_.buffer();
    ahead_.insert(ahead_.end(), fresh.begin(), fresh.end());
    recorder_.clear();
    if (end() <= from) drop(ahead_.size());  // only on the way there
    assert(more || end() >= to);
    if (!more) break;
  }
  drop(std::min(from - begin_, ahead_.size()));
  const std::size_t count = std::min(to - from, ahead_.size());
  std::vector<Event> found(ahead_.begin(), ahead_.begin() + static_cast<std::ptrdiff_t>(count));
  drop(count);
  found.resize(to - from);
  return found;
}

void Reexecution::drop(std::size_t count) {
  ahead_.erase(ahead_.begin(), ahead_.begin() + static_cast<std::ptrdiff_t>(count));
  begin_ += count;
}

void Reexecution::take_up(std::size_t position, const KeyFrame& frame) {
  recorder_ = {};
  ahead_.clear();
  begin_ = position;
  if (!mission_ || !frame.checkpoint)
    mission_ = make_mission(*scenario_, scenario_->planners[planner_], &recorder_);
  if (!frame.checkpoint) return;
  mission_->restore(*frame.checkpoint, frame.state);
  recorder_.line(frame.checkpoint->line);
}

}  // namespace replan
