// A robot with two driven wheels that follows its plan by the dynamic window approach (core/drive/dynamic_window.hpp).
//
//  Fox D., Burgard W. & Thrun S., "The dynamic window approach to collision avoidance", IEEE Robotics & Automation
//  Magazine 4(1), 1997, doi 10.1109/100.580977
//  Liu J., Xue L., Zhang H. & Liu Z., "Robot dynamic path planning based on improved A* and DWA algorithm" (Henan
//  University of Technology)
//
// What is settled here:
// - Each of its steps is a period of the drive: it decides, and keeps its speed and turn rate until the next.
// - The nodes of its plan are the sub-goals, taken in order: the next one when one is near, or when the way to the next
//   is free on the robot's map.
// - Known is what its map showed before it set out; what it has seen since is unknown to the plan of the paper, and has
//   the other weight. The plan is renewed whenever the map changes, as with every robot here.
// - It has arrived when it is in the goal's cell or within the tolerance. It stops for nothing else.
// - A robot that has lost sight of its sub-goal plans again from where it is.
// - A robot that has turned all the way round and found no arc plans again, once; then it says that it is stuck, as it
//   does when it has come no nearer to its goal for as long as its patience lasts.
// - Nothing that moves comes onto the way that it needs to stop in; a surprise may, and then it hits that.
// - The edge of the map holds its centre, not its body.
#pragma once

#include <memory>
#include <vector>

#include "core/robots/drive_sense.hpp"

namespace replan {

class DwaRobot final : public Mission {
 public:
  static RobotInfo describe();
  /// How near a node of its plan it makes for the next one, in metres.
  static const Parameter& near_parameter();
  /// Which way it looks when it sets out, in degrees.
  static const Parameter& heading_parameter();
  DwaRobot(const Scenario& scenario, const PlannerChoice& choice, Recorder* recorder);

 private:
  void move() override;
  bool stands() override;
  [[nodiscard]] std::vector<Point> stopping_way() const override;
  [[nodiscard]] bool is_at(NodeId cell) const override;

  void take_up_pose();
  [[nodiscard]] Spot sub_goal();
  [[nodiscard]] bool has_strayed(Spot goal);
  [[nodiscard]] bool comes_nearer(double to_go);
  void turn_round_in_vain();
  void keep(const Twist& motion);
  void tell(const DriveState& before) const;
  void tell_sub_goal();
  void tell(const DriveDecision& decision);
  void tell(Scalar scalar, std::uint64_t& told, std::uint64_t now) const;

  DriveSense sense_;
  double tolerance_;  // m, to the goal
  // The nodes of the plan in metres, made anew where the plan's path is another one.
  std::shared_ptr<const Path> path_;
  std::vector<Spot> nodes_;
};

}  // namespace replan
