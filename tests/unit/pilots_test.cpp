// Pilots: planners that bring their own robot. What runs for one is what runs where planner, stage and robot are chosen one
// by one, event for event; and the other panes keep the scenario's robot.
#include <algorithm>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "core/experiment/batch_report.hpp"
#include "core/session/session.hpp"
#include "core/study/run_report.hpp"
#include "core/world/choices.hpp"

namespace replan::pilots_test {
namespace {

Scenario boxes() {
  return std::move(read_scenario(REPLAN_SOURCE_DIR "/maps/fusion-boxes.json").value());
}

/// A cup that faces a robot on its way straight to the goal, known from the start.
Scenario facing_cup() {
  Scenario scenario;
  scenario.map = GridMap(24, 15);
  for (int x = 9; x <= 14; ++x)
    for (const int y : {4, 10}) scenario.map.set({x, y}, true);
  for (int y = 4; y <= 10; ++y) scenario.map.set({14, y}, true);
  scenario.start = {2, 7};
  scenario.goal = {21, 7};
  scenario.planners = {{"astar", {}}};
  return scenario;
}

PlannerChoice fusion_with(std::string_view global) {
  PlannerChoice choice{"fusion", {}};
  EXPECT_TRUE(set_from_text(choice.settings, find_choice("fusion")->parameters, "global", global).ok());
  return choice;
}

std::vector<Event> log_of(const Scenario& scenario, const PlannerChoice& choice) {
  Recorder recorder;
  const auto mission = make_mission(scenario, choice, &recorder);
  while (mission->advance(1 << 20)) {
  }
  return recorder.take();
}

TEST(Pilots, StandAmongAllThatCanBeChosen) {
  std::set<std::string_view> ids;
  bool exercises = false;
  for (const PlannerInfo& info : choices()) {
    EXPECT_TRUE(ids.insert(info.id).second) << info.id;
    EXPECT_TRUE(info.exercise || !exercises) << "exercises come last";
    exercises |= info.exercise;
    EXPECT_FALSE(info.blind) << info.id;
  }
  EXPECT_EQ(choices().size(), planners().size() + pilots().size());
  for (const char* id : {"dwa", "fusion"}) {
    EXPECT_NE(find_pilot(id), nullptr) << id;
    EXPECT_EQ(find_planner(id), nullptr) << id << " is no planner by itself";
  }
  EXPECT_NE(require_choice("fusoin").error().find("did you mean 'fusion'"), std::string::npos);
  EXPECT_FALSE(require_choice("straight-line").ok()) << "what is blind is nobody's choice";
}

TEST(Pilots, HaveTheParametersOfTheirRobotAndEachKeyOnce) {
  for (const Pilot& pilot : pilots()) {
    std::set<std::string_view> keys;
    for (const Parameter& parameter : pilot.info.parameters)
      EXPECT_TRUE(keys.insert(parameter.key).second) << pilot.info.id << "." << parameter.key;
    ASSERT_NE(find_robot(pilot.robot), nullptr);
    for (const Parameter& parameter : find_robot(pilot.robot)->parameters)
      EXPECT_TRUE(keys.contains(parameter.key)) << pilot.info.id << "." << parameter.key;
    for (const PlannerInfo& planner : planners())
      for (const Parameter& parameter : planner.parameters) {
        const Parameter* own = find_parameter(pilot.info.parameters, parameter.key);
        EXPECT_TRUE(own == nullptr || own->choices == parameter.choices)
            << parameter.key << " means two things for " << pilot.info.id;
      }
  }
}

TEST(Pilots, OfferEveryPlannerThatIsCompleteForGlobalAndImprovedAStarAtFirst) {
  const Parameter* global = find_parameter(find_choice("fusion")->parameters, "global");
  ASSERT_NE(global, nullptr);
  ASSERT_EQ(global->choices.size(), complete_planners().size());
  for (std::size_t i = 0; i < global->choices.size(); ++i)
    EXPECT_EQ(global->choices[i], complete_planners()[i].id);
  EXPECT_EQ(planner_of({"fusion", {}}).id, "adaptive-astar");
  EXPECT_EQ(planner_of(fusion_with("dld-star-lite")).id, "dld-star-lite");
}

TEST(Pilots, TakeTheirSettingsBeforeTheRobotsAndLeaveThoseOfAnotherKind) {
  PlannerChoice asked{"fusion", {}};
  asked.settings.set("v_max", 0.25);
  asked.settings.set("safety", 2);
  asked.settings.set("corners", 1);
  RobotSetup robot;
  robot.radius = 0.4;
  robot.settings.set("v_max", 3);
  const Resolved other = resolved(asked, robot);
  EXPECT_EQ(other.robot.kind, "dwa");
  EXPECT_EQ(other.robot.radius, 0.4);
  EXPECT_EQ(other.robot.settings.values().size(), 1u);
  EXPECT_EQ(other.robot.settings.get("v_max", 0), 0.25);
  EXPECT_EQ(other.planner.settings.get("corners", 0), 1);
  EXPECT_FALSE(other.planner.settings.has("v_max"));
  ASSERT_EQ(other.planner.stages.size(), 1u);
  EXPECT_EQ(other.planner.stages[0].settings.get("distance", 0), 2);
  robot.kind = "dwa";
  robot.settings.set("w_max", 1);
  const Resolved same = resolved(asked, robot);
  EXPECT_EQ(same.robot.settings.get("w_max", 0), 1);
  EXPECT_EQ(same.robot.settings.get("v_max", 0), 0.25);
  const PlannerChoice planner{"jps", {}, {{"floyd", {}}}};
  EXPECT_EQ(resolved(planner, robot).planner, planner);
  EXPECT_EQ(resolved(planner, robot).robot, robot);
}

/// What stands in the Planner tab and in the head of a trace is what the robot drives by.
TEST(Pilots, TellTheSettingsThatAreInForce) {
  auto world = std::make_shared<Scenario>(boxes());
  world->planners = {{"fusion", {}}, {"dstar-lite", {}}};
  const double w_max = world->robot.settings.get("w_max", 0);
  ASSERT_EQ(w_max, 1);
  EXPECT_EQ(replan::Run(world, 0).settings().get("w_max", 0), w_max);
  EXPECT_FALSE(replan::Run(world, 1).settings().has("w_max"));
  Session session(*world);
  const Parameter& parameter = *find_parameter(find_choice("fusion")->parameters, "w_max");
  ASSERT_TRUE(session.apply(SetParameter{0, "w_max", parameter.initial}).ok());
  EXPECT_EQ(session.run().settings().get("w_max", 0), parameter.initial)
      << "the default is a wish of its own here";
  ASSERT_TRUE(session.apply(SetParameter{0, "w_max", w_max}).ok());
  EXPECT_FALSE(session.scenario().planners[0].settings.has("w_max")) << "it is the scenario's again";
  ASSERT_TRUE(session.apply(ChoosePlanner{1, "dwa"}).ok());
  EXPECT_EQ(session.runs()[1]->settings().get("w_max", 0), w_max);
}

TEST(Pilots, RunAsTheirPartsDoEventForEvent) {
  const Scenario driven = boxes();
  Scenario by_cells = driven;
  by_cells.robot.kind = "cells";
  by_cells.robot.settings = {};
  for (const PlannerInfo& global : complete_planners()) {
    PlannerChoice asked = fusion_with(global.id);
    const std::vector<Event> parts =
        log_of(driven, {.id = std::string(global.id), .settings = {}, .stages = {{"floyd", {}}}});
    asked.settings.set("w_max", 1);
    EXPECT_TRUE(log_of(by_cells, asked) == parts) << global.id;
  }
}

TEST(Pilots, LeaveTheOtherPanesAsTheyAre) {
  auto alone = std::make_shared<Scenario>(boxes());
  alone->robot.kind = "cells";
  alone->robot.settings = {};
  alone->planners = {{"dstar-lite", {}}};
  auto beside = std::make_shared<Scenario>(*alone);
  beside->planners = {{"fusion", {}}, {"dwa", {}}, {"dstar-lite", {}}};
  replan::Run one(alone, 0), other(beside, 2), fusion(beside, 0);
  for (replan::Run* run : {&one, &other, &fusion}) run->finish(Target::end());
  EXPECT_EQ(one.timeline().log_hash(), other.timeline().log_hash());
  EXPECT_EQ(one.timeline().size(), other.timeline().size());
  EXPECT_FALSE(other.decisions().back().drive.begun);
  EXPECT_TRUE(fusion.decisions().back().drive.begun);
  EXPECT_EQ(fusion.info().name, "Fusion");
  EXPECT_EQ(fusion.info().id, "fusion");
  EXPECT_TRUE(fusion.info().values.declares(EventKind::queue));
  EXPECT_EQ(fusion.info().values.numbers.size(), find_planner("adaptive-astar")->values.numbers.size());
}

TEST(Pilots, TakeOverTheSettingsOfARobotOfTheirKind) {
  const Scenario driven = boxes();
  PlannerChoice asked{"fusion", {}};
  const std::vector<Event> as_it_is = log_of(driven, asked);
  asked.settings.set("w_max", 1);
  EXPECT_TRUE(log_of(driven, asked) == as_it_is);
  asked.settings.set("w_max", 0.5);
  EXPECT_FALSE(log_of(driven, asked) == as_it_is);
}

/// With the same weights: the planner is what leads out of a dead end.
TEST(Pilots, ComeOutOfADeadEndThatHoldsTheWindowAlone) {
  Scenario cup = facing_cup();
  for (const Knowledge knowledge : {Knowledge::map, Knowledge::nothing})
    for (const double radius : {0.0, 0.3}) {
      cup.robot.knowledge = knowledge;
      cup.robot.radius = radius;
      const RunReport fusion = drive(cup, {"fusion", {}});
      EXPECT_EQ(fusion.robot->ending, MissionState::arrived) << radius;
      EXPECT_EQ(fusion.robot->collisions, 0) << radius;
      const RunReport dwa = drive(cup, {"dwa", {}});
      EXPECT_EQ(dwa.robot->ending, MissionState::stuck) << radius;
      EXPECT_EQ(dwa.robot->collisions, 0) << radius;
      EXPECT_EQ(dwa.status, "found") << "both ends are free";
      EXPECT_EQ(dwa.figures.nodes, 2);
      EXPECT_EQ(dwa.counters.expansions, 0);
      EXPECT_FALSE(explanation(dwa).empty());
    }
}

TEST(Pilots, DriveStraightToAGoalThatNothingHides) {
  Scenario hall = facing_cup();
  hall.map = GridMap(24, 15);
  const RunReport dwa = drive(hall, {"dwa", {}});
  EXPECT_EQ(dwa.robot->ending, MissionState::arrived);
  EXPECT_NEAR(dwa.robot->travelled, 19, 0.6);
  Scenario there = hall;
  there.goal = there.start;
  EXPECT_EQ(drive(there, {"dwa", {}}).robot->ending, MissionState::arrived);
  hall.map.set(hall.goal, true);
  const RunReport blocked = drive(hall, {"dwa", {}});
  EXPECT_EQ(blocked.robot->ending, MissionState::no_path);
  EXPECT_EQ(blocked.status, status_name(PlanStatus::goal_blocked));
}

/// What moves to and fro in its sight changes its map again and again; it gives up all the same.
TEST(Pilots, AreNotKeptInADeadEndForEverByWhatTheySee) {
  Scenario cup = facing_cup();
  MovingObstacle mover;
  mover.way = {{10, 7}, {10, 9}};
  mover.speed = 0.3;
  cup.movers = {mover};
  const auto mission = make_mission(cup, {"dwa", {}});
  while (mission->now().clock < 20'000 && mission->advance(1 << 20)) {
  }
  EXPECT_EQ(mission->state(), MissionState::stuck);
  EXPECT_GT(mission->now().figures.replans, 20) << "it has seen it come and go";
}

/// A corridor of 30 cells whose robot has little patience: it takes longer for the whole way.
Scenario corridor() {
  Scenario scenario;
  scenario.map = GridMap(30, 3);
  scenario.start = {1, 1};
  scenario.goal = {28, 1};
  scenario.planners = {{"astar", {}}};
  scenario.robot.patience = 20;
  return scenario;
}

MissionState end_of(const Scenario& scenario) {
  const auto mission = make_mission(scenario, {"dwa", {}});
  while (mission->now().clock < 20'000 && mission->advance(1 << 20)) {
  }
  return mission->state();
}

/// Nor are they given up while they wait, or once there is another place to come nearer to.
TEST(Pilots, AreNotGivenUpForTimeThatTheyCouldDoNothingWith) {
  Scenario shut = corridor();
  Surprise covers{.at = {.move = 5, .near = {}, .within = 0}, .cells = {{{28, 1}, true}}, .announced = true};
  Surprise opens{
      .at = {.move = 405, .near = {}, .within = 0}, .cells = {{{28, 1}, false}}, .announced = true};
  shut.surprises = {covers, opens};
  EXPECT_EQ(end_of(shut), MissionState::arrived);
  shut.robot.unreachable_goal = UnreachableGoal::nearest;
  EXPECT_EQ(end_of(shut), MissionState::arrived);
  Scenario carried = corridor();
  Surprise back;
  back.at.move = 230;
  back.robot = Cell{1, 1};
  carried.surprises = {back};
  EXPECT_EQ(end_of(carried), MissionState::arrived);
}

/// A global planner that has no choice of moves is not held to one.
TEST(Pilots, AreHeldToTheRulesThatTheirPlannerGoesBy) {
  for (const PlannerInfo& global : complete_planners()) {
    PlannerChoice fusion = fusion_with(global.id);
    fusion.settings.set("moves", 1);
    const bool has = find_parameter(global.parameters, "moves") != nullptr;
    EXPECT_EQ(move_rules(settings_of(fusion, {})).diagonals, !has) << global.id;
    EXPECT_EQ(planner_of(fusion).settings.has("moves"), has) << global.id;
  }
}

TEST(Pilots, WhatIsBlindStandsLast) {
  const auto all = listed_planners();
  const auto first = std::find_if(all.begin(), all.end(), [](const PlannerInfo& each) { return each.blind; });
  EXPECT_TRUE(std::all_of(first, all.end(), [](const PlannerInfo& each) { return each.blind; }));
}

TEST(Pilots, ArriveAmongThePapersBoxesWhereTheWindowAloneIsStuck) {
  const Scenario world = boxes();
  const RunReport fusion = drive(world, {"fusion", {}}), dwa = drive(world, {"dwa", {}});
  EXPECT_EQ(fusion.robot->ending, MissionState::arrived);
  EXPECT_EQ(fusion.robot->collisions, 0);
  EXPECT_EQ(dwa.robot->ending, MissionState::stuck);
  EXPECT_EQ(dwa.robot->collisions, 0);
}

TEST(Pilots, StandInFilesAsTheyWereAskedFor) {
  Scenario world = facing_cup();
  PlannerChoice fusion = fusion_with("dstar-lite");
  fusion.settings.set("v_max", 0.4);
  world.planners = {fusion, {"dwa", {}}};
  const std::string text = scenario_text(world);
  EXPECT_NE(text.find("\"global\": \"dstar-lite\""), std::string::npos) << text;
  const auto again = parse_scenario(text, "pilots.json", "");
  ASSERT_TRUE(again.ok()) << again.error();
  EXPECT_EQ(again->planners, world.planners);
  const auto refused = parse_scenario(
      R"({"replan": 1, "map": {"rows": ["..."]}, "start": [0, 0], "goal": [2, 0],
          "planners": [{"id": "fusion", "settings": {"global": "dwa"}}]})",
      "pilots.json", "");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().find("adaptive-astar"), std::string::npos) << refused.error();
  const auto layered = parse_scenario(
      R"({"replan": 1, "map": {"layers": [["..", ".."], ["..", ".."]]}, "start": [0, 0, 0], "goal": [1, 1, 1],
          "planners": [{"id": "fusion"}]})",
      "pilots.json", "");
  ASSERT_FALSE(layered.ok());
  EXPECT_NE(layered.error().find("plans in the plane alone"), std::string::npos) << layered.error();
}

ScenProblem problem(Cell start, Cell goal, double length) {
  ScenProblem made;
  made.start = start;
  made.goal = goal;
  made.length = length;
  return made;
}

TEST(Pilots, DriveTheProblemsOfABatch) {
  const Scenario cup = facing_cup();
  const std::vector<ScenProblem> problems = {problem({2, 7}, {21, 7}, 25.0), problem({2, 2}, {21, 2}, 19)};
  const BatchReport fusion = solve_problems(cup.map, {}, problems, {"fusion", {}});
  EXPECT_EQ(fusion.found, 2);
  EXPECT_FALSE(fusion.comparable);
  EXPECT_GT(fusion.mean_ratio, 0.9);
  const BatchReport dwa = solve_problems(cup.map, {}, problems, {"dwa", {}});
  EXPECT_EQ(dwa.found, 1) << "the cup holds it";
  EXPECT_EQ(dwa.unsolved(), 1);
}

}  // namespace
}  // namespace replan::pilots_test
