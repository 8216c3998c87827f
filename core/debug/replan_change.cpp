#include "core/debug/replan_change.hpp"

#include <algorithm>

namespace replan {
namespace {

/// What a robot that learns writes down, and that another plan is to begin.
constexpr KindSet kLearning{EventKind::sensed, EventKind::forgotten, EventKind::known, EventKind::scalar,
                            EventKind::aim};

ChangeKind kind_of(const Event& event, const SearchState& state, const SharedBytes& drawn) {
  if (event.kind == EventKind::forgotten) return ChangeKind::forgotten;
  if (event.delta == 0) return ChangeKind::free;
  if (state.moving(event.node)) return ChangeKind::moving;
  return drawn[event.node] == 0 ? ChangeKind::surprise : ChangeKind::wall;
}

}  // namespace

std::vector<ChangedCell> changes_before(const LogView& view, std::size_t begin, const SharedBytes& drawn,
                                        std::size_t most) {
  const SearchState state = view.log.state_at(begin);
  std::vector<ChangedCell> changed;
  for (std::size_t i = begin; i-- > 0 && kLearning.has(view.log.event(i).kind) && changed.size() < most;) {
    const Event event = view.log.event(i);
    if (event.kind == EventKind::sensed || event.kind == EventKind::forgotten)
      changed.push_back({event.node, kind_of(event, state, drawn)});
  }
  std::reverse(changed.begin(), changed.end());
  return changed;
}

}  // namespace replan
