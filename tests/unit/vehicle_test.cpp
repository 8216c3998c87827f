// The vehicle that keeps to its plan: its times by hand, its turns, and what it senses in between.
#include <cmath>

#include <gtest/gtest.h>

#include "core/sim/mission.hpp"
#include "core/study/figures_table.hpp"

namespace replan::vehicle_test {
namespace {

/// A passage one cell wide that goes four cells to the right and then four down.
Scenario passage() {
  Scenario scenario;
  scenario.map = GridMap(5, 5);
  for (int y = 1; y < 5; ++y)
    for (int x = 0; x < 4; ++x) scenario.map.set({x, y}, true);
  scenario.start = {0, 0};
  scenario.goal = {4, 4};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot = {.speed = 2, .kind = "vehicle"};
  return scenario;
}

struct Ended {
  MissionState state;
  Decision now;
  std::vector<Event> log;
  [[nodiscard]] double seconds() const { return static_cast<double>(now.time) / kSecond; }
  [[nodiscard]] double turning() const { return static_cast<double>(now.figures.kept->turning) / kSecond; }
};

Ended driven(const Scenario& scenario) {
  Recorder recorder;
  const auto mission = make_mission(scenario, scenario.planners[0], &recorder);
  while (mission->advance(1 << 20)) {
  }
  return {mission->state(), mission->now(), recorder.take()};
}

/// It looks towards its goal, 45 degrees off the way; then comes the corner, of 90.
TEST(Vehicle, StopsAtSharpCornersAndTurnsOnTheSpot) {
  Scenario scenario = passage();
  const Ended ended = driven(scenario);
  EXPECT_EQ(ended.state, MissionState::arrived);
  EXPECT_EQ(ended.now.figures.moves, 8);
  EXPECT_EQ(ended.now.figures.kept->stops, 2);
  EXPECT_EQ(ended.now.clock, 10) << "a turn is a step by itself";
  EXPECT_NEAR(ended.turning(), 135 / 45.0, 1e-6);
  EXPECT_NEAR(ended.seconds(), 8 / 2.0 + 135 / 45.0, 1e-5);
  EXPECT_EQ(ended.now.course, (Course{0, 1, 0}));
  std::vector<std::uint64_t> degrees;
  for (const Event& event : ended.log)
    if (event.kind == EventKind::turn) degrees.push_back(event.delta);
  EXPECT_EQ(degrees, (std::vector<std::uint64_t>{45, 90}));
  scenario.robot.settings.set("turn_rate", 90);
  EXPECT_NEAR(driven(scenario).seconds(), 8 / 2.0 + 135 / 90.0, 1e-5);
}

TEST(Vehicle, TurnsUnderWayAsFastAsTheStrictestOfItsLimitsLetsIt) {
  Scenario scenario = passage();
  scenario.robot.settings.set("corner", 90);
  Ended ended = driven(scenario);
  EXPECT_EQ(ended.now.figures.kept->stops, 0);
  EXPECT_EQ(ended.now.clock, 8);
  EXPECT_NEAR(ended.seconds(), 6 / 2.0 + 45 / 45.0 + 90 / 45.0, 1e-5) << "the turns take longer than the way";
  scenario.robot.settings.set("turn_rate", 3600);
  EXPECT_NEAR(driven(scenario).seconds(), 8 / 2.0, 1e-5) << "now the way takes longer";
}

TEST(Vehicle, RisesAndSinksNoFasterThanItCan) {
  Scenario scenario;
  scenario.map = GridMap(1, 1, 7);
  scenario.start = {0, 0, 0};
  scenario.goal = {0, 0, 6};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot = {.speed = 4, .kind = "vehicle"};
  scenario.robot.settings.set("climb_rate", 0.5);
  EXPECT_NEAR(driven(scenario).seconds(), 6 / 0.5, 1e-5);
  std::swap(scenario.start, scenario.goal);
  EXPECT_NEAR(driven(scenario).seconds(), 6 / 0.5, 1e-5);
  scenario.robot.settings.set("climb_rate", 100);
  EXPECT_NEAR(driven(scenario).seconds(), 6 / 4.0, 1e-5);
  // Along a diagonal of the x-z plane it looks straight at its goal: sqrt 2 of way a step, and one layer.
  scenario.map = GridMap(7, 1, 7);
  scenario.start = {0, 0, 0};
  scenario.goal = {6, 0, 6};
  scenario.robot.settings.set("climb_rate", 3);
  EXPECT_NEAR(driven(scenario).seconds(), 6 * std::sqrt(2.0) / 4, 1e-5);
  scenario.robot.settings.set("climb_rate", 2);
  EXPECT_NEAR(driven(scenario).seconds(), 6 / 2.0, 1e-5);
}

/// An open field: one corner of 45 degrees, which the curve rounds.
TEST(Vehicle, GoesThroughACurveWithoutAStop) {
  Scenario scenario;
  scenario.map = GridMap(20, 10);
  scenario.start = {1, 1};
  scenario.goal = {16, 7};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot = {.speed = 4, .kind = "vehicle"};
  const Ended corner = driven(scenario);
  scenario.planners[0].stages = {{"bspline", {}}};
  const Ended curve = driven(scenario);
  EXPECT_EQ(curve.state, MissionState::arrived);
  EXPECT_GE(corner.now.figures.kept->stops, 1);
  EXPECT_EQ(curve.now.figures.kept->stops, 0);
  EXPECT_LT(curve.seconds(), corner.seconds() - 0.5);
}

/// What stands behind the corner is seen once it has turned there, before it goes on.
TEST(Vehicle, SensesWhereItLooksAfterATurn) {
  Scenario scenario = passage();
  scenario.robot.sensor_angle = 60;
  scenario.robot.sensor_blocked = true;
  Surprise shut;
  shut.at.move = 2;
  shut.cells = {{{4, 3}, true}};
  scenario.surprises = {shut};
  const Ended ended = driven(scenario);
  EXPECT_EQ(ended.state, MissionState::no_path);
  EXPECT_EQ(ended.now.at, centre_of(Cell{4, 0}));
  EXPECT_EQ(ended.now.course, (Course{0, 1, 0}));
  std::vector<EventKind> kinds;
  for (const Event& event : ended.log)
    if (event.kind == EventKind::turn || event.kind == EventKind::sensed || event.kind == EventKind::move)
      kinds.push_back(event.kind);
  using enum EventKind;
  EXPECT_EQ(kinds, (std::vector{turn, move, move, move, move, turn, sensed}));
}

TEST(Vehicle, WhatMovesGoesOnWhileItTurns) {
  Scenario scenario = passage();
  scenario.map = GridMap(5, 7);
  for (int y = 1; y < 5; ++y)
    for (int x = 0; x < 4; ++x) scenario.map.set({x, y}, true);
  scenario.movers = {{.way = {{0, 6}, {3, 6}}, .speed = 1}};
  Recorder recorder;
  const auto mission = make_mission(scenario, scenario.planners[0], &recorder);
  std::int64_t before = -1;
  while (mission->advance(1 << 20)) {
    const std::int64_t turns = mission->now().figures.kept->stops;
    if (turns == 1 && before == 0) {
      EXPECT_EQ(mission->now().movers[0].steps, 1) << "45 degrees take a second";
    }
    before = turns;
  }
  EXPECT_EQ(mission->state(), MissionState::arrived);
}

TEST(Vehicle, HasFiguresOfItsTurns) {
  Scenario scenario = passage();
  const RunReport turns = drive(scenario, scenario.planners[0]);
  scenario.robot.kind = "cells";
  const RunReport hops = drive(scenario, scenario.planners[0]);
  for (const NamedFigure& figure : kept_figures(*hops.robot)) EXPECT_FALSE(figure.value) << figure.key;
  const auto figures = kept_figures(*turns.robot);
  ASSERT_EQ(figures.size(), 4u);
  EXPECT_EQ(figures[0].value, 2);
  EXPECT_NEAR(figures[1].value.value(), 3, 1e-6);
  EXPECT_NEAR(figures[2].value.value(), 135, 1e-9);
  EXPECT_EQ(figures[3].value, 0.5) << "in the middle of a passage one cell wide";
  const RunReport both[] = {turns, hops};
  const std::string csv = runs_csv(both), names = csv.substr(0, csv.find('\n'));
  EXPECT_TRUE(
      names.ends_with("robot_seconds,robot_stops,robot_turning_seconds,robot_course_turned_deg,"
                      "robot_way_min_clearance"))
      << names;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), ','), 3 * std::count(names.begin(), names.end(), ','));
  EXPECT_NE(runs_json(both).find("\"turning_seconds\": 3"), std::string::npos);
  const FiguresTable table = figures_table(both);
  EXPECT_TRUE(std::any_of(table.rows.begin(), table.rows.end(),
                          [](const FigureRow& row) { return row.info->key == "way_min_clearance"; }));
}

/// A box that is on no map, beside its way: what counts is what stands there.
TEST(Vehicle, TellsHowNearItCameToWhatStoodInTheWorld) {
  Scenario scenario;
  scenario.map = GridMap(20, 9);
  scenario.start = {1, 4};
  scenario.goal = {18, 4};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot = {.sensor_radius = 0, .kind = "vehicle"};
  EXPECT_EQ(driven(scenario).now.figures.kept->clearance, KeptWay::kFarthest);
  scenario.map.set({9, 7}, true);
  EXPECT_EQ(driven(scenario).now.figures.kept->clearance, 2.5);
  scenario.map.set({9, 7}, false);
  Surprise box;
  box.at.move = 3;
  box.cells = {{{9, 6}, true}};
  scenario.surprises = {box};
  EXPECT_EQ(driven(scenario).now.figures.kept->clearance, 1.5);
}

/// Between two places of a path in neighbouring cells the path may go round a corner: a body that cut it would touch.
TEST(Vehicle, WithABodyTouchesNothingAlongACurve) {
  Scenario scenario;
  scenario.map = GridMap(3, 5);
  for (int y = 0; y < 4; ++y) scenario.map.set({0, y}, true);
  scenario.start = {0, 4};
  scenario.goal = {1, 0};
  Settings samples;
  samples.set("samples", 10);
  scenario.planners = {{"astar", {}, {{"bspline", samples}}}};
  for (const char* kind : {"cells", "vehicle"}) {
    scenario.robot = {.radius = 0.27, .kind = kind};
    const auto mission = make_mission(scenario, scenario.planners[0]);
    while (mission->advance(1 << 20)) {
    }
    EXPECT_EQ(mission->state(), MissionState::arrived) << kind;
  }
}

}  // namespace
}  // namespace replan::vehicle_test
