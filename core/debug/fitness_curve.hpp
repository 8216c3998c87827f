// How the paths of a population became fitter, generation by generation, out of its log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/debug/log_view.hpp"

namespace replan {

/// The end of a generation.
struct FitnessPoint {
  std::size_t event = 0;
  std::int64_t generation = 0;  ///< of all plans since the first, from 1 on
  Cost fittest = {};            ///< what the fittest path costs, penalties included
  Cost mean = {};               ///< of all paths
  bool free = false;            ///< the fittest one hits nothing
};

/// Those in the events [begin, end) in their order; none of a planner that breeds no paths.
std::vector<FitnessPoint> fitness_curve(const LogView& view, std::size_t begin, std::size_t end);

/// A line for each: generation, best (what the fittest path costs), mean, free (1: it hits nothing); costs in cells.
std::string fitness_csv(std::span<const FitnessPoint> curve);

}  // namespace replan
