// First plans of A* in space, in the worlds in which the peers were measured: boxes of which a fifth of the voxels,
// drawn at random, is blocked, and the ten problems of the Warframe box "Complex" that are the longest beside their
// length in an empty box. No corner is cut, as HOG2 has it. REPLAN_SHARED_DATA names the folder with the latter.
//
// HOG2's A* on such boxes of 64, 128 and 256 voxels a side takes 1.5, 13.7 and 282 ms for 2200, 16 000 and 186 000
// expansions, 0.66 to 1.4 million a second, and on Complex 1.65 ms for 2700. The random boxes and their problems are drawn
// anew here, so that only those of Complex are the same: there it expands as many, 2739, in the mean.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/base/random.hpp"
#include "core/plan/registry.hpp"
#include "core/world/formats/voxel_map.hpp"
#include "tests/bench/worlds.hpp"

namespace replan {
namespace {

struct VoxelProblem {
  Voxel start, goal;
};

/// A box and where to go in it.
struct VoxelWorld {
  GridMap map;
  std::vector<VoxelProblem> problems;
};

Voxel random_free_voxel(const GridMap& map, Random& random) {
  for (;;) {
    const Voxel voxel{random.between(0, map.width - 1), random.between(0, map.height - 1),
                      random.between(0, map.depth - 1)};
    if (!map.at(voxel)) return voxel;
  }
}

VoxelWorld random_voxels(int side) {
  VoxelWorld world{*random_cells({side, side, side}, 0.2, 1), {}};
  Random random(2);
  for (int i = 0; i < 10; ++i) {
    const Voxel start = random_free_voxel(world.map, random);
    world.problems.push_back({start, random_free_voxel(world.map, random)});
  }
  return world;
}

/// Those of the ten largest ratios; without any if the file is not there.
VoxelWorld hardest_of_complex() {
  const char* data = std::getenv("REPLAN_SHARED_DATA");
  const std::string path = std::string(data != nullptr ? data : "") + "/voxels/Complex.3dmap";
  auto map = read_voxel_map(path);
  auto scen = read_scen(path + ".3dscen");
  if (!map || !scen) return {};
  std::stable_sort(
      scen->problems.begin(), scen->problems.end(), [](const ScenProblem& a, const ScenProblem& b) {
        return std::strtod(a.printed_ratio.c_str(), nullptr) > std::strtod(b.printed_ratio.c_str(), nullptr);
      });
  VoxelWorld world{std::move(*map), {}};
  for (std::size_t i = 0; i < std::min<std::size_t>(10, scen->problems.size()); ++i)
    world.problems.push_back({scen->problems[i].start, scen->problems[i].goal});
  return world;
}

/// All problems of a world once, by A* with its usual settings.
void plan_in_space(benchmark::State& state, const VoxelWorld& world) {
  if (world.problems.empty()) return state.SkipWithError("the data are not there: set REPLAN_SHARED_DATA");
  const Voxel3 lattice(world.map.box().sides<3>(), world.map.blocked.plain(), move_rules({}));
  NoTrace nobody;
  const auto planner = make_planner(*find_planner("astar"), lattice, {}, nobody);
  std::int64_t expansions = 0;
  for (auto _ : state)
    for (const VoxelProblem& problem : world.problems) {
      planner->begin(world.map.box().node(problem.start), world.map.box().node(problem.goal));
      if (finish(*planner) != PlanStatus::found) state.SkipWithError("no path");
      benchmark::DoNotOptimize(planner->path().size());
      expansions += planner->counters().expansions;
    }
  const auto plans = static_cast<double>(state.iterations()) * static_cast<double>(world.problems.size());
  state.counters["expansions"] = static_cast<double>(expansions) / plans;
  state.counters["expansions/s"] =
      benchmark::Counter(static_cast<double>(expansions), benchmark::Counter::kIsRate);
  state.counters["time/plan"] =
      benchmark::Counter(plans, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// What comes before a first plan: the moves out of every voxel.
void make_lattice(benchmark::State& state, int side) {
  const GridMap map = random_voxels(side).map;
  const std::vector<std::uint8_t> cells = map.blocked.plain();
  for (auto _ : state) {
    const Voxel3 lattice(map.box().sides<3>(), cells, move_rules({}));
    benchmark::DoNotOptimize(lattice.node_count());
  }
}

}  // namespace

void bench::register_voxels() {
  benchmark::RegisterBenchmark("lattice_3d/vox256", [](benchmark::State& state) {
    make_lattice(state, 256);
  })->Unit(benchmark::kMillisecond);
  for (const int side : {64, 128, 256})
    benchmark::RegisterBenchmark(
        ("first_plan_3d/vox" + std::to_string(side) + "/astar").c_str(),
        [side](benchmark::State& state) { plan_in_space(state, random_voxels(side)); })
        ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("first_plan_3d/complex_hardest/astar", [](benchmark::State& state) {
    plan_in_space(state, hardest_of_complex());
  })->Unit(benchmark::kMillisecond);
}

}  // namespace replan
