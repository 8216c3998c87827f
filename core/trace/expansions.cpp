#include "core/trace/expansions.hpp"

namespace replan {

ExpansionCounter::ExpansionCounter(const Timeline& log, std::size_t position) {
  while (position-- > 0)
    if (const auto expands = expands_from(log.event(position).kind)) {
      expands_ = *expands;
      return;
    }
}

bool ExpansionTeller::operator()(const Timeline& log, std::size_t index) {
  if (log.event(index).kind != EventKind::visit) return false;
  if (index >= wipe_begin_ && index < wipe_end_) return false;
  // An expansion's vertex was taken a few events ago.
  for (std::size_t i = index; i > 0; --i) {
    if (i == wipe_end_) {
      wipe_end_ = index + 1;
      return false;
    }
    const auto expands = expands_from(log.event(i - 1).kind);
    if (!expands) continue;
    if (*expands) return true;
    wipe_begin_ = i - 1;
    wipe_end_ = index + 1;
    return false;
  }
  return false;
}

}  // namespace replan
