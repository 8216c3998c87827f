// A mission in a program of one's own: a generated world, driven through with surprises unknown to the robot.
#include <cstdio>

#include "core/sim/mission.hpp"
#include "core/world/generators/generators.hpp"
#include "core/world/map_file.hpp"

int main() {
  using namespace replan;
  const Cell ends[] = {{2, 2}, {57, 37}};
  auto map = random_rectangles(60, 40, 0.2, 3, 8, 1, ends);
  if (!map) {
    std::printf("%s\n", map.error().c_str());
    return 1;
  }
  Scenario scenario;
  scenario.map = *map;
  scenario.start = ends[0];
  scenario.goal = ends[1];
  scenario.planners = {{"dstar-lite", {}}};
  const auto mission = make_mission(scenario, scenario.planners[0], nullptr);  // nobody records it
  while (mission->advance(1000)) {
  }
  std::printf("%s\n", mission_state_name(mission->state()));
  // Whatever packages the readers need are linked too.
  if (read_map("no_such_map.yaml") || read_map("no_such_map.jpg")) return 1;
  return mission->state() == MissionState::arrived ? 0 : 1;
}
