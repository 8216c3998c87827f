// Jump point search: A*'s answers under every corner rule, with fewer expansions; and what its log tells of the cells
// that jumps passed over.
#include "core/planners/jps.hpp"

#include <cstdio>

#include <gtest/gtest.h>

#include "core/trace/search_state.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::jps_test {
namespace {

/// Wide enough for several words of bits in a row, and for corners at their borders.
TwinWorld<2> wide_world(Random& random, CornerRule corners) {
  const auto size = random.chance(0.5) ? random_size<2>(random, {1, 1}, {20, 20})
                                       : random_size<2>(random, {60, 1}, {140, 70});
  return {size, random_cells<2>(random, size), {corners, true}};
}

TEST(Jps, CostsWhatAStarCostsUnderEveryCornerRuleAndAfterEveryChange) {
  std::int64_t found = 0;
  Counters of_jps, of_astar;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Random random(seed);
    Settings settings;
    settings.set("corners", static_cast<double>(seed % 3));
    auto world = wide_world(random, move_rules(settings).corners);
    NoTrace nobody;
    const auto jps = make_planner(*find_planner("jps"), world.lattice, settings, nobody);
    const auto astar = make_planner(*find_planner("astar"), world.lattice, settings, nobody);
    NodeId start = random_free(random, world.plain);
    const NodeId goal = random_free(random, world.plain);
    jps->begin(start, goal);
    astar->begin(start, goal);
    for (int round = 0; round < 6; ++round) {
      ASSERT_EQ(finish(*jps), finish(*astar)) << "seed " << seed << ", round " << round;
      ASSERT_EQ(jps->cost(), astar->cost()) << "seed " << seed << ", round " << round;
      found += jps->status() == PlanStatus::found ? 1 : 0;
      if (jps->status() == PlanStatus::found) {
        ASSERT_EQ(fault_of_segments(*find_planner("jps"), settings, world.plain, start, goal, jps->path()),
                  "");
      }
      const auto edits = random_edits<2>(random, world.plain, 6);
      const auto moves = world.apply(edits);
      start = random_free(random, world.plain);
      jps->update({.cells = edits, .moves = moves}, start);
      astar->update({.cells = edits, .moves = moves}, start);
    }
    of_jps = of_jps + jps->counters();
    of_astar = of_astar + astar->counters();
  }
  std::printf("jps: %lld plans, %lld expansions where A* has %lld\n", static_cast<long long>(found),
              static_cast<long long>(of_jps.expansions), static_cast<long long>(of_astar.expansions));
  EXPECT_GT(found, 1800);
  EXPECT_LT(of_jps.expansions * 2, of_astar.expansions);
}

/// Rows of bits against looking at each cell.
TEST(Jps, StopsWhereAWalkCellByCellWouldStop) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const auto size = random_size<2>(random, {1, 1}, {150, 12});
    const TwinWorld<2> world(size, random_cells<2>(random, size), {});
    const bool cuts = seed % 2 == 0;
    JumpRows rows(cuts);
    rows.make(world.lattice);
    const auto bad = [&](int x, int y) { return world.plain.bad({x, y, 0}); };
    for (int k = 0; k < 200; ++k) {
      const NodeId from = random_free(random, world.plain);
      if (world.plain.blocked[from] != 0) continue;
      const Cell at = world.lattice.position(from);
      const bool across = random.chance(0.5);
      const int sign = random.chance(0.5) ? 1 : -1, dx = across ? sign : 0, dy = across ? 0 : sign;
      int x = at.x, y = at.y;
      const auto turns = [&](int side) {
        const int px = across ? 0 : side, py = across ? side : 0;
        return cuts ? bad(x + px, y + py) && !bad(x + dx + px, y + dy + py)
                    : bad(x - dx + px, y - dy + py) && !bad(x + px, y + py);
      };
      do {
        x += dx;
        y += dy;
      } while (!bad(x, y) && !turns(-1) && !turns(1));
      ASSERT_EQ(rows.stop(across ? 0 : 1, sign, at.x, at.y), across ? x : y)
          << "seed " << seed << ", from " << at.x << ", " << at.y;
    }
  }
}

/// The log shows each cell of a path but its first as passed over, none that is blocked, and none of the search before.
TEST(Jps, TellsWhichCellsItsJumpsPassedOver) {
  std::size_t scanned = 0, held = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    auto world = wide_world(random, static_cast<CornerRule>(seed % 3));
    Settings settings;
    settings.set("corners", static_cast<double>(seed % 3));
    Recorder recorder;
    const PlannerInfo& info = *find_planner("jps");
    const auto jps = make_planner(info, world.lattice, settings, recorder);
    SearchState state(world.lattice.node_count(), info.values.fields);
    jps->begin(random_free(random, world.plain), random_free(random, world.plain));
    for (int round = 0; round < 3; ++round) {
      const auto before = jps->counters().expansions;
      finish(*jps);
      for (const Event& event : recorder.take()) state.apply(event);
      for (NodeId n = 0; n < world.lattice.node_count(); ++n) {
        const std::uint64_t value = state.value(own_field(0), n);
        if (value == 0) continue;
        ++scanned;
        ASSERT_EQ(world.plain.blocked[n], 0) << "seed " << seed;
        ASSERT_GT(value, static_cast<std::uint64_t>(before));
        ASSERT_LE(value, static_cast<std::uint64_t>(jps->counters().expansions));
      }
      const Path path = jps->path();
      for (std::size_t i = 1; i < path.size(); ++i, ++held)
        ASSERT_NE(state.value(own_field(0), path.nodes()[i]), 0u) << "seed " << seed;
      const auto edits = random_edits<2>(random, world.plain, 6);
      const auto moves = world.apply(edits);
      jps->update({.cells = edits, .moves = moves}, random_free(random, world.plain));
    }
  }
  EXPECT_GT(scanned, 10'000u);
  EXPECT_GT(held, 1'000u);
}

TEST(Jps, HasNoSettingForNeighbours) {
  EXPECT_EQ(find_parameter(find_planner("jps")->parameters, "moves"), nullptr);
  Settings settings;
  EXPECT_FALSE(set_from_text(settings, find_planner("jps")->parameters, "moves", "4").ok());
}

}  // namespace
}  // namespace replan::test::jps_test
