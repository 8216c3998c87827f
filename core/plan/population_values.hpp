// The values of a population of paths (core/planners/population.hpp), read out of a state of its log.
#pragma once

#include <algorithm>
#include <compare>
#include <vector>

#include "core/trace/search_state.hpp"

namespace replan {

/// A cell of a path, and the obstacle in the straight way from there to the path's next cell: kNoNode if it is free.
struct PathPlace {
  NodeId cell = kNoNode;
  NodeId hit = kNoNode;
  friend bool operator==(const PathPlace&, const PathPlace&) = default;
};

/// A path from the start to the goal as planners breed them: their chromosome, with a cell for a gene.
using BredPath = std::vector<PathPlace>;

inline bool hits_something(const BredPath& path) {
  for (const PathPlace& place : path)
    if (place.hit != kNoNode) return true;
  return false;
}

/// How fit a path is: the less, the fitter. What hits nothing is fitter than what hits something, however small the penalty
/// is; else the fitness is 1 / cost.
struct Unfitness {
  bool hits = true;
  Cost cost = Cost::infinity();
  friend auto operator<=>(const Unfitness&, const Unfitness&) = default;
};

/// Where the log holds the cell of a path at a place.
constexpr NodeId place_of_path(std::uint32_t path, std::size_t place) {
  return path * kPlacesOfPath + static_cast<NodeId>(place);
}

/// How many paths there are, the child's among them.
inline std::uint32_t path_count(const SearchState& state) {
  return static_cast<std::uint32_t>(state.scalar(Scalar::paths));
}
inline Cost path_cost(const SearchState& state, std::uint32_t path) {
  return {static_cast<std::int64_t>(state.value(fields::kPathCost.kind, path))};
}
/// Empty if nothing was written there yet.
inline BredPath bred_path(const SearchState& state, std::uint32_t path) {
  BredPath places;
  const auto read = [&](const Field& field) {
    return static_cast<NodeId>(state.value(field.kind, place_of_path(path, places.size()))) - 1u;
  };
  while (places.size() < kPlacesOfPath) {
    const PathPlace place{read(fields::kPathCell), read(fields::kPathHit)};
    if (place.cell == kNoNode) break;
    places.push_back(place);
  }
  return places;
}
/// All paths but one, the fittest first; of equally fit ones that with the smaller number.
inline std::vector<std::uint32_t> paths_by_fitness(const SearchState& state, std::uint32_t but) {
  std::vector<std::uint32_t> paths;
  std::vector<Unfitness> unfitness;
  for (std::uint32_t i = 0; i < path_count(state); ++i) {
    unfitness.push_back({hits_something(bred_path(state, i)), path_cost(state, i)});
    if (i != but) paths.push_back(i);
  }
  std::stable_sort(paths.begin(), paths.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return unfitness[a] < unfitness[b]; });
  return paths;
}
/// The path that a scalar names; kNoNode if it names none.
inline std::uint32_t path_named(const SearchState& state, Scalar which) {
  return static_cast<std::uint32_t>(state.scalar(which)) - 1u;
}

}  // namespace replan
