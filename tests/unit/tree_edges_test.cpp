// Which edges of a large tree are drawn: all that are in sight, found without looking at those that are not.
#include "core/scene/tree_edges.hpp"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/plan/tree_values.hpp"

namespace replan::tree_edges_test {
namespace {

/// A rectangle that is looked at.
struct Window {
  double left, top, right, bottom;
  [[nodiscard]] bool meets(const Point& a, const Point& b) const {
    return std::max(a.x, b.x) >= left && std::min(a.x, b.x) <= right && std::max(a.y, b.y) >= top &&
           std::min(a.y, b.y) <= bottom;
  }
};

/// A plan whose robot is put down elsewhere later on, in a hall or a box of air with a wall.
std::unique_ptr<replan::Run> planned(std::string planner, bool solid, double samples) {
  auto scenario = std::make_shared<Scenario>();
  scenario->map = solid ? GridMap(60, 40, 12) : GridMap(300, 200);
  scenario->start = {4, 15};
  scenario->goal = {scenario->map.width - 5, 15};
  for (int z = 0; z < scenario->map.depth; ++z)
    for (int y = 0; y < 30; ++y) scenario->map.set({30, y, z}, true);
  scenario->planners = {{std::move(planner), {}}};
  scenario->planners[0].settings.set("samples", samples);
  Surprise moved;
  moved.at.move = 3;
  moved.robot = Cell{20, 35};
  scenario->surprises = {moved};
  auto run = std::make_unique<replan::Run>(scenario, 0);
  run->finish(Target::end());
  return run;
}

/// Held against a look at every vertex. One that has just been hung on another has no cost yet, and is not drawn.
void expect_bins(const replan::Run& run, EdgeBins& bins, const Window& window) {
  const SearchState& state = run.timeline().state();
  const bool solid = run.lattice().solid();
  const auto sees = [&](const Point& a, const Point& b) { return window.meets(a, b); };
  bins.follow(run);
  const auto found = bins.seen(SIZE_MAX, sees);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(std::is_sorted(found->begin(), found->end()));
  EXPECT_TRUE(std::adjacent_find(found->begin(), found->end()) == found->end());
  Cost dearest = Cost::zero();
  std::size_t edges = 0, in_sight = 0;
  for (std::uint32_t v = 0; v < vertex_count(state); ++v) {
    const std::uint32_t parent = vertex_parent(state, v);
    if (parent == kNoNode || vertex_cost(state, v).is_infinite()) continue;
    ++edges;
    dearest = std::max(dearest, vertex_cost(state, v));
    if (!sees(point_of(vertex_place(state, v, solid)), point_of(vertex_place(state, parent, solid))))
      continue;
    ++in_sight;
    EXPECT_TRUE(std::binary_search(found->begin(), found->end(), v)) << v;
  }
  EXPECT_EQ(bins.dearest(), dearest);
  EXPECT_LE(found->size(), edges) << "what was cut off or forgotten has no edge";
  if (in_sight > 0) {
    EXPECT_FALSE(bins.seen(in_sight - 1, sees).has_value()) << "more than were asked for";
  }
}

TEST(EdgeBins, HaveWhatALookAtEveryVertexFinds) {
  for (const char* planner : {"rrt-connect", "rrt-star", "greedy-informed-rrt-star"})
    for (const bool solid : {false, true}) {
      const auto run = planned(planner, solid, 3000);
      SCOPED_TRACE(std::string(planner) + (solid ? " in space" : " in the plane"));
      Timeline& log = run->timeline();
      ASSERT_GT(vertex_count(log.head()), 10u);
      EdgeBins bins;
      Random random(7);
      const auto at = [&](int most) { return static_cast<double>(random.between(0, most)); };
      for (int look = 0; look < 24; ++look) {
        const std::size_t near = log.cursor() + random.below(300);
        log.seek(std::min(log.size(),
                          look % 3 == 0 ? random.below(static_cast<std::uint32_t>(log.size())) : near));
        const double left = at(run->lattice().width()), top = at(run->lattice().height());
        expect_bins(*run, bins, {left, top, left + at(40), top + at(40)});
      }
    }
}

TEST(EdgeBins, AStepLooksAtFewStretches) {
  const auto run = planned("rrt-star", false, 8000);
  Timeline& log = run->timeline();
  std::size_t end = 0;
  while (log.event(end).kind != EventKind::plan_end) ++end;
  log.seek(end);
  EdgeBins bins;
  bins.follow(*run);
  const std::size_t whole = bins.scanned();
  bins.follow(*run);
  EXPECT_EQ(bins.scanned(), whole) << "nothing was written";
  log.seek(end - 12);
  bins.follow(*run);
  EXPECT_LE(bins.scanned(), whole + 2);
}

/// A goal in a closed room: the tree fills the rest of the world.
std::unique_ptr<replan::Run> huge_tree() {
  auto scenario = std::make_shared<Scenario>();
  scenario->map = GridMap(400, 300);
  for (int y = 139; y < 142; ++y)
    for (int x = 349; x < 352; ++x) scenario->map.set({x, y}, x != 350 || y != 140);
  scenario->start = {10, 15};
  scenario->goal = {350, 140};
  scenario->planners = {{"rrt", {}}};
  scenario->planners[0].settings.set("samples", 1.3 * kMostRead);
  auto run = std::make_unique<replan::Run>(scenario, 0);
  run->finish(Target::end());
  return run;
}

TEST(TreeEdges, OfATreeTooLargeToBeReadWhatIsInSightIsDrawnInFull) {
  const auto run = huge_tree();
  run->timeline().seek(run->timeline().size());
  const SearchState& state = run->timeline().state();
  const std::uint32_t count = vertex_count(state);
  ASSERT_GT(count, kMostRead + kMostRead / 10);
  EdgeBins bins;
  for (const Window& window :
       {Window{100, 100, 160, 150}, Window{0, 0, 20, 20}, Window{390, 290, 500, 500}}) {
    const auto sees = [&](const Point& a, const Point& b) { return window.meets(a, b); };
    const DrawnTree tree = drawn_tree(*run, &bins, sees);
    EXPECT_EQ(tree.every, 1);
    std::size_t in_sight = 0;
    for (std::uint32_t v = 1; v < count; ++v) {
      const Point from = point_of(vertex_place(state, vertex_parent(state, v), false)),
                  to = point_of(vertex_place(state, v, false));
      if (!sees(from, to)) continue;
      ASSERT_LT(in_sight, tree.edges.size());
      EXPECT_TRUE(tree.edges[in_sight].from == from && tree.edges[in_sight].to == to) << v;
      EXPECT_DOUBLE_EQ(tree.edges[in_sight].cost,
                       vertex_cost(state, v).to_double() / bins.dearest().to_double());
      ++in_sight;
    }
    EXPECT_EQ(tree.edges.size(), in_sight);
    EXPECT_LT(bins.seen(kMostRead, sees).value().size(), count / 10) << "most of it is not looked at";
    EXPECT_GT(in_sight, 100u);
  }
  const DrawnTree whole = drawn_tree(*run, nullptr, [](const Point&, const Point&) { return true; });
  EXPECT_GT(whole.every, 1);
  EXPECT_LE(whole.edges.size(), kMostEdges);
}

}  // namespace
}  // namespace replan::tree_edges_test
