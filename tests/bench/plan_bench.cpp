// Plans of every registered planner on the DLD* Lite paper's kinds of world, and what recording them costs.
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/plan/registry.hpp"
#include "tests/bench/worlds.hpp"

namespace replan {
namespace {

/// Plans as a run does, in slices; what was recorded is handed on, and its memory used again, when it comes
/// to a batch. Here nobody takes it.
template <class T>
PlanStatus plan_in_slices(Planner<Grid2>& planner, T& tracer) {
  constexpr std::int64_t kIterations = 2000;
  for (bool done = false; !done;) {
    done = planner.advance(kIterations);
    if constexpr (T::kEnabled) {
      constexpr std::size_t kBatchEvents = 400000;
      if (done || tracer.buffer().size() >= kBatchEvents) tracer.clear();
    }
  }
  return planner.status();
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
    lattices.emplace_back(Grid2::Coordinates{map.width, map.height}, map.blocked.plain(), move_rules(settings));
    planners.push_back(make_planner(info, lattices[i], settings, tracers[i]));
  }
  for (auto _ : state)
    for (std::size_t i = 0; i < planners.size(); ++i) {
      planners[i]->begin(lattices[i].node(worlds.start), lattices[i].node(worlds.goal));
      if (plan_in_slices(*planners[i], tracers[i]) != PlanStatus::found) state.SkipWithError("no path");
      expansions += planners[i]->counters().expansions;
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

}  // namespace

void bench::register_plans() {
  for (const Worlds& worlds : all_worlds())
    for (const PlannerInfo& info : sound_planners()) {
      register_first_plans<NoTrace>(info, worlds, "no_trace");
      register_first_plans<Recorder>(info, worlds, "recorder");
    }
}

}  // namespace replan
