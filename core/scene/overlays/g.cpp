#include "core/scene/overlay.hpp"

namespace replan {
namespace {

std::string g_words(const PlannerInfo& planner) {
  if (planner.values.waves) return "h: cost to the goal";
  return planner.from_goal ? "g: cost to the goal" : "g: cost from the start";
}

}  // namespace

OverlayKind overlay_g() {
  return {.info = {.label = "g",
                   .help = "The cost to the goal that the search has settled (A*: from the start).",
                   .key = '1',
                   .at_first = true},
          .field = FieldReader{.kind = EventKind::g},
          .words = g_words};
}

}  // namespace replan
