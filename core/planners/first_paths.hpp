// The paths that a population begins with: by sight, or of random cells.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/random.hpp"
#include "core/planners/bred_ways.hpp"

namespace replan {

template <Lattice L, Tracer T>
class FirstPaths {
 public:
  FirstPaths(const L& lattice, const Settings& settings, BredWays<L, T>& ways)
      : lattice_(lattice),
        ways_(ways),
        by_sight_(settings.get(parameters::kFirstPaths) == 0),
        most_cells_(static_cast<std::uint32_t>(settings.get(parameters::kMostCells))),
        seed_(static_cast<std::uint64_t>(settings.get(parameters::kBreedingSeed))) {}

  /// The i-th one of a plan before which so many children were bred.
  BredPath make(NodeId start, NodeId goal, std::int64_t children, std::uint32_t i) {
    const auto plan = static_cast<std::uint64_t>(children);
    Random random(hash_combine(hash_combine(hash_combine(seed_, kFirstOnes), plan), i));
    BredPath path = by_sight_ ? path_by_sight(random, start, goal) : random_path(random, start, goal);
    delete_loops(path);
    ways_.hold_against_map(path);
    return path;
  }

 private:
  /// Some free cells of the world in any order, between the two ends.
  BredPath random_path(Random& random, NodeId start, NodeId goal) const {
    BredPath path(1, {start});
    for (std::uint32_t left = random.below(most_cells_ + 1); left > 0; --left)
      path.push_back({random_cell(random, start)});
    path.push_back({goal});
    return path;
  }
  /// From cell to cell that is seen from there, until that is the goal or the path has its cells.
  BredPath path_by_sight(Random& random, NodeId start, NodeId goal) {
    BredPath path(1, {start});
    while (path.size() <= most_cells_ && ways_.hit_between(path.back().cell, goal) != kNoNode) {
      const NodeId one = seen_on_the_way(path.back().cell, random_cell(random, start)),
                   other = seen_on_the_way(path.back().cell, random_cell(random, start));
      const bool nearer = lattice_.squared_distance(other, goal) < lattice_.squared_distance(one, goal);
      path.push_back({nearer ? other : one});
    }
    path.push_back({goal});
    return path;
  }
  /// A cell that is seen from another one: `to`, or half as far, and so on.
  NodeId seen_on_the_way(NodeId from, NodeId to) {
    while (to != from && ways_.hit_between(from, to) != kNoNode) {
      auto half = lattice_.coordinates(from);
      const auto whole = lattice_.coordinates(to);
      for (std::size_t axis = 0; axis < half.size(); ++axis) half[axis] += (whole[axis] - half[axis]) / 2;
      to = lattice_.node(half);
    }
    return to;
  }
  /// A free cell, or the start in a world that has next to none.
  NodeId random_cell(Random& random, NodeId start) const {
    constexpr int kTries = 100;
    for (int tries = 0; tries < kTries; ++tries) {
      const NodeId cell = random.below(static_cast<std::uint32_t>(lattice_.node_count()));
      if (!lattice_.blocked(cell)) return cell;
    }
    return start;
  }

  static constexpr std::uint64_t kFirstOnes = 0xF1257;  // so that the first paths' numbers are of their own

  const L& lattice_;
  BredWays<L, T>& ways_;
  const bool by_sight_;
  const std::uint32_t most_cells_;
  const std::uint64_t seed_;
};

}  // namespace replan
