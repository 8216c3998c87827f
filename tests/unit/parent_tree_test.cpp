// The tree that parents make: against the state that it was read of, against plain counting, and where parents lead in a circle.
#include "core/debug/parent_tree.hpp"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "core/session/run.hpp"

namespace replan::parent_tree_test {
namespace {

std::unique_ptr<Run> walled_run(const PlannerInfo& info) {
  Scenario scenario;
  scenario.map = GridMap(14, 10);
  for (int y = 1; y < 9; ++y) scenario.map.set({7, y}, y != 3);
  scenario.start = {1, 5};
  scenario.goal = {12, 5};
  scenario.planners = {{std::string(info.id), {}}};
  if (info.sampling) scenario.planners[0].settings.set("samples", 150);
  Surprise surprise;
  surprise.at.move = 2;
  surprise.cells = {{{7, 3}, true}};
  scenario.surprises = {surprise};
  auto run = std::make_unique<Run>(std::make_shared<const Scenario>(scenario), 0);
  run->finish(Target::end());
  return run;
}

/// At the cursor, at once.
ParentTree tree_at_cursor(const Run& run) {
  ParentTableReader reader;
  reader.begin(run.log_view(), run.log_id());
  return ParentTree(reader.read(Deadline::never()));
}

/// How the state itself tells it, without a look at what the planner declares of its remote parents' order.
NodeId plain_parent(const Run& run, NodeId point) {
  const SearchState& state = run.timeline().state();
  if (run.info().values.grows()) return vertex_parent(state, point);
  if (run.info().any_angle && state.rp(point) != kNoNode)
    return state.rp(point) == point ? kNoNode : state.rp(point);
  return state.lp(point) == point ? kNoNode : state.lp(point);
}

void expect_tree(const Run& run, const ParentTree& tree, const std::string& where) {
  const auto count = static_cast<NodeId>(tree.point_count());
  std::vector<std::size_t> below(count), children(count);
  std::vector<bool> circle(count);
  for (NodeId point = 0; point < count; ++point) {
    ASSERT_EQ(tree.parent(point), plain_parent(run, point)) << where << ", point " << point;
    if (tree.parent(point) != kNoNode) ++children[tree.parent(point)];
    NodeId at = tree.parent(point);
    std::size_t steps = 0;
    for (; at != kNoNode && steps < count; at = tree.parent(at), ++steps) {
      circle[point] = circle[point] || at == point;
      if (!circle[point]) ++below[at];
    }
  }
  for (NodeId point = 0; point < count; ++point) {
    ASSERT_EQ(tree.in_circle(point), circle[point]) << where << ", point " << point;
    ASSERT_EQ(tree.children(point).size(), children[point]) << where << ", point " << point;
    ASSERT_TRUE(std::is_sorted(tree.children(point).begin(), tree.children(point).end()));
    for (const NodeId child : tree.children(point)) ASSERT_EQ(tree.parent(child), point);
    if (!circle[point]) {
      ASSERT_EQ(tree.below(point), below[point]) << where << ", point " << point;
    }
  }
}

TEST(ParentTree, OfEveryPlannerIsThatOfItsStateAtAnyMoment) {
  std::size_t with_parents = 0;
  for (const PlannerInfo& info : planners()) {
    if (!keeps_parents(info)) continue;
    ++with_parents;
    const auto run = walled_run(info);
    Timeline& log = run->timeline();
    // Forwards, and back again.
    for (int i = 0; i <= 16; ++i) {
      const std::size_t eighths = static_cast<std::size_t>(i <= 8 ? i : 16 - i);
      log.seek(log.size() * eighths / 8);
      expect_tree(*run, tree_at_cursor(*run), std::string(info.id) + " at " + std::to_string(log.cursor()));
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(with_parents, 10u);
}

TEST(ParentTree, AncestorsLeadToTheRootOfTheSearch) {
  const auto run = walled_run(*find_planner("dstar-lite"));
  Timeline& log = run->timeline();
  log.seek(log.size());
  const SearchState& state = log.state();
  const Ancestry up = ancestry(run->info(), state, state.node(Scalar::start));
  ASSERT_GT(up.points.size(), 1u);
  EXPECT_FALSE(up.circle);
  EXPECT_EQ(up.points.front(), state.node(Scalar::start));
  EXPECT_EQ(up.points.back(), state.node(Scalar::goal));
  for (std::size_t i = 0; i + 1 < up.points.size(); ++i)
    EXPECT_EQ(plain_parent(*run, up.points[i]), up.points[i + 1]);
}

TEST(ParentTree, CellsBelowAreThoseWhoseParentsLeadOverTheCell) {
  const auto run = walled_run(*find_planner("astar"));
  run->timeline().seek(run->timeline().size());
  const ParentTree tree = tree_at_cursor(*run);
  for (NodeId point = 0; point < tree.point_count(); ++point) {
    const CellSet below = cells_below(tree, point, run->lattice().node_count());
    EXPECT_EQ(below.size(), tree.below(point));
    EXPECT_FALSE(below.has(point));
    below.each([&](NodeId each) {
      const Ancestry up = ancestry(run->info(), run->timeline().state(), each);
      EXPECT_NE(std::find(up.points.begin(), up.points.end(), point), up.points.end());
    });
  }
}

/// 0 -> 1 -> 2 -> 0, with 3 on 0 and 4 on 3; 5 is a root with 6.
TEST(ParentTree, ACircleIsSaidAndHangsNothing) {
  auto table = std::make_shared<ParentTable>();
  table->parents = {1, 2, 0, 0, 3, kNoNode, 5};
  const ParentTree tree{std::shared_ptr<const ParentTable>(table)};
  for (const NodeId point : {0u, 1u, 2u}) EXPECT_TRUE(tree.in_circle(point));
  for (const NodeId point : {3u, 4u, 5u, 6u}) EXPECT_FALSE(tree.in_circle(point));
  EXPECT_EQ(tree.below(3), 1u);
  EXPECT_EQ(tree.below(5), 1u);
  const CellSet below = cells_below(tree, 1, 7);
  EXPECT_EQ(below.size(), 4u) << "0, 2, 3 and 4";
  EXPECT_FALSE(below.has(1));
}

TEST(ParentTree, AncestorsInACircleEndWhereItBeginsAgain) {
  const PlannerInfo& info = *find_planner("dstar-lite");
  SearchState state(8, info.values.fields);
  const auto hang = [&](NodeId point, NodeId parent) {
    state.apply(Event{.delta = std::uint64_t{parent} + 1, .node = point, .kind = EventKind::lp});
  };
  hang(5, 4);
  hang(4, 1);
  hang(1, 2);
  hang(2, 3);
  hang(3, 1);
  const Ancestry up = ancestry(info, state, 5);
  EXPECT_TRUE(up.circle);
  EXPECT_EQ(up.points, (std::vector<NodeId>{5, 4, 1, 2, 3}));
}

/// A single chain is the deepest that a million points can be.
TEST(ParentTree, OfAMillionPointsInAChainIsCounted) {
  constexpr NodeId kCount = 1'000'000;
  auto table = std::make_shared<ParentTable>();
  table->parents.push_back(kNoNode);
  for (NodeId point = 1; point < kCount; ++point) table->parents.push_back(point - 1);
  const ParentTree tree{std::shared_ptr<const ParentTable>(table)};
  EXPECT_EQ(tree.below(0), kCount - 1);
  EXPECT_EQ(tree.members(), kCount);
  EXPECT_EQ(cells_below(tree, 0, kCount).size(), kCount - 1);
}

TEST(ParentTree, IsReadSliceBySliceOfOneMoment) {
  Scenario scenario;
  scenario.map = GridMap(200, 200);
  scenario.start = {1, 100};
  scenario.goal = {198, 100};
  scenario.planners = {{"dijkstra", {}}};
  replan::Run run(std::make_shared<const Scenario>(scenario), 0);
  run.finish(Target::plan());
  Timeline& log = run.timeline();
  log.seek(log.size());
  ParentTableReader reader;
  reader.begin(run.log_view(), run.log_id());
  std::shared_ptr<const ParentTable> table;
  int slices = 0;
  while (!(table = reader.read(Deadline(0)))) {
    log.seek(log.cursor() / 2);
    ASSERT_LT(++slices, 1000);
  }
  EXPECT_GT(slices, 3);
  log.seek(log.size());
  EXPECT_EQ(table->position, log.size());
  for (NodeId point = 0; point < table->parents.size(); ++point)
    ASSERT_EQ(table->parents[point], plain_parent(run, point));
}

}  // namespace
}  // namespace replan::parent_tree_test
