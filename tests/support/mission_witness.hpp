// Follows a mission and holds it to what must be true of any, in the plane and in space: counted by the plainest means.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/sim/mission.hpp"
#include "core/trace/search_state.hpp"
#include "tests/support/missions.hpp"

namespace replan::test {

/// What missions came to, so that a test can tell whether it has seen everything.
struct MissionTotals {
  std::int64_t missions = 0, arrived = 0, no_path = 0, moves = 0, replans = 0, waits = 0, forgotten = 0,
               put_down = 0, new_goals = 0, endless = 0, beside_movers = 0, nearest = 0, nearest_plans = 0,
               goal_again = 0, drove_out = 0;
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
        rules_(move_rules(scenario.planners[0].settings)),
        mission_(make_mission(scenario, scenario.planners[0], &recorder_)),
        state_(initial_state(scenario, scenario.planners[0])) {
    if (info.any_angle) rules_.diagonals = true;
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
      const bool more = mission_->advance(64);
      for (const Event& event : recorder_.take()) {
        if (const std::string fault = take(event, totals); !fault.empty()) return fault;
        state_.apply(event);
        log_.push_back(event);
      }
      if (const std::string fault = world_fault(); !fault.empty()) return fault;
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
  std::string take(const Event& event, MissionTotals& totals) {
    switch (event.kind) {
      case EventKind::move:
        return move_fault(event.node, totals);
      case EventKind::surprise:
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
    world_.blocked.clear();
    for (NodeId n = 0; n < walls_.size(); ++n) world_.blocked.push_back(state_.known_blocked(n) ? 1 : 0);
    const auto costs = oracle::costs_to(world_, move_rules(scenario_.planners[0].settings), {}, robot_);
    const auto goal = world_.place(state_.wanted_goal());
    std::tuple<std::int64_t, oracle::Raw, NodeId> best{INT64_MAX, 0, kNoNode};
    for (NodeId n = 0; n < walls_.size(); ++n) {
      const auto at = world_.place(n);
      const std::int64_t dx = at[0] - goal[0], dy = at[1] - goal[1], dz = at[2] - goal[2];
      if (n == robot_ || (world_.blocked[robot_] == 0 && costs[n] < oracle::kNever))
        best = std::min(best, {dx * dx + dy * dy + dz * dz, costs[n], n});
    }
    return std::get<2>(best);
  }

  std::string plan_fault(PlanStatus status, MissionTotals& totals) {
    const NodeId aim = state_.node(Scalar::goal), goal = state_.wanted_goal();
    if (status == PlanStatus::found)
      return aim == goal ? "" : "a path to another cell counts as one to the goal";
    if (status != PlanStatus::found_nearest) return "";
    ++totals.nearest_plans;
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
    world_.blocked.clear();
    for (NodeId n = 0; n < walls_.size(); ++n) world_.blocked.push_back(state_.known_blocked(n) ? 1 : 0);
    if (world_.blocked[robot_] != 0) return "";
    if (scenario_.robot.unreachable_goal == UnreachableGoal::nearest)
      return "it did not look for the nearest cell";
    if (world_.blocked[goal] != 0) return "";
    const MoveRules rules = move_rules(scenario_.planners[0].settings);
    return oracle::costs_to(world_, rules, {}, goal)[robot_] == oracle::kNever ? "" : "there is a path";
  }

  const Scenario& scenario_;
  MoveRules rules_;
  Recorder recorder_;
  std::unique_ptr<Mission> mission_;
  SearchState state_;
  oracle::World world_;
  std::vector<std::uint8_t> walls_;
  std::vector<Event> log_;
  NodeId robot_ = kNoNode;
  bool spared_ = false;  // what wall there is came onto the robot's cell while it stood there
};

}  // namespace replan::test
