// What the log of a run costs: going to any moment of a long one, a cell's history, its memory, and taking
// over what the background has planned.
#include <chrono>
#include <ctime>
#include <thread>

#include <benchmark/benchmark.h>

#include "core/base/random.hpp"
#include "core/session/run.hpp"
#include "tests/bench/worlds.hpp"

namespace replan {
namespace {

/// Milliseconds that this thread has worked: what others do on the machine does not count.
double worked() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

void report_memory(benchmark::State& state, const Timeline& log) {
  const auto events = static_cast<double>(log.size());
  state.counters["events"] = events;
  state.counters["frames"] = static_cast<double>(log.key_frames());
  state.counters["bytes/event"] = static_cast<double>(log.log_bytes() + log.frame_bytes()) / events;
  state.counters["frame_MiB"] = static_cast<double>(log.frame_bytes() >> 20);
}

/// Seeks to random places, and takes a step after each.
void seek_about(benchmark::State& state, Timeline& log) {
  Random random(1);
  double slowest = 0;
  for (auto _ : state) {
    const double begin = worked();
    log.seek(static_cast<std::size_t>(random.next() % log.size()));
    log.seek(log.cursor() + 1);
    slowest = std::max(slowest, worked() - begin);
    benchmark::DoNotOptimize(log.state().g(0));
  }
  state.counters["max_ms"] = slowest;
  report_memory(state, log);
}

/// Random values in random fields: a walk touches places near each other, as a search does, but comes back to
/// all of them all the time, which no search does.
Timeline scattered_log(std::size_t events) {
  constexpr std::uint32_t kNodes = 1u << 20;
  Timeline timeline{SearchState(kNodes)};
  Random random(1);
  std::vector<Event> batch;
  NodeId at = kNodes / 2;
  for (std::size_t i = 0; i < events; ++i) {
    at = (at + random.below(7) * 511 + kNodes - 1533) % kNodes;
    batch.push_back({random.next(), at, static_cast<EventKind>(random.below(kWideFields)), 0, 0});
    if (batch.size() == 16384 || i + 1 == events) {
      timeline.append(batch);
      batch.clear();
    }
  }
  return timeline;
}

void timeline_seek(benchmark::State& state) {
  Timeline log = scattered_log(static_cast<std::size_t>(state.range(0)));
  seek_about(state, log);
}
BENCHMARK(timeline_seek)->Arg(1000000)->Arg(10000000)->Unit(benchmark::kMillisecond);

/// A first plan on random rectangles. Without an estimate it expands nearly every cell.
std::shared_ptr<const Scenario> big_world(const char* planner, int size, bool estimate) {
  Scenario scenario = big_scenario(planner, size);
  if (!estimate) scenario.planners[0].settings.set("heuristic", 2);
  return std::make_shared<const Scenario>(std::move(scenario));
}

/// Runs of one kind are made once: Google Benchmark calls a benchmark several times.
Run& planned(const char* planner, int size, bool estimate) {
  static std::unique_ptr<Run> run;
  static std::string made;
  const std::string name = planner + std::to_string(size) + (estimate ? "e" : "");
  if (made != name) {
    run.reset();
    run = std::make_unique<Run>(big_world(planner, size, estimate), 0);
    run->finish(Target::plan());
    made = name;
  }
  return *run;
}

void timeline_seek_run(benchmark::State& state, const char* planner, int size, bool estimate) {
  Run& run = planned(planner, size, estimate);
  seek_about(state, run.timeline());
  state.counters["dropped"] = run.timeline().dropped() ? 1 : 0;
}
BENCHMARK_CAPTURE(timeline_seek_run, dstar_lite_2048, "dstar-lite", 2048, true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(timeline_seek_run, dstar_lite_2048_all, "dstar-lite", 2048, false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(timeline_seek_run, dld_star_lite_2048, "dld-star-lite", 2048, true)
    ->Unit(benchmark::kMillisecond);

/// The last and the next event about a random cell, from a random place of a scattered log.
void timeline_history(benchmark::State& state) {
  const Timeline log = scattered_log(10000000);
  Random random(1);
  for (auto _ : state) {
    const NodeId node = random.below(1u << 20);
    const std::size_t place = random.next() % log.size();
    benchmark::DoNotOptimize(log.last_event(node, {EventKind::g}, place));
    benchmark::DoNotOptimize(log.next_event(node, {EventKind::g}, place));
  }
}
BENCHMARK(timeline_history)->Unit(benchmark::kMicrosecond);

/// The same in the log of a real run, the way a window asks: one cell after another, each of its values, and most cells
/// lie where hardly anything has happened.
void timeline_history_run(benchmark::State& state, const char* planner, int size, bool estimate) {
  Run& run = planned(planner, size, estimate);
  const Timeline& log = run.timeline();
  const auto nodes = static_cast<std::uint32_t>(run.lattice().node_count());
  Random random(1);
  double slowest = 0;
  for (auto _ : state) {
    const NodeId node = random.below(nodes);
    const std::size_t place = log.size() / 2 + static_cast<std::size_t>(random.next() % (log.size() / 2));
    const double begin = worked();
    for (const EventKind kind : {EventKind::g, EventKind::rhs, EventKind::queue, EventKind::lp})
      benchmark::DoNotOptimize(log.last_event(node, {kind}, place));
    slowest = std::max(slowest, worked() - begin);
  }
  state.counters["max_ms"] = slowest;
  report_memory(state, log);
}
BENCHMARK_CAPTURE(timeline_history_run, dld_star_lite_2048, "dld-star-lite", 2048, true)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(timeline_history_run, dstar_lite_2048_all, "dstar-lite", 2048, false)
    ->Unit(benchmark::kMicrosecond);

/// A plan of a huge world as a window sees it: how long the slowest pump() holds up a frame.
void run_pump(benchmark::State& state) {
  const auto world = big_world("dstar-lite", static_cast<int>(state.range(0)), true);
  for (auto _ : state) {
    Run run(world, 0);
    run.go(Target::plan());
    double slowest = 0, total = 0;
    while (run.busy()) {
      const double begin = worked();
      run.pump();
      const double took = worked() - begin;
      slowest = std::max(slowest, took);
      total += took;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    state.counters["max_ms"] = slowest;
    state.counters["pumping_ms"] = total;
    report_memory(state, run.timeline());
  }
}
BENCHMARK(run_pump)->Arg(4096)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace replan
