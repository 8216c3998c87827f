// A planner in a program of one's own: a plan, a change of the map, and the repaired plan.
#include <cstdio>

#include "core/plan/registry.hpp"

int main() {
  using namespace replan;
  Grid2 map({40, 30});
  NoTrace nobody;
  const auto planner = make_planner(*find_planner("dstar-lite"), map, Settings{}, nobody);
  planner->begin(map.node(Cell{2, 15}), map.node(Cell{37, 15}));
  finish(*planner);
  const double before = planner->cost().to_double();

  std::vector<CellEdit> wall;
  for (int y = 5; y < 30; ++y) wall.push_back({map.node(Cell{20, y}), true});
  const auto moves = map.apply(wall);
  planner->update({.cells = wall, .moves = moves}, map.node(Cell{2, 15}));
  finish(*planner);
  const double after = planner->cost().to_double();
  std::printf("%.3f cells, and %.3f round the wall: %zu nodes\n", before, after, planner->path().size());
  return before == 35 && after > before ? 0 : 1;
}
