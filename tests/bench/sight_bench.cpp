// The sight checks of a search by themselves: those that a first plan asks for are written down, and asked
// again.
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/field/clearance.hpp"
#include "core/lattice/sight.hpp"
#include "core/plan/registry.hpp"
#include "tests/bench/worlds.hpp"

namespace replan {
namespace {

/// What is asked on one map.
struct Questions {
  Grid2 lattice;
  ClearanceField<2> field;
  std::vector<std::pair<NodeId, NodeId>> pairs;
};

Questions questions_of(const PlannerInfo& info, const GridMap& map, const Worlds& worlds) {
  Questions asked{Grid2({map.width, map.height}, map.blocked.plain()), {}, {}};
  Recorder recorder;
  const auto planner = make_planner(info, asked.lattice, {}, recorder);
  planner->begin(asked.lattice.node(worlds.start), asked.lattice.node(worlds.goal));
  finish(*planner);
  for (const Event& event : recorder.buffer())
    if (event.kind == EventKind::sight)
      asked.pairs.emplace_back(event.node, static_cast<NodeId>(event.delta));
  asked.field = ClearanceField<2>(asked.lattice, {});
  return asked;
}

[[gnu::noinline]] std::size_t ask(const Questions& asked, bool clearance, const SightMap<2>& map) {
  std::size_t seen = 0;
  const auto bad = [&](NodeId c) { return clearance ? asked.field.near(c) : asked.lattice.blocked(c); };
  for (const auto& [a, b] : asked.pairs)
    seen += line_of_sight(asked.lattice, SightRule::supercover, a, b, bad, map) ? 1 : 0;
  return seen;
}

void sight_checks(benchmark::State& state, const PlannerInfo& info, const Worlds& worlds) {
  std::vector<Questions> all;
  std::vector<SightMap<2>> maps;
  std::size_t checks = 0, seen = 0;
  for (const GridMap& map : worlds.maps) {
    all.push_back(questions_of(info, map, worlds));
    const Questions& asked = all.back();
    maps.emplace_back(asked.lattice, [&](NodeId c) {
      return info.clearance ? asked.field.near(c) : asked.lattice.blocked(c);
    });
    checks += asked.pairs.size();
  }
  for (auto _ : state) {
    seen = 0;
    for (std::size_t i = 0; i < all.size(); ++i) seen += ask(all[i], info.clearance, maps[i]);
  }
  state.counters["checks"] = static_cast<double>(checks);
  state.counters["seen"] = static_cast<double>(seen);
}

}  // namespace

void bench::register_sight() {
  for (const Worlds& worlds : all_worlds())
    for (const PlannerInfo& info : sound_planners())
      if (find_parameter(info.parameters, "sight") != nullptr)  // others have lines of sight of their own
        benchmark::RegisterBenchmark(
            ("sight_checks/" + worlds.name + "/" + std::string(info.id)).c_str(),
            [&info, &worlds](benchmark::State& state) { sight_checks(state, info, worlds); })
            ->Unit(benchmark::kMillisecond);
}

}  // namespace replan
