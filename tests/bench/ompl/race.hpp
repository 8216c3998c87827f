// One race of a planner that samples: how soon it has a path, and what its path costs as time goes on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/lattice/box_lattice.hpp"
#include "core/lattice/lattice.hpp"

namespace replan::bench {

/// What both sides are given. Both hold ways against the obstacles by the same exact test (core/space/free_space.hpp).
struct RaceProblem {
  std::string name;
  const Grid2* world = nullptr;
  Cell start, goal;
  double optimum = 0;  ///< cells
  double step = 0;     ///< cells: how long an edge of the tree is at most
};

enum class Racer { rrt_connect, rrt_star, informed_rrt_star };
inline constexpr Racer kRacers[] = {Racer::rrt_connect, Racer::rrt_star, Racer::informed_rrt_star};
constexpr const char* racer_name(Racer racer) {
  return racer == Racer::rrt_connect ? "RRT-Connect" : racer == Racer::rrt_star ? "RRT*" : "Informed RRT*";
}

/// The cost of the path from that moment on.
struct Gain {
  double seconds = 0;
  double cost = 0;  ///< cells
};
/// In order of time; empty if no path was found.
using Race = std::vector<Gain>;

/// Both run for so many seconds, or until RRT-Connect has its path.
Race run_ours(const RaceProblem& problem, Racer racer, std::uint32_t seed, double seconds);
Race run_theirs(const RaceProblem& problem, Racer racer, std::uint32_t seed, double seconds);

}  // namespace replan::bench
