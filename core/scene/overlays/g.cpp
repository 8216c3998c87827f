#include "core/scene/overlay.hpp"

namespace replan {

OverlayKind overlay_g() {
  return {.info = {.label = "g",
                   .help = "The cost to the goal that the search has settled (A*: from the start).",
                   .key = '1',
                   .at_first = true},
          .field = FieldReader{.kind = EventKind::g}};
}

}  // namespace replan
