// What a run of an experiment came to: a row of the results, and its times beside them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/experiment/run_list.hpp"
#include "core/study/figures_table.hpp"

namespace replan {

/// A figure of a run in results: numbers that are the same wherever the run is made.
struct ResultColumn {
  std::string_view figure;  ///< NamedFigure::key
  std::string_view name;    ///< with its unit: "length_cells"
  Better better = Better::neither;
  bool newer =
      false;  ///< there are results without it, of an older version: in these it is read as not known
};
/// All of them, in the order of their columns.
std::span<const ResultColumn> result_columns();

struct RunResult {
  std::int64_t run = 0;  ///< its number
  RunName name;
  /// How it ended: mission_state_name() of a robot that drives, else status_name(); "skipped": start or goal of a listed
  /// problem lies in an obstacle.
  std::string status;
  std::string plan_status;  ///< of the first plan; empty if it was skipped
  bool succeeded = false;
  std::optional<double> expected;  ///< cells: the length that the problem's file lists
  std::string printed;             ///< ... as it stands there
  std::optional<bool> mismatch;    ///< the length is not the listed one; nothing: they are not comparable
  std::optional<double> metres_per_cell;       ///< of a metric map
  std::vector<std::optional<double>> figures;  ///< in the order of result_columns()

  // What does not repeat, for each time that it was run.
  std::vector<double> plan_ms, replan_ms;
  std::int64_t memory_bytes = 0;  ///< held by the planner at most, which depends on what it planned before

  /// The value of a column, if the run has it.
  [[nodiscard]] std::optional<double> figure(std::string_view column) const;
  /// Cells: of the way that was driven, or of the path.
  [[nodiscard]] std::optional<double> length() const;
  /// That over the listed length; nothing without one, or where it is 0.
  [[nodiscard]] std::optional<double> ratio() const;
  [[nodiscard]] bool skipped() const { return status == kSkipped; }
  friend bool operator==(const RunResult&, const RunResult&) = default;

  static constexpr std::string_view kSkipped = "skipped";
};

/// The result as one line of JSON without a line's end, and read back; `origin` names it in errors.
std::string result_line(const RunResult& result);
Result<RunResult> parse_result_line(const std::string& line, const std::string& origin);

}  // namespace replan
