#include "core/scene/digest.hpp"

#include <algorithm>
#include <utility>

namespace replan {

void RunDigest::read(const Run& run) {
  const Timeline& log = run.timeline();
  if (run.log_id() != log_id_) {
    if (const std::size_t common = run.common_with(log_id_); common > 0) {
      forget_from(run, common);
    } else {
      *this = RunDigest();
      incremental_ = run.info().incremental;
      keeps_start_ = run.info().keeps_start;
      stamps_ = PagedArray<std::uint32_t>(run.lattice().node_count());
    }
    log_id_ = run.log_id();
  }
  for (; read_ < log.size(); ++read_) {
    if (read_ % kStride == 0) counters_.push_back(counter_);
    take(log.event(read_), read_);
  }
}

// A log is cut between two decisions of the robot, so that no plan is under way at `position`.
void RunDigest::forget_from(const Run& run, std::size_t position) {
  if (position >= read_) return;
  counter_ = counter_at(run, position);
  read_ = position;
  counters_.resize((position + kStride - 1) / kStride);
  const auto later = [position](const MapEvent& event) { return event.event >= position; };
  map_events_.erase(std::find_if(map_events_.begin(), map_events_.end(), later), map_events_.end());
  plans_.erase(plans_.begin() + static_cast<std::ptrdiff_t>(plans_before(position)), plans_.end());
  touches_.resize(plans_.empty() ? 0 : plans_.back().last_touch);
  cause_ = {};
}

// A planner that starts every replan afresh wipes its values on the record before its first pop, and so does
// any other when the goal has moved; that is no work of the search and touches nothing.
void RunDigest::take(const Event& event, std::size_t index) {
  const bool expansion = counter_.take(event);
  switch (event.kind) {
    case EventKind::known:
    case EventKind::truth:
      map_events_.push_back({index, event.node, event.kind});
      break;
    case EventKind::sensed:
      ++(event.delta != 0 ? cause_.blocked : cause_.freed);
      break;
    case EventKind::forgotten:
      ++cause_.forgotten;
      break;
    case EventKind::new_goal:
      cause_.new_goal = true;
      break;
    case EventKind::put_down:
      cause_.put_down = true;
      break;
    case EventKind::aim:
      (event.delta != 0 ? cause_.to_goal_again : cause_.to_nearest) = true;
      break;
    case EventKind::plan_begin:
      cause_.new_start = keeps_start_ && !plans_.empty() && plans_.back().start != event.node;
      plans_.push_back({.begin = index,
                        .start = event.node,
                        .first_touch = touches_.size(),
                        .last_touch = touches_.size(),
                        .cause = std::exchange(cause_, {})});
      ++stamp_;
      break;
    case EventKind::plan_end:
      if (!plans_.empty()) plans_.back().end = index + 1;
      break;
    case EventKind::visit:
      if (expansion) touch(event.node, index);
      break;
    case EventKind::g:
    case EventKind::rhs:
      if (counter_.expands() || (incremental_ && !starts_afresh())) touch(event.node, index);
      break;
    default:
      break;
  }
}

void RunDigest::touch(NodeId node, std::size_t index) {
  if (plans_.empty()) return;
  if (stamps_[node] == stamp_) return;
  stamps_.at(node) = stamp_;
  PlanSpan& plan = plans_.back();
  ++plan.touched;
  // The first plan may touch millions of vertices; nobody asks for more than their number.
  if (plans_.size() == 1) return;
  touches_.push_back({index, node});
  plan.last_touch = touches_.size();
}

std::size_t RunDigest::plans_before(std::size_t position) const {
  const auto after = std::partition_point(plans_.begin(), plans_.end(),
                                          [position](const PlanSpan& plan) { return plan.begin < position; });
  return static_cast<std::size_t>(after - plans_.begin());
}

std::span<const Touch> RunDigest::touches_before(const PlanSpan& plan, std::size_t position) const {
  const std::span<const Touch> all(touches_.data() + plan.first_touch, plan.last_touch - plan.first_touch);
  const auto after = std::partition_point(all.begin(), all.end(),
                                          [position](const Touch& touch) { return touch.event < position; });
  return all.first(static_cast<std::size_t>(after - all.begin()));
}

ExpansionCounter RunDigest::counter_at(const Run& run, std::size_t position) const {
  position = std::min(position, read_);
  if (position == read_) return counter_;
  ExpansionCounter counter = counters_[position / kStride];
  for (std::size_t i = position / kStride * kStride; i < position; ++i) counter.take(run.timeline().event(i));
  return counter;
}

}  // namespace replan
