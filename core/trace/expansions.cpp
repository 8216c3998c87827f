#include "core/trace/expansions.hpp"

namespace replan {

ExpansionCounter::ExpansionCounter(const Timeline& log, std::size_t position) {
  while (position-- > 0)
    if (const auto expands = expands_from(log.event(position).kind)) {
      expands_ = *expands;
      return;
    }
}

}  // namespace replan
