// Plans of every registered planner on the DLD* Lite paper's kind of world, and what recording them costs.
#include <benchmark/benchmark.h>

#include <array>

#include "core/base/random.hpp"
#include "core/plan/registry.hpp"
#include "core/trace/timeline.hpp"
#include "core/world/generators.hpp"

namespace replan {
namespace {

constexpr Cell kStart{15, 15}, kGoal{175, 175};

/// Ten worlds of random rectangles, as in ALGORITHMS of the paper's Fig. 5.
const GridMap& world(std::size_t index) {
  static const auto worlds = [] {
    std::array<GridMap, 10> maps;
    const std::array<Cell, 2> free = {kStart, kGoal};
    for (std::uint64_t seed = 1; seed <= maps.size(); ++seed)
      maps[seed - 1] = *random_rectangles(200, 200, 0.17, 5, 15, seed, free);
    return maps;
  }();
  return worlds[index];
}

template <class T>
void first_plans(benchmark::State& state, const PlannerInfo& info) {
  std::int64_t expansions = 0;
  std::array<T, 10> tracers;
  std::vector<Grid2> lattices;
  std::vector<std::unique_ptr<Planner<Grid2>>> planners;
  const Settings settings;
  lattices.reserve(10);
  for (std::size_t i = 0; i < 10; ++i) {
    lattices.emplace_back(Grid2::Coordinates{200, 200}, world(i).blocked, move_rules(settings));
    planners.push_back(make_planner(info, lattices[i], settings, tracers[i]));
  }
  for (auto _ : state)
    for (std::size_t i = 0; i < 10; ++i) {
      planners[i]->begin(lattices[i].node(kStart), lattices[i].node(kGoal));
      finish(*planners[i]);
      expansions += planners[i]->counters().expansions;
      if constexpr (T::kEnabled) tracers[i].clear();
    }
  state.counters["expansions/s"] = benchmark::Counter(static_cast<double>(expansions), benchmark::Counter::kIsRate);
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

[[maybe_unused]] const bool kRegistered = [] {
  for (const PlannerInfo& info : planners()) {
    const std::string id(info.id);
    benchmark::RegisterBenchmark(("first_plan/" + id + "/no_trace").c_str(),
                                 [&info](benchmark::State& state) { first_plans<NoTrace>(state, info); })
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("first_plan/" + id + "/recorder").c_str(),
                                 [&info](benchmark::State& state) { first_plans<Recorder>(state, info); })
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace replan
