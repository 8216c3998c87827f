#include "core/robots/dwa_robot.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/bit_cast.hpp"
#include "core/plan/figures.hpp"

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
const Parameter kNear{
    .key = "next_turn",
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
          .summary =
              "Drives along arcs on two wheels: each time the one that scores best by the dynamic window "
              "approach.",
          .parameters = parameters_of_drive(),
          .planar = true,
          .drives = true,
          .heading = kHeading.key,
          .own_pace = true};
}

DwaRobot::DwaRobot(const Scenario& scenario, const PlannerChoice& choice, Recorder* recorder)
    : Mission(scenario, choice, recorder),
      sense_(scenario, scenario.robot),
      tolerance_(scenario.robot.settings.get(kTolerance)) {}

const Parameter& DwaRobot::near_parameter() {
  return kNear;
}

const Parameter& DwaRobot::heading_parameter() {
  return kHeading;
}

void DwaRobot::move() {
  take_up_pose();
  const Spot goal = sub_goal();
  if (state() != MissionState::driving) return;
  if (has_strayed(goal)) return replan();
  DriveState& now = moment().drive.state;
  const DriveDecision decision =
      replan::decide(now, sense_.obstacles(now, known()), goal, sense_.settings_towards(now, goal));
  tell(decision);
  if (decision.deed == DriveDeed::stuck) return turn_round_in_vain();
  if (decision.motion.v > 0) moment().drive.stuck = 0;
  keep(decision.motion);
  moment().drive.state.turned = decision.turned;
}

/// A blind plan is none the better for being made again.
bool DwaRobot::has_strayed(Spot goal) {
  Drive& drive = moment().drive;
  if (navigator().blind() || !sense_.has_strayed(moment(), drive.state.pose.spot(), goal, known()))
    return false;
  drive.planned = moment().time;
  return true;
}

bool DwaRobot::stands() {
  const Twist motion = driving().state.motion;
  if (!driving().begun || motion == Twist{}) return true;
  keep(braked(motion, sense_.settings()));
  return false;
}

bool DwaRobot::is_at(NodeId cell) const {
  if (robot() == cell) return true;
  return driving().begun &&
         distance(driving().state.pose.spot(), sense_.frame().centre(box().position(cell))) <= tolerance_;
}

/// In the middle of the cell where it starts, or was put down.
void DwaRobot::take_up_pose() {
  Drive& drive = moment().drive;
  if (drive.begun) return;
  const DriveState before = drive.state;
  drive.begun = true;
  drive.state = sense_.first_state(box().position(robot()));
  tell(before);
}

/// What it makes for, and how far the goal is by that way; it gives up where it has come no nearer for too long.
Spot DwaRobot::sub_goal() {
  const std::shared_ptr<const Path>& path = moment().plan->path;
  if (path != path_) {
    path_ = path;
    nodes_ = sense_.nodes_of(*path);
  }
  Drive& drive = moment().drive;
  const Spot robot = drive.state.pose.spot();
  drive.sub_goal = sense_.sub_goal(nodes_, drive.sub_goal, robot, known());
  tell_sub_goal();
  double to_go = distance(robot, nodes_[drive.sub_goal]);
  for (std::size_t i = drive.sub_goal; i + 1 < nodes_.size(); ++i)
    to_go += distance(nodes_[i], nodes_[i + 1]);
  moment().along_plan = std::max(0.0, moment().plan->length - to_go / sense_.frame().side);
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
  for (int i = 1; i <= kParts; ++i)
    points.push_back(sense_.in_cells(arc.spot(sense_.settings().period * i / kParts)));
  DriveState& now = moment().drive.state;
  now.pose = arc.pose(sense_.settings().period);
  now.motion = motion;
  const auto time = std::llround(sense_.settings().period * static_cast<double>(kSecond));
  drive_on(points, motion.v * sense_.settings().period / sense_.frame().side, time);
  if (state() == MissionState::collision) {
    now = before;
    return;
  }
  const double away = distance_to(*moment().first_path, moment().at) * sense_.frame().side;
  moment().figures.drive.add(motion, sense_.settings().period, away);
  const auto [sine, cosine] = sine_cosine(now.pose.heading);
  moment().course = {cosine, sine, 0};
  moment().after = {moment().at.x + cosine, moment().at.y + sine, moment().at.z};
  tell(before);
}

/// It may keep its motion for a period more before it brakes, along the same arc.
std::vector<Point> DwaRobot::stopping_way() const {
  const DriveState& now = driving().state;
  const Arc arc(now.pose, now.motion);
  const double time = stopping_time(now.motion, sense_.settings());
  std::vector<Point> points;
  for (int i = 1; i <= kParts && now.motion.v > 0; ++i)
    points.push_back(sense_.in_cells(arc.spot(time * i / kParts)));
  return points;
}

/// What has changed since, to the log.
void DwaRobot::tell(const DriveState& before) const {
  const DriveState& now = driving().state;
  const auto change = [this](Scalar scalar, double from, double to) {
    log().change(scalar, bit_cast<std::uint64_t>(from), bit_cast<std::uint64_t>(to));
  };
  change(Scalar::x, before.pose.x, now.pose.x);
  change(Scalar::y, before.pose.y, now.pose.y);
  change(Scalar::heading, before.pose.heading, now.pose.heading);
  change(Scalar::speed, before.motion.v, now.motion.v);
  change(Scalar::turning, before.motion.w, now.motion.w);
}

void DwaRobot::tell_sub_goal() {
  Drive& drive = moment().drive;
  tell(Scalar::sub_goal, drive.choice.sub_goal, box().node(sense_.cell_of(nodes_[drive.sub_goal])) + 1u);
}

/// Before it is carried out: who stops there can still look at what was decided.
void DwaRobot::tell(const DriveDecision& decision) {
  DriveChoice& choice = moment().drive.choice;
  tell(Scalar::admissible, choice.admissible, decision.admissible + 1);
  tell(Scalar::score, choice.score, decision.winner ? score_bits(decision.score) : 0);
}

void DwaRobot::tell(Scalar scalar, std::uint64_t& told, std::uint64_t now) const {
  log().change(scalar, told, now);
  told = now;
}

}  // namespace replan
