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
    if (end() <= from) drop(end() - begin_);  // only on the way there
    assert(more || end() >= to);
    if (!more) break;
  }
  drop(std::min(from, end()) - begin_);
  const std::size_t count = std::min(to, end()) - begin_;
  const auto first = ahead_.begin() + static_cast<std::ptrdiff_t>(used_);
  std::vector<Event> found(first, first + static_cast<std::ptrdiff_t>(count));
  drop(count);
  found.resize(to - from);
  return found;
}

/// A search that is set up writes millions of events in one go, of which a few are asked for at a time: those that are
/// used up go only when they are half of what lies there, so that each is moved about once.
void Reexecution::drop(std::size_t count) {
  begin_ += count;
  used_ += count;
  if (used_ * 2 < ahead_.size()) return;
  ahead_.erase(ahead_.begin(), ahead_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ = 0;
}

void Reexecution::take_up(std::size_t position, const KeyFrame& frame) {
  recorder_ = {};
  ahead_.clear();
  used_ = 0;
  begin_ = position;
  if (!mission_ || !frame.checkpoint)
    mission_ = make_mission(*scenario_, scenario_->planners[planner_], &recorder_);
  if (!frame.checkpoint) return;
  mission_->restore(*frame.checkpoint, frame.state);
  recorder_.line(frame.checkpoint->line);
}

}  // namespace replan
