// The results of a batch as a table to look through: which of them are shown, and in which order.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/experiment/planner_summary.hpp"
#include "core/experiment/run_result.hpp"

namespace replan::ui {

enum class BatchColumn : std::uint8_t {
  run,
  world,
  planner,
  surprises,
  seed,
  status,
  length,
  turns,
  clearance,
  expansions,
  replans,
  time
};
inline constexpr std::size_t kBatchColumns = 12;

struct BatchColumnInfo {
  const char* name;
  const char* title;  ///< of its tooltip
  const char* help;
  float width;  ///< its share
  bool words;   ///< it holds words, which stand at the left; else numbers
  bool main;    ///< where there is room for few, it is one of them
  int decimals = 0;
};
const BatchColumnInfo& info_of(BatchColumn column);

/// What stands in a column of a run, in the face of numbers; empty if the run has no such figure.
std::string batch_text(const RunResult& run, BatchColumn column);

class BatchTable {
 public:
  void clear();
  /// Takes more results, to their places in the order that there is.
  void add(std::vector<RunResult> results);
  /// The same column again turns the order around. Runs that have no value come last either way.
  void sort_by(BatchColumn column);
  /// Only runs of that planner (planner_label()), or of that status; empty: of all.
  void show_planner(std::string label);
  void show_status(std::string status);

  [[nodiscard]] std::size_t count() const { return results_.size(); }
  [[nodiscard]] std::size_t shown() const { return shown_.size(); }
  /// The run in that row of those that are shown.
  [[nodiscard]] const RunResult& row(std::size_t index) const { return results_[shown_[index]]; }
  /// The row of a run's number, if it is shown.
  [[nodiscard]] std::optional<std::size_t> row_of(std::int64_t run) const;
  [[nodiscard]] BatchColumn order() const { return order_; }
  [[nodiscard]] bool descending() const { return descending_; }
  [[nodiscard]] const std::string& planner() const { return planner_; }
  [[nodiscard]] const std::string& status() const { return status_; }
  /// All that there are, in the order in which they came.
  [[nodiscard]] std::span<const std::string> statuses() const { return statuses_; }
  [[nodiscard]] std::span<const PlannerSummary> summaries() const { return summaries_.all(); }

 private:
  /// What a run is sorted by.
  struct Key {
    std::string words;
    std::optional<double> number;
  };
  [[nodiscard]] static Key key_of(const RunResult& run, BatchColumn column);
  [[nodiscard]] bool shows(const RunResult& run) const;
  [[nodiscard]] bool before(std::size_t a, std::size_t b) const;
  void rebuild();

  std::vector<RunResult> results_;
  std::vector<Key> keys_;           // of results_, for the order that there is
  std::vector<std::size_t> shown_;  // places in results_, in order
  std::vector<std::string> statuses_;
  PlannerSummaries summaries_;
  BatchColumn order_ = BatchColumn::run;
  bool descending_ = false;
  std::string planner_, status_;
};

}  // namespace replan::ui
