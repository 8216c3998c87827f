// Missions drawn from a seed: what tests of the simulator and of the debugger run on.
#pragma once

#include <cmath>
#include <string>

#include "core/sim/mission.hpp"
#include "core/world/scenario.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test {

inline Cell random_cell(Random& random, const GridMap& map) {
  const Cell cell{random.between(0, map.width - 1), random.between(0, map.height - 1)};
  return map.depth == 1 ? cell : Cell{cell.x, cell.y, random.between(0, map.depth - 1)};
}

/// The cells of a box that begins at `low` and reaches at most so far along each axis, as obstacles that come.
inline std::vector<CellChange> random_box(Random& random, const GridMap& map, Cell low, int reach) {
  const int right = std::min(map.width - 1, low.x + random.between(0, reach)),
            bottom = std::min(map.height - 1, low.y + random.between(0, reach)),
            top = map.depth == 1 ? 0 : std::min(map.depth - 1, low.z + random.between(0, reach));
  std::vector<CellChange> cells;
  for (int z = low.z; z <= top; ++z)
    for (int y = low.y; y <= bottom; ++y)
      for (int x = low.x; x <= right; ++x) cells.push_back({{x, y, z}, true});
  return cells;
}

inline Surprise random_surprise(Random& random, const GridMap& map) {
  Surprise surprise;
  if (random.chance(0.7)) {
    surprise.at.move = random.between(0, 30);
  } else {
    surprise.at.near = random_cell(random, map);
    surprise.at.within = 6 * random.unit();
  }
  surprise.announced = random.chance(0.3);
  if (random.chance(0.1)) surprise.goal = random_cell(random, map);
  if (random.chance(0.1)) surprise.robot = random_cell(random, map);
  const Cell low = random_cell(random, map);
  surprise.cells = random_box(random, map, low, 4);
  if (!random.chance(0.6))
    for (CellChange& change : surprise.cells) change.blocked = false;
  return surprise;
}

/// Walls that shoot up where the robot is, or close to it.
inline Surprise random_wall_on_the_robot(Random& random, const GridMap& map) {
  Surprise surprise;
  surprise.at.near = random_cell(random, map);
  surprise.at.within = random.between(0, 2);
  surprise.announced = random.chance(0.5);
  surprise.cells = random_box(random, map, *surprise.at.near, 1);
  return surprise;
}

inline MovingObstacle random_mover(Random& random, const GridMap& map) {
  constexpr double kSpeeds[] = {0.3, 1, 2, 4, 11};
  MovingObstacle mover;
  for (int corners = random.between(1, 4); corners > 0; --corners)
    mover.way.push_back(random_cell(random, map));
  mover.width = random.between(1, 3);
  mover.height = random.between(1, 3);
  if (map.depth > 1) mover.depth = random.between(1, 3);
  mover.speed = kSpeeds[random.below(5)];
  mover.at_end = static_cast<WayEnd>(random.below(3));
  if (random.chance(0.3)) mover.from = random.between(0, 20);
  return mover;
}

/// A planner, a robot, surprises and moving obstacles in a world that has its cells; all kinds of settings.
inline void furnish(Random& random, const PlannerInfo& info, Scenario& scenario) {
  constexpr double kRadii[] = {0, 1, 1.5, 2, 3, 4.5, 6, 10, 40};
  constexpr double kSpeeds[] = {0.5, 2, 4, 20};
  for (std::size_t cell = 0; cell < scenario.map.blocked.size(); ++cell)
    if (scenario.map.blocked[cell] != 0 && random.chance(0.1)) scenario.map.blocked[cell] = kUnmapped;
  scenario.start = random_cell(random, scenario.map);
  scenario.goal = random_cell(random, scenario.map);
  if (random.chance(0.9)) {
    scenario.map.set(scenario.start, false);
    scenario.map.set(scenario.goal, false);
  }
  scenario.robot = {.knowledge = static_cast<Knowledge>(random.below(3)),
                    .sensor_radius = kRadii[random.below(9)],
                    .sensor_blocked = random.chance(0.5),
                    .motion = static_cast<Motion>(random.below(2)),
                    .speed = kSpeeds[random.below(4)],
                    .patience = random.chance(0.5) ? 10.0 : 40.0};
  for (int n = random.between(0, 4); n > 0; --n)
    scenario.surprises.push_back(random_surprise(random, scenario.map));
  for (int n = random.between(0, 4); n > 0; --n)
    scenario.movers.push_back(random_mover(random, scenario.map));
  scenario.planners = {{std::string(info.id), random_settings(random, info)}};
  for (int n = random.between(0, 3); n > 0; --n)
    scenario.surprises.push_back(random_wall_on_the_robot(random, scenario.map));
  if (random.chance(0.4)) scenario.robot.unreachable_goal = UnreachableGoal::nearest;
  scenario.robot.robot_cell_blocks = random.chance(0.2);
}

/// Gives the robot a size; half of the radii are such that squares are exactly so far away, or nearly. Not where a planner
/// is for a robot without one.
inline void give_size(Random& random, Scenario& scenario) {
  for (const PlannerChoice& choice : scenario.planners)
    if (!find_planner(choice.id)->point_only.empty()) return;
  const double exact = std::sqrt(random.between(1, 18)) / 2;
  constexpr double kBeside[] = {0, 1, 2};
  scenario.robot.radius = random.chance(0.5) ? 0.1 + 2.4 * random.unit()
                                             : std::nextafter(exact, kBeside[random.below(3)] * exact);
}

/// A small furnished world.
inline Scenario random_scenario(Random& random, const PlannerInfo& info,
                                Grid2::Coordinates largest = {20, 16}) {
  Scenario scenario;
  const auto size = random_size<2>(random, {4, 3}, largest);
  scenario.map = GridMap(size[0], size[1]);
  scenario.map.blocked = random_cells<2>(random, size);
  furnish(random, info, scenario);
  return scenario;
}

/// A small furnished box of voxels, of more than one layer.
inline Scenario random_voxel_scenario(Random& random, const PlannerInfo& info,
                                      Voxel3::Coordinates largest = {9, 8, 6}) {
  Scenario scenario;
  const auto size = random_size<3>(random, {3, 3, 2}, largest);
  scenario.map = GridMap(size[0], size[1], size[2]);
  scenario.map.blocked = random_cells<3>(random, size);
  furnish(random, info, scenario);
  return scenario;
}

}  // namespace replan::test
