// How the paths of a population became fitter, generation by generation, out of its log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/debug/scalar_values.hpp"

namespace replan {

/// The end of a generation.
struct FitnessPoint {
  std::size_t event = 0;
  std::int64_t generation = 0;  ///< of all plans of the run, from 1 on; a planner begins anew for a new goal
  Cost fittest = {};            ///< what the fittest path costs, penalties included
  Cost mean = {};               ///< of all paths
  bool free = false;            ///< the fittest one hits nothing
};

/// Those of a whole log in their order, read out of it in slices while it grows; none of a planner that breeds no paths.
class FitnessCurve {
 public:
  /// Reads on by at most `most` generations; starts over for another log (`log_id`).
  void follow(const LogView& view, std::uint64_t log_id, std::size_t most);

  [[nodiscard]] std::span<const FitnessPoint> points() const { return points_; }
  /// Whether all of the log is read.
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  struct Values {
    ScalarValues generation, fittest, mean, best;
  };

  std::uint64_t log_id_ = 0;
  std::optional<Values> values_;  // at the latest generation; nothing: not yet begun
  std::int64_t before_ = 0;       // generations of plans before the planner last began anew
  std::vector<FitnessPoint> points_;
  bool complete_ = false;
};

/// A line for each: generation, best (what the fittest path costs), mean, free (1: it hits nothing); costs in cells.
std::string fitness_csv(std::span<const FitnessPoint> curve);

}  // namespace replan
