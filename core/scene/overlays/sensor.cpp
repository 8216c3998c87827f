#include "core/scene/overlay.hpp"

namespace replan {

/// Its shapes are in core/scene/routes.cpp.
OverlayKind overlay_sensor() {
  return {
      .info = {.label = "sensor", .help = "How far the robot senses, and to which side.", .at_first = true},
      .layer = Layer::routes};
}

}  // namespace replan
