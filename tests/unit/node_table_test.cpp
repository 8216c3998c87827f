// A table of records forgets what was marked, and what a planner does with it: begin() costs the work of the
// search before and finds the map as it is.
#include "core/plan/node_table.hpp"

#include <gtest/gtest.h>

#include "core/trace/search_state.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::node_table_test {
namespace {

struct Record {
  int value = 7;
  std::uint32_t slot = 0;
};
struct Numbered : Record {
  std::uint32_t search = 0;
};

template <class Table>
void check_reset() {
  for (const std::size_t size : {1u, 63u, 64u, 65u, 511u, 512u, 513u, 5000u}) {
    Table table(size);
    ASSERT_EQ(table.size(), size);
    for (const std::size_t at : {std::size_t{0}, size / 2, size - 1}) {
      const auto node = static_cast<NodeId>(at);
      table.write(node).value = 1;
      table.set(node, 12);
      EXPECT_EQ(table.get(node), 12u);
      EXPECT_EQ(table[node].value, 1);
      EXPECT_EQ(&table.held(node), &table.write(node));
      EXPECT_EQ(table.held(node).value, 1);
      table.set(node, 0);  // as the open list does when it is cleared
    }
    table.reset();
    for (NodeId n = 0; n < size; ++n) {
      ASSERT_EQ(table[n].value, 7) << n << " of " << size;
      ASSERT_EQ(table.get(n), 0u);
    }
  }
}

TEST(NodeTable, ResetsEveryRecordThatWasWrittenToAndItsBlock) {
  check_reset<NodeTable<Record>>();
}
TEST(NumberedTable, ReadsRecordsOfEarlierSearchesAsBlank) {
  check_reset<NumberedTable<Numbered>>();
}

/// begin() after a change that the planner was not told of plans on the map as it is, and what it writes down
/// of the clearance is what has changed.
template <int D>
void check_begin_again(const PlannerInfo& info, std::uint64_t seed) {
  Random random(seed);
  const Settings settings = random_settings(random, info);
  SCOPED_TRACE(describe_settings(info, settings) + ", seed " + std::to_string(seed));
  typename BoxLattice<D>::Coordinates low, high;
  low.fill(D == 2 ? 6 : 4);
  high.fill(D == 2 ? 20 : 7);
  const auto size = random_size<D>(random, low, high);
  TwinWorld<D> world(size, random_cells<D>(random, size), move_rules(settings));
  Recorder recorder;
  const auto planner = make_planner(info, world.lattice, settings, recorder);
  SearchState state(world.lattice.node_count(), info.values.all_fields());
  for (int i = 0; i < 6; ++i) {
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    const auto before = state;
    planner->begin(start, goal);
    if (random.chance(0.3)) planner->advance(5);
    const std::vector<Event> events = recorder.take();
    for (const Event& event : events) {
      state.apply(event);
      if (event.kind == EventKind::dist) {
        ASSERT_NE(before.dist(event.node), state.dist(event.node));
      }
    }
    finish(*planner);
    for (const Event& event : recorder.take()) state.apply(event);
    const auto penalties = expected_penalties(info, settings, world.plain);
    for (NodeId n = 0; n < penalties.size(); ++n) ASSERT_EQ(state.dist(n).raw, penalties[n]);
    if (info.optimal(settings) || info.values.least_cost) {
      ASSERT_EQ(fault_of_plan<D>(info, settings, world.plain, start, goal, *planner), "");
    }
    recorder.clear();
    if (random.chance(0.7)) world.apply(random_edits<D>(random, world.plain, 6));
  }
}

TEST(NodeTable, LetsEveryPlannerBeginAgainOnAMapThatChangedUntold) {
  for (const PlannerInfo& info : sound_planners())
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      check_begin_again<2>(info, seed);
      if (!info.planar) check_begin_again<3>(info, seed);
      ASSERT_FALSE(HasFatalFailure()) << info.id;
    }
}

TEST(NodeTable, LatticesHaveARevisionForEveryMapTheyShow) {
  Grid2 lattice({5, 4}), other({5, 4});
  EXPECT_NE(lattice.revision(), other.revision());
  const std::uint64_t before = lattice.revision();
  lattice.apply({});
  const CellEdit same{3, false}, edit{3, true};
  lattice.apply({&same, 1});
  EXPECT_EQ(lattice.revision(), before) << "nothing has changed";
  lattice.apply({&edit, 1});
  EXPECT_NE(lattice.revision(), before);
  const Grid2 copy = lattice;
  EXPECT_EQ(copy.revision(), lattice.revision());
  const std::uint64_t edited = lattice.revision();
  lattice.set_rules({.corners = CornerRule::any});
  EXPECT_NE(lattice.revision(), edited);
}

}  // namespace
}  // namespace replan::test::node_table_test
