// The straight ways of the paths that a population is made of: what they hit, and how fit a path is by them.
//
// Line numbers are those of assets/planners/improved-ga.md.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/plan/population_values.hpp"
#include "core/planners/checked_way.hpp"
#include "core/planners/ga_parameters.hpp"

namespace replan {

/// Where a path comes to a cell again, what lies between goes.
inline void delete_loops(BredPath& path) {
  for (std::size_t i = 0; i < path.size(); ++i)
    for (std::size_t again = path.size() - 1; again > i; --again)
      if (path[again].cell == path[i].cell) {
        path[i].hit = path[again].hit;
        path.erase(path.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   path.begin() + static_cast<std::ptrdiff_t>(again) + 1);
        break;
      }
}

template <Lattice L, Tracer T>
class BredWays {
 public:
  BredWays(const L& lattice, const Settings& settings, Counters& counters, T& tracer)
      : lattice_(lattice),
        tr_(tracer),
        counters_(counters),
        penalty_{std::llround(settings.get(parameters::kHitPenalty) * static_cast<double>(Cost::kScale))} {}

  /// The obstacle in the straight way between two cells; kNoNode if it is free.
  NodeId hit_between(NodeId from, NodeId to) {
    const auto hit = hit_on_checked_way(lattice_, centre_of(lattice_.position(from)),
                                        centre_of(lattice_.position(to)), tr_, counters_);
    return hit ? lattice_.node(*hit) : kNoNode;
  }
  /// Line 14.
  void hold_against_map(BredPath& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      path[i].hit = hit_between(path[i].cell, path[i + 1].cell);
  }
  /// The path with another cell at an inner place.
  BredPath with_cell(BredPath path, std::size_t place, NodeId cell) {
    path[place].cell = cell;
    for (const std::size_t from : {place - 1, place})
      path[from].hit = hit_between(path[from].cell, path[from + 1].cell);
    return path;
  }
  /// Line 10: length, and the penalty for each way that hits something.
  [[nodiscard]] Unfitness unfitness_of(const BredPath& path) const {
    Unfitness unfitness{false, Cost::zero()};
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      unfitness.cost =
          unfitness.cost + euclidean_ceil(lattice_.squared_distance(path[i].cell, path[i + 1].cell));
      if (path[i].hit == kNoNode) continue;
      unfitness.hits = true;
      unfitness.cost = unfitness.cost + penalty_;
    }
    return unfitness;
  }

 private:
  const L& lattice_;
  T& tr_;
  Counters& counters_;
  const Cost penalty_;
};

}  // namespace replan
