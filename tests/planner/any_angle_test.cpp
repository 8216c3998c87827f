// Theta* and Lazy Theta* beside A* and beside the shortest of all any-angle paths between cells' centres.
#include <cmath>
#include <cstdio>
#include <limits>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/plan/registry.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::any_angle_test {
namespace {

constexpr const char* kAnyAngle[] = {"theta-star", "lazy-theta-star"};

/// How long a path is at least: no polyline between cells' centres over lines of sight is shorter. Dijkstra's
/// algorithm over all pairs that see each other.
double shortest_of_all(const oracle::World& world, CornerRule corners, SightRule rule, NodeId start,
                       NodeId goal) {
  const std::size_t count = world.blocked.size();
  std::vector<double> way(count, std::numeric_limits<double>::infinity());
  std::vector<bool> done(count);
  way[start] = 0;
  for (;;) {
    std::size_t u = count;
    for (std::size_t n = 0; n < count; ++n)
      if (!done[n] && std::isfinite(way[n]) && (u == count || way[n] < way[u])) u = n;
    if (u == count || u == goal) return way[goal];
    done[u] = true;
    const oracle::Place p = world.place(u);
    for (std::size_t n = 0; n < count; ++n) {
      if (done[n] || world.blocked[n] != 0) continue;
      const oracle::Place q = world.place(n);
      double squared = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) squared += double(p[axis] - q[axis]) * (p[axis] - q[axis]);
      const double sum = way[u] + std::sqrt(squared);
      if (sum < way[n] && oracle::sees(world, world.blocked, corners, rule, u, n)) way[n] = sum;
    }
  }
}

struct Tally {
  std::int64_t plans = 0, shorter = 0, optimal = 0;
  double over = 0;  // the optimum, added up
};

template <int D>
void check_between(const char* id, int worlds) {
  const PlannerInfo& info = *find_planner(id);
  Tally tally;
  for (int seed = 0; seed < worlds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 77);
    Settings settings = random_settings(random, info);
    settings.set("moves", 0);
    typename BoxLattice<D>::Coordinates low{}, high{};
    low.fill(D == 2 ? 5 : 3);
    high.fill(D == 2 ? 14 : 5);
    const auto size = random_size<D>(random, low, high);
    const TwinWorld<D> world(size, random_cells<D>(random, size), move_rules(settings));
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    SCOPED_TRACE(describe_settings(info, settings) + ", seed " + std::to_string(seed));
    NoTrace nobody;
    const auto planner = make_planner(info, world.lattice, settings, nobody);
    const auto astar = make_planner(*find_planner("astar"), world.lattice, {}, nobody);
    planner->begin(start, goal);
    astar->begin(start, goal);
    ASSERT_EQ(finish(*planner), finish(*astar));
    if (planner->status() != PlanStatus::found) continue;
    ASSERT_LE(planner->cost(), astar->cost()) << "in whole units";
    const double length = path_length(planner->path());
    const auto rule = static_cast<SightRule>(static_cast<int>(settings.get("sight", 0)));
    const double least = shortest_of_all(world.plain, move_rules(settings).corners, rule, start, goal);
    ASSERT_LE(length, path_length(astar->path()) + 1e-9);
    ASSERT_GE(length, least - 1e-9);
    ++tally.plans;
    tally.shorter += length < path_length(astar->path()) - 1e-6 ? 1 : 0;
    tally.optimal += length < least + 1e-6 ? 1 : 0;
    tally.over += least > 0 ? length / least - 1 : 0;
  }
  std::printf("%s, %dd: %lld plans, %lld shorter than A*'s, %lld shortest of all; %.3f %% above on average\n",
              id, D, static_cast<long long>(tally.plans), static_cast<long long>(tally.shorter),
              static_cast<long long>(tally.optimal), 100 * tally.over / static_cast<double>(tally.plans));
  EXPECT_GT(tally.shorter, tally.plans / 4);
}

class AnyAngle : public ::testing::TestWithParam<const char*> {};

TEST_P(AnyAngle, IsNeverLongerThanAStarNorShorterThanTheShortestIn2d) {
  check_between<2>(GetParam(), 300);
}
TEST_P(AnyAngle, IsNeverLongerThanAStarNorShorterThanTheShortestIn3d) {
  check_between<3>(GetParam(), 150);
}

/// The same without the brute force, on larger worlds of all kinds and under every setting.
template <int D>
void check_not_longer(const char* id, int worlds) {
  const PlannerInfo& info = *find_planner(id);
  std::int64_t plans = 0;
  for (int seed = 0; seed < worlds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 4000);
    const Settings settings = random_settings(random, info);
    typename BoxLattice<D>::Coordinates low{}, high{};
    low.fill(D == 2 ? 20 : 6);
    high.fill(D == 2 ? 60 : 16);
    const auto size = random_size<D>(random, low, high);
    const TwinWorld<D> world(size, random_cells<D>(random, size), move_rules(settings));
    NoTrace nobody;
    const auto planner = make_planner(info, world.lattice, settings, nobody);
    const auto astar = make_planner(*find_planner("astar"), world.lattice, {}, nobody);
    for (int pair = 0; pair < 3; ++pair) {
      const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
      planner->begin(start, goal);
      astar->begin(start, goal);
      ASSERT_EQ(finish(*planner), finish(*astar));
      ASSERT_LE(planner->cost(), astar->cost()) << describe_settings(info, settings) << ", seed " << seed;
      if (planner->status() != PlanStatus::found) continue;
      ASSERT_LE(path_length(planner->path()), planner->cost().to_double() + 1e-6);
      ++plans;
    }
  }
  std::printf("%s, %dd: %lld plans, none longer than A*'s\n", id, D, static_cast<long long>(plans));
}

TEST_P(AnyAngle, IsNeverLongerThanAStarOnLargerWorldsIn2d) {
  check_not_longer<2>(GetParam(), 1000);
}
TEST_P(AnyAngle, IsNeverLongerThanAStarOnLargerWorldsIn3d) {
  check_not_longer<3>(GetParam(), 300);
}

/// On an empty map the path is the straight line.
TEST_P(AnyAngle, GoesStraightWhereNothingIsInTheWay) {
  const Grid2 empty({50, 40});
  NoTrace nobody;
  const auto planner = make_planner(*find_planner(GetParam()), empty, {}, nobody);
  planner->begin(empty.node(Cell{3, 4}), empty.node(Cell{44, 31}));
  ASSERT_EQ(finish(*planner), PlanStatus::found);
  EXPECT_EQ(planner->path().size(), 2u);
  EXPECT_EQ(planner->cost(), euclidean_ceil(41 * 41 + 27 * 27));
}
INSTANTIATE_TEST_SUITE_P(Planners, AnyAngle, ::testing::ValuesIn(kAnyAngle), [](const auto& param) {
  std::string name = param.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

template <int D>
void check_checks() {
  typename BoxLattice<D>::Coordinates size{};
  size.fill(D == 2 ? 60 : 16);
  std::int64_t eager = 0, lazy = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const TwinWorld<D> world(size, random_cells<D>(random, size), {});
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    for (const char* id : kAnyAngle) {
      NoTrace nobody;
      const auto planner = make_planner(*find_planner(id), world.lattice, {}, nobody);
      planner->begin(start, goal);
      finish(*planner);
      (id == kAnyAngle[0] ? eager : lazy) += planner->counters().sight_checks;
    }
  }
  std::printf("%dd, lines of sight: Theta* %lld, Lazy Theta* %lld\n", D, static_cast<long long>(eager),
              static_cast<long long>(lazy));
  EXPECT_LT(lazy, eager);
}

TEST(LazyThetaStar, AsksForFewerLinesOfSightIn2d) {
  check_checks<2>();
}
TEST(LazyThetaStar, AsksForFewerLinesOfSightIn3d) {
  check_checks<3>();
}

}  // namespace
}  // namespace replan::test::any_angle_test
