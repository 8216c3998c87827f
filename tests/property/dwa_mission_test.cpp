// Robots that drive by the dynamic window approach through worlds of which they know a part: with obstacles that nobody has
// mapped and others that move slower than they. No robot touches anything, on its exact way, and nearly all arrive.
#include <cmath>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "core/study/run_report.hpp"
#include "core/world/brush.hpp"
#include "tests/support/missions.hpp"

namespace replan::test::dwa_mission_test {
namespace {

void add_boxes(Random& random, GridMap& map, int count, std::uint8_t what) {
  for (int i = 0; i < count; ++i) {
    const Cell low = random_cell(random, map);
    for (const CellChange& change : random_box(random, map, low, 3))
      map.blocked[map.index(change.cell)] = what;
  }
}

/// A hall of boxes, a few of them on no map, and something that goes to and fro at most at half of the robot's speed.
Scenario random_hall(Random& random) {
  Scenario scenario;
  scenario.map = GridMap(random.between(12, 30), random.between(10, 24));
  scenario.map.resolution = random.chance(0.5) ? 1 : 0.5;
  add_boxes(random, scenario.map, random.between(2, 10), kObstacle);
  add_boxes(random, scenario.map, random.between(0, 4), kUnmapped);
  scenario.start = {1, 1};
  scenario.goal = {scenario.map.width - 2, scenario.map.height - 2};
  for (const Cell end : {scenario.start, scenario.goal})
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) scenario.map.set({end.x + x, end.y + y}, false);
  for (int i = random.between(0, 2); i > 0; --i) {
    MovingObstacle mover = random_mover(random, scenario.map);
    mover.at_end = WayEnd::back;
    mover.from = 0;  // what appears does not look whether somebody comes
    mover.way.front() = {scenario.map.width / 2, scenario.map.height / 2};
    mover.speed = 0.25 * random.unit() / scenario.map.resolution + 0.01;
    scenario.movers.push_back(mover);
  }
  scenario.robot.kind = "dwa";
  scenario.robot.radius = random.chance(0.2) ? 0 : 0.45 * random.unit();
  scenario.robot.sensor_radius = 5;
  if (random.chance(0.5)) scenario.robot.settings.set("w_max", 0.25 + random.unit());
  scenario.planners = {{.id = random.chance(0.5) ? "dstar-lite" : "astar", .settings = {}}};
  if (random.chance(0.3)) scenario.planners[0].stages = {{"bspline", {}}};
  return scenario;
}

/// How near the disc's centre is to what stands in the world, in cells.
double gap(const Box& box, const SearchState& state, const Point& at, int reach) {
  double least = reach;
  box.each_cell_around(cell_of(at), reach, [&](NodeId node) {
    if (!state.truly_blocked(node)) return;
    const Cell cell = box.position(node);
    const double x = std::max({cell.x - at.x, at.x - cell.x - 1, 0.0}),
                 y = std::max({cell.y - at.y, at.y - cell.y - 1, 0.0});
    least = std::min(least, std::hypot(x, y));
  });
  return least;
}

/// Drives it and looks at every hundredth of each step; what went wrong, or nothing.
std::string touches(const Scenario& scenario, MissionState& ending) {
  Recorder recorder;
  const auto mission = make_mission(scenario, scenario.planners[0], &recorder);
  SearchState state = initial_state(scenario, scenario.planners[0]);
  const double side = scenario.map.resolution;
  bool more = true;
  while (more) {
    const Drive before = mission->now().drive;
    const std::int64_t moves = mission->now().figures.moves;
    more = mission->advance(1 << 20);
    const Drive& after = mission->now().drive;
    if (before.begun && mission->now().figures.moves > moves)
      for (int i = 0; i <= 100; ++i) {
        const double period = drive_settings(scenario.robot.settings).period;
        const Spot at = Arc(before.state.pose, after.state.motion).spot(period * i / 100);
        const double edge =
            gap(scenario.map.box(), state, {at.x / side, at.y / side, 0.5}, 2) - scenario.robot.radius;
        if (edge < -1e-9) return "the robot touches something by " + std::to_string(-edge) + " cells";
      }
    for (const Event& event : recorder.take()) state.apply(event);
    if (more && mission->standing() && mission->now().clock > 20'000) return "the mission does not end";
  }
  ending = mission->state();
  return mission->now().figures.collisions == 0 ? "" : "a collision was counted";
}

void drive_through(std::uint64_t count) {
  std::map<MissionState, int> endings;
  int driven = 0;
  for (std::uint64_t seed = 0; static_cast<std::uint64_t>(driven) < count; ++seed) {
    Random random(seed);
    const Scenario scenario = random_hall(random);
    const RunReport known =
        plan_once(scenario.map, scenario.start, scenario.goal, scenario.planners[0], scenario.robot);
    if (!known.succeeded()) continue;
    ++driven;
    MissionState ending = MissionState::planning;
    ASSERT_EQ(touches(scenario, ending), "") << "seed " << seed << "\n" << scenario_text(scenario);
    ++endings[ending];
    if (ending != MissionState::arrived)
      std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), mission_state_name(ending));
  }
  std::printf("%d of %d arrived\n", endings[MissionState::arrived], driven);
  EXPECT_GE(endings[MissionState::arrived], 0.95 * driven);
}

/// Nobody plans, so that few arrive; but each drive ends, and none at an obstacle.
TEST(DwaMissions, OfTheWindowAloneTouchNothingAndEnd) {
  std::map<MissionState, int> endings;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Random random(seed);
    Scenario scenario = random_hall(random);
    scenario.robot.kind = "cells";
    scenario.planners = {{.id = "dwa", .settings = scenario.robot.settings}};
    scenario.robot.settings = {};
    MissionState ending = MissionState::planning;
    ASSERT_EQ(touches(scenario, ending), "") << "seed " << seed << "\n" << scenario_text(scenario);
    ++endings[ending];
  }
  std::printf("%d arrived, %d stuck of 150\n", endings[MissionState::arrived], endings[MissionState::stuck]);
  EXPECT_EQ(endings[MissionState::arrived] + endings[MissionState::stuck] + endings[MissionState::no_path],
            150);
  EXPECT_GT(endings[MissionState::arrived], 30);
  EXPECT_GT(endings[MissionState::stuck], 10);
}

TEST(DwaMissions, TouchNothingAndArrive) {
  drive_through(250);
}

/// Left to the longer run by its name.
TEST(DwaMissions, TouchNothingInAHugeWorldOfFiveThousandHalls) {
  drive_through(5000);
}

}  // namespace
}  // namespace replan::test::dwa_mission_test
