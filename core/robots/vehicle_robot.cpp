#include "core/robots/vehicle_robot.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/trigonometry.hpp"

namespace replan {
namespace {

const Parameter kTurnRate{.key = "turn_rate",
                          .label = "Turn rate",
                          .type = ParameterType::real,
                          .initial = 45,
                          .low = 1,
                          .high = 3600,
                          .unit = "°/s",
                          .choices = {},
                          .help = "How fast its course can turn, under way and on the spot."};
const Parameter kClimbRate{.key = "climb_rate",
                           .label = "Climb rate",
                           .type = ParameterType::real,
                           .initial = 2,
                           .low = 0.01,
                           .high = 1000,
                           .unit = "cells/s",
                           .choices = {},
                           .help = "How fast it can rise and sink. In a world of one layer it does neither."};
const Parameter kCorner{
    .key = "corner",
    .label = "Sharpest turn under way",
    .type = ParameterType::real,
    .initial = 30,
    .low = 0,
    .high = 180,
    .unit = "°",
    .choices = {},
    .help = "Where its course changes by more from one cell to the next, it stops and turns on the spot."};

constexpr double kDegree = kPi / 180;

SimTime sim_time(double seconds) {
  return std::llround(static_cast<double>(kSecond) * seconds);
}

}  // namespace

RobotInfo VehicleRobot::describe() {
  return {
      .name = "Vehicle",
      .summary =
          "Keeps to its plan, turns and climbs no faster than it can, and stops to turn at sharp corners.",
      .parameters = {kTurnRate, kClimbRate, kCorner}};
}

VehicleRobot::VehicleRobot(const Scenario& scenario, const PlannerChoice& choice, Recorder* recorder)
    : Mission(scenario, choice, recorder),
      turn_rate_(scenario.robot.settings.get(kTurnRate) * kDegree),
      climb_rate_(scenario.robot.settings.get(kClimbRate)),
      corner_(scenario.robot.settings.get(kCorner) * kDegree) {
  moment().figures.spot_turns.emplace();
}

void VehicleRobot::move() {
  const std::size_t next = moment().next;
  if (next >= route().points.size()) return step_along(1);
  const Point to = route().points[next];
  const Course ahead = course_towards(moment().at, to);
  // Where the path turns within a cell, its next place may be where the vehicle is.
  const double angle = ahead.none() ? 0 : angle_between(moment().course, ahead);
  if (angle > corner_ + Cone::kSlack) return turn_on_the_spot(ahead, time_to_turn(angle));
  const double way = route().along[next] - moment().along_plan;
  step_along(1, std::max(time_to_turn(angle), time_to_go(to, way)));
}

SimTime VehicleRobot::time_to_turn(double angle) const {
  return sim_time(angle / turn_rate_);
}

SimTime VehicleRobot::time_to_go(const Point& to, double way) const {
  return sim_time(std::max(way / setup().speed, std::abs(to.z - now().at.z) / climb_rate_));
}

}  // namespace replan
