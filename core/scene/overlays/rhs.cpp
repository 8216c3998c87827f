#include "core/scene/overlay.hpp"

namespace replan {
namespace {

std::string rhs_words(const PlannerInfo& planner) {
  return planner.from_goal ? "rhs: cost to the goal, one step ahead"
                           : "rhs: cost from the start, one step ahead";
}

}  // namespace

OverlayKind overlay_rhs() {
  return {.info = {.label = "rhs",
                   .help = "One step of lookahead: the best neighbour's g plus the way to it.",
                   .key = '2'},
          .field = FieldReader{.kind = EventKind::rhs},
          .words = rhs_words};
}

}  // namespace replan
