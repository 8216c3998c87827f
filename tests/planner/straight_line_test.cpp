// What is blind: the straight line is there whatever stands in its way, and it is no planner among planners.
#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/plan/navigator.hpp"
#include "core/plan/registry.hpp"
#include "core/trace/search_state.hpp"

namespace replan::straight_line_test {
namespace {

const PlannerChoice kStraight{"straight-line", {}};

TEST(StraightLine, IsNoPlannerAmongPlanners) {
  const PlannerInfo* info = find_planner(kStraight.id);
  ASSERT_NE(info, nullptr);
  EXPECT_TRUE(info->blind);
  EXPECT_FALSE(require_planner(kStraight.id).ok());
  for (const PlannerInfo& planner : planners()) EXPECT_FALSE(planner.blind) << planner.id;
}

TEST(StraightLine, LeadsFromEachFreeCellToEachOtherThroughAnything) {
  for (const Box& box : {Box(17, 9), Box(6, 5, 4)}) {
    Random random(box.node_count());
    SharedBytes known(box.node_count());
    for (std::size_t i = 0; i < known.size(); ++i) known[i] = random.chance(0.4) ? 1 : 0;
    const auto any = [&] {
      return static_cast<NodeId>(random.below(static_cast<std::uint32_t>(box.node_count())));
    };
    Recorder recorder;
    const auto navigator = make_navigator(kStraight, box, known, 0, &recorder);
    SearchState state(known, known, find_planner(kStraight.id)->values.fields);
    NodeId goal = any();
    for (int i = 0; i < 300; ++i) {
      const NodeId start = any();
      const bool afresh = i % 7 == 0;
      if (afresh) goal = any();
      if (afresh)
        navigator->begin(centre_of(box.position(start)), centre_of(box.position(goal)));
      else
        navigator->update(centre_of(box.position(start)));
      const PlanStatus wanted = known[start] != 0  ? PlanStatus::start_blocked
                                : known[goal] != 0 ? PlanStatus::goal_blocked
                                                   : PlanStatus::found;
      ASSERT_EQ(finish(*navigator), wanted);
      for (const Event& event : recorder.take()) state.apply(event);
      EXPECT_EQ(state.node(Scalar::start), start);
      EXPECT_EQ(state.node(Scalar::goal), goal);
      for (NodeId n = 0; n < box.node_count(); ++n) EXPECT_TRUE(n == goal || state.g(n).is_infinite());
      const Path path = navigator->path();
      EXPECT_EQ(path.empty(), wanted != PlanStatus::found);
      if (path.empty()) continue;
      EXPECT_EQ(path.nodes().front(), start);
      EXPECT_EQ(path.nodes().back(), goal);
      EXPECT_EQ(path.size(), start == goal ? 1u : 2u);
      EXPECT_EQ(navigator->cost(), state.g(goal));
      EXPECT_NEAR(navigator->cost().to_double(), distance(box.position(start), box.position(goal)), 1e-9);
      EXPECT_EQ(navigator->counters().expansions, 0);
    }
  }
}

}  // namespace
}  // namespace replan::straight_line_test
