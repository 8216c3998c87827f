#include "core/scene/overlay.hpp"

namespace replan {

OverlayKind overlay_rhs() {
  return {.info = {.label = "rhs",
                   .help = "One step of lookahead: the best neighbour's g plus the way to it.",
                   .key = '2'},
          .field = FieldReader{.kind = EventKind::rhs}};
}

}  // namespace replan
