#include "core/scene/open_cells.hpp"

#include <algorithm>

namespace replan {

void OpenCells::scan(const SearchState& state, std::size_t stretch) {
  ++scanned_;
  --waiting_;
  stretches_[stretch].stale = false;
  std::vector<NodeId>& waiting = stretches_[stretch].waiting;
  waiting.clear();
  if (state.queue_size() == 0) return;
  const std::size_t end = std::min((stretch + 1) * kStretch, state.node_count());
  for (std::size_t first = stretch * kStretch; first < end; first += SearchState::kPage) {
    const std::uint64_t* page = state.page(EventKind::queue, static_cast<NodeId>(first));
    if (page == nullptr) continue;
    const std::size_t count = std::min(SearchState::kPage, end - first);
    for (std::size_t i = 0; i < count; ++i)
      if (page[i] != 0) waiting.push_back(static_cast<NodeId>(first + i));
  }
}

void OpenCells::mark(std::size_t stretch) {
  waiting_ += stretches_[stretch].stale ? 0 : 1;
  stretches_[stretch].stale = true;
}

void OpenCells::mark_all(std::size_t nodes) {
  stretches_.resize((nodes + kStretch - 1) / kStretch);
  for (Stretch& stretch : stretches_) stretch.stale = true;
  waiting_ = stretches_.size();
}

void OpenCells::mark_written(const Timeline& log, std::size_t from, std::size_t to) {
  for (std::size_t at = from; at < to;) {
    const std::span<const Event> events = log.peek(at, to);
    for (const Event& event : events)
      if (event.kind == EventKind::queue) mark(event.node / kStretch);
    at += events.size();
  }
}

void OpenCells::follow(const Run& run, const Deadline& deadline) {
  const Timeline& log = run.timeline();
  const SearchState& state = log.state();
  const std::size_t from = std::min(position_, log.cursor()), to = std::max(position_, log.cursor());
  const bool other_log =
      log_id_ != run.log_id() || stretches_.size() != (state.node_count() + kStretch - 1) / kStretch;
  // Beyond that many events it is cheaper to look at all cells than to find those that were written.
  const bool leap = to - from > state.node_count() / 32;
  if (other_log || leap || !log.reversible(from, to))
    mark_all(state.node_count());
  else
    mark_written(log, from, to);
  log_id_ = run.log_id();
  position_ = log.cursor();
  for (std::size_t stretch = 0; stretch < stretches_.size() && waiting_ > 0; ++stretch) {
    if (!stretches_[stretch].stale) continue;
    scan(state, stretch);
    if (deadline.passed()) return;
  }
}

}  // namespace replan
