// Planning and replanning on a grid of one's own: every planner, in the plane and in space, against a grid of its own
// that plans afresh; and what it says of wrong input.
#include "core/plan/replanner.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace replan::test::replanner_test {
namespace {

constexpr int kRounds = 6;

Box box_of(const oracle::World& world) {
  return {world.size[0], world.size[1], world.size[2]};
}

/// A world, and a planner's settings as a user types them.
template <int D>
struct Trial {
  Random random;
  Settings settings;
  std::vector<Replanner::Setting> typed;
  oracle::World world;

  Trial(const PlannerInfo& info, std::uint64_t seed) : random(seed), settings(random_settings(random, info)) {
    for (const Parameter& parameter : info.parameters)
      if (settings.has(parameter.key))
        typed.emplace_back(parameter.key, format_value(parameter, settings.get(parameter)));
    typename BoxLattice<D>::Coordinates low{}, high{};
    low.fill(2);
    high.fill(D == 2 ? 14 : 6);
    const auto size = random_size<D>(random, low, high);
    world = {.dimensions = D, .size = {1, 1, 1}, .blocked = random_cells<D>(random, size)};
    std::copy(size.begin(), size.end(), world.size.begin());
  }
  [[nodiscard]] Replanner grid(const PlannerInfo& info) const {
    auto made = Replanner::make(box_of(world), world.blocked, info.id, typed);
    EXPECT_TRUE(made) << made.error();
    return std::move(*made);
  }
  NodeId free() { return random_free(random, world); }
};

/// Over nodes if all its points are such, unless its segments may touch obstacles.
Path path_of(const PlannerInfo& info, const Replanner& grid, const Box& box) {
  const std::vector<Point> points = grid.points();
  if (!info.point_only.empty()) return Path(points);
  std::vector<NodeId> nodes;
  for (const Point& point : points)
    if (point == centre_of(cell_of(point))) nodes.push_back(box.node(cell_of(point)));
  return nodes.size() == points.size() ? Path(box, std::move(nodes)) : Path(points);
}

/// Its path, as the segments that the planner may take.
void expect_right(const PlannerInfo& info, const Settings& settings, const oracle::World& world, NodeId start,
                  NodeId goal, const Replanner& grid) {
  const Box box = box_of(world);
  const oracle::Raw shortest = shortest_way(info, settings, world, start, goal);
  const PlanStatus right = right_status(world, start, goal, shortest);
  ASSERT_TRUE(is_right(info, grid.status(), right)) << status_name(grid.status());
  const Path path = path_of(info, grid, box);
  if (grid.status() != PlanStatus::found) {
    ASSERT_TRUE(path.empty());
    ASSERT_EQ(grid.cost(), HUGE_VAL);
    return;
  }
  ASSERT_EQ(fault_of_segments(info, settings, world, start, goal, path), "");
  for (const Cell cell : grid.path()) ASSERT_FALSE(grid.blocked(cell));
}

template <int D>
void check_replans(const PlannerInfo& info, std::uint64_t seed) {
  Trial<D> trial(info, seed);
  SCOPED_TRACE(describe_settings(info, trial.settings) + ", seed " + std::to_string(seed));
  const Box box = box_of(trial.world);
  Replanner grid = trial.grid(info);
  NodeId start = trial.free();
  const NodeId goal = trial.free();
  ASSERT_TRUE(grid.plan(box.position(start), box.position(goal)));
  for (int round = 0; round < kRounds; ++round) {
    expect_right(info, trial.settings, trial.world, start, goal, grid);
    Replanner fresh = trial.grid(info);
    const auto again = fresh.plan(box.position(start), box.position(goal));
    ASSERT_TRUE(again);
    if (!info.can_miss()) {
      ASSERT_EQ(*again, grid.status());
    }
    if (!info.can_miss() && (info.incremental || info.optimal(trial.settings))) {
      ASSERT_EQ(fresh.cost(), grid.cost()) << "round " << round;
    }
    std::vector<Replanner::Change> changes;
    for (const CellEdit& edit : random_edits<D>(trial.random, trial.world, 5)) {
      changes.push_back({box.position(edit.node), edit.blocked});
      trial.world.blocked[edit.node] = edit.blocked ? 1 : 0;
    }
    // A cell that is told twice, the first time wrongly.
    const bool goal_blocked = trial.world.blocked[goal] != 0;
    changes.push_back({box.position(goal), !goal_blocked});
    changes.push_back({box.position(goal), goal_blocked});
    const bool moves = trial.random.chance(0.5);
    if (moves) start = trial.free();
    const auto status = moves ? grid.change(changes, box.position(start)) : grid.change(changes);
    ASSERT_TRUE(status);
    ASSERT_EQ(*status, grid.status());
    for (NodeId n = 0; n < trial.world.blocked.size(); ++n)
      ASSERT_EQ(grid.blocked(box.position(n)), trial.world.blocked[n] != 0);
  }
}

TEST(Replanner, PlansAndRepairsWithEveryPlannerInPlaneAndSpace) {
  for (const PlannerInfo& info : sound_planners())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      check_replans<2>(info, seed);
      if (!info.planar) check_replans<3>(info, seed);
      ASSERT_FALSE(HasFatalFailure()) << info.id;
    }
}

Replanner small_grid() {
  return Replanner::make({4, 3}, std::vector<std::uint8_t>(12)).value();
}

TEST(Replanner, KnowsItsMapBeforeThereIsAPlan) {
  Replanner grid = small_grid();
  EXPECT_EQ(grid.status(), PlanStatus::searching);
  EXPECT_TRUE(grid.path().empty());
  EXPECT_EQ(grid.cost(), HUGE_VAL);
  EXPECT_EQ(*grid.change({{{1, 0}, true}, {{1, 1}, true}}), PlanStatus::searching);
  EXPECT_TRUE(grid.blocked({1, 0}));
  EXPECT_TRUE(grid.blocked({4, 0}));
  EXPECT_FALSE(grid.blocked({0, 0}));
  EXPECT_EQ(*grid.plan({0, 0}, {3, 0}), PlanStatus::found);
  EXPECT_NEAR(grid.cost(), 5 + std::sqrt(2), 1e-6);
  EXPECT_EQ(*grid.change({{{1, 2}, true}}), PlanStatus::no_path);
  EXPECT_EQ(*grid.plan({2, 0}, {3, 2}), PlanStatus::found);
  Replanner moved = std::move(grid);
  EXPECT_EQ(moved.path().back(), (Cell{3, 2}));
}

template <class T>
std::string error_of(const Result<T>& result) {
  return result ? "no error" : result.error();
}

TEST(Replanner, SaysWhatIsWrongWithAGridOrASetting) {
  const auto make = [](Box box, std::size_t cells, std::string_view id = "astar",
                       const std::vector<Replanner::Setting>& settings = {}) {
    return error_of(Replanner::make(box, std::vector<std::uint8_t>(cells), id, settings));
  };
  EXPECT_EQ(make({4, 3}, 12), "no error");
  EXPECT_EQ(make({4, 3, 2}, 12), "a grid of 4 x 3 x 2 cells takes 24 values, and 12 were given");
  EXPECT_EQ(make({0, 3}, 0), "a grid of 0 x 3 cells cannot be planned on: give each side at least 1");
  EXPECT_EQ(make({2'000'000'000, 2'000'000'000, 2'000'000'000}, 0),
            "a grid of 2000000000 x 2000000000 x 2000000000 cells is too large: 134217728 are the most");
  EXPECT_EQ(make({4, 3}, 12, "atsar"), "unknown planner 'atsar'; did you mean 'astar'?");
  EXPECT_EQ(make({4, 3}, 12, "astar", {{"moves", "4"}, {"heuristic", "manhattan"}}), "no error");
  EXPECT_EQ(make({4, 3}, 12, "astar", {{"heuristics", "zero"}}),
            "unknown setting 'heuristics'; did you mean 'heuristic'?");
  EXPECT_EQ(make({4, 3}, 12, "astar", {{"moves", "6"}}), "'moves' cannot be '6': give one of: 8, 4");
}

TEST(Replanner, LeavesAllAsItIsWhereACellIsOutside) {
  Replanner grid = small_grid();
  ASSERT_TRUE(grid.plan({0, 0}, {3, 0}));
  const char* const outside = "(9, 0) lies outside the grid of 4 x 3 cells";
  EXPECT_EQ(error_of(grid.plan({9, 0}, {3, 0})), outside);
  EXPECT_EQ(error_of(grid.plan({0, 0}, {9, 0})), outside);
  EXPECT_EQ(error_of(grid.change({{{1, 0}, true}, {{9, 0}, true}})), outside);
  EXPECT_EQ(error_of(grid.change({{{1, 0}, true}}, {9, 0})), outside);
  EXPECT_EQ(error_of(grid.plan({0, 0}, {3, 0, 1})), "(3, 0, 1) lies outside the grid of 4 x 3 cells");
  EXPECT_FALSE(grid.blocked({1, 0}));
  EXPECT_EQ(grid.path().back(), (Cell{3, 0}));
  EXPECT_EQ(grid.cost(), 3);
}

}  // namespace
}  // namespace replan::test::replanner_test
