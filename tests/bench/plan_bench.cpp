// Plans of every registered planner on the DLD* Lite paper's kinds of world, and what recording them costs.
#include <array>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/plan/registry.hpp"
#include "core/world/generators.hpp"

namespace replan {
namespace {

/// Some worlds of one kind, and where to go in them.
struct Worlds {
  std::string name;
  Cell start, goal;
  std::vector<GridMap> maps;
};

/// The DLD* Lite paper's kind (ten maps of random rectangles, Fig. 5), and its narrow mazes (Fig. 7), where
/// it names the sight checks an open problem.
const std::vector<Worlds>& all_worlds() {
  static const auto worlds = [] {
    Worlds rectangles{"rectangles", {15, 15}, {175, 175}, {}};
    const std::array<Cell, 2> free = {rectangles.start, rectangles.goal};
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
      rectangles.maps.push_back(*random_rectangles(200, 200, 0.17, 5, 15, seed, free));
    Worlds narrow{
        "maze_1", {1, 1}, {499, 499}, {*maze(501, 501, {.corridor = 1, .braid = 0, .loops = 0.1}, 1)}};
    Worlds wide{
        "maze_7", {4, 4}, {493, 493}, {*maze(497, 497, {.corridor = 7, .braid = 0, .loops = 0.1}, 1)}};
    return std::vector<Worlds>{rectangles, narrow, wide};
  }();
  return worlds;
}

template <class T>
void first_plans(benchmark::State& state, const PlannerInfo& info, const Worlds& worlds) {
  std::int64_t expansions = 0;
  std::vector<T> tracers(worlds.maps.size());
  std::vector<Grid2> lattices;
  std::vector<std::unique_ptr<Planner<Grid2>>> planners;
  const Settings settings;
  lattices.reserve(worlds.maps.size());
  for (std::size_t i = 0; i < worlds.maps.size(); ++i) {
    const GridMap& map = worlds.maps[i];
    lattices.emplace_back(Grid2::Coordinates{map.width, map.height}, map.blocked, move_rules(settings));
    planners.push_back(make_planner(info, lattices[i], settings, tracers[i]));
  }
  for (auto _ : state)
    for (std::size_t i = 0; i < planners.size(); ++i) {
      planners[i]->begin(lattices[i].node(worlds.start), lattices[i].node(worlds.goal));
      if (finish(*planners[i]) != PlanStatus::found) state.SkipWithError("no path");
      expansions += planners[i]->counters().expansions;
      if constexpr (T::kEnabled) tracers[i].clear();
    }
  state.counters["expansions"] =
      benchmark::Counter(static_cast<double>(expansions), benchmark::Counter::kAvgIterations);
  state.counters["expansions/s"] =
      benchmark::Counter(static_cast<double>(expansions), benchmark::Counter::kIsRate);
}

template <class T>
void register_first_plans(const PlannerInfo& info, const Worlds& worlds, const char* tracer) {
  const std::string name = "first_plan/" + worlds.name + "/" + std::string(info.id) + "/" + tracer;
  benchmark::RegisterBenchmark(name.c_str(), [&info, &worlds](benchmark::State& state) {
    first_plans<T>(state, info, worlds);
  })->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const Worlds& worlds : all_worlds())
    for (const PlannerInfo& info : planners()) {
      register_first_plans<NoTrace>(info, worlds, "no_trace");
      register_first_plans<Recorder>(info, worlds, "recorder");
    }
  return true;
}();

}  // namespace
}  // namespace replan
