// What a session holds its planners to: switched on and off, through edits and branches, and told where two
// panes part.
#include <algorithm>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "core/debug/difference_search.hpp"
#include "core/debug/law_checker.hpp"
#include "core/session/session.hpp"

namespace replan::checks_test {
namespace {

Scenario world(const char* file) {
  const auto scenario = read_scenario(std::string(REPLAN_SOURCE_DIR "/maps/") + file);
  EXPECT_TRUE(scenario.ok());
  return *scenario;
}

Scenario with_planners(const char* file, std::vector<PlannerChoice> planners) {
  Scenario scenario = world(file);
  scenario.planners = std::move(planners);
  return scenario;
}

void run_to_end(Session& session) {
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  for (const auto& run : session.runs()) run->finish(Target::end());
  session.update(0);
  session.settle();
}

std::size_t plans_of(const Run& run) {
  return static_cast<std::size_t>(
      std::count_if(run.milestones().begin(), run.milestones().end(),
                    [](const Milestone& milestone) { return milestone.kind == EventKind::plan_end; }));
}

TEST(Checks, HoldSmallWorldsToTheirLawsUnlessSwitchedOff) {
  Session session(world("demo.json"));
  run_to_end(session);
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    const LawReport laws = session.checks().laws(pane);
    EXPECT_TRUE(laws.on);
    EXPECT_EQ(laws.checked, session.runs()[pane]->timeline().size());
    EXPECT_EQ(laws.breaches, 0u) << laws.first->words;
    EXPECT_FALSE(session.checks().oracle(pane).on);
  }
  ASSERT_TRUE(session.apply(SetChecks{false, true}).ok());
  session.settle();
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
    EXPECT_FALSE(session.checks().laws(pane).on);
    const OracleReport oracle = session.checks().oracle(pane);
    EXPECT_TRUE(oracle.on);
    EXPECT_FALSE(oracle.busy);
    EXPECT_EQ(oracle.asked, plans_of(*session.runs()[pane]));
    EXPECT_EQ(oracle.disagreements, 0u);
  }
  EXPECT_FALSE(session.checks().laws(99).on);
}

TEST(Checks, LeaveLargeWorldsAloneUntilAsked) {
  Scenario large;
  large.map = GridMap(600, 500);
  large.start = {1, 1};
  large.goal = {5, 5};
  large.planners = {{"dstar-lite", {}}};
  Session session(large);
  session.settle();
  EXPECT_FALSE(session.checks().laws(0).on);
  ASSERT_TRUE(session.apply(SetChecks{true, false}).ok());
  session.settle();
  EXPECT_EQ(session.checks().laws(0).checked, session.run().timeline().size());
}

TEST(Checks, GoOnByThemselvesUpdateByUpdate) {
  Session session(world("demo.json"));
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  ASSERT_TRUE(session.apply(SetChecks{true, true}).ok());
  for (int i = 0; i < 20000; ++i) {
    session.update(0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const bool running = std::any_of(session.runs().begin(), session.runs().end(),
                                     [](const auto& run) { return run->busy(); });
    if (!running && !session.checks().busy()) break;
  }
  EXPECT_EQ(session.checks().laws(0).checked, session.run().timeline().size());
  EXPECT_EQ(session.checks().oracle(0).asked, plans_of(session.run()));
  EXPECT_FALSE(session.update(0)) << "nothing is left that changes what is shown";
}

TEST(Checks, NameTheFirstBadPlanOfAPrintedRemoteParent) {
  for (const char* file : {"fault-through-obstacle.json", "fault-in-a-circle.json"}) {
    Session session(world(file));
    run_to_end(session);
    const LawReport printed = session.checks().laws(0);
    ASSERT_TRUE(printed.first) << file;
    // The plan that follows the surprise: the laws held for the first one.
    const replan::Run& run = *session.runs()[0];
    EXPECT_EQ(run.timeline().event(printed.first->position - 1).kind, EventKind::plan_end) << file;
    EXPECT_GT(printed.first->position, run.decisions().front().event) << file;
    for (std::size_t pane = 1; pane < session.runs().size(); ++pane)
      EXPECT_EQ(session.checks().laws(pane).breaches, 0u) << file;
  }
}

TEST(Checks, ForgetWhatAnEditTookBackAndKeepWhatStays) {
  Session session(with_planners("broken-planner.json", {world("broken-planner.json").planners.front()}));
  ASSERT_TRUE(session.apply(SetChecks{true, true}).ok());
  run_to_end(session);
  const LawReport whole = session.checks().laws(0);
  ASSERT_GT(whole.breaches, 0u);
  // Back to before the breach, and another way from there.
  ASSERT_TRUE(session.apply(Seek{session.run().decisions().front().event}).ok());
  ASSERT_TRUE(session.apply(DropSurprise{{{{0, 0}, true}}}).ok());
  run_to_end(session);
  LawChecker fresh(session.run().log_view());
  while (fresh.advance(10000)) {
  }
  EXPECT_EQ(session.checks().laws(0).breaches, fresh.breach_count());
  EXPECT_EQ(session.checks().laws(0).checked, session.run().timeline().size());
  EXPECT_EQ(session.checks().oracle(0).asked, plans_of(session.run()));
  ASSERT_TRUE(session.apply(Undo{}).ok());
  run_to_end(session);
  EXPECT_EQ(session.checks().laws(0).breaches, whole.breaches);
  EXPECT_EQ(session.checks().laws(0).first->words, whole.first->words);
}

TEST(Checks, TakeBothPanesToWhereTheyPart) {
  Session session(with_planners("demo.json", {{"dstar-lite", {}}, {"astar", {}}, {"dld-star-lite", {}}}));
  session.settle();
  ASSERT_TRUE(session.apply(FindDifference{{0, 2}, Compare::expansions}).ok());
  EXPECT_TRUE(session.checks().comparing());
  session.settle();
  EXPECT_FALSE(session.checks().comparing());
  const auto& found = session.checks().difference();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->panes, (std::array<std::size_t, 2>{0, 2}));
  EXPECT_EQ(session.runs()[0]->timeline().cursor(), found->positions[0]);
  EXPECT_EQ(session.runs()[2]->timeline().cursor(), found->positions[1]);
  const auto alone =
      first_difference(session.runs()[0]->log_view(), session.runs()[2]->log_view(), Compare::expansions);
  ASSERT_TRUE(alone);
  EXPECT_EQ(alone->positions, found->positions);
  EXPECT_EQ(session.log().back(), found->words);
  EXPECT_EQ(session.checks().comparison(), found->words);
  // They stand there until the next seek, and then go in lockstep again.
  session.update(1);
  EXPECT_EQ(session.runs()[2]->timeline().cursor(), found->positions[1]);
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  EXPECT_NE(session.runs()[2]->timeline().cursor(), found->positions[1]);
  // Asked for again it is known at once.
  ASSERT_TRUE(session.apply(FindDifference{{0, 2}, Compare::expansions}).ok());
  EXPECT_FALSE(session.checks().comparing());
  EXPECT_EQ(session.runs()[0]->timeline().cursor(), found->positions[0]);
  EXPECT_EQ(session.runs()[2]->timeline().cursor(), found->positions[1]);
}

TEST(Checks, ForgetADifferenceOfRunsThatAreNoMore) {
  Session session(with_planners("demo.json", {{"dstar-lite", {}}, {"dld-star-lite", {}}}));
  ASSERT_TRUE(session.apply(FindDifference{{0, 1}, Compare::expansions}).ok());
  session.settle();
  ASSERT_TRUE(session.checks().difference());
  ASSERT_TRUE(session.apply(SetParameter{1, "heuristic", 1}).ok());
  session.update(0);
  EXPECT_FALSE(session.checks().difference());
  EXPECT_EQ(session.checks().comparison(), "");
}

TEST(Checks, SayWhenTwoPanesAreAlikeToTheEnd) {
  Session session(with_planners("demo.json", {{"dstar-lite", {}}, {"dstar-lite", {}}}));
  ASSERT_TRUE(session.apply(FindDifference{{0, 1}, Compare::events}).ok());
  session.settle();
  EXPECT_FALSE(session.checks().difference());
  EXPECT_EQ(session.checks().comparison().rfind("alike to the end: ", 0), 0u)
      << session.checks().comparison();
  EXPECT_NE(session.run().decisions().back().state, MissionState::driving) << "both were run to their ends";
}

TEST(Checks, StopComparingOnCancelAndWhenTheWorldIsEdited) {
  Session session(with_planners("demo.json", {{"dstar-lite", {}}, {"dstar-lite", {}}}));
  ASSERT_TRUE(session.apply(FindDifference{{0, 1}, Compare::events}).ok());
  ASSERT_TRUE(session.apply(Cancel{}).ok());
  EXPECT_FALSE(session.checks().comparing());
  session.settle();
  ASSERT_TRUE(session.apply(FindDifference{{0, 1}, Compare::events}).ok());
  ASSERT_TRUE(session.apply(SetParameter{0, "heuristic", 1}).ok());
  session.update(0);
  EXPECT_FALSE(session.checks().comparing());
  EXPECT_EQ(session.checks().comparison(), "");
  EXPECT_FALSE(session.apply(FindDifference{{0, 2}, Compare::events}).ok());
  EXPECT_FALSE(session.apply(FindDifference{{1, 1}, Compare::events}).ok());
}

}  // namespace
}  // namespace replan::checks_test
