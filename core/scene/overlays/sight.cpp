#include "core/scene/overlay.hpp"
#include "core/scene/routes.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

void sight_in_space(SolidPen& pen) {
  for (const SightCheck& check : sight_checks(pen.context())) {
    pen.show(check.free ? Sign::sight_free : Sign::sight_stopped);
    pen.line(check.from, check.to, check.free ? pen.palette().good : pen.palette().bad, 1.6f);
  }
}

}  // namespace

/// Its shapes on a slice are in core/scene/routes.cpp.
OverlayKind overlay_sight() {
  return {.info = {.label = "sight lines",
                   .help = "The sight checks of the current expansion: free, or stopped by an obstacle."},
          .layer = Layer::routes,
          .draw_in_space = sight_in_space};
}

}  // namespace replan
