// What made a robot plan again, against the maps that its log has before and after.
#include "core/debug/replan_change.hpp"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/missions.hpp"

namespace replan::test::replan_change_test {
namespace {

TEST(ReplanChange, IsWhereTheMapsOfTwoPlansDiffer) {
  int replans = 0;
  std::set<ChangeKind> kinds;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const PlannerInfo& info = *find_planner("dstar-lite");
    const Scenario scenario = random_scenario(random, info);
    Recorder recorder;
    const auto mission = make_mission(scenario, scenario.planners[0], &recorder);
    for (int slices = 0; mission->advance(64) && slices < 1000; ++slices) {
    }
    Timeline log(initial_state(scenario, scenario.planners[0]));
    log.append(recorder.take());
    const Box box = scenario.map.box();
    const LogView view{log, box, info, scenario.planners[0].settings, scenario.robot.radius};
    std::size_t before = 0;
    for (std::size_t i = 0; i < log.size(); ++i) {
      if (log.event(i).kind == EventKind::plan_end) before = i + 1;
      if (log.event(i).kind != EventKind::plan_begin || log.event(i).delta == 0) continue;
      ++replans;
      const SearchState old = log.state_at(before), now = log.state_at(i);
      std::set<NodeId> told;
      for (const ChangedCell& each : changes_before(view, i, scenario.map.blocked, 100'000)) {
        const bool blocked = each.kind != ChangeKind::free && each.kind != ChangeKind::forgotten;
        ASSERT_EQ(now.known_blocked(each.node), blocked) << "seed " << seed << ", event " << i;
        if (each.kind == ChangeKind::moving) {
          ASSERT_TRUE(now.moving(each.node));
        }
        if (each.kind == ChangeKind::surprise) {
          ASSERT_FALSE(scenario.map.blocked[each.node] != kFree);
        }
        told.insert(each.node);
        kinds.insert(each.kind);
      }
      const std::size_t all = changes_before(view, i, scenario.map.blocked, 100'000).size();
      ASSERT_EQ(changes_before(view, i, scenario.map.blocked, 2).size(), std::min<std::size_t>(2, all));
      for (NodeId node = 0; node < box.node_count(); ++node)
        if (old.known_blocked(node) != now.known_blocked(node)) {
          ASSERT_TRUE(told.contains(node)) << "seed " << seed << ", event " << i << ", cell " << node;
        }
    }
  }
  EXPECT_GT(replans, 200);
  EXPECT_EQ(kinds.size(), 5u) << "all that can happen has to";
}

}  // namespace
}  // namespace replan::test::replan_change_test
