// What it costs to find the reachable cell nearest to a goal that cannot be reached, and to see that it can.
#include <benchmark/benchmark.h>

#include "core/base/random.hpp"
#include "core/lattice/nearest.hpp"

namespace replan {
namespace {

/// A field with a tenth of its cells blocked, and the goal in a far corner walled in or not.
void nearest(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  const bool shut = state.range(1) != 0;
  Random random(1);
  Grid2 map({side, side});
  std::vector<CellEdit> edits;
  const NodeId goal = map.node(Cell{side - 3, side - 3});
  for (NodeId node = 1; node < map.node_count(); ++node)
    if (map.squared_distance(node, goal) > 8 && random.chance(0.1)) edits.push_back({node, true});
  for (NodeId node = 0; shut && node < map.node_count(); ++node)
    if (const auto squared = map.squared_distance(node, goal); squared >= 1 && squared <= 2)
      edits.push_back({node, true});
  map.apply(edits);
  for (auto _ : state) benchmark::DoNotOptimize(nearest_reachable(map, 0, goal));
}
BENCHMARK(nearest)->ArgsProduct({{200, 1000, 4000}, {0, 1}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace replan
