// What a repair is compared with: a plan from scratch on the same knowledge.
#include "core/session/fresh_plan.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "core/scene/scene.hpp"
#include "core/session/session.hpp"

namespace replan::fresh_plan_test {
namespace {

Scenario demo() {
  const auto scenario = read_scenario(REPLAN_SOURCE_DIR "/maps/demo.json");
  EXPECT_TRUE(scenario.ok());
  return *scenario;
}

void run_to_end(Session& session) {
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  for (const auto& run : session.runs()) run->finish(Target::end());
  session.update(0);
}

TEST(FreshPlan, OfTheFirstPlanIsThatPlan) {
  Session session(demo());
  session.settle();
  for (const auto& run : session.runs()) {
    const FreshPlan fresh = plan_from_scratch(FreshPlanTask(*run), {});
    SceneMemory memory;
    EXPECT_EQ(fresh.expansions, run->decisions().front().figures.counters.expansions) << run->choice().id;
    EXPECT_EQ(fresh.expansions, memory.expansions(*run, run->timeline().size())) << run->choice().id;
    EXPECT_GE(fresh.touched, fresh.expansions);
    EXPECT_GT(fresh.ms, 0);
  }
}

TEST(FreshPlan, OfAReplanCostsWhatANewRunFromThereDoes) {
  Session session(demo());
  run_to_end(session);
  SceneMemory memory;
  FreshPlans plans;
  const replan::Run& run = session.run();
  for (const Milestone& milestone : run.milestones()) {
    if (milestone.kind != EventKind::plan_end) continue;
    ASSERT_TRUE(session.apply(Seek{milestone.event + 1}).ok());
    const RepairFigures repair = memory.repair(run, run.timeline().cursor());
    if (repair.number == 0) continue;
    const auto fresh = plans.of(run, static_cast<std::size_t>(repair.number), true);
    ASSERT_TRUE(fresh.has_value());
    // The same world as the robot knows it now, and a robot that sets out here.
    Scenario there = run.scenario();
    there.surprises.clear();
    there.start = run.lattice().position(run.timeline().state().node(Scalar::start));
    for (NodeId n = 0; n < run.lattice().node_count(); ++n)
      there.map.set(run.lattice().position(n), run.timeline().state().known_blocked(n));
    Session other(there);
    other.settle();
    EXPECT_EQ(fresh->expansions, other.run().decisions().front().figures.counters.expansions);
    EXPECT_GT(repair.cause.blocked, 0);
    EXPECT_TRUE(repair.ms.has_value());
  }
}

TEST(FreshPlan, IsWhatAPlannerMakesWhenTheGoalHasMoved) {
  for (const char* planner : {"dstar-lite", "dld-star-lite", "astar"}) {
    Scenario scenario = demo();
    scenario.surprises.clear();
    scenario.planners = {{planner, {}}};
    Session session(scenario);
    session.settle();
    ASSERT_TRUE(session.apply(Step{StepUnit::move, 9}).ok());
    ASSERT_TRUE(session.apply(SetGoal{{29, 3}}).ok());
    session.settle();
    SceneMemory memory;
    const RepairFigures repair = memory.repair(session.run(), session.run().timeline().size());
    ASSERT_EQ(repair.number, 1);
    EXPECT_TRUE(repair.cause.new_goal);
    FreshPlans plans;
    EXPECT_EQ(repair.touched, plans.of(session.run(), 1, true)->touched) << planner;
    // And it is drawn where it is now.
    const Scene scene = build_scene(session.run(), {}, {400, 400}, {});
    std::vector<Point> goals;
    for (const Shape& shape : scene.shapes)
      if (const auto* disc = std::get_if<Disc>(&shape); disc != nullptr && disc->glyph == Glyph::target)
        goals.push_back(disc->centre);
    EXPECT_EQ(goals, (std::vector<Point>{{29.5, 3.5, 0.5}})) << planner;
  }
}

TEST(FreshPlan, IsWorkedOutInTheBackgroundAndKept) {
  Session session(demo());
  session.settle();
  FreshPlans plans;
  std::optional<FreshPlan> fresh = plans.of(session.run(), 0, false);
  for (int i = 0; i < 50'000 && !fresh; ++i) {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    fresh = plans.of(session.run(), 0, false);
  }
  ASSERT_TRUE(fresh.has_value());
  EXPECT_FALSE(plans.busy()) << "asking again while it was worked out has not asked for it twice";
  EXPECT_EQ(plans.of(session.run(), 0, false)->ms, fresh->ms) << "it is not measured again";
  while (plans.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace
}  // namespace replan::fresh_plan_test
