#include <chrono>

#include "core/plan/registry.hpp"
#include "race.hpp"

namespace replan::bench {
namespace {

const char* id_of(Racer racer) {
  switch (racer) {
    case Racer::rrt_connect:
      return "rrt-connect";
    case Racer::rrt_star:
      return "rrt-star";
    case Racer::informed_rrt_star:
      return "informed-rrt-star";
  }
  return "";
}

Settings settings_for(const RaceProblem& problem, std::uint32_t seed) {
  Settings settings;
  settings.set("step", problem.step);
  settings.set("goal_reach", problem.step);
  settings.set("ball", 1);  // shrinking, as OMPL's neighbourhoods do
  settings.set("samples", 1e6);
  settings.set("seed", seed);
  return settings;
}

}  // namespace

Race run_ours(const RaceProblem& problem, Racer racer, std::uint32_t seed, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  NoTrace trace;
  const auto planner =
      make_planner(*find_planner(id_of(racer)), *problem.world, settings_for(problem, seed), trace);
  planner->begin(problem.world->node(problem.start), problem.world->node(problem.goal));
  Race race;
  for (bool done = false; !done && passed() < seconds;) {
    done = planner->advance(1);
    const Cost cost = planner->best_so_far();
    if (!cost.is_infinite() && (race.empty() || cost.to_double() < race.back().cost))
      race.push_back({passed(), cost.to_double()});
  }
  return race;
}

}  // namespace replan::bench
