// Field D*: its values are those of brute force after every change, its paths keep clear of all obstacles and are never
// much longer than they promise. (60 000 repairs in tests/property/field_dstar_property_test.cpp.)
#include "core/planners/field_dstar.hpp"

#include <cstdio>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::field_dstar_test {
namespace {

const PlannerInfo& field_dstar() {
  return *find_planner("field-dstar");
}

std::unique_ptr<Planner<Grid2>> planned(const Grid2& lattice, Cell start, Cell goal) {
  static NoTrace nobody;
  auto planner = make_planner(field_dstar(), lattice, {}, nobody);
  planner->begin(lattice.node(start), lattice.node(goal));
  finish(*planner);
  return planner;
}

/// The least distance of its points to an obstacle's square or the map's edge.
double clearance_of(const oracle::World& world, const Path& path) {
  double least = HUGE_VAL;
  for (std::size_t i = 1; i < path.size(); ++i)
    least = std::min(least, oracle::least_distance(world, path.point(i - 1).x, path.point(i - 1).y,
                                                   path.point(i).x, path.point(i).y));
  return least;
}

TEST(FieldDStar, CostsWhatBruteForceSaysAfterEveryChange) {
  std::int64_t plans = 0, found = 0, below_lattice = 0;
  for (std::uint64_t seed = 0; seed < 250; ++seed) {
    Random random(seed);
    const Settings settings = random_settings(random, field_dstar());
    const auto size = random_size<2>(random, {1, 1}, {16, 12});
    TwinWorld<2> world(size, random_cells<2>(random, size), move_rules(settings));
    NoTrace nobody;
    const auto planner = make_planner(field_dstar(), world.lattice, settings, nobody);
    NodeId start = random_free(random, world.plain);
    const NodeId goal = random_free(random, world.plain);
    planner->begin(start, goal);
    for (int round = 0; round < 8; ++round, ++plans) {
      finish(*planner);
      const MoveRules rules = move_rules(settings);
      const oracle::Raw right = oracle::interpolated_costs_to(world.plain, rules, goal)[start];
      const bool buried = world.plain.blocked[start] != 0;
      ASSERT_EQ(planner->cost().raw, buried ? oracle::kNever : right)
          << "seed " << seed << ", round " << round;
      if (planner->status() == PlanStatus::found) {
        const Path path = planner->path();
        ASSERT_EQ(fault_of_segments(field_dstar(), settings, world.plain, start, goal, path), "") << seed;
        ASSERT_LE(path_length(path), planner->cost().to_double() * kMostOverInterpolated + 1e-6) << seed;
        const oracle::Raw lattice = oracle::costs_to(world.plain, rules, {}, goal)[start];
        ASSERT_LE(right, lattice);
        below_lattice += right < lattice ? 1 : 0;
        ++found;
      }
      const auto edits = random_edits<2>(random, world.plain, 5);
      const auto moves = world.apply(edits);
      if (random.chance(0.5)) start = random_free(random, world.plain);
      planner->update({.cells = edits, .moves = moves}, start);
    }
  }
  std::printf("field-dstar: %lld plans, %lld found, %lld below the lattice's\n",
              static_cast<long long>(plans), static_cast<long long>(found),
              static_cast<long long>(below_lattice));
  EXPECT_GT(found, plans / 2);
  EXPECT_GT(below_lattice, found / 4);
}

/// Where no corner may be cut a path keeps half a cell from every obstacle's square and from the map's edge: it lies in
/// squares between four free cells, or between two along their side.
TEST(FieldDStar, KeepsHalfACellFromObstaclesWhereNoCornerIsCut) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const auto size = random_size<2>(random, {4, 4}, {24, 18});
    const TwinWorld<2> world(size, random_cells<2>(random, size), {});
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    const auto planner = planned(world.lattice, world.lattice.position(start), world.lattice.position(goal));
    if (planner->status() != PlanStatus::found || start == goal) continue;
    ++found;
    ASSERT_GE(clearance_of(world.plain, planner->path()), 0.5 - 1e-9) << "seed " << seed;
  }
  EXPECT_GT(found, 150);
}

/// The closed form of the way across a square, against the least over a thousand points of its far side.
TEST(FieldDStar, TheWayAcrossASquareIsTheLeastOverItsFarSide) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Cost straight{Cost::cells(3).raw + static_cast<std::int64_t>(random.below(1u << 30))};
    const Cost diagonal{straight.raw - static_cast<std::int64_t>(random.below(1u << 30)) + (1 << 28)};
    double least = HUGE_VAL;
    for (int k = 0; k <= 1000; ++k) {
      const double y = k / 1000.0;
      least =
          std::min(least, std::sqrt(1 + y * y) + (1 - y) * straight.to_double() + y * diagonal.to_double());
    }
    const Cost best = std::min(
        {across(straight, diagonal), straight + Grid2::step_cost(1), diagonal + Grid2::step_cost(0)});
    ASSERT_LE(best.to_double(), least + 1e-8);
    ASSERT_GE(best.to_double(), least - 1e-6);
  }
}

/// It is a strictly weakly superior function: more than both g, and no less if one of them grows.
TEST(FieldDStar, AWayAcrossIsMoreThanBothEndsAndGrowsWithThem) {
  for (std::int64_t f :
       {std::int64_t{1}, std::int64_t{2}, std::int64_t{30'000}, kSteepest / 2, kSteepest - 1, kSteepest}) {
    const Cost diagonal = Cost::cells(7), straight{diagonal.raw + f};
    const Cost sum = across(straight, diagonal);
    ASSERT_FALSE(sum.is_infinite());
    EXPECT_GT(sum, straight);
    EXPECT_GT(sum, diagonal);
    EXPECT_GT(sum.raw - straight.raw, kInterpolatedShare.raw) << "so that the heuristic is consistent";
    EXPECT_LE(sum, std::min(across({straight.raw + 1}, diagonal), diagonal + Grid2::step_cost(0)));
    EXPECT_LE(sum, std::min(across(straight, {diagonal.raw + 1}), straight + Grid2::step_cost(1)));
  }
  EXPECT_TRUE(across(Cost::cells(7), Cost::cells(7)).is_infinite());
  EXPECT_TRUE(across(Cost::infinity(), Cost::cells(7)).is_infinite());
  EXPECT_TRUE(across(Cost::cells(7), Cost::infinity()).is_infinite());
}

/// Across open ground: much nearer to the straight way than the lattice's path is.
TEST(FieldDStar, GoesNearlyStraightAcrossOpenGround) {
  const Grid2 empty({50, 40});
  const auto planner = planned(empty, {3, 4}, {44, 20});
  const double straight = distance(Cell{3, 4}, Cell{44, 20}), lattice = 16 * std::sqrt(2) + 25;
  const double length = path_length(planner->path());
  EXPECT_LT(length, straight * 1.01);
  EXPECT_GT(length, straight);
  EXPECT_GT(lattice, straight * 1.07);
}

/// A door shuts ahead: what is repaired is less than what a plan from scratch takes, and it comes to the same.
TEST(FieldDStar, RepairsWithLessWorkThanFromScratch) {
  std::vector<std::uint8_t> cells(60 * 40);
  for (int y = 0; y < 40; ++y)
    if (y != 8 && y != 30) cells[static_cast<std::size_t>(y * 60 + 20)] = 1;
  Grid2 lattice({60, 40}, cells);
  const auto planner = planned(lattice, {3, 20}, {55, 20});
  const std::int64_t first = planner->counters().expansions;
  const CellEdit door{lattice.node(Cell{20, 30}), true};
  const auto moves = lattice.apply({&door, 1});
  planner->update({.cells = {&door, 1}, .moves = moves}, lattice.node(Cell{4, 21}));
  finish(*planner);
  const auto fresh = planned(lattice, {4, 21}, {55, 20});
  EXPECT_EQ(planner->cost(), fresh->cost());
  EXPECT_LT(planner->counters().expansions - first, fresh->counters().expansions / 2);
}

}  // namespace
}  // namespace replan::test::field_dstar_test
