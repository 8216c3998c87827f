// Panes of a session: how they come and go, and what stays of their runs.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/session/session.hpp"
#include "core/world/choices.hpp"
#include "tests/support/panes.hpp"

namespace replan::session_panes_test {
namespace {

Scenario wall_with_gap() {
  Scenario scenario;
  scenario.map = GridMap(24, 16);
  for (int y = 0; y < 16; ++y)
    if (y != 5) scenario.map.set({12, y}, true);
  scenario.start = {2, 8};
  scenario.goal = {21, 8};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot.sensor_radius = 4;
  return scenario;
}

std::vector<std::string> planners_of(const Session& session) {
  std::vector<std::string> ids;
  for (const PlannerChoice& choice : session.scenario().planners) ids.push_back(choice.id);
  return ids;
}

TEST(SessionPanes, GrowByThePlannersLeastAlikeAndShrinkFromTheEnd) {
  Session session(wall_with_gap());
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  EXPECT_EQ(planners_of(session), (std::vector<std::string>{"dstar-lite", "dld-star-lite"}));
  ASSERT_TRUE(session.apply(SetPanes{4}).ok());
  const std::vector<std::string> four = planners_of(session);
  EXPECT_EQ(std::set(four.begin(), four.end()).size(), 4u) << "no planner twice";
  for (const std::string& id : four) EXPECT_FALSE(find_planner(id)->exercise) << id;
  ASSERT_TRUE(session.apply(SetPanes{3}).ok());
  EXPECT_EQ(planners_of(session), std::vector(four.begin(), four.begin() + 3));
  ASSERT_TRUE(session.apply(SetPanes{1}).ok());
  EXPECT_EQ(planners_of(session), std::vector<std::string>{"dstar-lite"});
  EXPECT_FALSE(session.apply(SetPanes{0}).ok());
  EXPECT_FALSE(session.apply(SetPanes{5}).ok());
  EXPECT_EQ(session.history_position(), 4u) << "what was refused is no edit";
}

/// Whoever plans in the plane alone is neither chosen nor shown beside others in a world with layers, and keeps such a
/// world from taking the place of his own.
TEST(SessionPanes, HaveNoPlannerThatCannotPlanInTheirWorld) {
  Scenario layered;
  layered.map = GridMap(4, 3, 2);
  layered.goal = {3, 2, 1};
  layered.planners = {{"dstar-lite", {}}};
  const GridMap layers = layered.map;
  Session session(std::move(layered));
  const Result<void> chosen = session.apply(ChoosePlanner{0, "jps"});
  ASSERT_FALSE(chosen.ok());
  EXPECT_EQ(chosen.error(), "'jps' plans in the plane alone, and this world has 2 layers");
  ASSERT_TRUE(session.apply(SetPanes{4}).ok());
  for (const std::string& id : planners_of(session)) EXPECT_FALSE(find_planner(id)->planar) << id;

  Scenario plane = wall_with_gap();
  plane.planners = {{"dstar-lite", {}}, {"jps", {}}};
  Session flat(std::move(plane));
  EXPECT_FALSE(flat.apply(ReplaceMap{layers, Cell{0, 0}, Cell{3, 2, 1}}).ok());
  ASSERT_TRUE(flat.apply(SetPanes{1}).ok());
  ASSERT_TRUE(flat.apply(ReplaceMap{layers, Cell{0, 0}, Cell{3, 2, 1}}).ok());
  ASSERT_TRUE(flat.apply(SetPanes{2}).ok());
  EXPECT_NE(planners_of(flat)[1], "jps") << "it was put away";
}

/// A planner whose paths touch obstacles and a robot with a size do not come together, whichever comes first.
TEST(SessionPanes, HaveNoPlannerThatCannotPlanForTheirRobot) {
  const std::string why =
      "'visibility-graph' plans for a robot without a size alone, since its paths touch obstacles: set the "
      "radius to 0, or choose a planner that keeps away from them, such as theta-star";
  Session session(wall_with_gap());
  RobotSetup sized = session.scenario().robot;
  sized.radius = 0.5;
  ASSERT_TRUE(session.apply(ChoosePlanner{0, "visibility-graph"}).ok());
  EXPECT_EQ(session.apply(SetRobot{sized}).error(), why);
  EXPECT_EQ(session.scenario().robot.radius, 0);
  ASSERT_TRUE(session.apply(ChoosePlanner{0, "fusion"}).ok());
  ASSERT_TRUE(session.apply(SetRobot{sized}).ok());
  EXPECT_EQ(session.apply(ChoosePlanner{0, "visibility-graph"}).error(), why);
  const Parameter& global = *find_parameter(find_choice("fusion")->parameters, "global");
  const auto index = std::find(global.choices.begin(), global.choices.end(), "visibility-graph");
  const Result<void> flown =
      session.apply(SetParameter{0, "global", static_cast<double>(index - global.choices.begin())});
  ASSERT_FALSE(flown.ok()) << "nor does what plans for a pilot";
  ASSERT_TRUE(session.apply(SetPanes{4}).ok());
  for (const PlannerChoice& pane : session.scenario().planners) EXPECT_TRUE(info_of(pane).point_only.empty());

  Scenario read = wall_with_gap();
  read.planners = {{"visibility-graph", {}}};
  EXPECT_TRUE(parse_scenario(scenario_text(read), "a.json", "").ok());
  read.robot.radius = 0.5;
  const auto refused = parse_scenario(scenario_text(read), "a.json", "");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().find(why), std::string::npos) << refused.error();
}

TEST(SessionPanes, ComeBackWithThePlannersThatTheyHad) {
  Scenario scenario = wall_with_gap();
  scenario.planners = {{"dld-star-lite", {}}, {"dijkstra", {}}, {"astar", {}}};
  Session session(std::move(scenario));
  ASSERT_TRUE(session.apply(SetPanes{1}).ok());
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  EXPECT_EQ(planners_of(session), (std::vector<std::string>{"dld-star-lite", "dijkstra"}));
  ASSERT_TRUE(session.apply(SetPanes{4}).ok());
  const std::vector<std::string> four = planners_of(session);
  EXPECT_EQ(std::vector(four.begin(), four.begin() + 3),
            (std::vector<std::string>{"dld-star-lite", "dijkstra", "astar"}));
}

TEST(SessionPanes, AreNoWorkThatCouldBeLost) {
  Session session(wall_with_gap());
  session.settle();
  ASSERT_TRUE(session.apply(SetPanes{1}).ok());
  ASSERT_TRUE(session.apply(SetPanes{4}).ok());
  EXPECT_FALSE(session.modified());
  EXPECT_EQ(session.unsaved_edits(), 0u);
  ASSERT_TRUE(session.apply(PaintCells{{{{1, 1}, true}}}).ok());
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  EXPECT_TRUE(session.modified());
  EXPECT_EQ(session.unsaved_edits(), 1u) << "the paint alone";
  session.saved("a.json");
  ASSERT_TRUE(session.apply(SetPanes{1}).ok());
  EXPECT_FALSE(session.modified());
  ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_EQ(planners_of(session).size(), 2u) << "it can be taken back for all that";
  EXPECT_FALSE(session.modified());
}

TEST(SessionPanes, ANewPanePlansByTheSameRules) {
  Scenario scenario = wall_with_gap();
  scenario.planners.front().settings.set("moves", 1);
  Session session(scenario);
  ASSERT_TRUE(session.apply(SetPanes{3}).ok());
  for (const PlannerChoice& choice : session.scenario().planners)
    EXPECT_EQ(choice.settings.get("moves", 0), 1) << choice.id;
}

TEST(SessionPanes, TheRunsThatStayAreKeptAndTheNewOneCatchesUp) {
  Session session(wall_with_gap());
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 7}).ok());
  const replan::Run* kept = session.runs()[0].get();
  const std::uint64_t log = kept->log_id();
  const std::size_t cursor = kept->timeline().cursor();
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  EXPECT_EQ(session.runs()[0].get(), kept);
  test::settle_panes(session);
  EXPECT_EQ(kept->log_id(), log) << "nothing was cut";
  EXPECT_EQ(kept->timeline().cursor(), cursor);
  const replan::Run& added = *session.runs()[1];
  EXPECT_EQ(added.decision_at(added.timeline().cursor())->clock, 7);
  EXPECT_EQ(&added.scenario(), &session.scenario());
  EXPECT_EQ(&kept->scenario(), &session.scenario());
}

TEST(SessionPanes, SettlingPutsANewPaneInItsPlace) {
  Session session(wall_with_gap());
  session.settle();
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  session.settle();
  const replan::Run& added = *session.runs()[1];
  ASSERT_FALSE(added.decisions().empty());
  EXPECT_EQ(added.timeline().cursor(), added.decisions().front().event) << "its plan stands";
}

TEST(SessionPanes, ComeAndGoWithUndoAndRedo) {
  Session session(wall_with_gap());
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 3}).ok());
  const replan::Run* kept = session.runs()[0].get();
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  EXPECT_EQ(session.undo_text(), "show 2 panes");
  ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_EQ(session.runs().size(), 1u);
  EXPECT_EQ(session.runs()[0].get(), kept);
  ASSERT_TRUE(session.apply(Redo{}).ok());
  test::settle_panes(session);
  ASSERT_EQ(session.runs().size(), 2u);
  EXPECT_EQ(session.runs()[0].get(), kept);
  EXPECT_EQ(kept->decision_at(kept->timeline().cursor())->clock, 3);
}

TEST(SessionPanes, AnotherPlannerInOnePaneLeavesTheOthersAlone) {
  Session session(wall_with_gap());
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  test::settle_panes(session);
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 4}).ok());
  const replan::Run* kept = session.runs()[0].get();
  ASSERT_TRUE(session.apply(ChoosePlanner{1, "astar"}).ok());
  EXPECT_EQ(session.runs()[0].get(), kept);
  test::settle_panes(session);
  const replan::Run& other = *session.runs()[1];
  EXPECT_EQ(other.choice().id, "astar");
  EXPECT_EQ(other.decision_at(other.timeline().cursor())->clock, 4);
}

TEST(SessionPanes, TheLeadGoesOverWhenItsPaneGoes) {
  Session session(wall_with_gap());
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  test::settle_panes(session);
  ASSERT_TRUE(session.apply(Lead{1}).ok());
  EXPECT_EQ(session.run().choice().id, "dld-star-lite");
  ASSERT_TRUE(session.apply(SetPanes{1}).ok());
  EXPECT_EQ(session.lead(), 0u);
  ASSERT_TRUE(session.apply(Step{StepUnit::expansion, -1}).ok());
  EXPECT_FALSE(session.apply(Lead{1}).ok());
}

TEST(SessionPanes, AnotherDocumentBeginsWithItsFirstPane) {
  Session session(wall_with_gap());
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  ASSERT_TRUE(session.apply(Lead{1}).ok());
  const Scenario two = session.scenario();
  ASSERT_TRUE(session.apply(ReplaceScenario{two, "", 0, {}}).ok());
  EXPECT_EQ(session.lead(), 0u);
}

TEST(SessionPanes, ToLeadMovesNoPane) {
  Session session(wall_with_gap());
  ASSERT_TRUE(session.apply(SetPanes{2}).ok());
  test::settle_panes(session);
  ASSERT_TRUE(session.apply(Seek{session.run().timeline().size() / 2}).ok());
  const std::size_t first = session.runs()[0]->timeline().cursor(),
                    second = session.runs()[1]->timeline().cursor();
  ASSERT_TRUE(session.apply(Lead{1}).ok());
  test::settle_panes(session);
  EXPECT_EQ(session.runs()[0]->timeline().cursor(), first);
  EXPECT_EQ(session.runs()[1]->timeline().cursor(), second);
}

TEST(SessionPanes, AnEditReachesAllPanesAtTheSameStep) {
  Session session(wall_with_gap());
  ASSERT_TRUE(session.apply(SetPanes{4}).ok());
  test::settle_panes(session);
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 2}).ok());
  test::settle_panes(session);
  ASSERT_TRUE(session.apply(PaintCells{{{{8, 6}, true}, {{8, 7}, true}}, 1}).ok());
  test::settle_panes(session);
  for (const auto& run : session.runs()) {
    const Decision* decision = run->decision_at(run->timeline().cursor());
    ASSERT_NE(decision, nullptr);
    EXPECT_EQ(decision->clock, 2) << run->choice().id;
    EXPECT_TRUE(run->timeline().state().wall(run->lattice().node(Cell{8, 6}))) << run->choice().id;
  }
}

TEST(SessionPanes, TheEndTakesAllToTheirEnds) {
  for (const Lockstep by : {Lockstep::expansions, Lockstep::moves, Lockstep::race}) {
    Session session(wall_with_gap());
    ASSERT_TRUE(session.apply(SetPanes{4}).ok());
    ASSERT_TRUE(session.apply(SetLockstep{by}).ok());
    ASSERT_TRUE(session.apply(RunToEnd{}).ok());
    test::settle_panes(session);
    for (const auto& run : session.runs()) {
      EXPECT_TRUE(run->over()) << run->choice().id;
      EXPECT_EQ(run->timeline().cursor(), run->timeline().size()) << run->choice().id;
    }
  }
}

}  // namespace
}  // namespace replan::session_panes_test
