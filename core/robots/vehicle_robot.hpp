// A vehicle that keeps to its plan and turns, climbs and goes no faster than it can, as an underwater vehicle does.
//
//  Zhu X., Sun B. & Zhu D., "Three-dimensional dynamic path planning of AUV based on improved D* algorithm", Control
//  Engineering of China 28(4), 2021, doi 10.14107/j.cnki.kzgc.20190179
//
// The model, which the paper leaves open:
// - It keeps to its path, whatever the path is made of: cells, straight ways or a B-spline. A vehicle that overshot its
//   corners would sweep through cells that nobody has planned for, and would be as safe as luck has it; this one touches
//   nothing, because its plan touches nothing. What its limits cost it is time, and nothing but time.
// - Its course is the direction of the piece of its path that it is on. Under way it goes and turns at once, as fast as
//   the strictest of its speed, its turn rate and its climb rate lets it. Where the next piece leads off by more than
//   `corner` it stops and turns on the spot: a step by itself, after which it senses with its sonar where it then looks,
//   while time goes by for all that moves. So a path without corners is worth something: a curve is gone through without a
//   stop. (A sharp corner in the middle of a cell takes it as long, but within the step: it senses in cells alone.)
// - It sets out, and is put down, looking towards its goal.
// - A plan begins in the middle of the cell where it is and does not know its course: after a replan it may have to turn.
#pragma once

#include "core/sim/mission.hpp"

namespace replan {

class VehicleRobot final : public Mission {
 public:
  static RobotInfo describe();
  VehicleRobot(const Scenario& scenario, const PlannerChoice& choice, Recorder* recorder);

 private:
  /// What a step costs.
  struct Costs {
    double stops = 0;   // rad, all that it turns on the spot within the step
    double curves = 0;  // rad, all that it turns under way
    double climb = 0;   // cells, up and down
    std::int64_t corners = 0;
  };
  void move() override;
  [[nodiscard]] Course course_of(std::size_t piece) const;
  [[nodiscard]] Costs costs_of(const Route::Way& way) const;
  [[nodiscard]] bool stops_for(double angle) const;
  [[nodiscard]] SimTime time_to_turn(double angle) const;

  double turn_rate_;   // rad/s
  double climb_rate_;  // cells/s, up and down alike
  double corner_;      // rad
};

}  // namespace replan
