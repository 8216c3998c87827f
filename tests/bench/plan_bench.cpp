// Plans of every registered planner on the DLD* Lite paper's kinds of world, what recording them costs, and
// how fast a recording is sought through.
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/base/random.hpp"
#include "core/plan/registry.hpp"
#include "core/trace/timeline.hpp"
#include "tests/bench/worlds.hpp"

namespace replan {
namespace {

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

/// Seeks to random places of a long run.
void timeline_seek(benchmark::State& state) {
  const auto events = static_cast<std::size_t>(state.range(0));
  constexpr std::uint32_t kNodes = 1u << 20;
  Timeline timeline{SearchState(kNodes)};
  Random random(1);
  std::vector<Event> batch;
  // A search touches places near each other; a walk does too.
  NodeId at = kNodes / 2;
  for (std::size_t i = 0; i < events; ++i) {
    at = (at + random.below(7) * 511 + kNodes - 1533) % kNodes;
    batch.push_back({random.next(), at, static_cast<EventKind>(random.below(kWideFields)), 0, 0});
    if (batch.size() == 100000 || i + 1 == events) {
      timeline.append(batch);
      batch.clear();
    }
  }
  for (auto _ : state) {
    timeline.seek(static_cast<std::size_t>(random.next() % events));
    benchmark::DoNotOptimize(timeline.state().g(0));
  }
  state.counters["frames"] = static_cast<double>(timeline.key_frames());
  state.counters["frame_MiB"] = static_cast<double>(timeline.frame_bytes() >> 20);
}
BENCHMARK(timeline_seek)->Arg(1000000)->Arg(10000000)->Unit(benchmark::kMicrosecond);

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
