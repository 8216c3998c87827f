// What each planner of a batch comes to, kept up as results arrive.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/running_median.hpp"
#include "core/experiment/run_result.hpp"

namespace replan {

/// A figure that summaries have the median of.
enum class SummaryFigure : std::uint8_t { length, turns, clearance, expansions, time };
inline constexpr std::size_t kSummaryFigures = 5;
/// Its value in a run that succeeded: cells, turns, cells, expansions, milliseconds (of repeats the median, replans
/// included). The clearance is the least of the way that was driven, or of the path.
std::optional<double> summary_figure(const RunResult& run, SummaryFigure figure);

/// All runs of one planner with its settings.
class PlannerSummary {
 public:
  explicit PlannerSummary(std::string label) : label_(std::move(label)) {}
  void add(const RunResult& run);

  [[nodiscard]] const std::string& label() const { return label_; }  ///< planner_label()
  [[nodiscard]] std::int64_t runs() const { return runs_; }          ///< without the skipped ones
  [[nodiscard]] std::int64_t found() const { return found_; }        ///< that succeeded
  /// Of the runs that succeeded; nothing if there is none that has the figure.
  [[nodiscard]] std::optional<double> median(SummaryFigure figure) const;
  /// The median over that of another planner; nothing where either is missing, or the other is 0.
  [[nodiscard]] std::optional<double> ratio(SummaryFigure figure, const PlannerSummary& other) const;

 private:
  std::string label_;
  std::int64_t runs_ = 0, found_ = 0;
  std::array<RunningMedian, kSummaryFigures> medians_;
};

/// One for each planner, in the order of its lowest run.
class PlannerSummaries {
 public:
  void add(const RunResult& run);
  [[nodiscard]] std::span<const PlannerSummary> all() const { return all_; }

 private:
  std::vector<PlannerSummary> all_;
  std::vector<std::int64_t> lowest_;  // run of each
};

}  // namespace replan
