// The mission: what moves, what the robot remembers of it, waiting, giving up, and how time goes by.
#include "core/sim/mission.hpp"

#include <gtest/gtest.h>

#include "core/trace/search_state.hpp"

namespace replan {
namespace {

/// Two rooms joined by a corridor one cell wide and `length` long, at y = 4.
Scenario corridor(int length) {
  Scenario scenario;
  scenario.map = GridMap(length + 10, 9);
  for (int x = 5; x < 5 + length; ++x)
    for (int y = 0; y < 9; ++y)
      if (y != 4) scenario.map.set({x, y}, true);
  scenario.start = {2, 4};
  scenario.goal = {length + 7, 4};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot = {.sensor_radius = 4, .speed = 2, .patience = 20};
  return scenario;
}

/// A mission with its log's state.
struct Driven {
  Recorder recorder;
  Mission<Recorder> mission;
  SearchState state;
  std::vector<Event> log;

  explicit Driven(const Scenario& scenario)
      : mission(scenario, scenario.planners[0], recorder),
        state(initial_knowledge(scenario), initial_truth(scenario)) {}

  bool step() {
    const bool more = mission.advance(1 << 20);
    for (const Event& event : recorder.take()) {
      state.apply(event);
      log.push_back(event);
    }
    return more;
  }
  void run() {
    for (int i = 0; i < 100'000 && step(); ++i) {
    }
  }
  [[nodiscard]] int count(EventKind kind) const {
    int found = 0;
    for (const Event& event : log) found += event.kind == kind ? 1 : 0;
    return found;
  }
};

TEST(Mover, GoesBackRoundOrStopsAtTheEndOfItsWay) {
  MovingObstacle setup{.way = {{1, 1}, {4, 1}, {4, 3}}};
  const std::vector<Cell> way = {{1, 1}, {2, 1}, {3, 1}, {4, 1}, {4, 2}, {4, 3}};
  EXPECT_EQ(cells_of_way(setup.way), way);
  const Mover back(setup);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(back.at(i), way[static_cast<std::size_t>(i)]);
  EXPECT_EQ(back.at(6), (Cell{4, 2}));
  EXPECT_EQ(back.at(10), (Cell{1, 1}));
  EXPECT_EQ(back.at(11), (Cell{2, 1}));
  EXPECT_TRUE(back.goes_on(5));
  setup.at_end = WayEnd::stop;
  const Mover stop(setup);
  EXPECT_EQ(stop.at(100), (Cell{4, 3}));
  EXPECT_TRUE(stop.goes_on(4));
  EXPECT_FALSE(stop.goes_on(5));
  setup.at_end = WayEnd::loop;
  const Mover loop(setup);
  EXPECT_EQ(loop.at(5), (Cell{4, 3}));
  EXPECT_EQ(loop.at(8), (Cell{1, 1}));  // 3 steps home, diagonally where it can
  EXPECT_EQ(loop.at(9), (Cell{2, 1}));
  EXPECT_EQ(Mover({.way = {{2, 2}}, .at_end = WayEnd::loop}).at(7), (Cell{2, 2}));
}

TEST(Mover, KeepsItsPaceAndWaitsForTheRobot) {
  Scenario scenario;
  scenario.map = GridMap(10, 1);
  scenario.movers = {{.way = {{0, 0}, {9, 0}}, .speed = 4, .at_end = WayEnd::stop}};
  const Crowd crowd(scenario);
  auto states = crowd.initial();
  EXPECT_TRUE(crowd.advance(states, kSecond / 4 - 1, 0, {}).empty());
  EXPECT_EQ(crowd.advance(states, kSecond / 4, 0, {}).size(), 2u);  // leaves one cell, covers another
  EXPECT_EQ(states[0].steps, 1);
  const Cell robot[] = {{4, 0}};
  (void)crowd.advance(states, 10 * kSecond, 0, robot);
  EXPECT_EQ(states[0].steps, 3) << "it stops before the robot";
  (void)crowd.advance(states, 11 * kSecond, 0, {});
  EXPECT_EQ(states[0].steps, 7) << "and goes on at its pace";
}

TEST(Mission, WaitsForAnObstacleThatFillsTheCorridorAndGoesOnWhenItHasLeft) {
  Scenario scenario = corridor(8);
  // It stands in the corridor for as long as it takes to go up and down the far room.
  scenario.movers = {{.way = {{7, 4}, {14, 4}, {14, 8}}, .speed = 1, .at_end = WayEnd::stop}};
  scenario.robot.speed = 4;
  Driven driven(scenario);
  driven.run();
  EXPECT_EQ(driven.mission.state(), MissionState::arrived);
  EXPECT_GT(driven.count(EventKind::waiting), 5);
  EXPECT_EQ(driven.mission.now().figures.collisions, 0);
}

TEST(Mission, GivesUpWhenItsPatienceIsOver) {
  Scenario scenario = corridor(8);
  scenario.movers = {{.way = {{8, 4}}}};  // it never leaves
  Driven driven(scenario);
  driven.run();
  EXPECT_EQ(driven.mission.state(), MissionState::no_path);
  // 20 seconds at 2 steps a second.
  EXPECT_EQ(driven.count(EventKind::waiting), 40);
  EXPECT_EQ(driven.count(EventKind::gave_up), 1);
}

TEST(Mission, ForgetsWhereItSawSomethingMoveOnceThatLeavesItWithoutAPath) {
  // The robot sees the box at the far end of its reach; then a wall comes between them, and the box goes on
  // unseen. What it remembers blocks the only way.
  Scenario scenario = corridor(8);
  scenario.robot.sensor_blocked = true;
  scenario.movers = {{.way = {{9, 4}, {14, 4}, {14, 1}}, .speed = 0.5, .at_end = WayEnd::stop}};
  Surprise shut, open;
  shut.at.move = 4;
  shut.cells = {{{7, 4}, true}};
  open.at.move = 30;
  open.cells = {{{7, 4}, false}};
  scenario.surprises = {shut, open};
  Driven driven(scenario);
  driven.run();
  EXPECT_GT(driven.count(EventKind::forgotten), 0);
  EXPECT_EQ(driven.mission.state(), MissionState::arrived);
}

TEST(Mission, SensesWhatMovesEvenIfItIsToldOfEveryChange) {
  Scenario scenario = corridor(8);
  scenario.robot.knowledge = Knowledge::all;
  scenario.movers = {{.way = {{14, 1}, {14, 7}}}};  // far out of sight at first
  Driven driven(scenario);
  while (!driven.mission.settled()) driven.step();
  EXPECT_TRUE(driven.state.moving(driven.mission.known().node(Cell{14, 1})));
  EXPECT_FALSE(driven.state.known_blocked(driven.mission.known().node(Cell{14, 1})));
}

TEST(Mission, TimeGoesByStepsOrByTheWay) {
  Scenario scenario;
  scenario.map = GridMap(11, 11);
  scenario.goal = {10, 10};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot.speed = 2;
  Driven steps(scenario);
  steps.run();
  EXPECT_EQ(steps.mission.now().time, 10 * kSecond / 2);
  scenario.robot.motion = Motion::smooth;
  Driven smooth(scenario);
  smooth.run();
  EXPECT_NEAR(static_cast<double>(smooth.mission.now().time), 10 * std::sqrt(2.0) / 2 * kSecond, 20);
  EXPECT_EQ(smooth.mission.now().clock, 10);
}

TEST(Mission, GoesToAGoalThatIsScriptedForLaterAfterItHasArrived) {
  Scenario scenario;
  scenario.map = GridMap(20, 5);
  scenario.start = {0, 2};
  scenario.goal = {5, 2};
  scenario.planners = {{"dld-star-lite", {}}};
  Surprise next;
  next.at.move = 12;
  next.goal = Cell{15, 2};
  scenario.surprises = {next};
  Driven driven(scenario);
  driven.run();
  EXPECT_EQ(driven.mission.state(), MissionState::arrived);
  EXPECT_EQ(driven.count(EventKind::arrival), 1);
  EXPECT_EQ(driven.mission.known().position(driven.state.node(Scalar::robot)), (Cell{15, 2}));
  EXPECT_EQ(driven.mission.now().clock, 22);
}

TEST(Mission, TakesUnmappedObstaclesForFreeUntilItSeesThem) {
  Scenario scenario = corridor(8);
  scenario.map.blocked[scenario.map.index({9, 4})] = kUnmapped;
  Driven driven(scenario);
  while (!driven.mission.settled()) driven.step();
  EXPECT_EQ(driven.mission.route().status, PlanStatus::found);
  driven.run();
  EXPECT_EQ(driven.mission.state(), MissionState::no_path);
  scenario.robot.knowledge = Knowledge::all;
  Driven knowing(scenario);
  while (!knowing.mission.settled()) knowing.step();
  EXPECT_EQ(knowing.mission.route().status, PlanStatus::no_path);
}

}  // namespace
}  // namespace replan
