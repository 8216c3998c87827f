// Plans and replans of every registered planner on the DLD* Lite paper's kinds of world and on open ground,
// both ways of sight checks, what recording costs, and what it costs to begin again on a large map.
//
// Instructions, which a busy machine counts the same, of one benchmark's planning alone:
//   valgrind --tool=callgrind --toggle-collect='*plan_in_slices*' replan_bench --benchmark_filter=NAME
//     --benchmark_min_time=0.01
// and of replans, the change of the map with them, --toggle-collect='*change_and_plan*'.
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/plan/registry.hpp"
#include "tests/bench/worlds.hpp"

namespace replan {
namespace {

/// A planner, and whether sight is checked along its path instead of in its search.
struct Kind {
  const PlannerInfo* info;
  bool along_path = false;

  [[nodiscard]] std::string name() const { return std::string(info->id) + (along_path ? ":path" : ""); }
  [[nodiscard]] Settings settings() const {
    Settings settings;
    if (along_path) settings.set("sight_checks", 1);
    return settings;
  }
};

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  for (const PlannerInfo& info : sound_planners()) {
    all.push_back({&info});
    if (find_parameter(info.parameters, "sight_checks") != nullptr) all.push_back({&info, true});
  }
  return all;
}

/// Plans as a run does, in slices; what was recorded is handed on, and its memory used again, when it comes
/// to a batch. Here nobody takes it. Reading out the path is part of it.
template <class T>
[[gnu::noinline]] PlanStatus plan_in_slices(Planner<Grid2>& planner, T& tracer) {
  constexpr std::int64_t kIterations = 2000;
  for (bool done = false; !done;) {
    done = planner.advance(kIterations);
    if constexpr (T::kEnabled) {
      constexpr std::size_t kBatchEvents = 400000;
      if (done || tracer.buffer().size() >= kBatchEvents) tracer.clear();
    }
  }
  benchmark::DoNotOptimize(planner.path().size());
  return planner.status();
}

/// One kind of planner in each of some worlds.
template <class T>
struct Fleet {
  Settings settings;
  std::vector<T> tracers;
  std::vector<Grid2> lattices;
  std::vector<std::unique_ptr<Planner<Grid2>>> planners;

  Fleet(const Kind& kind, const Worlds& worlds) : settings(kind.settings()), tracers(worlds.maps.size()) {
    lattices.reserve(worlds.maps.size());
    for (std::size_t i = 0; i < worlds.maps.size(); ++i) {
      const GridMap& map = worlds.maps[i];
      lattices.emplace_back(Grid2::Coordinates{map.width, map.height}, map.blocked.plain(),
                            move_rules(settings));
      planners.push_back(make_planner(*kind.info, lattices[i], settings, tracers[i]));
    }
  }
};

void report(benchmark::State& state, std::int64_t expansions) {
  state.counters["expansions"] =
      benchmark::Counter(static_cast<double>(expansions), benchmark::Counter::kAvgIterations);
  state.counters["expansions/s"] =
      benchmark::Counter(static_cast<double>(expansions), benchmark::Counter::kIsRate);
}

template <class T>
void first_plans(benchmark::State& state, const Kind& kind, const Worlds& worlds) {
  std::int64_t expansions = 0;
  Fleet<T> fleet(kind, worlds);
  for (auto _ : state)
    for (std::size_t i = 0; i < fleet.planners.size(); ++i) {
      const Grid2& lattice = fleet.lattices[i];
      fleet.planners[i]->begin(lattice.node(worlds.start), lattice.node(worlds.goal));
      if (plan_in_slices(*fleet.planners[i], fleet.tracers[i]) != PlanStatus::found)
        state.SkipWithError("no path");
      expansions += fleet.planners[i]->counters().expansions;
    }
  report(state, expansions);
}

/// Blocks of 3 x 3 cells along the shortest lattice path, from its start on, each put there and taken away
/// again.
std::vector<std::vector<CellEdit>> blocks_ahead(const Grid2& lattice, NodeId start, NodeId goal) {
  constexpr std::size_t kBlocks = 10, kApart = 7;
  NoTrace nobody;
  const auto planner = make_planner(*find_planner("dstar-lite"), lattice, {}, nobody);
  planner->begin(start, goal);
  finish(*planner);
  const std::vector<NodeId> path = planner->path().nodes();
  std::vector<std::vector<CellEdit>> changes;
  for (std::size_t at = kApart; at + kApart < path.size() && changes.size() < 2 * kBlocks; at += kApart) {
    const Cell middle = lattice.position(path[at]);
    std::vector<CellEdit> block;
    for (int y = middle.y - 1; y <= middle.y + 1; ++y)
      for (int x = middle.x - 1; x <= middle.x + 1; ++x)
        if (lattice.contains(Cell{x, y}) && !lattice.blocked(lattice.node(Cell{x, y})))
          block.push_back({lattice.node(Cell{x, y}), true});
    changes.push_back(block);
    for (CellEdit& edit : block) edit.blocked = false;
    changes.push_back(std::move(block));
  }
  return changes;
}

void change(Planner<Grid2>& planner, Grid2& lattice, const std::vector<CellEdit>& edits, NodeId start) {
  const auto moves = lattice.apply(edits);
  planner.update({.cells = edits, .moves = moves}, start);
}
[[gnu::noinline]] void change_and_plan(Planner<Grid2>& planner, Grid2& lattice,
                                       const std::vector<CellEdit>& edits, NodeId start) {
  NoTrace nobody;
  change(planner, lattice, edits, start);
  plan_in_slices(planner, nobody);
}

void replans(benchmark::State& state, const Kind& kind, const Worlds& worlds) {
  Fleet<NoTrace> fleet(kind, worlds);
  std::vector<std::vector<std::vector<CellEdit>>> changes;
  for (std::size_t i = 0; i < fleet.planners.size(); ++i) {
    const Grid2& lattice = fleet.lattices[i];
    const NodeId start = lattice.node(worlds.start), goal = lattice.node(worlds.goal);
    changes.push_back(blocks_ahead(lattice, start, goal));
    fleet.planners[i]->begin(start, goal);
    finish(*fleet.planners[i]);
    // The first time round costs more than every other one: cells come into the search that stay in it.
    for (const auto& edits : changes[i]) {
      change(*fleet.planners[i], fleet.lattices[i], edits, start);
      finish(*fleet.planners[i]);
      (void)fleet.planners[i]->path();
    }
  }
  std::int64_t expansions = 0;
  for (auto _ : state)
    for (std::size_t i = 0; i < fleet.planners.size(); ++i) {
      const std::int64_t before = fleet.planners[i]->counters().expansions;
      for (const auto& edits : changes[i])
        change_and_plan(*fleet.planners[i], fleet.lattices[i], edits, fleet.lattices[i].node(worlds.start));
      expansions += fleet.planners[i]->counters().expansions - before;
    }
  report(state, expansions);
}

/// The goal is dragged about near the start of a large map: a plan of few expansions each time.
void begin_again(benchmark::State& state, const Kind& kind) {
  const auto side = static_cast<int>(state.range(0));
  const Worlds worlds{"empty", {side / 2, side / 2}, {side / 2 + 200, side / 2 + 3}, {GridMap(side, side)}};
  Fleet<NoTrace> fleet(kind, worlds);
  Planner<Grid2>& planner = *fleet.planners[0];
  const Grid2& lattice = fleet.lattices[0];
  const auto plan_to = [&](int x) {
    planner.begin(lattice.node(worlds.start), lattice.node(Cell{worlds.goal.x + x, worlds.goal.y}));
    plan_in_slices(planner, fleet.tracers[0]);
  };
  plan_to(0);
  std::int64_t expansions = 0;
  int x = 0;
  for (auto _ : state) {
    plan_to(x = (x + 1) % 8);
    expansions += planner.counters().expansions;
  }
  report(state, expansions);
  state.counters["bytes/cell"] =
      static_cast<double>(planner.memory_bytes()) / static_cast<double>(lattice.node_count());
}

}  // namespace

void bench::register_plans() {
  using benchmark::RegisterBenchmark;
  using benchmark::State;
  for (const Worlds& worlds : all_worlds())
    for (const Kind& kind : kinds()) {
      const std::string name = worlds.name + "/" + kind.name();
      RegisterBenchmark(("first_plan/" + name + "/no_trace").c_str(), [kind, &worlds](State& state) {
        first_plans<NoTrace>(state, kind, worlds);
      })->Unit(benchmark::kMillisecond);
      RegisterBenchmark(("first_plan/" + name + "/recorder").c_str(), [kind, &worlds](State& state) {
        first_plans<Recorder>(state, kind, worlds);
      })->Unit(benchmark::kMillisecond);
      if (kind.info->incremental)
        RegisterBenchmark(("replan/" + name).c_str(), [kind, &worlds](State& state) {
          replans(state, kind, worlds);
        })->Unit(benchmark::kMillisecond);
    }
  for (const Kind& kind : kinds())
    RegisterBenchmark(("begin_again/" + kind.name()).c_str(),
                      [kind](State& state) { begin_again(state, kind); })
        ->Arg(2048)
        ->Arg(8192)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace replan
