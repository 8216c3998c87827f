#include "core/scene/overlay.hpp"

namespace replan {

/// Its shapes are in core/scene/routes.cpp.
OverlayKind overlay_sight() {
  return {.info = {.label = "sight lines",
                   .help = "The sight checks of the current expansion: free, or stopped by an obstacle."},
          .layer = Layer::routes};
}

}  // namespace replan
