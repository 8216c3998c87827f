// What a robot's size costs: growing all obstacles of a map, and taking in a surprise beside growing them anew.
#include <benchmark/benchmark.h>

#include "core/lattice/box_lattice.hpp"
#include "core/world/generators/generators.hpp"

namespace replan {
namespace {

Grid2 field(int side, double radius) {
  const GridMap map = *random_rectangles(side, side, 0.17, 5, 60, 1, {});
  return {{side, side}, map.blocked.plain(), {.radius = radius}};
}

/// A map with the robot's radius in quarter cells; 0: without a size.
void inflate_map(benchmark::State& state) {
  const Grid2 lattice = field(static_cast<int>(state.range(0)), 0);
  const std::vector<std::uint8_t> cells(lattice.cells().begin(), lattice.cells().end());
  const double radius = static_cast<double>(state.range(1)) / 4;
  for (auto _ : state) benchmark::DoNotOptimize(Grid2(lattice.size(), cells, {.radius = radius}));
}
BENCHMARK(inflate_map)->ArgsProduct({{1024}, {0, 3, 12, 40}})->Unit(benchmark::kMillisecond);

/// A box of 3 x 3 cells that comes and goes, in the middle of the map.
void inflate_change(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  Grid2 lattice = field(side, static_cast<double>(state.range(1)) / 4);
  std::vector<CellEdit> edits;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) edits.push_back({lattice.node(Cell{side / 2 + x, side / 2 + y}), false});
  lattice.apply(edits);
  for (auto _ : state) {
    for (CellEdit& edit : edits) edit.blocked = !edit.blocked;
    benchmark::DoNotOptimize(lattice.apply(edits).size());
  }
}
BENCHMARK(inflate_change)->ArgsProduct({{1024, 4096}, {0, 3, 12, 40}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace replan
