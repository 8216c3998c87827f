// The session's commands for the world as a whole, for what is to happen, and its history.
#include <set>

#include <gtest/gtest.h>

#include "core/session/session.hpp"
#include "core/session/world_edit.hpp"

namespace replan::session_world_test {
namespace {

/// A free strip on which the robot drives from left to right.
Scenario strip() {
  Scenario scenario;
  scenario.map = GridMap(24, 9);
  scenario.start = {2, 4};
  scenario.goal = {21, 4};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot.sensor_radius = 3;
  return scenario;
}

Surprise wall_at(int x, Trigger when) {
  Surprise surprise;
  surprise.at = when;
  for (int y = 2; y < 7; ++y) surprise.cells.push_back({{x, y}, true});
  return surprise;
}
Trigger at_step(std::int64_t step) {
  return {step, std::nullopt, 0};
}

void run_to_end(Session& session) {
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  while (session.run().busy()) session.update(0);
  session.update(0);
}

std::int64_t clock_now(const Session& session) {
  const Decision* decision = session.run().decision_at(session.run().timeline().cursor());
  return decision == nullptr ? -1 : decision->clock;
}

TEST(SessionWorld, AScheduledSurpriseHappensAtItsStepAndNotBefore) {
  Session session(strip());
  session.settle();
  ASSERT_TRUE(session.apply(ScheduleSurprise{wall_at(15, at_step(6))}).ok());
  run_to_end(session);
  const auto& run = session.run();
  EXPECT_EQ(run.decisions().back().state, MissionState::arrived);
  EXPECT_EQ(run.decisions().back().figures.collisions, 0);
  const NodeId cell = run.lattice().node(Cell{15, 4});
  for (const Decision& decision : run.decisions()) {
    ASSERT_TRUE(session.apply(Seek{decision.event}).ok());
    if (decision.clock == 6) continue;  // before it and after it
    EXPECT_EQ(run.timeline().state().wall(cell), decision.clock > 6);
  }
}

/// Of ten cells, some of which two surprises at one step turn into obstacles and back, an edit erases those
/// that are obstacles where it happens, whatever the cursor shows: it may stand amid the surprises.
TEST(SessionWorld, AnEditAmidSurprisesChangesWhatIsThereWhenItHappens) {
  Scenario scenario = strip();
  Surprise second = wall_at(16, at_step(6));
  for (const int y : {3, 4}) second.cells.push_back({{15, y}, false});
  scenario.surprises = {wall_at(15, at_step(6)), second};
  std::vector<CellChange> erased;
  for (int x : {15, 16})
    for (int y = 2; y < 7; ++y) erased.push_back({{x, y}, false});
  std::set<std::size_t> counts;
  for (std::size_t position = 0, size = 1; position <= size; ++position) {
    Session session(scenario);
    session.settle();
    run_to_end(session);
    size = session.run().timeline().size();
    ASSERT_TRUE(session.apply(Seek{position}).ok());
    const Decision* decision = session.run().decision_for_edit();
    if (decision == nullptr) continue;
    // The end shows what both have made of the cells.
    const SearchState then = session.run().timeline().state_at(decision->clock < 6 ? 0 : size);
    std::vector<Cell> expected, found;
    for (int y = 2; y < 7; ++y)
      for (int x : {15, 16})
        if (then.wall(session.run().lattice().node(Cell{x, y}))) expected.push_back({x, y});
    ASSERT_TRUE(session.apply(PaintCells{erased}).ok());
    const bool edited = session.scenario().surprises.size() > scenario.surprises.size();
    if (edited)
      for (const CellChange& change : session.scenario().surprises.back().cells) found.push_back(change.cell);
    ASSERT_EQ(found, expected) << position;
    counts.insert(found.size());
  }
  EXPECT_EQ(counts, (std::set<std::size_t>{0, 8}));
}

TEST(SessionWorld, SchedulingLeavesTheRobotWhereItIs) {
  Session session(strip());
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 3}).ok());
  const std::size_t cursor = session.run().timeline().cursor();
  ASSERT_EQ(clock_now(session), 3);
  ASSERT_TRUE(session.apply(ScheduleSurprise{wall_at(15, at_step(9))}).ok());
  session.update(0);
  EXPECT_EQ(session.run().timeline().cursor(), cursor);
  ASSERT_TRUE(session.apply(RemoveSurprise{0}).ok());
  session.update(0);
  EXPECT_EQ(session.run().timeline().cursor(), cursor);
  EXPECT_TRUE(session.scenario().surprises.empty());
}

TEST(SessionWorld, SchedulingLeavesEveryPaneWhereItIs) {
  Scenario scenario = strip();
  scenario.planners.push_back({"dld-star-lite", {}});
  Session session(scenario);
  session.settle();
  ASSERT_TRUE(session.apply(ScheduleSurprise{wall_at(15, at_step(9))}).ok());
  for (int i = 0; i < 50; ++i) {
    session.settle();
    session.update(0);
  }
  for (const auto& run : session.runs()) {
    const Decision* decision = run->decision_at(run->timeline().cursor());
    ASSERT_NE(decision, nullptr);
    EXPECT_EQ(decision->clock, 0);
  }
}

TEST(SessionWorld, ASurpriseNearAPlaceBringsTheRobotBackToWhereItWas) {
  Session session(strip());
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 3}).ok());
  Trigger near;
  near.near = Cell{14, 4};
  near.within = 3;
  ASSERT_TRUE(session.apply(ScheduleSurprise{wall_at(16, near)}).ok());
  while (session.run().busy()) session.update(0);
  session.update(0);
  EXPECT_EQ(clock_now(session), 3);
  run_to_end(session);
  EXPECT_EQ(session.run().decisions().back().state, MissionState::arrived);
}

TEST(SessionWorld, ASurpriseThatCannotBeIsRefused) {
  Session session(strip());
  session.settle();
  const auto refused = [&](const Surprise& surprise, const char* words) {
    const Result<void> done = session.apply(ScheduleSurprise{surprise});
    return !done.ok() && done.error().find(words) != std::string::npos;
  };
  EXPECT_TRUE(refused(wall_at(40, at_step(3)), "(40, 2) lies outside"));
  EXPECT_TRUE(refused(wall_at(5, {}), "when"));
  EXPECT_TRUE(refused(wall_at(5, at_step(-1)), "from 0"));
  EXPECT_TRUE(refused(wall_at(5, {std::nullopt, Cell{99, 0}, 2}), "on the map"));
  Surprise empty;
  empty.at = at_step(3);
  EXPECT_TRUE(refused(empty, "change nothing"));
  EXPECT_FALSE(session.apply(RemoveSurprise{0}).ok());
  EXPECT_FALSE(session.modified());
}

TEST(SessionWorld, RemovingAScriptedSurpriseAndUndoKeepSavingRight) {
  Scenario scenario = strip();
  scenario.surprises = {wall_at(15, at_step(6))};
  Session session(scenario);
  session.settle();
  ASSERT_TRUE(session.apply(PaintCells{{{{8, 4}, true}}, 1}).ok());
  ASSERT_TRUE(session.apply(RemoveSurprise{0}).ok());
  // What was painted before the robot moved is part of the map, with or without the script.
  EXPECT_TRUE(session.to_save().map.at({8, 4}));
  EXPECT_TRUE(session.to_save().surprises.empty());
  ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_TRUE(session.to_save().map.at({8, 4}));
  EXPECT_EQ(session.to_save().surprises, scenario.surprises);
  ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_EQ(session.scenario(), scenario);
}

TEST(SessionWorld, TurnsAndSizesAreTakenBack) {
  Scenario scenario = strip();
  scenario.map.set({10, 4}, true);
  scenario.surprises = {wall_at(22, at_step(6))};
  Session session(scenario);
  session.settle();
  ASSERT_TRUE(session.apply(PaintCells{{{{11, 4}, true}}, 1}).ok());
  ASSERT_TRUE(session.apply(TurnWorld{Turn::right}).ok());
  EXPECT_EQ(session.scenario().map.width, 9);
  EXPECT_TRUE(session.scenario().map.at({4, 10}) && session.scenario().map.at({4, 11}));
  ASSERT_TRUE(session.apply(TurnWorld{Turn::left}).ok());
  ASSERT_TRUE(session.apply(ResizeWorld{{22, 9, Side::low, Side::low, false}}).ok());
  EXPECT_TRUE(session.scenario().surprises.empty());
  EXPECT_EQ(session.log().back(), "5 cells of surprises lay outside and are gone");
  session.settle();
  EXPECT_EQ(session.run().decisions().back().state, MissionState::driving);
  EXPECT_EQ(session.undo_text(), "resize to 22 x 9");
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_EQ(session.scenario(), scenario);
  EXPECT_FALSE(session.modified());
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(session.apply(Redo{}).ok());
  EXPECT_EQ(session.scenario().map.width, 22);
  EXPECT_FALSE(session.apply(ResizeWorld{{0, 4, Side::low, Side::low, false}}).ok());
  EXPECT_TRUE(session.apply(ResizeWorld{{22, 9, Side::high, Side::high, true}}).ok());
  EXPECT_EQ(session.history().size(), 4u);  // the same size is no edit
}

TEST(SessionWorld, InvertAndClearRepairThePlan) {
  Scenario scenario = strip();
  scenario.map.set({10, 4}, true);
  Session session(scenario);
  session.settle();
  const auto plans = [&] {
    return std::count_if(session.run().milestones().begin(), session.run().milestones().end(),
                         [](const Milestone& milestone) { return milestone.kind == EventKind::plan_end; });
  };
  ASSERT_EQ(plans(), 1);
  ASSERT_TRUE(session.apply(ClearWorld{}).ok());
  session.settle();
  EXPECT_EQ(plans(), 2);
  EXPECT_FALSE(session.world().at({10, 4}));
  ASSERT_TRUE(session.apply(Undo{}).ok());
  ASSERT_TRUE(session.apply(InvertWorld{}).ok());
  session.settle();
  const GridMap world = session.world();
  EXPECT_FALSE(world.at({10, 4}) || world.at(scenario.start) || world.at(scenario.goal));
  EXPECT_TRUE(world.at({11, 4}));
  EXPECT_EQ(session.undo_text(), "invert the world");
}

TEST(SessionWorld, AGeneratedWorldHasEndsThatMeet) {
  Scenario scenario = strip();
  scenario.surprises = {wall_at(15, at_step(6))};
  Session session(scenario);
  session.settle();
  ASSERT_TRUE(session.apply(GenerateWorld{"maze", {}, 31, 21, 7}).ok());
  session.settle();
  EXPECT_EQ(session.undo_text(), "generate maze of 31 x 21, seed 7");
  EXPECT_EQ(session.scenario().name, "Maze, 31 x 21") << "it is another world";
  EXPECT_EQ(session.scenario().map.width, 31);
  EXPECT_TRUE(session.scenario().surprises.empty());
  EXPECT_EQ(session.run().decisions().back().state, MissionState::driving);
  EXPECT_EQ(session.run().decisions().back().plan->status, PlanStatus::found);
  const Scenario generated = session.scenario();
  ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_EQ(session.scenario(), scenario);
  ASSERT_TRUE(session.apply(GenerateWorld{"maze", {}, 31, 21, 7}).ok());
  EXPECT_EQ(session.scenario(), generated);
  EXPECT_FALSE(session.apply(GenerateWorld{"mace", {}, 31, 21, 7}).ok());
  EXPECT_FALSE(session.apply(GenerateWorld{"maze", {}, 0, 21, 7}).ok());
  EXPECT_EQ(session.scenario(), generated);
}

TEST(SessionWorld, AWorldOfLayersIsTippedResizedAndGenerated) {
  Scenario scenario;
  scenario.map = GridMap(12, 8, 5);
  for (int z = 0; z < 4; ++z) scenario.map.set({6, 4, z}, true);
  scenario.start = {1, 4, 2};
  scenario.goal = {10, 4, 2};
  scenario.planners = {{"dstar-lite", {}, {}}};
  Session session(scenario);
  session.settle();
  const auto apply = [&](const Command& command) {
    ASSERT_TRUE(session.apply(command).ok());
    session.settle();
    EXPECT_EQ(session.run().decisions().back().plan->status, PlanStatus::found);
  };
  for (const Turn turn :
       {Turn::tip_back, Turn::tip_right, Turn::upside_down, Turn::tip_left, Turn::tip_forward})
    apply(TurnWorld{turn});
  EXPECT_EQ(session.undo_text(), "tip the world forward");
  apply(ResizeWorld{{.width = 12, .height = 8, .depth = 9, .up = Side::middle}});
  EXPECT_EQ(session.undo_text(), "resize to 12 x 8 x 9");
  apply(ResizeWorld{{.width = 12, .height = 8}});  // a plane
  EXPECT_EQ(session.scenario().map.box(), Box(12, 8));
  apply(GenerateWorld{"sea-floor", {}, 20, 16, 3, 8});
  EXPECT_EQ(session.undo_text(), "generate sea-floor of 20 x 16 x 8, seed 3");
  EXPECT_EQ(session.scenario().map.box(), Box(20, 16, 8));
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_EQ(session.scenario(), scenario);
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(session.apply(Redo{}).ok());
  EXPECT_EQ(session.scenario().map.box(), Box(20, 16, 8));
  EXPECT_FALSE(session.apply(GenerateWorld{"maze", {}, 20, 16, 3, 8}).ok());
}

/// A condition that names a cell of the plane makes no sense in space: it stays, in the file too.
TEST(SessionWorld, ADocumentWhoseWorldHasGrownALayerIsReadAgain) {
  Session session(strip());
  session.settle();
  ASSERT_TRUE(session.apply(AddBreakpoint{"g(1, 1) > 2"}).ok());
  const Box before = session.scenario().map.box();
  ASSERT_TRUE(
      session.apply(ResizeWorld{{.width = before.width(), .height = before.height(), .depth = 2}}).ok());
  Scenario saved = session.scenario();
  saved.debug = session.debug();
  const auto again = parse_scenario(scenario_text(saved), "again.json", "");
  ASSERT_TRUE(again.ok()) << again.error();
  ASSERT_EQ(again->debug.breakpoints.size(), 1u);
  Session opened(*again);
  opened.settle();
  EXPECT_NE(opened.breakpoints().problem(0), "");
  ASSERT_TRUE(opened.apply(ResizeWorld{{.width = before.width(), .height = before.height()}}).ok());
  opened.settle();
  EXPECT_EQ(opened.breakpoints().problem(0), "") << "it is in a plane again";
}

/// So many voxels that they are more cells than a plane can have. That is seen before the cells are looked at.
TEST(SessionWorld, AWorldIsNotTippedToAPlaneThatIsTooLarge) {
  Scenario scenario = strip();
  scenario.map.width = 8193;
  scenario.map.height = 1;
  scenario.map.depth = 8193;
  const auto tipped = edited(scenario, 0, TurnWorld{Turn::tip_back});
  ASSERT_FALSE(tipped.ok());
  EXPECT_EQ(tipped.error(),
            "a world cannot have 8193 x 8193 cells: give sides from 1 and at most 67108864 cells in all");
}

TEST(SessionWorld, APlannerOfThePlaneKeepsAWorldFlat) {
  Scenario scenario = strip();
  scenario.planners = {{"field-dstar", {}, {}}};
  Session session(scenario);
  session.settle();
  const NewSize higher{.width = scenario.map.width, .height = scenario.map.height, .depth = 3};
  EXPECT_FALSE(session.apply(ResizeWorld{higher}).ok());
  EXPECT_FALSE(session.apply(GenerateWorld{"boxes", {}, 20, 16, 3, 8}).ok());
  EXPECT_EQ(session.scenario(), scenario);
}

TEST(SessionWorld, AMapTakesThePlaceOfAnother) {
  Session session(strip());
  session.settle();
  GridMap map(6, 6);
  map.blocked[map.index({3, 3})] = kUnmapped;
  ASSERT_TRUE(session.apply(ReplaceMap{map, Cell{1, 1}, Cell{5, 5}}).ok());
  EXPECT_EQ(session.scenario().map, map);
  EXPECT_EQ(session.scenario().start, (Cell{1, 1}));
  ASSERT_TRUE(session.apply(ReplaceMap{map, std::nullopt, std::nullopt}).ok());
  EXPECT_EQ(session.scenario().start, (Cell{0, 0}));
  EXPECT_FALSE(session.apply(ReplaceMap{map, Cell{6, 0}, std::nullopt}).ok());
  EXPECT_FALSE(session.apply(ReplaceMap{}).ok());
}

TEST(SessionWorld, TheHistoryGoesToAnyEdit) {
  Session session(strip());
  session.settle();
  std::vector<Scenario> states = {session.scenario()};
  const std::vector<Command> edits = {
      PaintCells{{{{8, 4}, true}}, 1},     TurnWorld{Turn::left},
      AddMover{{.way = {{2, 2}, {6, 2}}}}, GenerateWorld{"caves", {}, 40, 30, 3},
      SetRobot{{.sensor_radius = 9}},      ResizeWorld{{50, 30, Side::middle, Side::low, true}}};
  for (const Command& edit : edits) {
    ASSERT_TRUE(session.apply(edit).ok());
    states.push_back(session.scenario());
  }
  EXPECT_EQ(session.history().size(), edits.size());
  EXPECT_EQ(session.history()[3], "generate caves of 40 x 30, seed 3");
  for (const std::size_t position : {0u, 6u, 3u, 5u, 1u, 4u, 2u, 6u}) {
    ASSERT_TRUE(session.apply(GoToHistory{position}).ok());
    EXPECT_EQ(session.history_position(), position);
    EXPECT_EQ(session.history().size(), edits.size());
    EXPECT_EQ(session.scenario(), states[position]) << position;
  }
  EXPECT_FALSE(session.apply(GoToHistory{7}).ok());
  ASSERT_TRUE(session.apply(GoToHistory{2}).ok());
  ASSERT_TRUE(session.apply(ClearWorld{}).ok());  // another edit from here: the rest is gone
  EXPECT_EQ(session.history().size(), 3u);
}

TEST(SessionWorld, AStrokeIsOneEditThatCountsItsCells) {
  Session session(strip());
  session.settle();
  for (int x = 5; x < 9; ++x)
    ASSERT_TRUE(session.apply(PaintCells{{{{x, 1}, true}, {{x, 2}, true}}, 7}).ok());
  EXPECT_EQ(session.history(), (std::vector<std::string>{"paint 8 cells"}));
  EXPECT_EQ(session.log().back(), "paint 8 cells");
  ASSERT_TRUE(session.apply(PaintCells{{{{5, 1}, false}}, 8}).ok());
  EXPECT_EQ(session.history().back(), "erase 1 cell");
}

TEST(SessionWorld, TheWorldIsThatAtTheCursor) {
  Scenario scenario = strip();
  scenario.map.blocked[scenario.map.index({5, 1})] = kUnmapped;
  scenario.surprises = {wall_at(15, at_step(2))};
  Session session(scenario);
  session.settle();
  EXPECT_EQ(session.world(), scenario.map);
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 4}).ok());
  EXPECT_TRUE(session.world().at({15, 4}));
  EXPECT_EQ(session.world().blocked[scenario.map.index({5, 1})], kUnmapped);
}

}  // namespace
}  // namespace replan::session_world_test
