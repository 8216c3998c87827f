#include "core/scene/overlay.hpp"

namespace replan {

OverlayKind overlay_order() {
  return {.info = {.label = "expansion order",
                   .help = "When each cell was last expanded: the wave that the search ran in.",
                   .key = '4'},
          .field = FieldReader{.kind = EventKind::visit, .mask = 0xFFFFFFFFu, .none = 0, .unit = 1}};
}

}  // namespace replan
