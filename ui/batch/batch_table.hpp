// The results of a batch as a table to look through: which of them are shown, and in which order.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
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

/// How wide a table is that has room for the columns that say most, and for all.
inline constexpr float kRoomForMost = 440, kRoomForAll = 900;

struct BatchColumnInfo {
  const char* name;
  const char* unit;   ///< empty: what is counted, or words
  const char* title;  ///< of its tooltip
  const char* help;
  float width;  ///< its share
  bool words;   ///< it holds words, which stand at the left; else numbers
  float room;   ///< design pixels that the table has to have for this column to be in it
  int decimals = 0;
};
const BatchColumnInfo& info_of(BatchColumn column);
/// Its name with its unit: "length  cells".
std::string batch_heading(BatchColumn column);

/// A run as the table keeps it: what its columns show, and no more. Of a hundred thousand runs the results themselves, with
/// all their figures, would take a hundred megabytes.
struct BatchRow {
  std::int64_t run = 0;
  std::uint64_t seed = 0;
  std::array<std::uint32_t, 4>
      words{};  ///< places among the table's words: world, planner, surprises, status
  bool succeeded = false;
  std::array<double, 6> numbers{};  ///< from BatchColumn::length on; not a number: the run has none

  /// Nothing in columns of words, and where the run has no such figure.
  [[nodiscard]] std::optional<double> number(BatchColumn column) const;
};

class BatchTable {
 public:
  void clear();
  /// Takes more results, to their places in the order that there is.
  void add(const std::vector<RunResult>& results);
  /// The same column again turns the order around. Runs that have no value come last either way.
  void sort_by(BatchColumn column);
  /// Only runs of that planner (planner_label()), or of that status; empty: of all.
  void show_planner(std::string label);
  void show_status(std::string status);

  [[nodiscard]] std::size_t count() const { return rows_.size(); }
  [[nodiscard]] std::size_t shown() const { return shown_.size(); }
  /// The run in that row of those that are shown.
  [[nodiscard]] const BatchRow& row(std::size_t index) const { return rows_[shown_[index]]; }
  /// What stands there in a column, in the face of numbers; empty if the run has no such figure.
  [[nodiscard]] std::string text(std::size_t index, BatchColumn column) const;
  /// The row of a run's number, if it is shown. Looks through all of them.
  [[nodiscard]] std::optional<std::size_t> row_of(std::int64_t run) const;
  [[nodiscard]] BatchColumn order() const { return order_; }
  [[nodiscard]] bool descending() const { return descending_; }
  [[nodiscard]] const std::string& planner() const { return planner_; }
  [[nodiscard]] const std::string& status() const { return status_; }
  /// All that there are, in the order in which they came.
  [[nodiscard]] std::span<const std::string> statuses() const { return statuses_; }
  [[nodiscard]] std::span<const PlannerSummary> summaries() const { return summaries_.all(); }

 private:
  /// What a row is sorted by.
  struct Key {
    double value;  // not a number: none
    std::int64_t run;
    std::uint32_t row;
  };
  [[nodiscard]] Key key_of(std::uint32_t row) const;
  [[nodiscard]] bool before(const Key& a, const Key& b) const;
  [[nodiscard]] bool shows(const BatchRow& row) const;
  [[nodiscard]] std::uint32_t word(const std::string& text);
  void rank_words();
  void merge(std::vector<std::uint32_t> fresh);
  void rebuild();

  std::vector<BatchRow> rows_;
  std::vector<std::uint32_t> shown_;  // places in rows_, in order
  std::vector<std::string> words_;    // of all rows, each once
  std::unordered_map<std::string, std::uint32_t> word_places_;
  std::vector<std::uint32_t> sorted_words_;  // their places, in natural order
  std::vector<std::uint32_t> word_ranks_;    // by place
  std::vector<std::string> statuses_;
  PlannerSummaries summaries_;
  BatchColumn order_ = BatchColumn::run;
  bool descending_ = false;
  std::string planner_, status_;
};

}  // namespace replan::ui
