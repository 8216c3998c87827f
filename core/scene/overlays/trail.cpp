#include "core/scene/overlay.hpp"

namespace replan {

/// Its shapes are in core/scene/routes.cpp.
OverlayKind overlay_trail() {
  return {.info = {.label = "trail", .help = "The way that the robot has driven.", .at_first = true},
          .layer = Layer::routes};
}

}  // namespace replan
