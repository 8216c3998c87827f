// The kinds of robots, made from robots/robots.def.
#include "core/plan/named.hpp"
#include "core/sim/mission.hpp"
#include "core/world/choices.hpp"

#define REPLAN_ROBOT_HEADERS
#include "core/robots/robots.def"
#undef REPLAN_ROBOT_HEADERS

namespace replan {
namespace {

template <class Robot>
RobotInfo entry(std::string_view id) {
  RobotInfo info = Robot::describe();
  info.id = id;
  return info;
}

/// The mission of the scenario's own robot with a planner that searches.
std::unique_ptr<Mission> mission_of_kind(const Scenario& scenario, const PlannerChoice& planner,
                                         Recorder* recorder) {
#define REPLAN_ROBOT(ID, CLASS) \
  if (scenario.robot.kind == ID) return std::make_unique<CLASS>(scenario, planner, recorder);
#include "core/robots/robots.def"
#undef REPLAN_ROBOT
  return nullptr;
}

}  // namespace

std::span<const RobotInfo> robots() {
  static const std::vector<RobotInfo> all = {
#define REPLAN_ROBOT(ID, CLASS) entry<CLASS>(ID),
#include "core/robots/robots.def"
#undef REPLAN_ROBOT
  };
  return all;
}

std::unique_ptr<Mission> make_mission(const Scenario& scenario, const PlannerChoice& choice,
                                      Recorder* recorder) {
  const Resolved run = resolved(choice, scenario.robot);
  if (run.robot == scenario.robot) return mission_of_kind(scenario, run.planner, recorder);
  Scenario own = scenario;
  own.robot = run.robot;
  return mission_of_kind(own, run.planner, recorder);
}

const RobotInfo* find_robot(std::string_view id) {
  return find_by_id(robots(), id);
}

Result<const RobotInfo*> require_robot(std::string_view id) {
  return require_by_id(robots(), id, "robot");
}

Result<const RobotInfo*> require_robot(std::string_view id, const Box& world) {
  Result<const RobotInfo*> known = require_robot(id);
  if (!known || !(*known)->planar || !world.solid()) return known;
  return Error{"robot '" + std::string(id) + "' drives in a plane, and this world has " +
               std::to_string(world.depth()) + " layers: choose '" + std::string(robots().front().id) + "'"};
}

}  // namespace replan
