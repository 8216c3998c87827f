#include "core/scene/overlay.hpp"

namespace replan {

OverlayKind overlay_key() {
  return {.info = {.label = "key (k1)",
                   .help = "The first key component of the cells in the open list: the smallest comes next."},
          .field = FieldReader{.kind = EventKind::queue, .offset = 1}};
}

}  // namespace replan
