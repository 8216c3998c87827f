// What it costs to hold a planner to its laws: a recorded mission with a surprise, alone and with every step
// of its log checked.
#include <ctime>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/debug/law_checker.hpp"
#include "core/sim/mission.hpp"
#include "core/trace/timeline.hpp"
#include "tests/bench/worlds.hpp"

namespace replan {
namespace {

/// The first of these worlds, and a block that appears half way across it and is gone again later.
Scenario with_surprise(const Worlds& worlds, const PlannerInfo& info) {
  Scenario scenario;
  scenario.map = worlds.maps.front();
  scenario.start = worlds.start;
  scenario.goal = worlds.goal;
  scenario.planners = {{std::string(info.id), {}}};
  const Cell middle{(worlds.start.x + worlds.goal.x) / 2, (worlds.start.y + worlds.goal.y) / 2};
  for (const bool blocked : {true, false}) {
    Surprise surprise;
    surprise.at.move = blocked ? 10 : 30;
    surprise.announced = true;
    for (int y = middle.y - 3; y <= middle.y + 3; ++y)
      for (int x = middle.x - 3; x <= middle.x + 3; ++x)
        if (!scenario.map.blocked[scenario.map.index({x, y})]) surprise.cells.push_back({{x, y}, blocked});
    scenario.surprises.push_back(std::move(surprise));
  }
  return scenario;
}

/// Records the mission as a session does. Returns the log.
Timeline record(const Scenario& scenario) {
  Recorder recorder;
  const auto mission = make_mission(scenario, scenario.planners[0], &recorder);
  Timeline log(initial_state(scenario, scenario.planners.front()));
  while (mission->advance(20000)) log.append(recorder.take());
  log.append(recorder.take());
  return log;
}

/// Of the processor, so that a busy machine tells the same.
double seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Times both, one after the other, and says how many times as long a run with checks takes.
void checked_plan(benchmark::State& state, const PlannerInfo& info, const Worlds& worlds) {
  const Scenario scenario = with_surprise(worlds, info);
  const Settings settings;
  const Box lattice(scenario.map.width, scenario.map.height);
  double alone = 0, checks = 0;
  std::size_t events = 0, bytes = 0;
  for (auto _ : state) {
    const double begin = seconds();
    const Timeline log = record(scenario);
    const double recorded = seconds();
    LawChecker checker({log, lattice, info, settings});
    while (checker.advance(2048)) {
    }
    checks += seconds() - recorded;
    alone += recorded - begin;
    events = log.size();
    bytes = checker.bytes();
    if (checker.breach_count() != 0) state.SkipWithError("a law is broken");
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["alone_ms"] = 1000 * alone / runs;
  state.counters["checks_ms"] = 1000 * checks / runs;
  state.counters["times"] = (alone + checks) / alone;
  state.counters["events"] = static_cast<double>(events);
  state.counters["ns/event"] = 1e9 * checks / runs / static_cast<double>(events);
  state.counters["MiB"] = static_cast<double>(bytes) / (1 << 20);
}

}  // namespace

void bench::register_checks() {
  for (const Worlds& worlds : paper_worlds())
    for (const PlannerInfo& info : sound_planners()) {
      const std::string name = "checked_plan/" + worlds.name + "/" + std::string(info.id);
      benchmark::RegisterBenchmark(name.c_str(), [&info, &worlds](benchmark::State& state) {
        checked_plan(state, info, worlds);
      })->Unit(benchmark::kMillisecond);
    }
}

}  // namespace replan
