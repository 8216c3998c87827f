#include "core/scene/open_cells.hpp"

#include <algorithm>

namespace replan {

void OpenCells::scan(const SearchState& state, std::size_t first, std::size_t end,
                     std::vector<NodeId>& waiting) {
  ++scanned_;
  waiting.clear();
  if (state.queue_size() == 0) return;
  for (; first < end; first += SearchState::kPage) {
    const std::uint64_t* page = state.page(EventKind::queue, static_cast<NodeId>(first));
    if (page == nullptr) continue;
    const std::size_t count = std::min(SearchState::kPage, end - first);
    for (std::size_t i = 0; i < count; ++i)
      if (page[i] != 0) waiting.push_back(static_cast<NodeId>(first + i));
  }
}

void OpenCells::follow(const Run& run, const Deadline& deadline) {
  const Timeline& log = run.timeline();
  const SearchState& state = log.state();
  if (stale_.follow({log, run.log_id(), log.cursor(), state.node_count()}, {EventKind::queue}))
    stretches_.assign(stale_.count(), {});
  stale_.refresh(deadline, [&](std::size_t stretch, std::size_t first, std::size_t end) {
    scan(state, first, end, stretches_[stretch]);
  });
}

}  // namespace replan
