#include "core/scene/overlay.hpp"

namespace replan {

/// Its shapes are in core/scene/routes.cpp.
OverlayKind overlay_path() {
  return {.info = {.label = "path", .help = "The path of the latest plan.", .at_first = true},
          .layer = Layer::routes};
}

}  // namespace replan
