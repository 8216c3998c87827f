#include "ui/batch/batch_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/file.hpp"
#include "ui/documents/file_list.hpp"
#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

constexpr std::array<BatchColumnInfo, kBatchColumns> kInfos = {
    {{"run", "", "Run", "Its number. The same experiment gives the same run the same number everywhere.", 80,
      false, kRoomForMost},
     {"world", "", "World", "The file of its world, and the line of its problem where that has several.", 88,
      true, kRoomForAll},
     {"planner", "", "Planner", "Who planned, with settings that are not the usual ones.", 190, true, 0},
     {"surprises", "", "Surprises", "What happens while the robot drives.", 188, true, kRoomForAll},
     {"seed", "", "Seed", "What chance was drawn from.", 52, false, kRoomForAll},
     {"status", "", "Status", "How the run ended.", 80, true, kRoomForMost},
     {"length", "cells", "Length",
      "Of the way that was driven, or of the path. In cells, also where the map says how many metres a cell "
      "is.",
      132, false, 0, 3},
     {"turns", "", "Turns", "How often the first plan's path changes its direction.", 66, false, kRoomForAll},
     {"clearance", "cells", "Clearance",
      "To the nearest obstacle, where the way, or the path, comes closest. In cells.", 156, false,
      kRoomForAll, 2},
     {"expansions", "", "Expansions",
      "Cells that were expanded, samples that were drawn or children that were bred, in all plans of the run "
      "together.",
      108, false, kRoomForMost},
     {"replans", "", "Replans", "How often the robot had to plan again.", 80, false, kRoomForAll},
     {"time", "ms", "Time",
      "Milliseconds of planning and replanning; of repeats the median. Jobs disturb each other's.", 92, false,
      0, 2}}};

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

double number_of(const RunResult& run, BatchColumn column) {
  const auto figure = [&run](SummaryFigure which) { return summary_figure(run, which).value_or(kNoNumber); };
  switch (column) {
    case BatchColumn::length:
      return figure(SummaryFigure::length);
    case BatchColumn::turns:
      return figure(SummaryFigure::turns);
    case BatchColumn::clearance:
      return figure(SummaryFigure::clearance);
    case BatchColumn::expansions:
      return run.figure("expansions").value_or(kNoNumber);
    case BatchColumn::replans:
      return run.figure("replans").value_or(kNoNumber);
    case BatchColumn::time:
      return figure(SummaryFigure::time);
    default:
      return kNoNumber;
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

constexpr std::array kWordColumns = {BatchColumn::world, BatchColumn::planner, BatchColumn::surprises,
                                     BatchColumn::status};

/// Which of a row's words stands in the column.
std::size_t word_number(BatchColumn column) {
  return static_cast<std::size_t>(std::find(kWordColumns.begin(), kWordColumns.end(), column) -
                                  kWordColumns.begin());
}

BatchColumn number_column(std::size_t number) {
  return static_cast<BatchColumn>(static_cast<std::size_t>(BatchColumn::length) + number);
}

}  // namespace

const BatchColumnInfo& info_of(BatchColumn column) {
  return kInfos[static_cast<std::size_t>(column)];
}

std::string batch_heading(BatchColumn column) {
  const BatchColumnInfo& info = info_of(column);
  return *info.unit == '\0' ? info.name : std::string(info.name) + "  " + info.unit;
}

std::optional<double> BatchRow::number(BatchColumn column) const {
  if (column == BatchColumn::run) return static_cast<double>(run);
  if (column == BatchColumn::seed) return static_cast<double>(seed);
  if (info_of(column).words) return std::nullopt;
  const double value =
      numbers[static_cast<std::size_t>(column) - static_cast<std::size_t>(BatchColumn::length)];
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::string BatchTable::text(std::size_t index, BatchColumn column) const {
  const BatchRow& shown = row(index);
  const BatchColumnInfo& info = info_of(column);
  if (info.words) return words_[shown.words[word_number(column)]];
  if (column == BatchColumn::seed) return std::to_string(shown.seed);
  const auto number = shown.number(column);
  if (!number) return {};
  return info.decimals > 0 ? fixed(*number, info.decimals)
                           : grouped(static_cast<std::int64_t>(*number + 0.5));
}

void BatchTable::clear() {
  *this = BatchTable();
}

bool BatchTable::shows(const BatchRow& row) const {
  return (status_.empty() || words_[row.words[word_number(BatchColumn::status)]] == status_) &&
         (planner_.empty() || words_[row.words[word_number(BatchColumn::planner)]] == planner_);
}

BatchTable::Key BatchTable::key_of(std::uint32_t place) const {
  const BatchRow& row = rows_[place];
  if (info_of(order_).words)
    return {static_cast<double>(word_ranks_[row.words[word_number(order_)]]), row.run, place};
  return {row.number(order_).value_or(kNoNumber), row.run, place};
}

bool BatchTable::before(const Key& a, const Key& b) const {
  const bool none = std::isnan(a.value);
  if (none != std::isnan(b.value)) return !none;
  if (!none && a.value != b.value) return (a.value < b.value) != descending_;
  return a.run < b.run;
}

std::uint32_t BatchTable::word(const std::string& text) {
  const auto [at, fresh] = word_places_.try_emplace(text, static_cast<std::uint32_t>(words_.size()));
  if (fresh) words_.push_back(text);
  return at->second;
}

/// Those that are new come to their places in natural order, and all ranks with them: which of two is the lower one stays.
void BatchTable::rank_words() {
  const auto less = [this](std::uint32_t a, std::uint32_t b) { return natural_less(words_[a], words_[b]); };
  for (auto place = static_cast<std::uint32_t>(sorted_words_.size()); place < words_.size(); ++place)
    sorted_words_.insert(std::upper_bound(sorted_words_.begin(), sorted_words_.end(), place, less), place);
  word_ranks_.resize(words_.size());
  for (std::uint32_t rank = 0; rank < sorted_words_.size(); ++rank) word_ranks_[sorted_words_[rank]] = rank;
}

void BatchTable::add(const std::vector<RunResult>& results) {
  std::vector<std::uint32_t> fresh;
  for (const RunResult& result : results) {
    summaries_.add(result);
    if (std::find(statuses_.begin(), statuses_.end(), result.status) == statuses_.end())
      statuses_.push_back(result.status);
    BatchRow row{.run = result.run, .seed = result.name.seed, .succeeded = result.succeeded};
    for (std::size_t i = 0; i < kWordColumns.size(); ++i)
      row.words[i] = word(words_of(result, kWordColumns[i]));
    for (std::size_t i = 0; i < row.numbers.size(); ++i) row.numbers[i] = number_of(result, number_column(i));
    rows_.push_back(row);
    if (shows(row)) fresh.push_back(static_cast<std::uint32_t>(rows_.size() - 1));
  }
  if (word_ranks_.size() < words_.size()) rank_words();
  merge(std::move(fresh));
}

/// A few among many: from the last one on, each finds its place by halving, and what is behind that moves on once.
void BatchTable::merge(std::vector<std::uint32_t> fresh) {
  const auto less = [this](std::uint32_t a, std::uint32_t b) { return before(key_of(a), key_of(b)); };
  std::sort(fresh.begin(), fresh.end(), less);
  auto old = static_cast<std::ptrdiff_t>(shown_.size());
  shown_.resize(shown_.size() + fresh.size());
  auto end = static_cast<std::ptrdiff_t>(shown_.size());
  const auto begin = shown_.begin();
  for (std::size_t i = fresh.size(); i-- > 0;) {
    const auto at = std::upper_bound(begin, begin + old, fresh[i], less) - begin;
    std::move_backward(begin + at, begin + old, begin + end);
    end -= old - at + 1;
    old = at;
    begin[end] = fresh[i];
  }
}

/// By keys that lie side by side: in so many rows each look into a row costs more than the comparison.
void BatchTable::rebuild() {
  std::vector<Key> keys;
  keys.reserve(rows_.size());
  for (std::uint32_t place = 0; place < rows_.size(); ++place)
    if (shows(rows_[place])) keys.push_back(key_of(place));
  std::sort(keys.begin(), keys.end(), [this](const Key& a, const Key& b) { return before(a, b); });
  shown_.resize(keys.size());
  std::transform(keys.begin(), keys.end(), shown_.begin(), [](const Key& key) { return key.row; });
}

void BatchTable::sort_by(BatchColumn column) {
  descending_ = column == order_ && !descending_;
  order_ = column;
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
