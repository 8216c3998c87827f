#include "core/scene/overlay.hpp"

namespace replan {

OverlayKind overlay_times() {
  return {
      .info = {.label = "times expanded",
               .help = "How often each cell was expanded; a repair expands some again."},
      .field = FieldReader{.kind = EventKind::visit, .shift = 32, .mask = 0xFFFFFFFFu, .none = 0, .unit = 1}};
}

}  // namespace replan
