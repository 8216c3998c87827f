#include "core/scene/overlay.hpp"
#include "core/scene/routes.hpp"
#include "core/scene/solid_pen.hpp"
#include "core/scene/sonar.hpp"

namespace replan {
namespace {

/// A ball, as the circles in which the three planes through its middle cut it; or a cone.
void sensor_in_space(SolidPen& pen) {
  const RobotSetup& robot = pen.context().run.scenario().robot;
  if (robot.knowledge == Knowledge::all) return;
  pen.show(Sign::sensor);
  const SonarReach reach{robot_point(pen.context()), course_of_robot(pen.context()), robot.sensor_radius,
                         robot.sensor_angle};
  for (const std::vector<Point>& wire : wires_of(reach))
    pen.polyline(wire, faded(pen.palette().robot, 0.6), 1.2f);
}

}  // namespace

/// Its shapes on a slice are in core/scene/routes.cpp.
OverlayKind overlay_sensor() {
  return {
      .info = {.label = "sensor", .help = "How far the robot senses, and to which side.", .at_first = true},
      .layer = Layer::routes,
      .draw_in_space = sensor_in_space};
}

}  // namespace replan
