#include "ui/batch/batch_table.hpp"

#include <algorithm>
#include <array>

#include "core/base/file.hpp"
#include "ui/documents/file_list.hpp"
#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

constexpr std::array<BatchColumnInfo, kBatchColumns> kInfos = {
    {{"run", "Run", "Its number. The same experiment gives the same run the same number everywhere.", 60,
      false, true},
     {"world", "World", "The file of its world, and the line of its problem where that has several.", 110,
      true, false},
     {"planner", "Planner", "Who planned, with settings that are not the usual ones.", 220, true, true},
     {"surprises", "Surprises", "What happens while the robot drives.", 190, true, false},
     {"seed", "Seed", "What chance was drawn from.", 56, false, false},
     {"status", "Status", "How the run ended.", 100, true, true},
     {"length", "Length", "Cells: of the way that was driven, or of the path.", 92, false, true, 3},
     {"turns", "Turns", "How often the first plan's path changes its direction.", 66, false, false},
     {"clearance", "Clearance", "Cells to the nearest obstacle, where the way, or the path, comes closest.",
      96, false, false, 2},
     {"expansions", "Expansions", "Cells that were expanded, in all plans of the run together.", 104, false,
      true},
     {"replans", "Replans", "How often the robot had to plan again.", 76, false, false},
     {"ms", "Time",
      "Milliseconds of planning and replanning; of repeats the median. Jobs disturb each other's.", 84, false,
      true, 2}}};

std::optional<double> number_of(const RunResult& run, BatchColumn column) {
  switch (column) {
    case BatchColumn::run:
      return static_cast<double>(run.run);
    case BatchColumn::seed:
      return static_cast<double>(run.name.seed);
    case BatchColumn::length:
      return summary_figure(run, SummaryFigure::length);
    case BatchColumn::turns:
      return summary_figure(run, SummaryFigure::turns);
    case BatchColumn::clearance:
      return summary_figure(run, SummaryFigure::clearance);
    case BatchColumn::expansions:
      return run.figure("expansions");
    case BatchColumn::replans:
      return run.figure("replans");
    case BatchColumn::time:
      return summary_figure(run, SummaryFigure::time);
    default:
      return std::nullopt;
  }
}

std::string words_of(const RunResult& run, BatchColumn column) {
  switch (column) {
    case BatchColumn::world:
      return file_stem(run.name.world) + (run.name.line > 0 ? ":" + std::to_string(run.name.line) : "");
    case BatchColumn::planner:
      return planner_label(run.name);
    case BatchColumn::surprises:
      return run.name.surprises;
    case BatchColumn::status:
      return run.status;
    default:
      return {};
  }
}

}  // namespace

const BatchColumnInfo& info_of(BatchColumn column) {
  return kInfos[static_cast<std::size_t>(column)];
}

std::string batch_text(const RunResult& run, BatchColumn column) {
  const BatchColumnInfo& info = info_of(column);
  if (info.words) return words_of(run, column);
  if (column == BatchColumn::seed) return std::to_string(run.name.seed);
  const auto number = number_of(run, column);
  if (!number) return {};
  return info.decimals > 0 ? fixed(*number, info.decimals)
                           : grouped(static_cast<std::int64_t>(*number + 0.5));
}

void BatchTable::clear() {
  *this = BatchTable();
}

bool BatchTable::shows(const RunResult& run) const {
  return (status_.empty() || run.status == status_) &&
         (planner_.empty() || planner_label(run.name) == planner_);
}

BatchTable::Key BatchTable::key_of(const RunResult& run, BatchColumn column) {
  return info_of(column).words ? Key{words_of(run, column), std::nullopt} : Key{"", number_of(run, column)};
}

bool BatchTable::before(std::size_t a, std::size_t b) const {
  const Key &one = keys_[a], &other = keys_[b];
  if (one.number.has_value() != other.number.has_value()) return one.number.has_value();
  if (one.number != other.number) return (*one.number < *other.number) != descending_;
  if (one.words != other.words) return natural_less(one.words, other.words) != descending_;
  return results_[a].run < results_[b].run;
}

void BatchTable::add(std::vector<RunResult> results) {
  const auto old = static_cast<std::ptrdiff_t>(shown_.size());
  for (RunResult& result : results) {
    summaries_.add(result);
    if (std::find(statuses_.begin(), statuses_.end(), result.status) == statuses_.end())
      statuses_.push_back(result.status);
    keys_.push_back(key_of(result, order_));
    results_.push_back(std::move(result));
    if (shows(results_.back())) shown_.push_back(results_.size() - 1);
  }
  const auto less = [this](std::size_t a, std::size_t b) { return before(a, b); };
  std::sort(shown_.begin() + old, shown_.end(), less);
  std::inplace_merge(shown_.begin(), shown_.begin() + old, shown_.end(), less);
}

void BatchTable::rebuild() {
  shown_.clear();
  for (std::size_t i = 0; i < results_.size(); ++i)
    if (shows(results_[i])) shown_.push_back(i);
  std::sort(shown_.begin(), shown_.end(), [this](std::size_t a, std::size_t b) { return before(a, b); });
}

void BatchTable::sort_by(BatchColumn column) {
  descending_ = column == order_ && !descending_;
  order_ = column;
  for (std::size_t i = 0; i < results_.size(); ++i) keys_[i] = key_of(results_[i], order_);
  rebuild();
}

void BatchTable::show_planner(std::string label) {
  planner_ = std::move(label);
  rebuild();
}

void BatchTable::show_status(std::string status) {
  status_ = std::move(status);
  rebuild();
}

std::optional<std::size_t> BatchTable::row_of(std::int64_t run) const {
  for (std::size_t i = 0; i < shown_.size(); ++i)
    if (row(i).run == run) return i;
  return std::nullopt;
}

}  // namespace replan::ui
