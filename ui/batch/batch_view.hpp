// How the results of a batch look: a summary of each planner, and below it a row for each run.
#pragma once

#include <optional>

#include "ui/batch/batch_table.hpp"
#include "ui/look.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// Draws the table and remembers where one stands in it.
class BatchView {
 public:
  [[nodiscard]] BatchTable& table() { return table_; }
  [[nodiscard]] const BatchTable& table() const { return table_; }
  void clear();

  /// Draws to that height; the number of the run that was clicked, or chosen by Up, Down and Enter, to be opened.
  std::optional<std::int64_t> draw(const Look& look, float height);

 private:
  void draw_summaries(const Look& look);
  void draw_filters(const Look& look);
  void draw_header(const Look& look);
  std::optional<std::int64_t> draw_rows(const Look& look, float height);
  std::optional<std::int64_t> take_keys(const Look& look, float height);

  BatchTable table_;
  RowScroll scroll_, summary_scroll_;
  std::optional<std::int64_t> selected_;  // number of the run
};

}  // namespace replan::ui
