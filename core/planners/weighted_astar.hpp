// Weighted A*: best-first search (best_first.hpp) by f = g + w h.
//
//  Pohl, "Heuristic search viewed as path finding in a graph", Artificial Intelligence 1(3-4), 1970,
//  doi 10.1016/0004-3702(70)90007-X
//
// With a consistent h no plan costs more than w times the cheapest one, although a vertex that was taken is never
// opened again (Likhachev, Gordon & Thrun, "ARA*: anytime A* with provable bounds on sub-optimality", NIPS 2003): each
// vertex that is taken has at most w times its right g. Opening them again costs more than it saves: on large game
// maps it made w = 1.5 take twice as many expansions as A*, for paths that are hardly shorter. An estimate that is too
// long by a factor, Manhattan's, is a consistent one times that factor. Settled here: w is taken as a number of 2^-30,
// rounded down, and w h is rounded down, which the bound may miss by a unit for each move.
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
  static constexpr bool kOnce = true;
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
