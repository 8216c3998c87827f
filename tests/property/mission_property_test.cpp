// Random missions in worlds that change: with surprises, moving obstacles and sensors of every kind the robot
// never enters an obstacle, and where it gives up there is no path on its map. Where it makes for the cell
// nearest to its goal, that is the cell which brute force names, and none is nearer that it could reach.
#include <cstdio>
#include <tuple>

#include <gtest/gtest.h>

#include "core/sim/mission.hpp"
#include "core/trace/search_state.hpp"
#include "tests/support/missions.hpp"

namespace replan::test::mission_property_test {
namespace {

constexpr int kMissions = 20'004;  // a multiple of the number of planners, below

struct Totals {
  std::int64_t missions = 0, arrived = 0, no_path = 0, moves = 0, replans = 0, waits = 0, forgotten = 0,
               put_down = 0, new_goals = 0, endless = 0, beside_movers = 0, nearest = 0, nearest_plans = 0,
               goal_again = 0, drove_out = 0;
};

/// Where a moving obstacle is after that many steps, by walking.
Cell walked(const MovingObstacle& setup, std::int64_t steps) {
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

/// Follows one mission and holds it to what must be true of any.
class Witness {
 public:
  Witness(const Scenario& scenario, const PlannerInfo& info)
      : scenario_(scenario),
        rules_(move_rules(scenario.planners[0].settings)),
        mission_(make_mission(scenario, scenario.planners[0], &recorder_)),
        state_(initial_knowledge(scenario), initial_truth(scenario)) {
    if (info.any_angle) rules_.diagonals = true;
    world_.size = {scenario.map.width, scenario.map.height, 1};
    for (const std::uint8_t cell : scenario.map.blocked) walls_.push_back(cell == kFree ? 0 : 1);
  }

  /// What went wrong, or nothing.
  std::string run(Totals& totals) {
    robot_ = scenario_.map.box().node(scenario_.start);
    spared_ = walls_[robot_] == 0;
    for (int slices = 0;; ++slices) {
      if (slices > 300000) return "the mission does not end";
      const bool more = mission_->advance(64);
      for (const Event& event : recorder_.take()) {
        if (const std::string fault = take(event, totals); !fault.empty()) return fault;
        state_.apply(event);
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

 private:
  std::string take(const Event& event, Totals& totals) {
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

  std::string move_fault(NodeId to, Totals& totals) {
    if (state_.truly_blocked(to)) return "the robot enters an obstacle";
    world_.blocked.clear();
    for (NodeId n = 0; n < walls_.size(); ++n) world_.blocked.push_back(state_.truly_blocked(n) ? 1 : 0);
    const oracle::Place a = world_.place(robot_), b = world_.place(to);
    // A robot that was put into a wall has no moves, so it never leaves one.
    if (world_.blocked[robot_] != 0) ++totals.drove_out;
    if (!scenario_.robot.robot_cell_blocks && (walls_[robot_] == 0 || spared_)) world_.blocked[robot_] = 0;
    if (!oracle::may_move(world_, rules_, a, {b[0] - a[0], b[1] - a[1], 0})) return "that is not a move";
    for (int y = std::max(0, b[1] - 1); y <= std::min(world_.size[1] - 1, b[1] + 1); ++y)
      for (int x = std::max(0, b[0] - 1); x <= std::min(world_.size[0] - 1, b[0] + 1); ++x)
        totals.beside_movers += state_.moving(static_cast<NodeId>(world_.index({x, y, 0}))) ? 1 : 0;
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
      const std::int64_t dx = at[0] - goal[0], dy = at[1] - goal[1];
      if (n == robot_ || (world_.blocked[robot_] == 0 && costs[n] < oracle::kNever))
        best = std::min(best, {dx * dx + dy * dy, costs[n], n});
    }
    return std::get<2>(best);
  }

  std::string plan_fault(PlanStatus status, Totals& totals) {
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
      for (int y = at.y; y < std::min(scenario_.map.height, at.y + setup.height); ++y)
        for (int x = at.x; x < std::min(scenario_.map.width, at.x + setup.width); ++x) {
          std::uint8_t& cell = expected[scenario_.map.index({x, y})];
          cell = static_cast<std::uint8_t>(cell + kMoverUnit);
        }
    }
    for (NodeId n = 0; n < expected.size(); ++n)
      if (state_.value(EventKind::truth, n) != expected[n])
        return "the world is not as it should be at cell " + std::to_string(n);
    return "";
  }

  std::string end_fault(Totals& totals) {
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
  NodeId robot_ = kNoNode;
  bool spared_ = false;  // what wall there is came onto the robot's cell while it stood there
};

class RandomMissions : public ::testing::TestWithParam<const PlannerInfo*> {};

TEST_P(RandomMissions, endWithoutACollision) {
  const PlannerInfo& info = *GetParam();
  Totals totals;
  const auto count = static_cast<std::uint64_t>(kMissions) / sound_planners().size();
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    Random random(seed * 1000 + static_cast<std::uint64_t>(&info - planners().data()));
    const Scenario scenario = random_scenario(random, info);
    Witness witness(scenario, info);
    const std::string fault = witness.run(totals);
    ASSERT_EQ(fault, "") << "seed " << seed << ", " << describe_settings(info, scenario.planners[0].settings)
                         << "\n"
                         << scenario_text(scenario);
  }
  std::printf(
      "%s: %lld missions, %lld arrived, %lld without a path; %lld moves (%lld beside something moving), %lld "
      "replans, %lld turned back for ever, %lld waits, %lld sightings forgotten, %lld times put down, %lld "
      "new goals; %lld plans to the nearest cell, %lld ends there, %lld times on to the goal again, %lld "
      "moves "
      "out of an obstacle\n",
      std::string(info.id).c_str(), static_cast<long long>(totals.missions),
      static_cast<long long>(totals.arrived), static_cast<long long>(totals.no_path),
      static_cast<long long>(totals.moves), static_cast<long long>(totals.beside_movers),
      static_cast<long long>(totals.replans), static_cast<long long>(totals.endless),
      static_cast<long long>(totals.waits), static_cast<long long>(totals.forgotten),
      static_cast<long long>(totals.put_down), static_cast<long long>(totals.new_goals),
      static_cast<long long>(totals.nearest_plans), static_cast<long long>(totals.nearest),
      static_cast<long long>(totals.goal_again), static_cast<long long>(totals.drove_out));
  EXPECT_LT(totals.endless, 10);
  // Each of them has to occur, or the test says nothing of it.
  for (const std::int64_t count_of :
       {totals.arrived, totals.no_path, totals.beside_movers, totals.waits, totals.forgotten, totals.put_down,
        totals.new_goals, totals.nearest_plans, totals.nearest, totals.goal_again, totals.drove_out})
    EXPECT_GT(count_of, 20);
}

std::vector<const PlannerInfo*> every_planner() {
  std::vector<const PlannerInfo*> all;
  for (const PlannerInfo& info : sound_planners()) all.push_back(&info);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Planners, RandomMissions, ::testing::ValuesIn(every_planner()),
                         [](const auto& param) {
                           std::string name(param.param->id);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace replan::test::mission_property_test
