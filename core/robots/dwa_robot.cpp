#include "core/robots/dwa_robot.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/drive/sub_goals.hpp"
#include "core/sim/body.hpp"

namespace replan {
namespace {

/// It plans again after the first time that it turned round in vain, and gives up after so many.
constexpr int kMostTurnsInVain = 2;
/// Of its way in a period; a straight line between two of them differs from the arc by much less than a millimetre.
constexpr int kParts = 10;

const Parameter kHeading{.key = "heading",
                         .label = "First heading",
                         .type = ParameterType::real,
                         .low = -180,
                         .high = 180,
                         .unit = "°",
                         .choices = {},
                         .help = "Which way it looks when it sets out: 0 is to the right, 90 up."};
const Parameter kNear{.key = "next_turn",
                      .label = "Sub-goal reached",
                      .type = ParameterType::real,
                      .initial = 0.3,
                      .low = 0.001,
                      .high = 100,
                      .unit = "m",
                      .choices = {},
                      .help = "So near a node of the plan it makes for the next one; in its cell it does so anyway."};
const Parameter kTolerance{.key = "tolerance",
                           .label = "Goal reached",
                           .type = ParameterType::real,
                           .initial = 0.1,
                           .low = 0,
                           .high = 100,
                           .unit = "m",
                           .choices = {},
                           .help = "So near the goal it has arrived; in the goal's cell it has so anyway."};

/// The robot's radius is the scenario's.
std::vector<Parameter> parameters_of_drive() {
  std::vector<Parameter> all;
  for (const Parameter& each : drive_parameters())
    if (each.key != "radius") all.push_back(each);
  all.insert(all.end(), {kHeading, kNear, kTolerance});
  return all;
}

}  // namespace

RobotInfo DwaRobot::describe() {
  return {.name = "Dynamic window",
          .summary = "Drives along arcs on two wheels: each time the one that scores best by the dynamic window approach.",
          .parameters = parameters_of_drive(),
          .planar = true};
}

DwaRobot::DwaRobot(const Scenario& scenario, const PlannerChoice& choice, Recorder* recorder)
    : Mission(scenario, choice, recorder),
      frame_{scenario.map.box(), scenario.map.resolution},
      settings_(drive_settings(scenario.robot.settings)),
      heading_(-scenario.robot.settings.get(kHeading) * kPi / 180),
      near_(std::max(scenario.robot.settings.get(kNear), frame_.side / 2)),
      tolerance_(scenario.robot.settings.get(kTolerance)),
      mapped_(initial_knowledge(scenario)) {
  settings_.limits.radius = scenario.robot.radius * frame_.side;
}

void DwaRobot::move() {
  take_up_pose();
  const Spot goal = sub_goal();
  if (state() != MissionState::driving) return;
  if (has_strayed(goal)) return replan();
  DriveState& now = moment().drive.state;
  const DriveDecision decision = replan::decide(now, obstacles(), goal, settings_towards(goal));
  if (decision.deed == DriveDeed::stuck) return turn_round_in_vain();
  if (decision.motion.v > 0) moment().drive.stuck = 0;
  keep(decision.motion);
  moment().drive.state.turned = decision.turned;
}

/// Whether it has lost sight of its sub-goal: it drove past, or something drove it off. Not again within a second.
bool DwaRobot::has_strayed(Spot goal) {
  Drive& drive = moment().drive;
  if (moment().time < drive.planned + kSecond || sees(drive.state.pose.spot(), goal)) return false;
  drive.planned = moment().time;
  return true;
}

/// A robot that is too fast to turn to its sub-goal drives round it for ever: the arc that leads there from its heading
/// has the radius d^2 / (2 |across|), and a sub-goal behind it is turned to on the spot.
DriveSettings DwaRobot::settings_towards(Spot goal) const {
  const DriveState& now = driving().state;
  const auto [sine, cosine] = sine_cosine(now.pose.heading);
  const double x = goal.x - now.pose.x, y = goal.y - now.pose.y;
  const double along = cosine * x + sine * y, across = std::abs(cosine * y - sine * x);
  DriveSettings settings = settings_;
  DriveLimits& limits = settings.limits;
  double most = limits.v_max;
  if (along <= 0)
    most = 0;
  else if (across > 0)
    most = std::min(most, limits.w_max * (along * along + across * across) / (2 * across));
  limits.v_max = std::max({most, limits.v_min, now.motion.v - limits.brake * settings.period});
  return settings;
}

bool DwaRobot::stands() {
  const Twist motion = driving().state.motion;
  if (!driving().begun || motion == Twist{}) return true;
  keep(braked(motion, settings_));
  return false;
}

bool DwaRobot::is_at(NodeId cell) const {
  if (robot() == cell) return true;
  return driving().begun &&
         distance(driving().state.pose.spot(), frame_.centre(box().position(cell))) <= tolerance_;
}

/// In the middle of the cell where it starts, or was put down.
void DwaRobot::take_up_pose() {
  Drive& drive = moment().drive;
  if (drive.begun) return;
  const DriveState before = drive.state;
  const Spot middle = frame_.centre(box().position(robot()));
  drive.begun = true;
  drive.state = {.pose = {middle.x, middle.y, heading_}, .motion = {}, .turned = 0};
  tell(before);
}

/// Gives up where it has come no nearer for too long.
Spot DwaRobot::sub_goal() {
  const std::shared_ptr<const Path>& path = moment().plan->path;
  if (path != path_) {
    path_ = path;
    nodes_.clear();
    for (std::size_t i = 0; i < path->size(); ++i)
      nodes_.push_back({path->point(i).x * frame_.side, path->point(i).y * frame_.side});
  }
  Drive& drive = moment().drive;
  const Spot robot = drive.state.pose.spot();
  drive.sub_goal =
      next_sub_goal(nodes_, drive.sub_goal, robot, near_, [&](Spot node) { return sees(robot, node); });
  double to_go = distance(robot, nodes_[drive.sub_goal]);
  for (std::size_t i = drive.sub_goal; i + 1 < nodes_.size(); ++i) to_go += distance(nodes_[i], nodes_[i + 1]);
  moment().along_plan = std::max(0.0, moment().plan->length - to_go / frame_.side);
  if (!comes_nearer(to_go)) give_up(MissionState::stuck);
  return nodes_[drive.sub_goal];
}

bool DwaRobot::comes_nearer(double to_go) {
  Drive& drive = moment().drive;
  constexpr double kWorthIt = 0.01;  // m
  if (to_go < drive.to_go - kWorthIt) {
    drive.to_go = to_go;
    drive.since = moment().time;
  }
  return static_cast<double>(moment().time - drive.since) <= setup().patience * static_cast<double>(kSecond);
}

bool DwaRobot::sees(Spot from, Spot to) const {
  const double radius = std::max(setup().radius, 1e-6);
  const double free = radius - Body::kTouch;
  return Body(box(), radius, in_cells(from), in_cells(to)).nearest(known()) >= free * free;
}

LocalObstacles DwaRobot::obstacles() const {
  const Spot at = driving().state.pose.spot();
  const double reach =
      settings_.limits.v_max * settings_.horizon + settings_.limits.radius + settings_.reach + frame_.side;
  const auto known_cells = known();
  const auto around = [&](bool mapped) {
    return cells_around(frame_, at, reach, false, [&](NodeId node) {
      return known_cells[node] != 0 && node != robot() && (mapped_[node] != 0) == mapped;
    });
  };
  std::vector<Spot> walls = around(true);
  add_edge(walls, at, reach);
  const ObstacleShape cell{frame_.side / 2, 0};
  LocalObstacles obstacles;
  obstacles.known = ObstacleSet(cell, walls);
  obstacles.unknown = ObstacleSet(cell, around(false));
  return obstacles;
}

/// Squares so far outside the map that a robot which keeps away from them keeps its centre on the map.
void DwaRobot::add_edge(std::vector<Spot>& walls, Spot at, double reach) const {
  const double away = settings_.limits.radius + settings_.margin, half = frame_.side / 2;
  const double right = frame_.box.width() * frame_.side, bottom = frame_.box.height() * frame_.side;
  const auto each = [&](double middle, double most, auto&& add) {
    const double first = std::max(-away, middle - reach), last = std::min(most + away, middle + reach);
    for (double along = first; along <= last + frame_.side; along += frame_.side) add(along);
  };
  each(at.x, right, [&](double x) {
    if (at.y < reach) walls.push_back({x, -away - half});
    if (bottom - at.y < reach) walls.push_back({x, bottom + away + half});
  });
  each(at.y, bottom, [&](double y) {
    if (at.x < reach) walls.push_back({-away - half, y});
    if (right - at.x < reach) walls.push_back({right + away + half, y});
  });
}

void DwaRobot::turn_round_in_vain() {
  Drive& drive = moment().drive;
  const DriveState before = drive.state;
  drive.state.turned = 0;
  drive.state.motion = {};
  tell(before);
  if (++drive.stuck >= kMostTurnsInVain) return give_up(MissionState::stuck);
  replan();
}

/// For a period.
void DwaRobot::keep(const Twist& motion) {
  const DriveState before = driving().state;
  const Arc arc(before.pose, motion);
  std::vector<Point> points;
  for (int i = 1; i <= kParts; ++i) points.push_back(in_cells(arc.spot(settings_.period * i / kParts)));
  DriveState& now = moment().drive.state;
  now.pose = arc.pose(settings_.period);
  now.motion = motion;
  const auto time = std::llround(settings_.period * static_cast<double>(kSecond));
  drive_on(points, motion.v * settings_.period / frame_.side, time);
  if (state() == MissionState::collision) {
    now = before;
    return;
  }
  const auto [sine, cosine] = sine_cosine(now.pose.heading);
  moment().after = {moment().at.x + cosine, moment().at.y + sine, moment().at.z};
  tell(before);
}

/// It may keep its motion for a period more before it brakes, along the same arc.
std::vector<Point> DwaRobot::stopping_way() const {
  const DriveState& now = driving().state;
  const Arc arc(now.pose, now.motion);
  const double time = stopping_time(now.motion, settings_);
  std::vector<Point> points;
  for (int i = 1; i <= kParts && now.motion.v > 0; ++i) points.push_back(in_cells(arc.spot(time * i / kParts)));
  return points;
}

/// What has changed since, to the log.
void DwaRobot::tell(const DriveState& before) const {
  const DriveState& now = driving().state;
  const auto change = [this](Scalar scalar, double from, double to) {
    log().change(scalar, std::bit_cast<std::uint64_t>(from), std::bit_cast<std::uint64_t>(to));
  };
  change(Scalar::x, before.pose.x, now.pose.x);
  change(Scalar::y, before.pose.y, now.pose.y);
  change(Scalar::heading, before.pose.heading, now.pose.heading);
  change(Scalar::speed, before.motion.v, now.motion.v);
  change(Scalar::turning, before.motion.w, now.motion.w);
}

}  // namespace replan
