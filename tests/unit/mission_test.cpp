// The mission: what moves, what the robot remembers of it, waiting, giving up, and how time goes by.
#include "core/sim/mission.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/lattice/nearest.hpp"
#include "core/plan/registry.hpp"
#include "core/trace/search_state.hpp"

namespace replan::mission_test {
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
  std::unique_ptr<Mission> made;
  Mission& mission;
  SearchState state;
  std::vector<Event> log;

  explicit Driven(const Scenario& scenario)
      : made(make_mission(scenario, scenario.planners[0], &recorder)),
        mission(*made),
        state(initial_state(scenario, scenario.planners.front())) {}

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

TEST(Mover, GoesThroughLayers) {
  const Mover lift({.way = {{2, 2, 0}, {2, 2, 3}, {4, 3, 3}}, .width = 2, .depth = 2});
  EXPECT_EQ(lift.at(3), (Cell{2, 2, 3}));
  EXPECT_EQ(lift.at(5), (Cell{4, 3, 3}));
  EXPECT_TRUE(lift.covers({2, 2, 1}, {3, 2, 2}));
  EXPECT_FALSE(lift.covers({2, 2, 1}, {3, 2, 3}) || lift.covers({2, 2, 1}, {3, 2, 0}));
  std::vector<Cell> covered;
  lift.each_cell({2, 2, 3}, Box(3, 4, 4), [&](Cell cell) { covered.push_back(cell); });
  EXPECT_EQ(covered, (std::vector<Cell>{{2, 2, 3}})) << "what lies outside the world is not there";
  const Cell above[] = {{3, 2, 3}}, beside[] = {{4, 2, 3}};
  EXPECT_EQ(lift.open_steps(0, 9, above), 1)
      << "with two layers it would come onto the cell at its second step";
  EXPECT_EQ(lift.open_steps(0, 3, beside), 3);
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
  EXPECT_TRUE(driven.state.moving(scenario.map.box().node(Cell{14, 1})));
  EXPECT_FALSE(driven.state.known_blocked(scenario.map.box().node(Cell{14, 1})));
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
  EXPECT_EQ(scenario.map.box().position(driven.state.node(Scalar::robot)), (Cell{15, 2}));
  EXPECT_EQ(driven.mission.now().clock, 22);
}

TEST(Mission, TakesUnmappedObstaclesForFreeUntilItSeesThem) {
  Scenario scenario = corridor(8);
  scenario.map.blocked[scenario.map.index({9, 4})] = kUnmapped;
  Driven driven(scenario);
  while (!driven.mission.settled()) driven.step();
  EXPECT_EQ(driven.mission.plan().status, PlanStatus::found);
  driven.run();
  EXPECT_EQ(driven.mission.state(), MissionState::no_path);
  scenario.robot.knowledge = Knowledge::all;
  Driven knowing(scenario);
  while (!knowing.mission.settled()) knowing.step();
  EXPECT_EQ(knowing.mission.plan().status, PlanStatus::no_path);
}

TEST(Mission, KeepsThePathOnceForAllPlansThatHaveIt) {
  Scenario scenario = corridor(8);
  scenario.robot.knowledge = Knowledge::all;
  const Cell corner = {0, 0};  // where the change makes no difference to the path
  for (const bool blocked : {true, false}) {
    Surprise& away = scenario.surprises.emplace_back();
    away.at.move = 0;
    away.cells = {{corner, blocked}};
  }
  Driven driven(scenario);
  while (!driven.mission.standing()) driven.step();
  const Decision first = driven.mission.now();
  while (!driven.mission.settled()) driven.step();
  const Decision third = driven.mission.now();
  ASSERT_EQ(third.figures.replans, 2);
  EXPECT_EQ(third.plan->path.get(), first.plan->path.get());
  EXPECT_NE(third.plan.get(), first.plan.get()) << "figures of a plan are told apart by it";
  driven.step();
  EXPECT_EQ(driven.mission.now().before, first.at);
  EXPECT_EQ(driven.mission.now().at, first.after);
}

TEST(Route, IsRightInAWorldThatIsVeryWide) {
  const Grid2 lattice({60'000, 40});
  const NodeId from = lattice.node(Cell{0, 0}), to = lattice.node(Cell{59'999, 39});
  const Route route = lay_out(lattice.box(), lattice.cells(), Path(lattice.box(), {from, to}));
  EXPECT_TRUE(std::is_sorted(route.along.begin(), route.along.end()));
  EXPECT_NEAR(route.along.back(), distance(Cell{0, 0}, Cell{59'999, 39}), 1e-6);
  for (const Point& point : route.points) ASSERT_TRUE(point.x > 0 && point.x < 60'000) << point.x;
}

/// Also in a cell that a segment passes at its corner, where it is nearest to the centre before or behind it.
TEST(Route, HasThePointOfEachCellInIt) {
  const Grid2 lattice({30, 20});
  Random random(4);
  int cells = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<Point> points;
    for (int n = 0; n < 5; ++n)
      points.push_back({random.between(1, 1919) / 64.0, random.between(1, 1279) / 64.0, 0.5});
    const Route route = lay_out(lattice.box(), lattice.cells(), Path(points));
    EXPECT_TRUE(std::is_sorted(route.along.begin(), route.along.end()));
    for (std::size_t k = 0; k < route.cells.size(); ++k, ++cells) {
      const Cell cell = lattice.position(route.cells[k]);
      const Point& at = route.points[k];
      ASSERT_TRUE(at.x > cell.x - 1e-9 && at.x < cell.x + 1 + 1e-9) << at.x << " in column " << cell.x;
      ASSERT_TRUE(at.y > cell.y - 1e-9 && at.y < cell.y + 1 + 1e-9) << at.y << " in row " << cell.y;
    }
  }
  EXPECT_GT(cells, 10'000);
}

TEST(Senses, DoNotReachToTheOtherEndOfAWorldThatIsVeryWide) {
  const std::vector<std::uint8_t> known(60'000), truth(60'000);
  const RobotSetup setup{.sensor_radius = 6};
  const Senses senses(Box(60'000, 1), known, truth, setup, 0);
  EXPECT_TRUE(senses.in_sight(6));
  for (const NodeId node : {7u, 46'340u, 46'341u, 59'999u}) EXPECT_FALSE(senses.in_sight(node)) << node;
}

TEST(Mover, IsToldAtMostTwiceItsCellsHoweverFastItIs) {
  Scenario scenario = corridor(8);
  scenario.robot.speed = kMinSpeed;  // a step takes 100 s
  scenario.robot.patience = 0;
  for (std::size_t i = 0; i < kMaxMovers; ++i)
    scenario.movers.push_back({.way = {{9, static_cast<int>(i % 3)}, {17, 0}, {12, 2}},
                               .width = 2,
                               .height = 2,
                               .speed = kMaxSpeed});
  Driven driven(scenario);
  driven.run();
  EXPECT_EQ(driven.count(EventKind::move), 13);
  EXPECT_GT(driven.mission.now().movers[0].steps, 1'000'000) << "it did move all the while";
  EXPECT_LE(driven.count(EventKind::truth), 13 * static_cast<int>(kMaxMovers) * 2 * 4);
}

TEST(Mission, EndsEvenIfItsScriptIsForAStepThatNoneLivesToSee) {
  Scenario scenario = corridor(8);
  for (int y = 0; y < 9; ++y) scenario.map.set({5, y}, true);
  scenario.movers = {{.way = {{14, 1}, {14, 7}}}};
  Surprise late;
  late.at.move = 1'000'000'000'000;
  late.cells = {{{5, 4}, false}};
  scenario.surprises = {late};
  const auto waiting = make_mission(scenario, scenario.planners[0]);
  while (waiting->advance(1 << 20)) {
  }
  EXPECT_EQ(waiting->state(), MissionState::endless);
  EXPECT_GE(waiting->now().clock, kMostWaits);
  // With nothing that moves it can wait for it at once, even at a pace at which time has no number for it.
  scenario.movers.clear();
  scenario.robot.speed = kMinSpeed;
  Driven patient(scenario);
  patient.run();
  EXPECT_EQ(patient.mission.state(), MissionState::arrived);
  EXPECT_GT(patient.mission.now().time, 0);
}

/// An open field that the robot crosses from left to right.
Scenario field() {
  Scenario scenario;
  scenario.map = GridMap(7, 3);
  scenario.start = {0, 1};
  scenario.goal = {6, 1};
  scenario.planners = {{"dstar-lite", {}}};
  return scenario;
}
Surprise wall_at(std::int64_t move, std::vector<Cell> cells, bool announced = false) {
  Surprise surprise;
  surprise.at.move = move;
  surprise.announced = announced;
  for (const Cell cell : cells) surprise.cells.push_back({cell, true});
  return surprise;
}

TEST(Mission, DrivesOutOfAnObstacleThatComesOntoItsCell) {
  for (const PlannerInfo& info : sound_planners())
    for (const bool announced : {false, true})
      for (const Knowledge knowledge : {Knowledge::all, Knowledge::map, Knowledge::nothing}) {
        Scenario scenario = field();
        scenario.planners = {{std::string(info.id), {}}};
        scenario.robot.knowledge = knowledge;
        scenario.surprises = {wall_at(2, {{2, 1}}, announced)};
        Driven driven(scenario);
        driven.run();
        EXPECT_EQ(driven.mission.state(), MissionState::arrived) << info.id;
        // A path of samples may lead through a cell more.
        EXPECT_LE(driven.count(EventKind::move), info.can_miss() ? 9 : 7) << info.id;
        const NodeId cell = scenario.map.box().node(Cell{2, 1});
        EXPECT_TRUE(driven.state.known_blocked(cell)) << info.id << ": when it has left it knows of it";
        scenario.robot.robot_cell_blocks = true;
        Driven held(scenario);
        held.run();
        EXPECT_EQ(held.mission.state(), MissionState::no_path) << info.id;
        EXPECT_EQ(held.mission.plan().status, PlanStatus::start_blocked) << info.id;
        EXPECT_EQ(held.count(EventKind::move), 2) << info.id;
      }
}

TEST(Mission, DoesNotDriveOutThroughAnotherObstacle) {
  Scenario scenario = field();
  scenario.surprises = {wall_at(2, {{1, 0}, {2, 0}, {3, 0}, {1, 1}, {2, 1}, {3, 1}, {1, 2}, {2, 2}, {3, 2}})};
  Driven walled_in(scenario);
  walled_in.run();
  EXPECT_EQ(walled_in.mission.state(), MissionState::no_path);
  EXPECT_EQ(walled_in.mission.plan().status, PlanStatus::no_path);
  EXPECT_TRUE(walled_in.mission.covered());
  // Only a corner is open, past which the corner rule does not let it.
  scenario.surprises = {wall_at(2, {{1, 0}, {2, 0}, {1, 1}, {2, 1}, {3, 1}, {1, 2}, {2, 2}, {3, 2}})};
  Driven at_a_corner(scenario);
  at_a_corner.run();
  EXPECT_EQ(at_a_corner.mission.state(), MissionState::no_path);
  ASSERT_TRUE(
      set_from_text(scenario.planners[0].settings, find_planner("dstar-lite")->parameters, "corners", "any")
          .ok());
  Driven past_it(scenario);
  past_it.run();
  EXPECT_EQ(past_it.mission.state(), MissionState::arrived);
}

TEST(Mission, StaysInAWallThatItStartsInOrIsPutInto) {
  for (const Knowledge knowledge : {Knowledge::all, Knowledge::map, Knowledge::nothing})
    for (const std::uint8_t kind : {kObstacle, kUnmapped}) {
      Scenario scenario = field();
      scenario.robot.knowledge = knowledge;
      scenario.map.blocked[scenario.map.index({0, 1})] = kind;
      Driven started(scenario);
      started.run();
      EXPECT_EQ(started.mission.state(), MissionState::no_path);
      EXPECT_EQ(started.mission.plan().status, PlanStatus::start_blocked);
      scenario = field();
      scenario.robot.knowledge = knowledge;
      scenario.map.blocked[scenario.map.index({4, 0})] = kind;
      Surprise put;
      put.at.move = 2;
      put.robot = Cell{4, 0};
      scenario.surprises = {put};
      Driven was_put(scenario);
      was_put.run();
      EXPECT_EQ(was_put.mission.state(), MissionState::no_path);
      EXPECT_EQ(was_put.mission.plan().status, PlanStatus::start_blocked);
      put.at.move = 3;
      put.robot = Cell{1, 1};
      scenario.surprises.push_back(put);
      Driven put_out(scenario);
      put_out.run();
      EXPECT_EQ(put_out.mission.state(), MissionState::arrived);
    }
}

TEST(Mission, GoesToTheNearestCellAndOnToTheGoalOnceTheMapOpens) {
  for (const PlannerInfo& info : sound_planners()) {
    Scenario scenario = corridor(8);
    scenario.planners = {{std::string(info.id), {}}};
    for (int y = 0; y < 9; ++y) scenario.map.set({13, y}, true);  // the corridor is shut at its far end
    scenario.robot.unreachable_goal = UnreachableGoal::nearest;
    Driven shut(scenario);
    while (!shut.mission.settled()) shut.step();
    EXPECT_EQ(shut.mission.plan().status, PlanStatus::found_nearest) << info.id;
    EXPECT_EQ(shut.state.wanted_goal(), scenario.map.box().node(scenario.goal));
    shut.run();
    EXPECT_EQ(shut.mission.state(), MissionState::nearest) << info.id;
    EXPECT_EQ(scenario.map.box().position(shut.state.node(Scalar::robot)), (Cell{12, 4})) << info.id;
    EXPECT_EQ(shut.count(EventKind::gave_up), 1);
    Surprise open;
    open.at.move = 30;
    open.cells = {{{13, 4}, false}};
    scenario.surprises = {open};
    Driven opened(scenario);
    opened.run();
    EXPECT_EQ(opened.mission.state(), MissionState::arrived) << info.id;
    EXPECT_EQ(opened.mission.now().figures.collisions, 0);
    EXPECT_EQ(opened.count(EventKind::aim), 2) << info.id << ": to the nearest cell, and to the goal again";
    EXPECT_EQ(opened.state.node(Scalar::goal), opened.state.wanted_goal());
    scenario.robot.unreachable_goal = UnreachableGoal::wait;
    Driven waits(scenario);
    waits.run();
    EXPECT_EQ(waits.count(EventKind::aim), 0);
    EXPECT_EQ(waits.state.scalar(Scalar::wanted), 0u) << "its log is what it was";
  }
}

TEST(Nearest, PrefersTheShorterWayAndThenTheSmallerIndex) {
  // The goal stands in the middle of a block; the cells around that are nearest to it are equally far.
  Grid2 map({9, 9});
  std::vector<CellEdit> block;
  for (int y = 3; y <= 5; ++y)
    for (int x = 3; x <= 5; ++x) block.push_back({map.node(Cell{x, y}), true});
  map.apply(block);
  const NodeId goal = map.node(Cell{4, 4});
  const auto from = [&](Cell robot) { return map.position(nearest_reachable(map, map.node(robot), goal)); };
  EXPECT_EQ(from({0, 4}), (Cell{2, 4}));
  EXPECT_EQ(from({8, 4}), (Cell{6, 4}));
  EXPECT_EQ(from({4, 8}), (Cell{4, 6}));
  EXPECT_EQ(from({8, 8}), (Cell{6, 4})) << "(4, 6) is as near and as far: the smaller index";
  EXPECT_EQ(from({4, 4}), (Cell{4, 4})) << "in an obstacle it stays where it is";
  EXPECT_EQ(map.position(nearest_reachable(map, map.node(Cell{0, 0}), map.node(Cell{8, 8}))), (Cell{8, 8}));
}

}  // namespace
}  // namespace replan::mission_test
