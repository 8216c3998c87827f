// LPA*: its repairs cost what plans from scratch cost, and less work; once the start has moved it begins afresh, and
// says so. (100 000 of each dimension in tests/property/lpa_star_property_test.cpp.)
#include "tests/support/repairs.hpp"

namespace replan::test::lpa_star_test {
namespace {

template <int D>
void check() {
  const RepairTally tally = check_repairs<D>(*find_planner("lpa-star"), 1, 3000);
  EXPECT_GT(tally.found, tally.repairs / 2);
  EXPECT_GT(tally.moved, 50);
  EXPECT_LT(tally.expansions, tally.afresh) << "repairs save work";
}

TEST(LpaStar, RepairsCostWhatAFreshAStarCostsIn2d) {
  check<2>();
}
TEST(LpaStar, RepairsCostWhatAFreshAStarCostsIn3d) {
  check<3>();
}

/// An edit far from the search is next to no work; a step of the start is a search from scratch.
TEST(LpaStar, KeepsItsSearchOnlyWhileTheStartStays) {
  Grid2 lattice({40, 30});
  Recorder recorder;
  const PlannerInfo& info = *find_planner("lpa-star");
  EXPECT_TRUE(info.incremental && info.keeps_start && !info.from_goal);
  const auto planner = make_planner(info, lattice, {}, recorder);
  const NodeId start = lattice.node(Cell{2, 2}), goal = lattice.node(Cell{35, 2});
  planner->begin(start, goal);
  finish(*planner);
  const std::int64_t first = planner->counters().expansions;
  recorder.clear();
  const CellEdit far{lattice.node(Cell{20, 25}), true};
  planner->update({.cells = {&far, 1}, .moves = lattice.apply({&far, 1})}, start);
  finish(*planner);
  EXPECT_EQ(planner->counters().expansions, first);
  const auto begins_afresh = [&] {
    const auto log = recorder.take();
    return std::any_of(log.begin(), log.end(), [](const Event& e) { return e.kind == EventKind::epoch; });
  };
  EXPECT_FALSE(begins_afresh());
  const CellEdit near{lattice.node(Cell{20, 2}), true};
  planner->update({.cells = {&near, 1}, .moves = lattice.apply({&near, 1})}, start);
  finish(*planner);
  EXPECT_FALSE(begins_afresh());
  EXPECT_GT(planner->counters().expansions, first);
  planner->update({.cells = {}, .moves = {}}, lattice.node(Cell{3, 2}));
  finish(*planner);
  EXPECT_TRUE(begins_afresh());
}

}  // namespace
}  // namespace replan::test::lpa_star_test
