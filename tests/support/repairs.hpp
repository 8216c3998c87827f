// Repairs of a plan whose start stays, held against a plan from scratch.
#pragma once

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace replan::test {

struct RepairTally {
  std::int64_t repairs = 0, found = 0, moved = 0;
  std::int64_t expansions = 0, afresh = 0;  ///< of the repairs, and of A* for the same
};

/// Random edits in random worlds until there were `count` replans; each costs what a fresh A* costs, and its path is
/// one. Now and then the start moves, or an end is covered, or a change comes while the search is under way.
template <int D>
RepairTally check_repairs(const PlannerInfo& info, std::uint64_t first_seed, std::int64_t count) {
  RepairTally tally;
  for (std::uint64_t seed = first_seed; tally.repairs < count; ++seed) {
    Random random(seed);
    const Settings settings = random_settings(random, info);
    const auto size = [&] {
      if constexpr (D == 2)
        return random_size<2>(random, {10, 10}, {24, 18});
      else
        return random_size<3>(random, {5, 5, 4}, {8, 7, 6});
    }();
    TwinWorld<D> world(size, random_cells<D>(random, size), move_rules(settings));
    NoTrace nobody;
    const auto planner = make_planner(info, world.lattice, settings, nobody);
    NodeId start = random_free(random, world.plain);
    const NodeId goal = random_free(random, world.plain);
    planner->begin(start, goal);
    finish(*planner);
    for (int i = 0; i < 50; ++i, ++tally.repairs) {
      const bool moves_on = random.chance(0.05);
      for (int rounds = random.chance(0.1) ? 2 : 1; rounds > 0; --rounds) {
        auto edits = random_edits<D>(random, world.plain, random.chance(0.2) ? 12 : 4);
        for (const NodeId end : {start, goal}) {
          std::erase_if(edits, [end](const CellEdit& edit) { return edit.node == end; });
          const bool covered = world.plain.blocked[end] != 0;
          if (random.chance(covered ? 0.7 : 0.02) && (edits.empty() || edits.back().node != end))
            edits.push_back({end, !covered});
        }
        const auto moves = world.apply(edits);
        if (moves_on) start = random_free(random, world.plain);
        planner->update({.cells = edits, .moves = moves}, start);
        if (rounds > 1) planner->advance(random.between(1, 20));
      }
      const std::int64_t before = planner->counters().expansions;
      finish(*planner);
      const auto fresh = make_planner(*find_planner("astar"), world.lattice, settings, nobody);
      fresh->begin(start, goal);
      finish(*fresh);
      EXPECT_EQ(planner->cost(), fresh->cost()) << "seed " << seed << ", change " << i;
      EXPECT_EQ(planner->status(), fresh->status()) << "seed " << seed << ", change " << i;
      if (planner->status() == PlanStatus::found) {
        EXPECT_EQ(fault_of_segments(info, settings, world.plain, start, goal, planner->path()), "");
        ++tally.found;
      }
      if (::testing::Test::HasFailure()) return tally;
      tally.moved += moves_on ? 1 : 0;
      if (moves_on) continue;
      tally.expansions += planner->counters().expansions - before;
      tally.afresh += fresh->counters().expansions;
    }
  }
  return tally;
}

}  // namespace replan::test
