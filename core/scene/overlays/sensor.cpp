#include "core/scene/overlay.hpp"
#include "core/scene/routes.hpp"
#include "core/scene/solid_pen.hpp"

namespace replan {
namespace {

/// A ball, as the circles in which the three planes through its middle cut it.
void sensor_in_space(SolidPen& pen) {
  const RobotSetup& robot = pen.context().run.scenario().robot;
  if (robot.knowledge == Knowledge::all) return;
  pen.show(Sign::sensor);
  const Point at = robot_point(pen.context());
  const Colour colour = faded(pen.palette().robot, 0.6);
  constexpr Point kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};
  pen.ring(at, robot.sensor_radius, kX, kY, colour);
  pen.ring(at, robot.sensor_radius, kX, kZ, colour);
  pen.ring(at, robot.sensor_radius, kY, kZ, colour);
}

}  // namespace

/// Its shapes on a slice are in core/scene/routes.cpp.
OverlayKind overlay_sensor() {
  return {.info = {.label = "sensor", .help = "How far the robot senses.", .at_first = true},
          .layer = Layer::routes,
          .draw_in_space = sensor_in_space};
}

}  // namespace replan
