// Weighted A*: best-first search (best_first.hpp) by f = g + w h.
//
//  Pohl, "Heuristic search viewed as path finding in a graph", Artificial Intelligence 1(3-4), 1970,
//  doi 10.1016/0004-3702(70)90007-X
//
// With h no more than the truth no plan costs more than w times the cheapest one: of the cheapest path some vertex
// waits in the list with its right g until the goal is taken, and its f is at most w times that path's cost. That
// takes a vertex to be opened again where a shorter way to it shows, which best_first.hpp does. Settled here: w is
// taken as a number of 2^-30, rounded down, and w h is rounded down, so that the bound holds to the last unit.
#pragma once

#include <cmath>

#include "core/planners/best_first.hpp"

namespace replan {

namespace parameters {

inline const Parameter kWeight{.key = "weight",
                               .label = "Weight",
                               .type = ParameterType::real,
                               .initial = 1.5,
                               .low = 1,
                               .high = 10,
                               .help =
                                   "How much the estimate counts, w in f = g + w h. More leads to the goal "
                                   "with fewer expansions; a path "
                                   "costs at most w times the cheapest. 1 is A*."};

}  // namespace parameters

struct WeightedAStarSwitches {};

class GPlusWeightedH {
 public:
  static constexpr const char* kLaw = "a key in the list is g + w h";
  explicit GPlusWeightedH(const Settings& settings)
      : weight_{static_cast<std::int64_t>(
            std::floor(settings.get(parameters::kWeight) * static_cast<double>(Cost::kScale)))} {}
  Cost operator()(Cost g, Cost h) const { return g + weighted(h, weight_); }

 private:
  Cost weight_;
};

inline PlannerInfo describe(WeightedAStarSwitches) {
  PlannerInfo info;
  info.name = "Weighted A*";
  info.summary = "A* whose estimate counts w times: fewer expansions, a path at most w times the shortest.";
  info.source = "Pohl 1970, doi 10.1016/0004-3702(70)90007-X";
  info.key = key_rule<GPlusWeightedH>();
  for (Field& field : info.values.fields)
    if (field.kind == EventKind::queue) field.help = "g + w h while it waits in the open list.";
  info.parameters = {parameters::kWeight, parameters::kAnyHeuristic};
  info.length_bound = [](const Settings& settings) {
    return settings.get(parameters::kWeight) * overestimate(settings);
  };
  return info;
}

template <Lattice L, Tracer T>
using WeightedAStar = BestFirst<L, T, GPlusWeightedH>;

}  // namespace replan
