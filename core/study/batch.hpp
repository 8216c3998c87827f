// Every problem of a MovingAI scenario file, in two or three dimensions, with one planner, held against the
// listed lengths.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/world/formats/movingai.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// A problem whose listed length was not found.
struct BatchMismatch {
  int line = 0;      ///< in the scenario file
  double found = 0;  ///< 0 if no path was found
  double listed = 0;
};

/// What one planner came to on a file.
struct BatchReport {
  std::string planner;        ///< registry id
  bool comparable = false;    ///< the listed lengths are this planner's to find: see lengths_apply()
  std::int64_t problems = 0;  ///< that were to be solved, the skipped ones included
  std::int64_t skipped = 0;   ///< start or goal lies in an obstacle of the map
  std::int64_t found = 0;     ///< for which a path was found
  std::int64_t mismatches =
      0;  ///< not the listed optimum to the precision printed; 0 for planners not comparable
  double max_relative_error = 0;  ///< largest |found / listed - 1|
  double mean_ratio = 0;  ///< mean of found / listed, problems of length 0 left out; 0 if there is none
  double total_ms = 0;    ///< wall time of planning and replanning, all problems together
  std::int64_t expansions = 0;
  std::vector<BatchMismatch> first_mismatches;  ///< at most kMismatchesKept
  static constexpr std::size_t kMismatchesKept = 5;

  [[nodiscard]] std::int64_t unsolved() const { return problems - skipped - found; }
  /// True if every problem that was not skipped has a path and none mismatches.
  [[nodiscard]] bool passed() const { return mismatches == 0 && unsolved() == 0; }
};

/// How a batch is watched and stopped.
struct BatchWatch {
  std::function<void(std::size_t done)> progress;  ///< after each problem
  std::stop_token stop;                            ///< the report then counts the problems done so far
};

/// Whether the lengths of MovingAI files are what a planner must find with these settings: it finds shortest
/// lattice paths, under the rules that the lengths were made with (8 neighbours, no corner cut).
bool lengths_apply(const PlannerChoice& choice);

/// `limit` problems spread evenly over the file in its order, the first and the last among them; all if there
/// are no more than that. 0: all.
std::vector<ScenProblem> even_sample(const std::vector<ScenProblem>& problems, std::size_t limit);

/// Solves the problems with one instance of the planner; a pilot drives each. They must fit the map (check_scen_fits()).
BatchReport run_batch(const GridMap& map, const LengthFormat& lengths, std::span<const ScenProblem> problems,
                      const PlannerChoice& choice, const BatchWatch& watch = {});

/// `{"planners": [...]}`.
std::string batch_json(std::span<const BatchReport> reports);

}  // namespace replan
