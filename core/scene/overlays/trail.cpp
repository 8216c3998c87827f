#include "core/scene/overlay.hpp"
#include "core/scene/routes.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

void trail_in_space(SolidPen& pen) {
  const std::vector<Point> points = trail_points(pen.context());
  if (points.size() < 2) return;
  pen.show(Sign::trail);
  pen.polyline(points, faded(pen.palette().robot, 0.8), 2);
}

}  // namespace

/// Its shapes on a slice are in core/scene/routes.cpp.
OverlayKind overlay_trail() {
  return {.info = {.label = "trail", .help = "The way that the robot has driven.", .at_first = true},
          .layer = Layer::routes,
          .draw_in_space = trail_in_space};
}

}  // namespace replan
