#include "core/scene/open_cells.hpp"

#include <algorithm>

namespace replan {

void OpenCells::scan(const SearchState& state, std::size_t stretch) {
  ++scanned_;
  std::vector<NodeId>& waiting = stretches_[stretch];
  waiting.clear();
  const std::size_t end = std::min((stretch + 1) * kStretch, state.node_count());
  for (std::size_t first = stretch * kStretch; first < end; first += SearchState::kPage) {
    const std::uint64_t* page = state.page(EventKind::queue, static_cast<NodeId>(first));
    if (page == nullptr) continue;
    const std::size_t count = std::min(SearchState::kPage, end - first);
    for (std::size_t i = 0; i < count; ++i)
      if (page[i] != 0) waiting.push_back(static_cast<NodeId>(first + i));
  }
}

void OpenCells::scan_all(const SearchState& state) {
  stretches_.assign((state.node_count() + kStretch - 1) / kStretch, {});
  if (state.queue_size() == 0) return;
  for (std::size_t stretch = 0; stretch < stretches_.size(); ++stretch) scan(state, stretch);
}

void OpenCells::scan_written(const Timeline& log, std::size_t from, std::size_t to) {
  std::vector<bool> written(stretches_.size());
  for (std::size_t at = from; at < to;) {
    const std::span<const Event> events = log.peek(at, to);
    for (const Event& event : events)
      if (event.kind == EventKind::queue) written[event.node / kStretch] = true;
    at += events.size();
  }
  for (std::size_t stretch = 0; stretch < stretches_.size(); ++stretch)
    if (written[stretch]) scan(log.state(), stretch);
}

void OpenCells::follow(const Run& run) {
  const Timeline& log = run.timeline();
  const SearchState& state = log.state();
  const std::size_t from = std::min(position_, log.cursor()), to = std::max(position_, log.cursor());
  const bool other_log =
      log_id_ != run.log_id() || stretches_.size() != (state.node_count() + kStretch - 1) / kStretch;
  // Beyond that many events it is cheaper to look at all cells than to find those that were written.
  const bool leap = to - from > state.node_count() / 32;
  if (other_log || leap || !log.reversible(from, to))
    scan_all(state);
  else
    scan_written(log, from, to);
  log_id_ = run.log_id();
  position_ = log.cursor();
}

}  // namespace replan
