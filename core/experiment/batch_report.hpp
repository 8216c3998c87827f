// What each planner came to in an experiment, all of its runs together; and problems of MovingAI files held against the
// listed lengths.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/experiment/run_list.hpp"
#include "core/experiment/run_result.hpp"

namespace replan {

/// A problem whose listed length was not found.
struct BatchMismatch {
  std::string world;  ///< the file of problems
  int line = 0;       ///< in it
  double found = 0;   ///< 0 if no path was found
  double listed = 0;
  friend bool operator==(const BatchMismatch&, const BatchMismatch&) = default;
};

/// What one planner with its settings came to.
struct BatchReport {
  std::string planner;        ///< registry id
  std::string label;          ///< with settings and stages, where these are not the usual ones
  bool comparable = false;    ///< the listed lengths are this planner's to find: RunList::length_is_listed()
  std::int64_t problems = 0;  ///< runs, the skipped ones included
  std::int64_t skipped = 0;   ///< start or goal lies in an obstacle of the map
  std::int64_t found = 0;     ///< that succeeded
  std::int64_t mismatches =
      0;  ///< not the listed optimum to the precision printed; 0 for planners not comparable
  double max_relative_error = 0;  ///< largest |found / listed - 1|
  double mean_ratio = 0;  ///< mean of found / listed, problems of length 0 left out; 0 if there is none
  double total_ms = 0;    ///< wall time of planning and replanning, all runs together; of repeats the median
  std::int64_t expansions = 0;
  std::vector<BatchMismatch> first_mismatches;  ///< at most kMismatchesKept
  static constexpr std::size_t kMismatchesKept = 5;

  [[nodiscard]] std::int64_t unsolved() const { return problems - skipped - found; }
  /// True if every problem that was not skipped has a path and none mismatches.
  [[nodiscard]] bool passed() const { return mismatches == 0 && unsolved() == 0; }
};

/// Adds runs up, as they come or all at once: one report for each planner, in the order of its first run.
class BatchSums {
 public:
  void add(const RunResult& run);
  [[nodiscard]] std::vector<BatchReport> reports() const;

 private:
  /// Of one planner.
  struct Sum {
    BatchReport report = {};
    double ratios = 0;          // of those that have one, together ...
    std::int64_t compared = 0;  // ... and how many
    void add(const RunResult& run);
    void compare(const RunResult& run);
    void mismatch(const RunResult& run);
  };

  std::vector<Sum> sums_;
};
std::vector<BatchReport> batch_reports(std::span<const RunResult> results);
/// `{"planners": [...]}`.
std::string batch_json(std::span<const BatchReport> reports);

/// Solves problems that fit the map (check_scen_fits()) with one planner.
BatchReport solve_problems(const GridMap& map, const LengthFormat& lengths,
                           std::span<const ScenProblem> problems, const PlannerChoice& choice);

}  // namespace replan
