// Two results held against each other, run by run: what has become better, what worse, and whether chance alone could have
// made it so.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/statistics.hpp"
#include "core/experiment/run_result.hpp"

namespace replan {

struct CompareSettings {
  double alpha = 0.05;     ///< so often a difference may be called one where there is none, all rows together
  bool times = false;      ///< the times of planning too, which tell machines and their load apart as well
  std::uint64_t seed = 1;  ///< of the resampling
};

enum class Trend : std::uint8_t { unchanged, better, worse };

/// One figure of one planner in both.
struct ComparedFigure {
  std::string planner;  ///< id, settings and stages
  std::string figure;   ///< a column of results.csv, "plan_ms", "replan_ms", or "succeeded"
  Better better = Better::lower;
  std::int64_t pairs = 0;                   ///< runs that are in both and have the figure in both
  std::int64_t improved = 0, worsened = 0;  ///< of these; the others are equal
  double before = 0, after = 0;             ///< medians; of "succeeded" the part of the runs
  /// The median of after / before over the pairs whose value before is not 0; of "succeeded" that of the two parts.
  std::optional<double> ratio;
  std::optional<Interval> interval;  ///< where that median lies with a confidence of 95 %
  double effect =
      0;         ///< -1 to 1: SignedRanks::effect() of after - before; of "succeeded" of those that changed
  double p = 1;  ///< of the signed-rank test; of "succeeded" of McNemar's exact test
  double corrected = 1;  ///< by Holm's method, for all rows in which any pair differs
  Trend verdict = Trend::unchanged;

  /// By which part of what it was the median pair is worse: 0.02 for 2 %. Nothing where it is no worse, or cannot be told.
  [[nodiscard]] std::optional<double> loss() const;
};

struct Comparison {
  std::vector<ComparedFigure> rows;  ///< planner by planner, in the order of the first results
  std::int64_t pairs = 0;            ///< runs that are in both
  std::int64_t only_before = 0, only_after = 0;
};

/// Pairs runs by their names (RunName). Skipped runs are left out. A figure counts where both runs succeeded; that a run
/// succeeds is a row of its own.
Comparison compare_results(std::span<const RunResult> before, std::span<const RunResult> after,
                           const CompareSettings& settings = {});

/// Names runs by their planner's id alone, whatever its settings and stages, so that two settings of a planner can be held
/// against each other. An Error if two of the results then have the same name.
Result<void> forget_settings(std::vector<RunResult>& results);

/// `{"pairs", "only_before", "only_after", "rows": [...]}`.
std::string comparison_json(const Comparison& comparison);

}  // namespace replan
