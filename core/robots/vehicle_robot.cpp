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
      .parameters = {kTurnRate, kClimbRate, kCorner},
      .own_pace = true};
}

VehicleRobot::VehicleRobot(const Scenario& scenario, const PlannerChoice& choice, Recorder* recorder)
    : Mission(scenario, choice, recorder),
      turn_rate_(scenario.robot.settings.get(kTurnRate) * kDegree),
      climb_rate_(scenario.robot.settings.get(kClimbRate)),
      corner_(scenario.robot.settings.get(kCorner) * kDegree) {
  moment().figures.kept.emplace();
}

void VehicleRobot::move() {
  const std::size_t next = now().next;
  if (next >= route().cells.size()) return step_along(1);  // which says that it goes round in a circle
  const Route::Way way = route().way_to(*plan().path, next, now().at);
  if (way.pieces.empty()) return step_along(1, 0);  // it is there already
  const Course ahead = course_of(way.pieces.front());
  const double angle = angle_between(now().course, ahead);
  if (stops_for(angle)) return turn_on_the_spot(ahead, time_to_turn(angle));
  const Costs costs = costs_of(way);
  const double length = route().along[next] - now().along_plan;
  const double going = std::max(length / setup().speed, costs.climb / climb_rate_);
  const double clearance = clearance_of(way.points, now().figures.kept->clearance);
  const std::int64_t moves = now().figures.moves;
  step_along(1, std::max(time_to_turn(costs.curves), sim_time(going)) + time_to_turn(costs.stops));
  if (now().figures.moves == moves) return;  // it could not go
  moment().course = course_of(way.pieces.back());
  KeptWay& kept = *moment().figures.kept;
  kept.stops += costs.corners;
  kept.turning += time_to_turn(costs.stops);
  kept.turned += costs.stops + costs.curves;
  kept.clearance = clearance;
}

/// On that piece of the plan's path.
Course VehicleRobot::course_of(std::size_t piece) const {
  return course_towards(plan().path->point(piece - 1), plan().path->point(piece));
}

VehicleRobot::Costs VehicleRobot::costs_of(const Route::Way& way) const {
  Costs costs;
  Course course = now().course;
  for (std::size_t i = 0; i < way.pieces.size(); ++i) {
    const Course next = course_of(way.pieces[i]);
    const double angle = angle_between(course, next);
    (stops_for(angle) ? costs.stops : costs.curves) += angle;
    costs.corners += stops_for(angle) ? 1 : 0;
    costs.climb += std::abs(way.points[i + 1].z - way.points[i].z);
    course = next;
  }
  return costs;
}

/// A course is made of differences of places: of a corner that is as sharp as it may be it may say a hair too much.
bool VehicleRobot::stops_for(double angle) const {
  return angle > corner_ + 1e-9;
}

SimTime VehicleRobot::time_to_turn(double angle) const {
  return sim_time(angle / turn_rate_);
}

}  // namespace replan
