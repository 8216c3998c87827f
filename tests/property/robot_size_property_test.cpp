// A robot with a size: obstacles grown by its radius equal brute force, bit for bit and after any edits; what it sees
// and the ways out of narrow places are what brute force says; and on random missions with surprises and moving
// obstacles its body never touches anything.
#include <cstdio>
#include <queue>

#include <gtest/gtest.h>

#include "core/lattice/sight.hpp"
#include "core/lattice/way_out.hpp"
#include "core/sim/body.hpp"
#include "tests/support/each_planner.hpp"
#include "tests/support/mission_witness.hpp"
#include "tests/support/trials.hpp"

namespace replan::test::robot_size_property_test {
namespace {

template <int D>
struct Sized {
  double radius = 0;
  TwinWorld<D> world;

  explicit Sized(Random& random) : Sized(random, some_radius(random)) {}

  [[nodiscard]] std::vector<std::uint8_t> brute_force() const { return oracle::grown(world.plain, radius); }

 private:
  Sized(Random& random, double r) : radius(r), world(make(random, r)) {}

  static double some_radius(Random& random) {
    Scenario scenario;
    give_size(random, scenario);
    return D == 2 && random.chance(0.1) ? 2 * scenario.robot.radius : scenario.robot.radius;
  }
  static TwinWorld<D> make(Random& random, double r) {
    typename BoxLattice<D>::Coordinates low, high;
    low.fill(D == 2 ? 1 : 2);
    high.fill(D == 2 ? 14 : 7);
    const auto size = random_size<D>(random, low, high);
    std::vector<std::uint8_t> cells = random_cells<D>(random, size);
    if (random.chance(0.7))  // so that something is left free
      for (std::uint8_t& cell : cells)
        if (random.chance(0.8)) cell = 0;
    return {
        size,
        cells,
        {.corners = static_cast<CornerRule>(random.below(3)), .diagonals = random.chance(0.8), .radius = r}};
  }
};

/// Cells, moves and what is told of both against a lattice without a size on the cells that brute force names.
template <int D>
void expect_brute_force(const Sized<D>& sized) {
  const BoxLattice<D>& lattice = sized.world.lattice;
  const std::vector<std::uint8_t> grown = sized.brute_force();
  ASSERT_TRUE(std::equal(grown.begin(), grown.end(), lattice.cells().begin(), lattice.cells().end()));
  const auto& plain = sized.world.plain.blocked;
  ASSERT_TRUE(std::equal(plain.begin(), plain.end(), lattice.obstacles().begin(), lattice.obstacles().end()));
  const BoxLattice<D> as_point(lattice.size(), grown, {.diagonals = lattice.rules().diagonals});
  for (NodeId n = 0; n < lattice.node_count(); ++n) {
    ASSERT_EQ(lattice.moves(n), as_point.moves(n)) << n;
    const std::int64_t least = oracle::least_quarters(sized.world.plain, n);
    const bool near = plain[n] != 0 || (least != INT64_MAX && oracle::nearer(least, sized.radius));
    ASSERT_EQ(lattice.inflation().quarters(n), near ? least : Inflation<D>::kClear) << n;
  }
}

template <int D>
void grow(int maps) {
  std::int64_t blocked = 0, obstacles = 0, turned = 0;
  for (int seed = 0; seed < maps; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) * 10 + D);
    Sized<D> sized(random);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", radius " + std::to_string(sized.radius));
    expect_brute_force(sized);
    ASSERT_FALSE(::testing::Test::HasFatalFailure());
    for (int change = 0; change < 4; ++change) {
      const std::vector<CellEdit> edits = random_edits<D>(random, sized.world.plain, 8);
      const std::vector<std::uint8_t> before = sized.brute_force();
      std::vector<std::uint32_t> moves;
      for (NodeId n = 0; n < before.size(); ++n) moves.push_back(sized.world.lattice.moves(n));
      const auto changes = sized.world.apply(edits);
      std::vector<CellEdit> told;
      const std::vector<std::uint8_t> after = sized.brute_force();
      for (NodeId n = 0; n < before.size(); ++n)
        if (before[n] != after[n]) told.push_back({n, after[n] != 0});
      const auto all = sized.world.lattice.turned_by(edits);
      ASSERT_EQ(told, std::vector<CellEdit>(all.begin(), all.end()));
      std::size_t differ = 0;
      for (NodeId n = 0; n < before.size(); ++n) differ += moves[n] != sized.world.lattice.moves(n) ? 1u : 0u;
      ASSERT_EQ(changes.size(), differ);
      for (const auto& move : changes) ASSERT_EQ(move.before, moves[move.node]);
      expect_brute_force(sized);
      ASSERT_FALSE(::testing::Test::HasFatalFailure());
      turned += static_cast<std::int64_t>(told.size());
    }
    for (NodeId n = 0; n < sized.world.lattice.node_count(); ++n) {
      blocked += sized.world.lattice.blocked(n) ? 1 : 0;
      obstacles += sized.world.lattice.obstacles()[n] != 0 ? 1 : 0;
    }
  }
  std::printf("%d maps: %lld obstacles block %lld cells, %lld cells turned\n", maps,
              static_cast<long long>(obstacles), static_cast<long long>(blocked),
              static_cast<long long>(turned));
  EXPECT_GT(blocked, obstacles * 5 / 4);
  EXPECT_GT(turned, maps);
}

TEST(RobotSize, GrownObstaclesEqualBruteForceInThePlane) {
  grow<2>(10'000);
}
TEST(RobotSize, GrownObstaclesEqualBruteForceInSpace) {
  grow<3>(2'000);
}

// The least radius that a square at each distance is too near for, and the greatest that it is not.
TEST(RobotSize, IsComparedExactly) {
  Random random(3);
  for (std::int64_t quarters = 1; quarters <= 4 * 33 * 33; ++quarters) {
    const double root = std::sqrt(static_cast<double>(quarters)) / 2;
    for (const double radius :
         {std::nextafter(root, 0), root, std::nextafter(root, 100), root * random.unit()})
      if (radius > 0) {
        ASSERT_EQ(quarters < limit_of(radius), oracle::nearer(quarters, radius)) << quarters << " " << radius;
        ASSERT_EQ(quarters - 1 < limit_of(radius), oracle::nearer(quarters - 1, radius));
      }
  }
  EXPECT_EQ(limit_of(0.5), 1);
  EXPECT_EQ(limit_of(1), 4);
  EXPECT_EQ(limit_of(std::nextafter(1, 2)), 5);
  EXPECT_EQ(limit_of(1e-300), 1);
}

template <int D>
void look(int maps) {
  std::int64_t seen = 0, asked = 0;
  for (int seed = 0; seed < maps; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) * 10 + 5 + D);
    const Sized<D> sized(random);
    const BoxLattice<D>& lattice = sized.world.lattice;
    const std::vector<std::uint8_t> grown = sized.brute_force();
    const auto bad = [&lattice](NodeId n) { return lattice.blocked(n); };
    const auto world = lattice.box();
    for (int pair = 0; pair < 30; ++pair) {
      const NodeId a = random.below(static_cast<std::uint32_t>(grown.size())),
                   b = random.below(static_cast<std::uint32_t>(grown.size()));
      const bool sees = line_of_sight(lattice, SightRule::supercover, a, b, bad);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(a) + " to " + std::to_string(b));
      ASSERT_EQ(sees, oracle::sees_wide(sized.world.plain, grown, a, b));
      ASSERT_EQ(sees, line_of_sight(lattice, SightRule::bresenham, b, a, bad));
      ++asked;
      seen += sees && a != b ? 1 : 0;
      const Point from = centre_of(world.position(a)), to = centre_of(world.position(b));
      if (sees) {
        ASSERT_FALSE(hits(world, lattice.obstacles(), sized.radius, from, to));
      }
      // The body against points of the way.
      const double nearest = std::sqrt(Body(world, 100, from, to).nearest(lattice.obstacles()));
      double sampled = 100;
      for (int k = 0; k <= 200; ++k) {
        const double t = k / 200.0;
        const Point at{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                       from.z + t * (to.z - from.z)};
        sampled = std::min(sampled, std::sqrt(Body(world, 100, at, at).nearest(lattice.obstacles())));
      }
      ASSERT_LE(nearest, sampled + 1e-9);
      ASSERT_GE(nearest, sampled - 0.05);
    }
  }
  std::printf("%lld of %lld pairs see each other\n", static_cast<long long>(seen),
              static_cast<long long>(asked));
  EXPECT_GT(seen, asked / 20);
}

TEST(RobotSize, SeesWhatItsBodyCanPassInThePlane) {
  look<2>(150);
}
TEST(RobotSize, SeesWhatItsBodyCanPassInSpace) {
  look<3>(80);
}

/// How far it is to each cell on ways that come no nearer to obstacles than each cell that they leave; through cells
/// that are too near one, up to the first that is not.
template <int D>
std::vector<oracle::Raw> ways_out(const Sized<D>& sized, NodeId robot) {
  const oracle::World& world = sized.world.plain;
  const std::vector<std::uint8_t> grown = sized.brute_force();
  std::vector<oracle::Raw> costs(grown.size(), oracle::kNever);
  std::vector<std::int64_t> near;
  for (NodeId n = 0; n < grown.size(); ++n) near.push_back(oracle::least_quarters(world, n));
  costs[robot] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeId n = 0; n < grown.size(); ++n) {
      if (costs[n] == oracle::kNever || grown[n] == 0) continue;
      // What comes nearer than this cell is closed: then its moves are those of a world without corners cut.
      oracle::World open = world;
      for (NodeId other = 0; other < grown.size(); ++other)
        open.blocked[other] = near[other] < near[n] ? 1 : 0;
      for (const std::size_t there :
           oracle::neighbours(open, {.diagonals = sized.world.lattice.rules().diagonals}, n)) {
        const oracle::Raw sum = costs[n] + oracle::step_between(world, n, there);
        if (sum < costs[there]) costs[there] = sum, changed = true;
      }
    }
  }
  return costs;
}

TEST(RobotSize, LeavesByTheShortestWayThatComesNoNearer) {
  int ways = 0, held = 0, to_goal = 0;
  for (int seed = 0; seed < 3000; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) * 10 + 1);
    const Sized<2> sized(random);
    const Grid2& lattice = sized.world.lattice;
    const auto count = static_cast<std::uint32_t>(lattice.node_count());
    NodeId robot = random.below(count);
    for (int tries = 0; tries < 100 && (!lattice.blocked(robot) || lattice.obstacles()[robot] != 0); ++tries)
      robot = random.below(count);
    const NodeId goal = random.below(count);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", from " + std::to_string(robot));
    const std::vector<NodeId> way = way_out(lattice, robot, goal);
    if (!lattice.blocked(robot) || lattice.obstacles()[robot] != 0) {
      ASSERT_TRUE(way.empty());
      continue;
    }
    const auto costs = ways_out(sized, robot);
    const auto reach = oracle::costs_to({2, sized.world.plain.size, sized.brute_force()},
                                        {.diagonals = lattice.rules().diagonals}, {}, goal);
    std::pair<oracle::Raw, NodeId> nearest{oracle::kNever, kNoNode}, best = nearest;
    for (NodeId n = 0; n < count; ++n) {
      if (lattice.blocked(n) || costs[n] == oracle::kNever) continue;
      nearest = std::min(nearest, {costs[n], n});
      if (reach[n] < oracle::kNever && !lattice.blocked(goal)) best = std::min(best, {costs[n], n});
    }
    const auto end = best.second != kNoNode ? best : nearest;
    if (way.empty()) {
      ASSERT_EQ(end.second, kNoNode);
      ++held;
      continue;
    }
    ++ways;
    to_goal += best.second != kNoNode && best != nearest ? 1 : 0;
    ASSERT_EQ(way.front(), robot);
    ASSERT_EQ(way.back(), end.second);
    oracle::Raw length = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
      length += oracle::step_between(sized.world.plain, way[i - 1], way[i]);
      ASSERT_GE(oracle::least_quarters(sized.world.plain, way[i]),
                oracle::least_quarters(sized.world.plain, way[i - 1]));
      const Box world = lattice.box();
      ASSERT_FALSE(hits(world, lattice.obstacles(), sized.radius, centre_of(world.position(way[i - 1])),
                        centre_of(world.position(way[i]))));
    }
    ASSERT_EQ(length, end.first);
  }
  std::printf("%d ways out, %d of them not the nearest; %d robots held\n", ways, to_goal, held);
  EXPECT_GT(ways, 500);
  EXPECT_GT(to_goal, 5);
  EXPECT_GT(held, 20);
}

class SizedMissions : public ::testing::TestWithParam<const PlannerInfo*> {};

TEST_P(SizedMissions, EndWithoutACollision) {
  const PlannerInfo& info = *GetParam();
  if (!info.point_only.empty()) GTEST_SKIP() << "plans for a robot without a size alone";
  MissionTotals totals;
  const auto missions = static_cast<std::uint64_t>(trials(2000));
  for (std::uint64_t seed = 0; seed < missions; ++seed) {
    Random random(seed * 1000 + 77 + static_cast<std::uint64_t>(&info - planners().data()));
    Scenario scenario = random_scenario(random, info);
    give_size(random, scenario);
    if (random.chance(0.7))
      for (std::size_t cell = 0; cell < scenario.map.blocked.size(); ++cell)
        if (random.chance(0.8)) scenario.map.blocked[cell] = kFree;
    MissionWitness witness(scenario, info);
    const std::string fault = witness.run(totals);
    ASSERT_EQ(fault, "") << "seed " << seed << ", " << describe_settings(info, scenario.planners[0].settings)
                         << "\n"
                         << scenario_text(scenario);
  }
  std::printf(
      "%s: %lld missions, %lld arrived, %lld without a path; %lld moves, %lld of them too near an obstacle "
      "(%lld no farther from it, %lld out); %lld replans, %lld waits\n",
      std::string(info.id).c_str(), static_cast<long long>(totals.missions),
      static_cast<long long>(totals.arrived), static_cast<long long>(totals.no_path),
      static_cast<long long>(totals.moves), static_cast<long long>(totals.in_zone),
      static_cast<long long>(totals.along_zone), static_cast<long long>(totals.left_zone),
      static_cast<long long>(totals.replans), static_cast<long long>(totals.waits));
  for (const std::int64_t count_of :
       {totals.arrived, totals.no_path, totals.in_zone, totals.left_zone, totals.waits})
    EXPECT_GT(count_of, trials(20));
}

INSTANTIATE_TEST_SUITE_P(Planners, SizedMissions, ::testing::ValuesIn(each_of(sound_planners())),
                         planner_test_name);

}  // namespace
}  // namespace replan::test::robot_size_property_test
