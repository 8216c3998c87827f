#include "core/robots/drive_sense.hpp"

#include <cmath>

#include "core/drive/sample_grid.hpp"
#include "core/robots/dwa_robot.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

/// The robot's map at a moment of its log.
struct MapAt {
  const SearchState& state;
  bool operator[](NodeId node) const { return state.known_blocked(node); }
};

}  // namespace

DriveSense::DriveSense(const Scenario& scenario, const RobotSetup& robot)
    : frame_{scenario.map.box(), scenario.map.resolution},
      settings_(drive_settings(robot.settings)),
      radius_(robot.radius),
      near_(std::max(robot.settings.get(DwaRobot::near_parameter()), frame_.side / 2)),
      heading_(-robot.settings.get(DwaRobot::heading_parameter()) * kPi / 180),
      mapped_(initial_knowledge(scenario)) {
  settings_.limits.radius = radius_ * frame_.side;
}

/// A robot that is too fast to turn to its sub-goal drives round it for ever: the arc that leads there from its heading
/// has the radius d^2 / (2 |across|), and a sub-goal behind it is turned to on the spot.
DriveSettings DriveSense::settings_towards(const DriveState& state, Spot goal) const {
  const auto [sine, cosine] = sine_cosine(state.pose.heading);
  const double x = goal.x - state.pose.x, y = goal.y - state.pose.y;
  const double along = cosine * x + sine * y, across = std::abs(cosine * y - sine * x);
  DriveSettings settings = settings_;
  DriveLimits& limits = settings.limits;
  double most = limits.v_max;
  if (along <= 0)
    most = 0;
  else if (across > 0)
    most = std::min(most, limits.w_max * (along * along + across * across) / (2 * across));
  limits.v_max = std::max({most, limits.v_min, state.motion.v - limits.brake * settings.period});
  return settings;
}

DriveState DriveSense::first_state(Cell cell) const {
  const Spot middle = frame_.centre(cell);
  return {.pose = {middle.x, middle.y, heading_}, .motion = {}, .turned = 0};
}

std::vector<Spot> DriveSense::nodes_of(const Path& path) const {
  std::vector<Spot> nodes;
  for (std::size_t i = 0; i < path.size(); ++i)
    nodes.push_back({path.point(i).x * frame_.side, path.point(i).y * frame_.side});
  return nodes;
}

/// Squares so far outside the map that a robot which keeps away from them keeps its centre on the map, a centimetre from
/// its edge.
void DriveSense::add_edge(std::vector<Spot>& walls, Spot at) const {
  const double inside = std::min(0.01, frame_.side / 4);
  const double away = settings_.limits.radius + settings_.margin - inside, half = frame_.side / 2,
               far = reach();
  const double right = frame_.box.width() * frame_.side, bottom = frame_.box.height() * frame_.side;
  const auto each = [&](double middle, double most, auto&& add) {
    const double first = std::max(-away, middle - far), last = std::min(most + away, middle + far);
    for (double along = first; along <= last + frame_.side; along += frame_.side) add(along);
  };
  each(at.x, right, [&](double x) {
    if (at.y < far) walls.push_back({x, -away - half});
    if (bottom - at.y < far) walls.push_back({x, bottom + away + half});
  });
  each(at.y, bottom, [&](double y) {
    if (at.x < far) walls.push_back({-away - half, y});
    if (right - at.x < far) walls.push_back({right + away + half, y});
  });
}

std::optional<DriveWhy> why_it_drives(const Scenario& scenario, const PlannerChoice& choice,
                                      const Decision& decision, const SearchState& state) {
  const Path& path = *decision.plan->path;
  if (!drives(scenario, choice) || path.empty()) return std::nullopt;
  const DriveSense sense(scenario, resolved(choice, scenario.robot).robot);
  const MapAt known{state};
  const Cell cell = sense.frame().box.position(state.node(Scalar::robot));
  const DriveState now = decision.drive.begun ? decision.drive.state : sense.first_state(cell);
  const std::vector<Spot> nodes = sense.nodes_of(path);
  const Spot goal = nodes[sense.sub_goal(nodes, decision.drive.sub_goal, now.pose.spot(), known)];
  DriveWhy why{now,
               goal,
               sense.frame(),
               sense.obstacles(now, known),
               sense.settings_towards(now, goal),
               sense.settings().limits,
               {}};
  why.strayed = !info_of(choice).blind && sense.has_strayed(decision, now.pose.spot(), goal, known);
  why.explanation = explain(now, why.obstacles, goal, why.settings);
  return why;
}

DriveSample sample_of(const DriveWhy& why, const Twist& motion) {
  const SampleGrid grid(why.explanation, why.settings);
  if (const auto nearest = grid.nearest(why.explanation, motion)) return why.explanation.samples[*nearest];
  DriveSample sample = assess(why.state, why.obstacles, why.goal, why.settings, motion);
  // What the motors could do well, but not on the way to this sub-goal.
  DriveSettings own = why.settings;
  own.limits = why.limits;
  if (dynamic_window(why.state.motion, own).contains(motion) && motion.v > why.explanation.window.v_high)
    sample.rejection = Rejection::circles;
  return sample;
}

bool drives(const Scenario& scenario, const PlannerChoice& choice) {
  const RobotInfo* robot = find_robot(resolved(choice, scenario.robot).robot.kind);
  return robot != nullptr && robot->drives;
}

bool drives(const Scenario& scenario) {
  return std::any_of(scenario.planners.begin(), scenario.planners.end(),
                     [&](const PlannerChoice& each) { return drives(scenario, each); });
}

}  // namespace replan
