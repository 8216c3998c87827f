#include "core/scene/overlay.hpp"

namespace replan {

OverlayKind overlay_dist() {
  return {.info = {.label = "dist (penalty)",
                   .help = "The penalty that a cell costs for lying near an obstacle.",
                   .key = '3'},
          .field = FieldReader{.kind = EventKind::dist, .none = 0}};
}

}  // namespace replan
