// Distance transforms of whole maps, and the clearance field's local update.
#include <benchmark/benchmark.h>

#include "core/base/random.hpp"
#include "core/field/clearance.hpp"
#include "core/field/distance.hpp"

namespace replan {
namespace {

std::vector<std::uint8_t> random_cells(int side, double share) {
  Random random(1);
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (auto& cell : cells) cell = random.chance(share) ? 1 : 0;
  return cells;
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const int side : {200, 512, 2048})
    for (const int percent : {20, 1}) bench->Args({side, percent});
  bench->Unit(benchmark::kMillisecond);
}

void exact_transform(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  const auto cells = random_cells(side, static_cast<double>(state.range(1)) / 100);
  for (auto _ : state) benchmark::DoNotOptimize(squared_distances(side, side, cells));
}
BENCHMARK(exact_transform)->Apply(sizes);

/// In space, obstacles a share of a million; the counter is what the bar is in: seconds a voxel.
void exact_transform_in_space(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  Random random(1);
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                                  static_cast<std::size_t>(side));
  for (auto& cell : cells) cell = random.chance(static_cast<double>(state.range(1)) / 1e6) ? 1 : 0;
  for (auto _ : state) benchmark::DoNotOptimize(squared_distances(side, side, side, cells));
  state.counters["voxel"] =
      benchmark::Counter(static_cast<double>(cells.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(exact_transform_in_space)
    ->ArgsProduct({{256}, {200'000, 10'000, 100, 1}})
    ->Unit(benchmark::kMillisecond);

void chamfer_transform(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  const auto cells = random_cells(side, static_cast<double>(state.range(1)) / 100);
  for (auto _ : state) benchmark::DoNotOptimize(chamfer_distances(side, side, cells));
}
BENCHMARK(chamfer_transform)->Apply(sizes);

void clearance_field(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  const Grid2 lattice({side, side}, random_cells(side, static_cast<double>(state.range(1)) / 100));
  for (auto _ : state) benchmark::DoNotOptimize(ClearanceField<2>(lattice, {}));
}
BENCHMARK(clearance_field)->Apply(sizes);

/// Ten cells near each other toggle, range 2: the lattice's own update not counted.
void local_update(benchmark::State& state) {
  const int side = 512;
  Grid2 lattice({side, side}, random_cells(side, 0.2));
  ClearanceField<2> field(lattice, {});
  Random random(2);
  for (auto _ : state) {
    state.PauseTiming();
    const int x = random.between(20, side - 21), y = random.between(20, side - 21);
    std::vector<CellEdit> edits;
    for (int i = 0; i < 10; ++i) {
      const NodeId node = lattice.node(Cell{x + random.between(-10, 10), y + random.between(-10, 10)});
      edits.push_back({node, !lattice.blocked(node)});
    }
    lattice.apply(edits);
    for (CellEdit& edit : edits) edit.blocked = lattice.blocked(edit.node);
    state.ResumeTiming();
    benchmark::DoNotOptimize(field.update(lattice, edits));
  }
}
BENCHMARK(local_update)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace replan
