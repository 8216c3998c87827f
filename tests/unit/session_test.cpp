// The session: live edits, time travel, undo; and that a run is a function of its scenario.
#include "core/session/session.hpp"

#include <chrono>
#include <cstdio>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::session_test {
namespace {

/// A room with a wall and a gap in it, and a robot that knows the map.
Scenario wall_with_gap(const std::string& planner) {
  Scenario scenario;
  scenario.map = GridMap(24, 16);
  for (int y = 0; y < 16; ++y)
    if (y != 5) scenario.map.set({12, y}, true);
  scenario.start = {2, 8};
  scenario.goal = {21, 8};
  scenario.planners = {{planner, {}}};
  scenario.robot.sensor_radius = 4;
  return scenario;
}

std::vector<CellChange> block(int x, int y, int width, int height, bool blocked = true) {
  std::vector<CellChange> cells;
  for (int j = y; j < y + height; ++j)
    for (int i = x; i < x + width; ++i) cells.push_back({{i, j}, blocked});
  return cells;
}

/// A box that goes up and down in front of the gap.
MovingObstacle patrol() {
  return {.way = {{14, 2}, {14, 9}}, .width = 2, .height = 2, .speed = 3};
}

void run_to_end(Session& session) {
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  while (session.run().busy()) session.update(0);
  session.update(0);
}

const Decision& last_decision(const Session& session) {
  return session.run().decisions().back();
}

class SessionOf : public testing::TestWithParam<const char*> {};

TEST_P(SessionOf, OpensWithAPlanAndDrivesToTheGoal) {
  Session session(wall_with_gap(GetParam()));
  session.settle();
  EXPECT_EQ(last_decision(session).state, MissionState::driving);
  EXPECT_EQ(session.run().timeline().cursor(), session.run().timeline().size());
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  EXPECT_EQ(last_decision(session).figures.collisions, 0);
}

TEST_P(SessionOf, ARobotAtItsGoalIsThereAfterAnEditToo) {
  Session session(wall_with_gap(GetParam()));
  session.settle();
  run_to_end(session);
  const std::int64_t moves = last_decision(session).figures.moves;
  ASSERT_TRUE(session.apply(PaintCells{block(2, 2, 2, 2), 1}).ok());
  session.settle();
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  EXPECT_EQ(last_decision(session).figures.moves, moves);
  EXPECT_EQ(session.take_notice().words, "") << "nobody had come to an end before it";
}

TEST(Session, SaysWhoseRobotHadComeToItsEndBeforeAChange) {
  // Without diagonals the robot needs more steps than the other.
  Scenario scenario = wall_with_gap("dld-star-lite");
  scenario.planners = {{"dstar-lite", {}}, {"dstar-lite", {}}};
  scenario.planners[0].settings.set("moves", 1);
  Session session(std::move(scenario));
  session.settle();
  run_to_end(session);
  session.settle();
  ASSERT_LT(session.runs()[1]->decisions().back().clock, last_decision(session).clock);
  ASSERT_TRUE(session.apply(PaintCells{block(2, 2, 2, 2), 1}).ok());
  EXPECT_NE(session.take_notice().words.find("had ended its drive at step"), std::string::npos);
  EXPECT_EQ(session.take_notice().words, "") << "once";
}

TEST(Session, SaysThatAnEditMakesALongSearchBeginAgain) {
  Scenario scenario;
  scenario.map = GridMap(1000, 1000);
  scenario.goal = {999, 999};
  scenario.planners = {{"dijkstra", {}}};
  Session session(std::move(scenario));
  ASSERT_TRUE(session.apply(PaintCells{block(5, 5, 1, 1), 1}).ok());
  EXPECT_EQ(session.take_notice().words, "") << "nobody has waited yet";
  while (session.run().timeline().size() < 1'200'000) session.update(0);
  ASSERT_TRUE(session.run().decisions().empty()) << "the search is not over";
  ASSERT_TRUE(session.apply(PaintCells{block(7, 7, 1, 1), 2}).ok());
  EXPECT_NE(session.take_notice().words.find("its search begins again"), std::string::npos);
  ASSERT_TRUE(session.apply(PaintCells{block(8, 8, 1, 1), 2}).ok());
  EXPECT_EQ(session.take_notice().words, "") << "a stroke says it once";
}

TEST_P(SessionOf, AnEditWhileAPlanStandsIsRepairedAndTheRunRepeatsFromItsScenario) {
  Session session(wall_with_gap(GetParam()));
  session.settle();
  ASSERT_TRUE(session.apply(PaintCells{block(6, 4, 2, 6), 1}).ok());
  session.settle();
  EXPECT_EQ(last_decision(session).figures.replans, 1);
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 5}).ok());
  ASSERT_TRUE(session.apply(DropSurprise{block(12, 5, 1, 1), 2}).ok());
  ASSERT_TRUE(session.apply(PaintCells{block(12, 10, 1, 1, false), 3}).ok());
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);

  Session again(session.scenario());
  run_to_end(again);
  EXPECT_EQ(again.run().timeline().size(), session.run().timeline().size());
  EXPECT_EQ(again.run().timeline().log_hash(), session.run().timeline().log_hash());
}

TEST_P(SessionOf, StepsBackBeforeASurpriseAndForwardAgainWithEqualHashes) {
  Session session(wall_with_gap(GetParam()));
  session.settle();
  const std::uint64_t planned = session.run().timeline().state().hash();
  const std::size_t before = session.run().timeline().cursor();
  ASSERT_TRUE(session.apply(PaintCells{block(6, 4, 2, 6), 1}).ok());
  session.settle();
  const std::uint64_t repaired = session.run().timeline().state().hash();
  const std::size_t after = session.run().timeline().cursor();
  EXPECT_NE(planned, repaired);
  while (session.run().timeline().cursor() > before)
    ASSERT_TRUE(session.apply(Step{StepUnit::line, -1}).ok());
  EXPECT_EQ(session.run().timeline().state().hash(), planned);
  while (session.run().timeline().cursor() < after)
    ASSERT_TRUE(session.apply(Step{StepUnit::expansion, 1}).ok());
  EXPECT_EQ(session.run().timeline().state().hash(), repaired);
}

TEST_P(SessionOf, AnEditInThePastBranchesFromThatMoment) {
  Session session(wall_with_gap(GetParam()));
  run_to_end(session);
  const auto decisions = session.run().decisions();
  ASSERT_TRUE(session.apply(Seek{decisions[decisions.size() / 2].event}).ok());
  const std::int64_t clock = session.run().decision_at(session.run().timeline().cursor())->clock;
  ASSERT_TRUE(session.apply(PaintCells{block(18, 2, 1, 10), 1}).ok());
  session.settle();
  EXPECT_EQ(last_decision(session).clock, clock);
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  Session again(session.scenario());
  run_to_end(again);
  EXPECT_EQ(again.run().timeline().log_hash(), session.run().timeline().log_hash());
}

TEST_P(SessionOf, UndoBringsTheRunBackAndRedoTheRepair) {
  Session session(wall_with_gap(GetParam()));
  session.settle();
  const std::uint64_t planned = session.run().timeline().log_hash();
  ASSERT_TRUE(session.apply(PaintCells{block(6, 4, 2, 3), 9}).ok());
  ASSERT_TRUE(session.apply(PaintCells{block(6, 7, 2, 3), 9}).ok());  // the same stroke
  session.settle();
  const std::uint64_t repaired = session.run().timeline().log_hash();
  ASSERT_TRUE(session.apply(Undo{}).ok());
  session.settle();
  EXPECT_EQ(session.run().timeline().log_hash(), planned);
  EXPECT_TRUE(session.undo_text().empty());
  ASSERT_TRUE(session.apply(Redo{}).ok());
  session.settle();
  EXPECT_EQ(session.run().timeline().log_hash(), repaired);
  EXPECT_FALSE(session.apply(Redo{}).ok());
}

INSTANTIATE_TEST_SUITE_P(Planners, SessionOf,
                         testing::Values("dijkstra", "astar", "dstar-lite", "los-dstar-lite",
                                         "dist-dstar-lite", "dld-star-lite"),
                         [](const auto& planner) {
                           std::string name = planner.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Session, ASurpriseOnTheDemoWorldIsRepairedSteppedBackAndForthWithEqualHashes) {
  const auto demo = read_scenario(REPLAN_SOURCE_DIR "/maps/demo.json");
  ASSERT_TRUE(demo.ok()) << demo.error();
  Session session(*demo);
  session.settle();
  const auto& log = session.run().timeline();
  const std::size_t planned_at = log.cursor();
  const std::uint64_t planned = log.state().hash();
  ASSERT_TRUE(
      session.apply(DropSurprise{block(8, 12, 4, 2), 1}).ok());  // beside the start, on the path ahead
  for (int moves = 0; last_decision(session).figures.replans == 0 && moves < 20; ++moves)
    ASSERT_TRUE(session.apply(Step{StepUnit::move, 1}).ok());
  session.settle();
  ASSERT_TRUE(session.apply(Seek{log.size()}).ok());
  EXPECT_GE(last_decision(session).figures.replans, 1);  // the sensor may see it piece by piece
  const std::size_t repaired_at = log.cursor();
  const std::uint64_t repaired = log.state().hash();
  while (log.cursor() > planned_at) ASSERT_TRUE(session.apply(Step{StepUnit::expansion, -1}).ok());
  std::printf("planned %016llx, back before the surprise %016llx; ", static_cast<unsigned long long>(planned),
              static_cast<unsigned long long>(log.state().hash()));
  EXPECT_EQ(log.state().hash(), planned);
  while (log.cursor() < repaired_at) ASSERT_TRUE(session.apply(Step{StepUnit::line, 1}).ok());
  std::printf("repaired %016llx, forward again %016llx\n", static_cast<unsigned long long>(repaired),
              static_cast<unsigned long long>(log.state().hash()));
  EXPECT_EQ(log.state().hash(), repaired);
}

TEST(Session, RandomCommandsGiveARunThatRepeatsFromItsScenario) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    Scenario scenario = wall_with_gap(seed % 2 == 0 ? "dld-star-lite" : "dstar-lite");
    if (seed % 3 == 0) scenario.movers = {patrol()};
    if (seed % 4 == 0) scenario.robot.motion = Motion::smooth;
    Session session(scenario);
    for (int i = 0; i < 25; ++i) {
      const int x = random.between(3, 19), y = random.between(0, 12);
      const std::size_t size = session.run().timeline().size();
      switch (random.below(12)) {
        case 8:
          (void)session.apply(SetGoal{{x, y}, random.below(3)});
          break;
        case 9:
          (void)session.apply(PutRobot{{x, y}, random.below(3)});
          break;
        case 10:
          (void)session.apply(AddMover{{.way = {{x, y}, {y, 15}}, .width = 2}});
          break;
        case 11:
          (void)session.apply(RemoveMover{random.below(2)});
          break;
        case 0:
          (void)session.apply(PaintCells{block(x, y, 2, 3, random.chance(0.6)), 0});
          break;
        case 1:
          (void)session.apply(DropSurprise{block(x, y, 3, 2, random.chance(0.7)), 0});
          break;
        case 2:
          (void)session.apply(Step{StepUnit::move, random.between(-4, 6)});
          break;
        case 3:
          (void)session.apply(Seek{random.below(static_cast<std::uint32_t>(size + 1))});
          break;
        case 4:
          (void)session.apply(Undo{});
          break;
        case 5:
          (void)session.apply(Redo{});
          break;
        case 6:
          (void)session.apply(Step{StepUnit::expansion, random.between(-20, 20)});
          break;
        default:
          session.settle();
          break;
      }
    }
    run_to_end(session);
    Session again(session.scenario());
    run_to_end(again);
    ASSERT_EQ(again.run().timeline().log_hash(), session.run().timeline().log_hash()) << "seed " << seed;
  }
}

/// Runs the session to its end and a fresh one on its scenario: the logs must be equal.
void expect_repeats(Session& session) {
  run_to_end(session);
  Session again(session.scenario());
  run_to_end(again);
  EXPECT_EQ(again.run().timeline().size(), session.run().timeline().size());
  EXPECT_EQ(again.run().timeline().log_hash(), session.run().timeline().log_hash());
}

/// Plays until nothing moves any more, or for so many frames.
void play_on(Session& session, int frames = 4000) {
  for (int i = 0; i < frames && (session.playback().direction != 0 || session.run().busy()); ++i) {
    session.update(0.02);
    if (session.run().busy()) std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

TEST(Session, PlayingGoesOnWhenALostWayComesBack) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  ASSERT_TRUE(session.apply(SetSpeed{5000}).ok());
  ASSERT_TRUE(session.apply(Play{1}).ok());
  for (int i = 0; i < 10; ++i) {
    session.update(0.02);
    session.settle();  // how far it comes does not depend on how busy the machine is
  }
  ASSERT_TRUE(session.apply(PaintCells{block(12, 5, 1, 1), 1}).ok());
  play_on(session);
  EXPECT_EQ(last_decision(session).state, MissionState::no_path);
  EXPECT_EQ(session.playback().direction, 0) << "it plays although nothing can move";
  ASSERT_TRUE(session.apply(PaintCells{block(12, 5, 1, 1, false), 2}).ok());
  session.settle();
  session.update(0.02);
  EXPECT_EQ(session.playback().direction, 1);
  play_on(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  EXPECT_EQ(session.run().timeline().cursor(), session.run().timeline().size());
}

TEST(Session, PlayingGoesOnWhenTheGoalWasDraggedOverAnObstacle) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 4}).ok());
  ASSERT_TRUE(session.apply(SetSpeed{5000}).ok());
  ASSERT_TRUE(session.apply(Play{1}).ok());
  ASSERT_TRUE(session.apply(SetGoal{{12, 9}, 7}).ok());  // in the wall
  play_on(session);
  ASSERT_TRUE(session.apply(SetGoal{{5, 13}, 7}).ok());
  session.settle();
  session.update(0.02);
  play_on(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  EXPECT_EQ(session.run().timeline().state().node(Scalar::robot), session.run().lattice().node({5, 13}));
}

TEST(Session, WhoPausesOrStepsIsNotPlayedOn) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(SetSpeed{5000}).ok());
  ASSERT_TRUE(session.apply(Play{1}).ok());
  ASSERT_TRUE(session.apply(PaintCells{block(12, 5, 1, 1), 1}).ok());
  play_on(session);
  ASSERT_TRUE(session.apply(Step{StepUnit::move, -1}).ok());
  ASSERT_TRUE(session.apply(PaintCells{block(12, 5, 1, 1, false), 2}).ok());
  session.settle();
  session.update(0.02);
  EXPECT_EQ(session.playback().direction, 0);
}

TEST(Session, AnEditWhilePlayingDoesNotLeapAhead) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 2}).ok());
  ASSERT_TRUE(session.apply(Play{1}).ok());
  for (int i = 0; i < 10; ++i) session.update(0.02);
  ASSERT_TRUE(session.apply(PaintCells{block(20, 1, 1, 1), 1}).ok());
  const std::size_t before = session.run().timeline().state().scalar(Scalar::moves);
  for (int i = 0; i < 20; ++i) {
    session.update(0.01);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_LE(session.run().timeline().state().scalar(Scalar::moves), before + 5)
      << "0.2 s at 15 moves a second";
}

TEST(Session, AStrokeOnTheWayIsOneSurprise) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 5}).ok());
  const std::size_t before = session.scenario().surprises.size();
  for (int y = 9; y >= 6; --y) ASSERT_TRUE(session.apply(PaintCells{block(10, y, 1, 1), 7}).ok());
  session.settle();
  ASSERT_EQ(session.scenario().surprises.size(), before + 1);
  EXPECT_EQ(session.scenario().surprises.back().cells, block(10, 6, 1, 4));
  EXPECT_EQ(last_decision(session).figures.replans, 1);
  EXPECT_EQ(session.undo_text(), "paint 4 cells");
  ASSERT_TRUE(session.apply(DropSurprise{block(10, 1, 1, 1), 8}).ok());  // another stroke, another surprise
  session.settle();
  EXPECT_EQ(session.scenario().surprises.size(), before + 2);
  run_to_end(session);
  Session again(session.scenario());
  run_to_end(again);
  EXPECT_EQ(again.run().timeline().log_hash(), session.run().timeline().log_hash());
  ASSERT_TRUE(session.apply(Undo{}).ok());
  ASSERT_TRUE(session.apply(Undo{}).ok());
  session.settle();
  EXPECT_EQ(session.scenario().surprises.size(), before);
}

TEST(Session, TwoHiddenSurprisesAtOneStepRepeatFromTheScenario) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 2}).ok());
  ASSERT_TRUE(session.apply(DropSurprise{block(6, 5, 1, 3), 1}).ok());
  session.settle();  // the robot sees the first before the second comes
  ASSERT_TRUE(session.apply(DropSurprise{block(5, 9, 1, 3), 2}).ok());
  expect_repeats(session);
}

TEST(Session, AnEditOfAnUnknownWorldRepeatsFromTheScenario) {
  Scenario scenario = wall_with_gap("dld-star-lite");
  scenario.robot.knowledge = Knowledge::nothing;
  scenario.map.set({4, 8}, true);
  Session session(scenario);
  session.settle();
  ASSERT_TRUE(session.apply(PaintCells{block(6, 6, 1, 3), 1}).ok());
  EXPECT_EQ(session.to_save(), session.scenario());  // told of it, not of the map
  expect_repeats(session);
}

TEST(Session, EditsAfterTheEndRepeatFromTheScenario) {
  Session arrived(wall_with_gap("dstar-lite"));
  run_to_end(arrived);
  ASSERT_TRUE(arrived.apply(PaintCells{block(20, 6, 1, 3), 1}).ok());
  expect_repeats(arrived);
  Scenario closed = wall_with_gap("dstar-lite");
  closed.map.set({12, 5}, true);
  Session gave_up(closed);
  run_to_end(gave_up);
  ASSERT_TRUE(gave_up.apply(PaintCells{block(12, 9, 1, 2, false), 1}).ok());
  expect_repeats(gave_up);
}

TEST(Session, SavingKeepsWhatWasErasedAfterASurprise) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(DropSurprise{block(6, 5, 1, 1), 1}).ok());
  ASSERT_TRUE(session.apply(PaintCells{block(6, 5, 1, 1, false), 2}).ok());
  session.settle();
  Session reopened(session.to_save());
  run_to_end(reopened);
  const auto& run = reopened.run();
  EXPECT_FALSE(run.timeline().head().truly_blocked(run.lattice().node(Cell{6, 5})));
}

TEST(Session, KnowsWhetherItsDocumentIsSaved) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  for (int part = 0; part < 3; ++part)
    ASSERT_TRUE(session.apply(PaintCells{block(6 + part, 4, 1, 1), 7}).ok());
  EXPECT_TRUE(session.modified());
  ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_FALSE(session.modified());  // one stroke, one undo
  ASSERT_TRUE(session.apply(Redo{}).ok());
  session.saved("x.json");
  ASSERT_TRUE(session.apply(Undo{}).ok());
  ASSERT_TRUE(session.apply(PaintCells{block(15, 4, 1, 1), 8}).ok());
  EXPECT_TRUE(session.modified());  // as many edits as when saved, but others
}

TEST(Session, WaitingForAFarStepTakesNoTime) {
  Scenario scenario = wall_with_gap("dstar-lite");
  scenario.map.set({12, 5}, true);
  scenario.surprises.push_back({.at = {.move = 1'000'000'000'000, .near = {}, .within = 0},
                                .cells = block(12, 5, 1, 1, false),
                                .announced = true});
  Session session(scenario);
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  EXPECT_GT(last_decision(session).clock, 1'000'000'000'000);
}

TEST(Session, PlayTakesUpACancelledPlan) {
  Session session(wall_with_gap("dstar-lite"));
  ASSERT_TRUE(session.apply(Cancel{}).ok());
  ASSERT_TRUE(session.apply(Play{1}).ok());
  ASSERT_TRUE(session.apply(SetSpeed{1e5}).ok());
  for (int frame = 0; frame < 20000 && session.playback().direction != 0; ++frame) {
    if (session.run().busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    session.update(0.05);
  }
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
}

TEST(Session, NoPathIsAnAnswerAndTheRobotGoesOnWhenTheMapOpens) {
  Scenario scenario = wall_with_gap("dstar-lite");
  scenario.map.set({12, 5}, true);
  Session session(scenario);
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::no_path);
  EXPECT_EQ(last_decision(session).plan->status, PlanStatus::no_path);
  ASSERT_TRUE(session.apply(PaintCells{block(12, 9, 1, 2, false), 1}).ok());
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
}

TEST(Session, ARobotUnderASurpriseWaitsUntilItIsFree) {
  Scenario scenario = wall_with_gap("dld-star-lite");
  scenario.surprises.push_back(
      {.at = {.move = 3, .near = {}, .within = 0}, .cells = block(3, 5, 3, 6), .announced = true});
  scenario.surprises.push_back(
      {.at = {.move = 8, .near = {}, .within = 0}, .cells = block(3, 5, 3, 6, false), .announced = true});
  Session session(scenario);
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  EXPECT_EQ(last_decision(session).figures.collisions, 0);
  EXPECT_GT(last_decision(session).clock, last_decision(session).figures.moves);
}

TEST(Session, EditsBeforeTheRobotMovedArePartOfTheSavedMap) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(PaintCells{block(6, 4, 2, 2), 1}).ok());
  const Scenario saved = session.to_save();
  EXPECT_TRUE(saved.surprises.empty());
  EXPECT_TRUE(saved.map.at({6, 4}));
  EXPECT_TRUE(session.modified());
  session.saved("x.json");
  EXPECT_FALSE(session.modified());
}

/// A setting that both have is kept by its word; of a choice the same number may be another one there, or none.
TEST(Session, AnotherPlannerTakesOverWhatItHasByItsWord) {
  for (const PlannerInfo& from : planners())
    for (const Parameter& parameter : from.parameters) {
      if (parameter.type != ParameterType::choice) continue;
      for (std::size_t value = 0; value < parameter.choices.size(); ++value)
        for (const PlannerInfo& to : planners()) {
          Scenario scenario;
          scenario.map = GridMap(6, 6);
          scenario.goal = {5, 5};
          scenario.planners = {{std::string(from.id), {}, {}}};
          scenario.planners[0].settings.set(parameter.key, static_cast<double>(value));
          Session session(scenario);
          ASSERT_TRUE(session.apply(ChoosePlanner{0, std::string(to.id)}).ok()) << from.id << ' ' << to.id;
          const Parameter* same = find_parameter(to.parameters, parameter.key);
          if (same == nullptr) continue;
          const auto word = parse_value(*same, parameter.choices[value]);
          const double expected = word ? *word : same->initial;
          EXPECT_EQ(session.scenario().planners[0].settings.get(*same), expected)
              << from.id << " to " << to.id << ": " << parameter.key << '=' << parameter.choices[value];
        }
    }
}

TEST(Session, RefusesWhatLiesOutsideAndSaysSo) {
  Session session(wall_with_gap("dstar-lite"));
  const auto refused = session.apply(PaintCells{{{{24, 0}, true}}, 1});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().find("outside"), std::string::npos);
  EXPECT_FALSE(session.apply(ChoosePlanner{0, "dstar-light"}).ok());
  EXPECT_FALSE(session.apply(SetParameter{0, "range", 3}).ok());  // D* Lite has no range
}

TEST(Session, PanesGoInLockstepByStepsOfTheRobotAndExpansions) {
  Scenario scenario = wall_with_gap("dstar-lite");
  scenario.planners.push_back({"dld-star-lite", {}});
  Session session(scenario);
  run_to_end(session);
  while (session.runs()[1]->busy()) session.update(0);
  const auto& first = *session.runs()[0];
  const auto& second = *session.runs()[1];
  for (std::size_t p = 0; p < first.timeline().size(); p += 13) {
    ASSERT_TRUE(session.apply(Seek{p}).ok());
    const Progress wanted = progress(first, p), got = progress(second, second.timeline().cursor());
    if (wanted.clock >= second.decisions().back().clock) break;  // the other robot has arrived
    // A first plan that has ended stands, which is step 0.
    EXPECT_EQ(std::max<std::int64_t>(0, got.clock), std::max<std::int64_t>(0, wanted.clock)) << "at " << p;
    if (got.clock == wanted.clock && got.plan == wanted.plan) {
      EXPECT_LE(got.expansions, wanted.expansions) << "at " << p;
    }
  }
}

TEST(Session, PlaysForwardsToTheArrivalAndBackToTheBeginning) {
  Session session(wall_with_gap("dld-star-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  ASSERT_TRUE(session.apply(SetSpeed{2000}).ok());
  ASSERT_TRUE(session.apply(Play{1}).ok());
  int frames = 0;
  for (; frames < 20000 && session.playback().direction != 0; ++frames) {
    if (session.run().busy())
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // as between two frames
    session.update(0.05);
  }
  EXPECT_LT(frames, 20000);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  EXPECT_EQ(session.run().timeline().cursor(), session.run().timeline().size());
  ASSERT_TRUE(session.apply(Play{-1}).ok());
  for (int frame = 0; frame < 20000 && session.playback().direction != 0; ++frame) session.update(0.05);
  EXPECT_EQ(session.run().timeline().cursor(), 0u);
}

TEST(Session, AGoalThatMovesOnTheWayIsPlannedForAfreshFromWhereTheRobotIs) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 5}).ok());
  const std::size_t before = session.run().timeline().cursor();
  // A drag over three cells counts as one change.
  for (const Cell cell : {Cell{20, 8}, Cell{20, 12}, Cell{19, 13}}) {
    ASSERT_TRUE(session.apply(SetGoal{cell, 7}).ok());
    session.settle();
  }
  ASSERT_EQ(session.scenario().surprises.size(), 1u);
  EXPECT_EQ(session.scenario().surprises[0].goal, (Cell{19, 13}));
  EXPECT_EQ(session.scenario().goal, (Cell{21, 8})) << "the run's own goal stays";
  EXPECT_EQ(last_decision(session).figures.moves, 5);
  EXPECT_GE(session.run().timeline().cursor(), before);
  const auto kinds = [&](EventKind kind) {
    int count = 0;
    for (std::size_t i = 0; i < session.run().timeline().size(); ++i)
      count += session.run().timeline().event(i).kind == kind ? 1 : 0;
    return count;
  };
  EXPECT_EQ(kinds(EventKind::new_goal), 1);
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  EXPECT_EQ(session.run().timeline().state().node(Scalar::robot), session.run().lattice().node(Cell{19, 13}));
  expect_repeats(session);
  ASSERT_TRUE(session.apply(Undo{}).ok());
  session.settle();
  EXPECT_TRUE(session.scenario().surprises.empty());
}

TEST(Session, ARobotThatIsPutElsewhereRepairsItsPlan) {
  Session session(wall_with_gap("dld-star-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(PutRobot{{3, 3}}).ok());
  EXPECT_EQ(session.scenario().start, (Cell{3, 3})) << "before it has set out this moves the start";
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 4}).ok());
  ASSERT_TRUE(session.apply(PutRobot{{5, 14}}).ok());
  session.settle();
  EXPECT_EQ(session.run().timeline().state().node(Scalar::robot), session.run().lattice().node(Cell{5, 14}));
  EXPECT_EQ(session.scenario().start, (Cell{3, 3}));
  run_to_end(session);
  EXPECT_EQ(last_decision(session).state, MissionState::arrived);
  expect_repeats(session);
}

TEST(Session, AnObstacleThatMovesAppearsWhereTheRobotIsAndTheRobotStaysThere) {
  Session session(wall_with_gap("dstar-lite"));
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 6}).ok());
  const NodeId robot = session.run().timeline().state().node(Scalar::robot);
  ASSERT_TRUE(session.apply(AddMover{patrol()}).ok());
  while (session.run().busy()) session.update(0);
  session.update(0);
  ASSERT_EQ(session.scenario().movers.size(), 1u);
  EXPECT_EQ(session.scenario().movers[0].from, 6);
  EXPECT_EQ(session.run().timeline().state().node(Scalar::robot), robot);
  expect_repeats(session);
  EXPECT_EQ(last_decision(session).figures.collisions, 0);
  EXPECT_FALSE(session.apply(AddMover{{.way = {}}}).ok());
  EXPECT_FALSE(session.apply(AddMover{{.way = {{99, 0}}}}).ok());
  EXPECT_FALSE(session.apply(RemoveMover{1}).ok());
  ASSERT_TRUE(session.apply(RemoveMover{0}).ok());
  EXPECT_TRUE(session.scenario().movers.empty());
}

TEST(Session, ASmoothRobotIsShownBetweenCellsAndDrivesAtItsSpeed) {
  Scenario scenario = wall_with_gap("dstar-lite");
  scenario.robot.motion = Motion::smooth;
  scenario.robot.speed = 5;
  Session session(scenario);
  session.settle();
  run_to_end(session);
  const std::size_t planned = session.run().decisions().front().event;
  const double driven = last_decision(session).figures.travelled;
  ASSERT_TRUE(session.apply(Seek{planned}).ok());
  ASSERT_TRUE(session.apply(SetSpeed{Session::kRealTimeSpeed}).ok());
  ASSERT_TRUE(session.apply(Play{1}).ok());
  int frames = 0, between = 0;
  for (; frames < 2000 && session.playback().direction != 0; ++frames) {
    session.update(1.0 / 60);
    between += session.run().travel() > 0 && session.run().travel() < 1 ? 1 : 0;
  }
  EXPECT_NEAR(frames / 60.0, driven / scenario.robot.speed, 0.3);
  EXPECT_GT(between, frames / 2);
  EXPECT_EQ(session.run().travel(), 1);
}

}  // namespace
}  // namespace replan::session_test
