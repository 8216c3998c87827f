// What edits cost the thread that draws, and what they leave in memory: strokes, undo, edits in the past,
// Cancel. And what the log of a run leaves there, as the operating system counts it.
#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "core/base/random.hpp"
#include "core/session/session.hpp"
#include "tests/bench/worlds.hpp"

namespace replan {
namespace {

/// MiB of memory that the process has now.
double resident() {
  std::size_t whole = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> whole >> pages;
  return static_cast<double>(pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) / (1 << 20);
}

/// Milliseconds that this thread has worked, and that have gone by.
struct Clock {
  double worked = 0, wall = 0;
  static Clock now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return {static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6,
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
                .count()};
  }
};

/// The longest and the mean of what was timed, in milliseconds of this thread's work. What others do on the
/// machine does not count; what is waited for does, as `longest_wall` shows.
class Times {
 public:
  template <class Work>
  void time(Work&& work) {
    const Clock begin = Clock::now();
    work();
    const Clock end = Clock::now();
    longest_ = std::max(longest_, end.worked - begin.worked);
    longest_wall_ = std::max(longest_wall_, end.wall - begin.wall);
    total_ += end.worked - begin.worked;
    ++count_;
  }
  void report(benchmark::State& state, const std::string& name) const {
    state.counters[name + "_mean_ms"] = total_ / std::max(1, count_);
    state.counters[name + "_max_ms"] = longest_;
    state.counters[name + "_max_wall_ms"] = longest_wall_;
  }

 private:
  double longest_ = 0, longest_wall_ = 0, total_ = 0;
  int count_ = 0;
};

/// A stroke of 10 x 10 cells somewhere.
std::vector<CellChange> stroke(Random& random, int size) {
  const int left = random.between(0, size - 10), top = random.between(0, size - 10);
  const bool blocked = random.chance(0.5);
  std::vector<CellChange> cells;
  for (int y = top; y < top + 10; ++y)
    for (int x = left; x < left + 10; ++x) cells.push_back({{x, y}, blocked});
  return cells;
}

/// Many strokes, drawn between, then all of them undone. Before the first plan stands they change the map,
/// afterwards they are surprises.
void session_strokes(benchmark::State& state, bool planned) {
  const auto size = static_cast<int>(state.range(0));
  const auto count = static_cast<int>(state.range(1));
  for (auto _ : state) {
    Session session(big_scenario("dstar-lite", size));
    if (planned)
      session.settle();
    else
      (void)session.apply(Cancel{});
    const Scenario first = session.scenario();
    const auto log_mib = [&] {
      const Timeline& log = session.run().timeline();
      return static_cast<double>(log.log_bytes() + log.frame_bytes()) / (1 << 20);
    };
    const double before = resident(), log_before = log_mib();
    Random random(1);
    Times strokes, frames, undos;
    for (int i = 0; i < count; ++i) {
      const auto cells = stroke(random, size);
      strokes.time([&] { (void)session.apply(PaintCells{cells}); });
      if (!planned) (void)session.apply(Cancel{});
      frames.time([&] { session.update(0.016); });
    }
    state.counters["grown_MiB"] = resident() - before;
    state.counters["of_that_log_MiB"] = log_mib() - log_before;
    while (session.history_position() > 0) {
      undos.time([&] { (void)session.apply(Undo{}); });
      if (!planned) (void)session.apply(Cancel{});
    }
    if (session.scenario() != first) state.SkipWithError("undo does not lead back to the first state");
    strokes.report(state, "stroke");
    frames.report(state, "frame");
    undos.report(state, "undo");
  }
}
BENCHMARK_CAPTURE(session_strokes, surprises, true)
    ->Args({4096, 300})
    ->Args({4096, 10000})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(session_strokes, map, false)
    ->Args({4096, 300})
    ->Args({4096, 10000})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

/// On a plan that has been carried out to its end: a stroke of one cell at the end, strokes in the past, each
/// undone and made again.
void session_branches(benchmark::State& state) {
  const auto size = static_cast<int>(state.range(0));
  for (auto _ : state) {
    Session session(big_scenario("dstar-lite", size));
    session.settle();
    for (const auto& run : session.runs()) run->finish(Target::clock_at(60));
    session.update(0);
    const auto wait = [&] {
      while (session.run().busy()) {
        session.update(0.016);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
    };
    Times one_cell, past, undo, redo, frames;
    const Cell robot = {size / 2, size / 2};
    one_cell.time([&] { (void)session.apply(PaintCells{{{robot, true}}}); });
    wait();
    for (int i = 0; i < 8; ++i) {
      const std::size_t decision = session.run().decisions().size() / 2;
      (void)session.apply(Seek{session.run().decisions()[decision].event});
      std::vector<CellChange> cells;
      const Cell at = session.run().lattice().position(session.run().timeline().state().node(Scalar::robot));
      for (int k = 4; k < 14; ++k) cells.push_back({{at.x + k, at.y + k - i}, true});
      past.time([&] { (void)session.apply(PaintCells{cells}); });
      frames.time([&] { session.update(0.016); });
      undo.time([&] { (void)session.apply(Undo{}); });
      frames.time([&] { session.update(0.016); });
      redo.time([&] { (void)session.apply(Redo{}); });
      for (int k = 0; k < 100; ++k) frames.time([&] { session.update(0.016); });
      wait();
    }
    one_cell.report(state, "one_cell");
    past.report(state, "past");
    undo.report(state, "undo");
    redo.report(state, "redo");
    frames.report(state, "frame");
  }
}
BENCHMARK(session_branches)->Arg(1024)->Arg(2048)->Arg(4096)->Iterations(1)->Unit(benchmark::kSecond);

/// Cancel in the middle of a first plan, of the making of a planner, and while a planner forgets its search.
void session_cancel(benchmark::State& state, const char* planner) {
  const auto size = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const Scenario scenario = big_scenario(planner, size);
    Times cancel;
    double stopped = 0;
    Session session(scenario);
    Random random(2);
    for (int i = 0; i < 30; ++i) {
      (void)session.apply(Restart{});
      const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(random.below(400));
      while (std::chrono::steady_clock::now() < until) session.update(0.016);
      if (random.chance(0.5)) (void)session.apply(SetGoal{{random.between(0, size - 1), size - 1}});
      cancel.time([&] { (void)session.apply(Cancel{}); });
      const auto asked = std::chrono::steady_clock::now();
      while (session.run().busy()) session.update(0);
      stopped = std::max(
          stopped,
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - asked).count());
    }
    cancel.report(state, "cancel");
    state.counters["stopped_after_max_ms"] = stopped;
  }
}
BENCHMARK_CAPTURE(session_cancel, dstar_lite, "dstar-lite")
    ->Arg(1024)
    ->Arg(2048)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(session_cancel, astar, "astar")
    ->Arg(1024)
    ->Arg(2048)
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

/// Memory that a long log leaves, against its limit and its two states.
void timeline_memory(benchmark::State& state) {
  const std::size_t limit = static_cast<std::size_t>(state.range(0)) << 20;
  const auto events = static_cast<std::size_t>(state.range(1)) * 1000000;
  constexpr std::uint32_t kNodes = 1u << 20;
  for (auto _ : state) {
    const double before = resident();
    Timeline log(SearchState(kNodes), {.bytes = limit});
    log.set_source([](std::size_t, const KeyFrame&, std::size_t from, std::size_t to) {
      return std::vector<Event>(to - from);
    });
    Random random(1);
    std::vector<Event> batch;
    NodeId at = kNodes / 2;
    for (std::size_t i = 0; i < events; ++i) {
      at = (at + random.below(7) * 511 + kNodes - 1533) % kNodes;
      batch.push_back({random.next(), at, static_cast<EventKind>(random.below(kWideFields)), 0, 0});
      if (batch.size() < 16384) continue;
      log.append(batch);
      batch.clear();
    }
    const double stated = static_cast<double>(limit + log.head().page_bytes()) / (1 << 20);
    state.counters["stated_MiB"] = stated;
    state.counters["resident_MiB"] = resident() - before;
    state.counters["resident/stated"] = (resident() - before) / stated;
    state.counters["log_bytes_MiB"] = static_cast<double>(log.log_bytes() >> 20);
  }
}
BENCHMARK(timeline_memory)->Args({64, 25})->Args({1024, 100})->Iterations(1)->Unit(benchmark::kSecond);

/// A whole run on a large world: the process's memory beside what is stated of it.
void run_memory(benchmark::State& state) {
  const auto size = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const double before = resident();
    Scenario scenario = big_scenario("dstar-lite", size);
    scenario.planners[0].settings.set("heuristic", 2);  // zero: nearly every cell is expanded
    Run run(std::make_shared<const Scenario>(std::move(scenario)), 0);
    run.finish(Target::plan());
    const double grown = resident() - before;
    constexpr double kMiB = 1 << 20;
    const double planner = static_cast<double>(run.decisions().back().figures.peak_bytes) / kMiB;
    const double states = static_cast<double>(run.timeline().head().page_bytes()) / kMiB;
    const double cells = static_cast<double>(size) * size / kMiB;
    state.counters["planner_MiB"] = planner;
    state.counters["state_MiB"] = states;
    // The log's limit, the planner with its counts of visits and the lattice, the state at the end, the maps.
    const double stated = 1024 + planner + cells * (8 + 2) + states + cells * 2;
    state.counters["events_M"] = static_cast<double>(run.timeline().size()) * 1e-6;
    state.counters["stated_MiB"] = stated;
    state.counters["resident_MiB"] = grown;
    state.counters["resident/stated"] = grown / stated;
  }
}
BENCHMARK(run_memory)->Arg(2048)->Arg(4096)->Arg(8192)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace replan
