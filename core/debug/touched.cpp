#include "core/debug/touched.hpp"

#include <algorithm>

namespace replan {
namespace {

/// Events between two looks at the clock.
constexpr std::size_t kSlice = 4096;

/// Whether the goal moved between the plan before and this one, or the robot makes for another cell: it then
/// starts afresh. So does a planner whose values are distances from the start once that is another one.
bool starts_afresh(const LogView& view, std::size_t begin) {
  const Timeline& log = view.log;
  const NodeId start = log.event(begin).node;
  bool same_goal = false;
  for (std::size_t i = begin; i-- > 0;) {
    const Event event = log.event(i);
    if (!same_goal && (event.kind == EventKind::new_goal || event.kind == EventKind::aim)) return true;
    same_goal |= event.kind == EventKind::plan_end;
    if (same_goal && !view.info.keeps_start) return false;
    if (event.kind == EventKind::plan_begin) return event.node != start;
  }
  return false;
}

}  // namespace

void TouchedList::start(const LogView& view) {
  list_.clear();
  places_ = PagedArray<std::uint32_t>(view.lattice.node_count());
  before_ = now_ = view.log.state_at(begin_);
  repairs_ = view.info.incremental && !starts_afresh(view, begin_);
  counter_ = {};
  read_ = begin_;
}

void TouchedList::follow(const LogView& view, std::uint64_t log_id, std::size_t begin, std::size_t end,
                         const Deadline& deadline) {
  if (log_id != log_id_ || begin != begin_ || end < read_) {
    log_id_ = log_id;
    begin_ = begin;
    start(view);
  }
  while (read_ < end) {
    for (const Event& event : view.log.peek(read_, std::min(end, read_ + kSlice))) take(event, read_++);
    if (deadline.passed()) break;
  }
  behind_ = read_ < end;
}

void TouchedList::take(const Event& event, std::size_t index) {
  const bool expansion = counter_.take(event);
  switch (event.kind) {
    case EventKind::visit:
      if (expansion) ++touched(event.node, index).expanded;
      break;
    case EventKind::epoch:
      now_.apply(event);  // no work of its own, but part of the values
      break;
    case EventKind::g:
    case EventKind::rhs:
      now_.apply(event);
      if (!repairs_ && !counter_.expands()) break;
      touched(event.node, index).g_after = now_.g(event.node);
      touched(event.node, index).rhs_after = now_.rhs(event.node);
      break;
    default:
      break;
  }
}

Touched& TouchedList::touched(NodeId node, std::size_t index) {
  if (places_[node] == 0) {
    list_.push_back({node, index, before_.g(node), now_.g(node), before_.rhs(node), now_.rhs(node), 0});
    places_.at(node) = static_cast<std::uint32_t>(list_.size());
  }
  return list_[places_[node] - 1];
}

const Touched* TouchedList::find(NodeId node) const {
  if (node >= places_.size() || places_[node] == 0) return nullptr;
  return &list_[places_[node] - 1];
}

}  // namespace replan
