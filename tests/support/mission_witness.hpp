// Follows a mission and holds it to what must be true of any, in the plane and in space: counted by the plainest means.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/sim/mission.hpp"
#include "core/trace/search_state.hpp"
#include "tests/support/missions.hpp"
#include "tests/support/sensor_witness.hpp"

namespace replan::test {

/// What missions came to, so that a test can tell whether it has seen everything.
struct MissionTotals {
  std::int64_t missions = 0, arrived = 0, no_path = 0, moves = 0, replans = 0, waits = 0, forgotten = 0,
               put_down = 0, new_goals = 0, endless = 0, beside_movers = 0, nearest = 0, nearest_plans = 0,
               goal_again = 0, drove_out = 0, left_zone = 0, in_zone = 0, along_zone = 0, turns = 0,
               better_known = 0;
};

/// Where a moving obstacle is after that many steps, by walking.
inline Cell walked(const MovingObstacle& setup, std::int64_t steps) {
  std::vector<Cell> corners = setup.way;
  if (setup.at_end == WayEnd::loop) corners.push_back(corners.front());
  std::vector<Cell> cells = cells_of_way(corners);
  std::size_t at = 0;
  bool back = false;
  for (; steps > 0; --steps) {
    if (setup.at_end == WayEnd::loop) {
      at = at + 1 < cells.size() ? at + 1 : 0;
      if (at + 1 == cells.size()) at = 0;  // the way's end is its beginning
    } else if (setup.at_end == WayEnd::stop) {
      at = std::min(at + 1, cells.size() - 1);
    } else if (cells.size() > 1) {
      if (at + 1 == cells.size()) back = true;
      if (at == 0) back = false;
      at = back ? at - 1 : at + 1;
    }
  }
  return cells[at];
}

/// One mission: surprises, moving obstacles, sensors of every kind. The robot never enters an obstacle, and where it
/// gives up there is no path on its map.
class MissionWitness {
 public:
  MissionWitness(const Scenario& scenario, const PlannerInfo& info)
      : scenario_(scenario),
        info_(info),
        rules_(oracle_rules(scenario)),
        sensor_(scenario),
        mission_(make_mission(scenario, scenario.planners[0], &recorder_)),
        state_(initial_state(scenario, scenario.planners[0])) {
    if (info.any_angle || !scenario.planners[0].stages.empty()) rules_.diagonals = true;
    world_.dimensions = scenario.map.depth > 1 ? 3 : 2;
    world_.size = {scenario.map.width, scenario.map.height, scenario.map.depth};
    for (const std::uint8_t cell : scenario.map.blocked) walls_.push_back(cell == kFree ? 0 : 1);
  }

  /// What went wrong, or nothing.
  std::string run(MissionTotals& totals) {
    robot_ = scenario_.map.box().node(scenario_.start);
    spared_ = walls_[robot_] == 0;
    for (int slices = 0;; ++slices) {
      if (slices > 300000) return "the mission does not end";
      const std::int64_t moves = mission_->now().figures.moves;
      sensor_.look(mission_->now());
      const bool more = mission_->advance(64);
      went_ = mission_->now().figures.moves > moves;
      for (const Event& event : recorder_.take()) {
        if (const std::string fault = take(event, totals); !fault.empty()) return fault;
        state_.apply(event);
        log_.push_back(event);
      }
      if (const std::string fault = world_fault(); !fault.empty()) return fault;
      if (const std::string fault = sensor_.limit_fault(mission_->now()); !fault.empty()) return fault;
      if (!more) break;
    }
    ++totals.missions;
    const MissionFigures& figures = mission_->now().figures;
    if (figures.collisions != 0) return "a collision was counted";
    totals.moves += figures.moves;
    totals.replans += figures.replans;
    return end_fault(totals);
  }
  /// All that the mission has told.
  [[nodiscard]] const std::vector<Event>& log() const { return log_; }

 private:
  /// A robot with a size cuts no corners.
  static MoveRules oracle_rules(const Scenario& scenario) {
    MoveRules rules = move_rules(scenario.planners[0].settings);
    if (scenario.robot.radius > 0) rules.corners = CornerRule::none;
    return rules;
  }
  /// The robot's map as it looks to its centre.
  void look_at_known() {
    world_.blocked.clear();
    for (NodeId n = 0; n < walls_.size(); ++n) world_.blocked.push_back(state_.known_blocked(n) ? 1 : 0);
    if (scenario_.robot.radius == 0 || world_.blocked == grown_from_) {
      if (scenario_.robot.radius > 0) world_.blocked = grown_;
      return;
    }
    grown_from_ = world_.blocked;
    grown_ = world_.blocked = oracle::grown(world_, scenario_.robot.radius);
  }

  /// A robot with a size on its way to a cell: once it is clear of all obstacles that it knows of it stays so, and
  /// where one has come too near it comes no nearer.
  std::string zone_fault(NodeId to, MissionTotals& totals) {
    look_at_known();
    const bool was_in = grown_[robot_] != 0, is_in = grown_[to] != 0;
    if (!was_in) return is_in ? "the robot drives too near an obstacle that it knows of" : "";
    ++totals.in_zone;
    totals.left_zone += is_in ? 0 : 1;
    world_.blocked = grown_from_;
    const std::int64_t before = oracle::least_quarters(world_, robot_),
                       after = oracle::least_quarters(world_, to);
    totals.along_zone += after == before ? 1 : 0;
    return after < before ? "the robot drives deeper in" : "";
  }
  /// Its body on the way, against all that stands in the world: sampled, by the distance of points from squares.
  std::string body_fault() {
    const double radius = scenario_.robot.radius;
    const std::vector<Point> way = sensor_.way_of(mission_->now());
    const auto clearance = [&](const Point& from, const Point& to, double t) {
      const double at[] = {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                           from.z + t * (to.z - from.z)};
      double least = radius;
      for (NodeId n = 0; n < walls_.size(); ++n) {
        if (!state_.truly_blocked(n)) continue;
        const oracle::Place square = world_.place(n);
        double squared = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double off = std::max({square[axis] - at[axis], at[axis] - square[axis] - 1, 0.0});
          squared += off * off;
        }
        least = std::min(least, std::sqrt(squared));
      }
      return least;
    };
    const double before = clearance(way.front(), way.front(), 0);
    const int parts = way.size() > 2 ? 2 : 8;
    for (std::size_t i = 1; i < way.size(); ++i)
      for (int k = 1; k <= parts; ++k)
        if (clearance(way[i - 1], way[i], double(k) / parts) < before - 1e-7)
          return "the robot's body touches an obstacle";
    return "";
  }

  std::string take(const Event& event, MissionTotals& totals) {
    switch (event.kind) {
      case EventKind::move:
        return move_fault(event.node, totals);
      case EventKind::surprise:
        sensor_.is_told();
        for (const CellChange& change : scenario_.surprises[event.delta].cells)
          walls_[scenario_.map.index(change.cell)] = change.blocked ? 1 : 0;
        // A wall that comes onto its cell does not hold it; one that it was in before does.
        spared_ = spared_ || walls_[robot_] == 0;
        break;
      case EventKind::put_down:
        robot_ = event.node;
        spared_ = walls_[robot_] == 0;
        ++totals.put_down;
        break;
      case EventKind::plan_end:
        return plan_fault(static_cast<PlanStatus>(event.delta), totals);
      case EventKind::aim:
        totals.goal_again += event.delta != 0 ? 1 : 0;
        break;
      case EventKind::new_goal:
        ++totals.new_goals;
        break;
      case EventKind::waiting:
        ++totals.waits;
        break;
      case EventKind::sensed:
        return sensor_.sensed_fault(robot_, event.node);
      case EventKind::turn:
        ++totals.turns;
        return sensor_.sight_fault(state_, robot_);
      case EventKind::forgotten:
        ++totals.forgotten;
        break;
      default:
        break;
    }
    return "";
  }

  std::string move_fault(NodeId to, MissionTotals& totals) {
    if (state_.truly_blocked(to)) return "the robot enters an obstacle";
    if (const std::string fault = sensor_.sight_fault(state_, robot_); !fault.empty()) return fault;
    if (scenario_.robot.radius > 0 && went_)
      for (const std::string& fault : {zone_fault(to, totals), body_fault()})
        if (!fault.empty()) return fault;
    world_.blocked.clear();
    for (NodeId n = 0; n < walls_.size(); ++n) world_.blocked.push_back(state_.truly_blocked(n) ? 1 : 0);
    const oracle::Place a = world_.place(robot_), b = world_.place(to);
    // A robot that was put into a wall has no moves, so it never leaves one.
    if (world_.blocked[robot_] != 0) ++totals.drove_out;
    if (!scenario_.robot.robot_cell_blocks && (walls_[robot_] == 0 || spared_)) world_.blocked[robot_] = 0;
    if (!oracle::may_move(world_, rules_, a, {b[0] - a[0], b[1] - a[1], b[2] - a[2]}))
      return "that is not a move";
    scenario_.map.box().each_cell_around(scenario_.map.box().position(to), 1, [&](NodeId beside) {
      totals.beside_movers += state_.moving(beside) ? 1 : 0;
    });
    robot_ = to;
    spared_ = true;
    return "";
  }

  /// Where brute force makes for: the nearest to the goal of the cells that the robot can reach on its map.
  [[nodiscard]] NodeId brute_force_aim() {
    look_at_known();
    std::vector<oracle::Raw> barred = closed();
    if (!barred.empty()) barred[robot_] = 0;  // where it stands it need not come
    const auto costs = oracle::costs_to(world_, oracle_rules(scenario_), barred, robot_);
    const auto goal = world_.place(state_.wanted_goal());
    std::tuple<std::int64_t, oracle::Raw, NodeId> best{INT64_MAX, 0, kNoNode};
    for (NodeId n = 0; n < walls_.size(); ++n) {
      const auto at = world_.place(n);
      const std::int64_t dx = at[0] - goal[0], dy = at[1] - goal[1], dz = at[2] - goal[2];
      if (n == robot_ ||
          (world_.blocked[robot_] == 0 && costs[n] < oracle::kNever && (barred.empty() || barred[n] == 0)))
        best = std::min(best, {dx * dx + dy * dy + dz * dz, costs[n], n});
    }
    return std::get<2>(best);
  }

  std::string plan_fault(PlanStatus status, MissionTotals& totals) {
    const NodeId aim = state_.node(Scalar::goal), goal = state_.wanted_goal();
    last_plan_ = status;
    if (status == PlanStatus::none_found)
      return info_.can_miss() ? "" : "a planner that finds all paths says that it found none";
    if (status == PlanStatus::found)
      return aim == goal ? "" : "a path to another cell counts as one to the goal";
    if (status != PlanStatus::found_nearest) return "";
    ++totals.nearest_plans;
    look_at_known();
    if (scenario_.robot.radius > 0 && world_.blocked[robot_] != 0) return "";  // by its way out
    if (scenario_.robot.unreachable_goal != UnreachableGoal::nearest)
      return "nobody asked for the nearest cell";
    return aim == brute_force_aim() && aim != goal ? "" : "brute force makes for another cell";
  }

  /// The log's world against walls and moving obstacles counted here.
  [[nodiscard]] std::string world_fault() const {
    std::vector<std::uint8_t> expected = walls_;
    for (std::size_t i = 0; i < scenario_.movers.size(); ++i) {
      const MoverState& mover = mission_->now().movers[i];
      if (mover.steps < 0) continue;
      const MovingObstacle& setup = scenario_.movers[i];
      const Cell at = walked(setup, mover.steps);
      for (NodeId n = 0; n < expected.size(); ++n) {
        const Cell cell = scenario_.map.box().position(n);
        const bool inside = cell.x >= at.x && cell.x < at.x + setup.width && cell.y >= at.y &&
                            cell.y < at.y + setup.height && cell.z >= at.z && cell.z < at.z + setup.depth;
        expected[n] = static_cast<std::uint8_t>(expected[n] + (inside ? kMoverUnit : 0));
      }
    }
    for (NodeId n = 0; n < expected.size(); ++n)
      if (state_.value(EventKind::truth, n) != expected[n])
        return "the world is not as it should be at cell " + std::to_string(n);
    return "";
  }

  std::string end_fault(MissionTotals& totals) {
    const NodeId goal = state_.wanted_goal();
    if (state_.node(Scalar::robot) != robot_) return "the robot is not where it drove";
    if (const std::string fault = sensor_.sight_fault(state_, robot_); !fault.empty()) return fault;
    if (mission_->state() == MissionState::arrived) {
      ++totals.arrived;
      return robot_ == goal ? "" : "it has arrived somewhere else";
    }
    if (mission_->state() == MissionState::endless) {
      ++totals.endless;
      return "";
    }
    if (mission_->state() == MissionState::nearest) {
      ++totals.nearest;
      return robot_ == brute_force_aim() && robot_ != goal ? "" : "it could have come nearer";
    }
    if (mission_->state() != MissionState::no_path) return "it ends neither by arriving nor without a path";
    ++totals.no_path;
    if (last_plan_ == PlanStatus::none_found) return "";  // which is no claim that there is none
    look_at_known();
    if (world_.blocked[robot_] != 0) return "";
    if (scenario_.robot.unreachable_goal == UnreachableGoal::nearest)
      return "it did not look for the nearest cell";
    if (world_.blocked[goal] != 0) return "";
    const MoveRules rules = oracle_rules(scenario_);
    if (oracle::costs_to(world_, rules, closed(), goal)[robot_] != oracle::kNever) return "there is a path";
    return truth_fault(goal, totals);
  }

  /// Where a fresh plan on the world as it is would find a path, the robot holds something for an obstacle that it has
  /// seen, cannot see now, and that has gone since.
  std::string truth_fault(NodeId goal, MissionTotals& totals) {
    bool gone = false;
    for (NodeId n = 0; n < walls_.size(); ++n) {
      world_.blocked[n] = state_.truly_blocked(n) && n != robot_ ? 1 : 0;
      gone = gone || (state_.known_blocked(n) && !state_.truly_blocked(n));
    }
    if (scenario_.robot.radius > 0) world_.blocked = oracle::grown(world_, scenario_.robot.radius);
    if (oracle::costs_to(world_, oracle_rules(scenario_), closed(), goal)[robot_] == oracle::kNever)
      return "";
    ++totals.better_known;
    return gone ? "" : "its map is right, and there is a path";
  }

  [[nodiscard]] std::vector<oracle::Raw> closed() const {
    return closed_cells(info_, scenario_.planners[0].settings, world_);
  }

  const Scenario& scenario_;
  const PlannerInfo& info_;
  MoveRules rules_;
  Recorder recorder_;
  SensorWitness sensor_;
  std::unique_ptr<Mission> mission_;
  SearchState state_;
  oracle::World world_;
  std::vector<std::uint8_t> walls_;
  std::vector<std::uint8_t> grown_, grown_from_;  // the robot's map, and how it looks to its centre
  bool went_ = false;                             // in the latest slice
  std::vector<Event> log_;
  NodeId robot_ = kNoNode;
  PlanStatus last_plan_ = PlanStatus::searching;
  bool spared_ = false;  // what wall there is came onto the robot's cell while it stood there
};

}  // namespace replan::test
