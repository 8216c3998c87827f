#include "core/debug/expansions.hpp"

namespace replan {

bool ExpansionTeller::operator()(const Timeline& log, std::size_t index) {
  if (log.event(index).kind != EventKind::visit) return false;
  if (index >= wipe_begin_ && index < wipe_end_) return false;
  // An expansion's vertex was taken a few events ago.
  for (std::size_t i = index; i > 0; --i) {
    if (i == wipe_end_) {
      wipe_end_ = index + 1;
      return false;
    }
    const EventKind kind = log.event(i - 1).kind;
    if (kind == EventKind::pop) return true;
    if (kind == EventKind::plan_begin) {
      wipe_begin_ = i - 1;
      wipe_end_ = index + 1;
      return false;
    }
  }
  return false;
}

}  // namespace replan
