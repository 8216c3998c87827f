// The planners whose estimate counts more than once: Weighted A* by a setting, Adaptive A* by what it finds on the map.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/planners/adaptive_astar.hpp"
#include "core/planners/weighted_astar.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::weighted_test {
namespace {

struct Work {
  Cost cost, weight;
  std::int64_t expansions = 0;
  std::vector<NodeId> nodes;
};

template <int D>
Work work_of(const char* id, const BoxLattice<D>& lattice, const Settings& settings, NodeId start,
             NodeId goal) {
  NoTrace nobody;
  const auto planner = make_planner(*find_planner(id), lattice, settings, nobody);
  planner->begin(start, goal);
  finish(*planner);
  const Path path = planner->path();
  return {planner->cost(),
          planner->number(Scalar::weight),
          planner->counters().expansions,
          {path.nodes().begin(), path.nodes().end()}};
}

/// cost <= weight times the cheapest, but for a unit of 2^-30 for each move.
bool within(Cost cost, Cost weight, Cost cheapest) {
  __extension__ using Wide = __int128;
  const Wide moves = cheapest.raw / Cost::kScale + 1;
  return (static_cast<Wide>(cost.raw) - moves) * Cost::kScale <= static_cast<Wide>(weight.raw) * cheapest.raw;
}

template <int D, class Check>
void in_random_worlds(int worlds, Check&& check) {
  typename BoxLattice<D>::Coordinates low{}, high{};
  low.fill(D == 2 ? 10 : 4);
  high.fill(D == 2 ? 40 : 12);
  for (int seed = 0; seed < worlds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto size = random_size<D>(random, low, high);
    const TwinWorld<D> world(size, random_cells<D>(random, size), {});
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    if (world.plain.blocked[start] != 0 || world.plain.blocked[goal] != 0) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    check(world, start, goal);
    ASSERT_FALSE(::testing::Test::HasFatalFailure());
  }
}

template <int D>
void check_weighted() {
  std::int64_t plain = 0, weighted = 0, longer = 0, plans = 0;
  in_random_worlds<D>(400, [&](const TwinWorld<D>& world, NodeId start, NodeId goal) {
    const Work astar = work_of("astar", world.lattice, {}, start, goal);
    for (const double weight : {1.0, 1.1, 1.5, 3.0, 10.0}) {
      Settings settings;
      settings.set("weight", weight);
      const Work found = work_of("weighted-astar", world.lattice, settings, start, goal);
      ASSERT_EQ(found.cost.is_infinite(), astar.cost.is_infinite());
      if (astar.cost.is_infinite()) continue;
      const Cost units{static_cast<std::int64_t>(std::floor(weight * static_cast<double>(Cost::kScale)))};
      ASSERT_TRUE(within(found.cost, units, astar.cost)) << weight;
      if (weight == 1) {
        ASSERT_EQ(found.nodes, astar.nodes) << "with weight 1 it is A*";
        ASSERT_EQ(found.expansions, astar.expansions);
      }
      ++plans;
      longer += found.cost > astar.cost ? 1 : 0;
      plain += weight == 1.5 ? astar.expansions : 0;
      weighted += weight == 1.5 ? found.expansions : 0;
    }
  });
  std::printf("%dd: %lld plans, %lld longer than A*'s; expansions with 1.5: %.2f of A*'s\n", D,
              static_cast<long long>(plans), static_cast<long long>(longer),
              static_cast<double>(weighted) / static_cast<double>(plain));
  EXPECT_GT(longer, 0);
  EXPECT_LT(weighted, plain);
}

TEST(WeightedAStar, CostsAtMostItsWeightTimesTheCheapestIn2d) {
  check_weighted<2>();
}
TEST(WeightedAStar, CostsAtMostItsWeightTimesTheCheapestIn3d) {
  check_weighted<3>();
}

/// N and the area by looking at each cell, and the weight by the C library in long double.
template <int D>
void check_adaptive() {
  std::int64_t plans = 0, longer = 0, empty = 0;
  in_random_worlds<D>(400, [&](const TwinWorld<D>& world, NodeId start, NodeId goal) {
    const oracle::Place p = world.plain.place(start), q = world.plain.place(goal);
    std::int64_t obstacles = 0, area = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) area *= std::abs(p[axis] - q[axis]) + 1;
    for (std::size_t i = 0; i < world.plain.blocked.size(); ++i) {
      const oracle::Place c = world.plain.place(i);
      bool inside = world.plain.blocked[i] != 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        inside &= std::min(p[axis], q[axis]) <= c[axis] && c[axis] <= std::max(p[axis], q[axis]);
      obstacles += inside ? 1 : 0;
    }
    const ObstacleShare share = obstacle_share(world.lattice, start, goal);
    ASSERT_EQ(share.obstacles, obstacles);
    ASSERT_EQ(share.cells, area);
    ASSERT_EQ(obstacle_share(world.lattice, goal, start).obstacles, obstacles) << "in any order of ends";
    empty += obstacles == 0 ? 1 : 0;
    const long double k = static_cast<long double>(std::max<std::int64_t>(obstacles, 1)) / area;
    ASSERT_NEAR(share.weight().to_double(), static_cast<double>(1 - std::log(k)), 2e-9);
    ASSERT_NEAR(share.share().to_double(), static_cast<double>(k), 2e-9);

    const Work astar = work_of("astar", world.lattice, {}, start, goal);
    const Work found = work_of("adaptive-astar", world.lattice, {}, start, goal);
    ASSERT_EQ(found.weight, share.weight());
    ASSERT_EQ(found.cost.is_infinite(), astar.cost.is_infinite());
    if (astar.cost.is_infinite()) return;
    ASSERT_TRUE(within(found.cost, share.weight(), astar.cost));
    ++plans;
    longer += found.cost > astar.cost ? 1 : 0;
  });
  std::printf("%dd: %lld plans, %lld longer than A*'s, no obstacle between the ends of %lld\n", D,
              static_cast<long long>(plans), static_cast<long long>(longer), static_cast<long long>(empty));
  EXPECT_GT(longer, 0);
  EXPECT_GT(empty, 0);
}

TEST(AdaptiveAStar, CountsWhatLiesBetweenStartAndGoalIn2d) {
  check_adaptive<2>();
}
TEST(AdaptiveAStar, CountsWhatLiesBetweenStartAndGoalIn3d) {
  check_adaptive<3>();
}

TEST(AdaptiveAStar, TakesNoObstacleForOneCell) {
  const Grid2 empty({30, 20});
  for (const auto& [from, to] :
       {std::pair<Cell, Cell>{{2, 3}, {21, 12}}, {{21, 12}, {2, 3}}, {{2, 12}, {21, 3}}}) {
    const ObstacleShare share = obstacle_share(empty, empty.node(from), empty.node(to));
    EXPECT_EQ(share.obstacles, 0);
    EXPECT_EQ(share.cells, 200);
    EXPECT_NEAR(share.weight().to_double(), 1 + std::log(200.0), 2e-9);
    EXPECT_NEAR(share.share().to_double(), 1 / 200.0, 2e-9);
  }
  const ObstacleShare one = obstacle_share(empty, 7, 7);
  EXPECT_EQ(one.weight(), Cost::cells(1)) << "start and goal alike: K is 1";
}

TEST(AdaptiveAStar, IsAStarWhereNearlyAllIsObstacle) {
  Grid2 world({40, 40}, std::vector<std::uint8_t>(1600, 1));
  std::vector<CellEdit> ring;  // the only way leads along the rectangle's border
  for (int i = 0; i < 40; ++i)
    ring.insert(ring.end(), {{world.node(Cell{i, 0}), false}, {world.node(Cell{39, i}), false}});
  world.apply(ring);
  const NodeId start = world.node(Cell{0, 0}), goal = world.node(Cell{39, 39});
  const ObstacleShare share = obstacle_share(world, start, goal);
  EXPECT_EQ(share.obstacles, 1600 - 79);
  const Work found = work_of("adaptive-astar", world, {}, start, goal);
  EXPECT_NEAR(found.weight.to_double(), 1 - std::log(1521.0 / 1600), 2e-9);
  EXPECT_LT(found.weight.to_double(), 1.06);
  EXPECT_EQ(found.cost, work_of("astar", world, {}, start, goal).cost);
}

/// K is of the map as the robot knows it when it plans.
TEST(AdaptiveAStar, WorksItOutAnewForEachPlan) {
  Grid2 world({20, 20});
  Recorder recorder;
  const auto planner = make_planner(*find_planner("adaptive-astar"), world, {}, recorder);
  const NodeId start = world.node(Cell{1, 1}), goal = world.node(Cell{10, 10});
  planner->begin(start, goal);
  finish(*planner);
  EXPECT_NEAR(planner->number(Scalar::weight).to_double(), 1 + std::log(100.0), 2e-9);
  const std::vector<CellEdit> edits = {
      {world.node(Cell{5, 5}), true}, {world.node(Cell{6, 5}), true}, {world.node(Cell{15, 5}), true}};
  const auto moves = world.apply(edits);
  planner->update({.cells = edits, .moves = moves}, start);
  finish(*planner);
  EXPECT_NEAR(planner->number(Scalar::weight).to_double(), 1 + std::log(50.0), 2e-9);
  EXPECT_NEAR(planner->number(Scalar::share).to_double(), 0.02, 2e-9);
  SearchState state(world.node_count());
  for (const Event& event : recorder.take()) state.apply(event);
  EXPECT_EQ(static_cast<std::int64_t>(state.scalar(Scalar::weight)), planner->number(Scalar::weight).raw);
  EXPECT_EQ(static_cast<std::int64_t>(state.scalar(Scalar::share)), planner->number(Scalar::share).raw);
}

}  // namespace
}  // namespace replan::test::weighted_test
