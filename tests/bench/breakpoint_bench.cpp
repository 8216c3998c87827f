// How fast conditions are looked for along a log: events per second, for each kind of condition. None of them
// holds anywhere, so that the whole log is gone over.
#include <benchmark/benchmark.h>

#include "core/debug/probe.hpp"
#include "core/sim/mission.hpp"

namespace replan {
namespace {

/// A first plan of DLD* Lite through a large world, and the replans on the way.
struct LongLog {
  static constexpr int kSide = 700;
  Scenario scenario;
  PlannerChoice choice{"dld-star-lite", {}};
  Box lattice{kSide, kSide};
  Timeline log;

  LongLog() {
    scenario.map = GridMap(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) scenario.map.set({x, y}, (x * 37 + y * 91 + x * y) % 23 < 3);
    scenario.start = {1, 1};
    scenario.goal = {kSide - 2, kSide - 2};
    scenario.map.set(scenario.start, false);
    scenario.map.set(scenario.goal, false);
    scenario.robot.knowledge = Knowledge::map;
    log = Timeline(initial_state(scenario, choice));
    Recorder recorder;
    const auto mission = make_mission(scenario, choice, &recorder);
    while (mission->advance(20000)) log.append(recorder.take());
    log.append(recorder.take());
  }
  [[nodiscard]] LogView view() const { return {log, lattice, *find_planner(choice.id), choice.settings}; }
};

const LongLog& long_log() {
  static const LongLog log;
  return log;
}

void breakpoint_scan(benchmark::State& state, const char* text, int direction) {
  const LongLog& run = long_log();
  const auto condition = parse_condition(text, {run.scenario.map.width, run.scenario.map.height});
  if (!condition) return state.SkipWithError(condition.error().c_str());
  const std::size_t size = run.log.size();
  for (auto _ : state) {
    Probe probe(run.view(), *condition, direction > 0 ? 0 : size);
    benchmark::DoNotOptimize(direction > 0 ? probe.forwards(size) : probe.backwards(0));
    if (probe.position() != (direction > 0 ? size : 0)) return state.SkipWithError("it stopped");
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(size));
  state.counters["events"] = static_cast<double>(size);
}

#define REPLAN_SCAN(NAME, TEXT)                                                     \
  BENCHMARK_CAPTURE(breakpoint_scan, NAME, TEXT, 1)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(breakpoint_scan, NAME##_backwards, TEXT, -1)->Unit(benchmark::kMillisecond)

REPLAN_SCAN(value, "g(350, 350) < 1");
REPLAN_SCAN(taken, "taken(0, 0) && km > 1e6");
REPLAN_SCAN(change, "changed(rhs(350, 350)) && km > 1e6");
REPLAN_SCAN(line, "line(250)");
REPLAN_SCAN(happening, "event(blocked) || event(arrival) && moves < 2");
REPLAN_SCAN(open_list, "km > 1e6 && size(U) >= 100");
REPLAN_SCAN(open_list_size, "size(U) > 1e9");
REPLAN_SCAN(expansions, "expansions > 1e9");
REPLAN_SCAN(underconsistent, "event(underconsistent) && km > 1e6");
REPLAN_SCAN(several,
            "g(12, 40) < -1 || rhs(80, 90) < -1 || lp(300, 20) == (0, 0) || km > 1e6 && size(U) > 1e9");

#undef REPLAN_SCAN

}  // namespace
}  // namespace replan
