#include "ui/batch/batch_view.hpp"

#include <algorithm>
#include <array>

#include "core/study/figures_table.hpp"
#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/shell/dialogs/parts.hpp"
#include "ui/shell/format.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kMostSummaryRows = 6;
constexpr const char* kOpensRuns = "; a click on one opens it in the debugger";

struct SummaryColumn {
  SummaryFigure figure;
  const char* name;
  int decimals;
  float room;  // BatchColumnInfo::room
};
constexpr std::array kSummaryColumns = {
    SummaryColumn{SummaryFigure::length, "length  cells", 3, 0},
    SummaryColumn{SummaryFigure::turns, "turns", 1, kRoomForAll},
    SummaryColumn{SummaryFigure::clearance, "clearance  cells", 2, kRoomForAll},
    SummaryColumn{SummaryFigure::expansions, "expansions", 0, kRoomForMost},
    SummaryColumn{SummaryFigure::time, "time  ms", 2, 0}};

/// The median, and behind it, if there is room, its ratio to the first planner's.
std::string summary_text(const PlannerSummary& planner, const PlannerSummary& first,
                         const SummaryColumn& column, bool with_ratio) {
  const auto median = planner.median(column.figure);
  if (!median) return "–";
  const std::string value = column.decimals > 0 ? fixed(*median, column.decimals)
                                                : grouped(static_cast<std::int64_t>(*median + 0.5));
  const auto ratio = planner.ratio(column.figure, first);
  return &planner == &first || !ratio || !with_ratio ? value : value + "  " + ratio_text(*ratio);
}

bool has_room(const Look& look, float wanted) {
  return ImGui::GetContentRegionAvail().x >= look.px(wanted);
}

/// Those that there is room for.
std::vector<SummaryColumn> summary_columns(const Look& look) {
  std::vector<SummaryColumn> columns;
  for (const SummaryColumn& each : kSummaryColumns)
    if (has_room(look, each.room)) columns.push_back(each);
  return columns;
}
std::vector<BatchColumn> batch_columns(const Look& look) {
  std::vector<BatchColumn> columns;
  for (std::size_t i = 0; i < kBatchColumns; ++i)
    if (const auto column = static_cast<BatchColumn>(i); has_room(look, info_of(column).room))
      columns.push_back(column);
  return columns;
}

std::vector<Column> layout_of(std::span<const BatchColumn> columns) {
  std::vector<Column> layout;
  for (const BatchColumn column : columns) {
    const BatchColumnInfo& info = info_of(column);
    layout.push_back({info.name, info.width, info.words ? Align::left : Align::right});
  }
  return layout;
}

ImU32 colour_of(const Theme& theme, const BatchRow& run, BatchColumn column) {
  if (column == BatchColumn::status && !run.succeeded) return theme.warning;
  return info_of(column).words || column == BatchColumn::run ? theme.dim : theme.text;
}

/// One of some texts, or none of them in particular; whether another was chosen.
bool choose_one(const Look& look, const char* id, const char* all, std::span<const std::string> texts,
                std::string& chosen) {
  std::vector<const char*> names = {all};
  int current = 0;
  for (const std::string& each : texts) {
    if (each == chosen) current = static_cast<int>(names.size());
    names.push_back(each.c_str());
  }
  if (!combo(look, id, names, current)) return false;
  chosen = current == 0 ? "" : texts[static_cast<std::size_t>(current - 1)];
  return true;
}

}  // namespace

void BatchView::clear() {
  *this = BatchView();
}

void BatchView::draw_summaries(const Look& look) {
  const std::vector<SummaryColumn> figures = summary_columns(look);
  const bool roomy = has_room(look, kRoomForMost);
  std::vector<Column> columns = {
      {roomy ? "medians of each planner" : "medians", roomy ? 290.0f : 220.0f, Align::left}, {"found", 160}};
  for (const SummaryColumn& each : figures) columns.push_back({each.name, 160});
  const std::span<const PlannerSummary> all = table_.summaries();
  table_header(look, columns);
  hint(
      look,
      {"What each planner came to", "",
       "Medians of the runs that reached the goal, and how many times those of the first planner they are."});
  const float height =
      look.px.row * static_cast<float>(std::clamp<std::size_t>(all.size(), 1, kMostSummaryRows));
  const auto [first, last] = begin_rows(look, "summaries", all.size(), height, summary_scroll_);
  for (std::size_t i = first; i < last; ++i) {
    std::vector<std::string> texts = {all[i].label(),
                                      grouped(all[i].found()) + " of " + grouped(all[i].runs())};
    for (const SummaryColumn& each : figures) texts.push_back(summary_text(all[i], all[0], each, roomy));
    std::vector<TableCell> cells;
    for (const std::string& each : texts) cells.push_back({each});
    const bool on = table_.planner() == all[i].label();
    if (table_row(look, static_cast<int>(i), columns, cells, on))
      table_.show_planner(on ? "" : all[i].label());
    hint(look,
         {all[i].label().c_str(), "", "Click to show its runs alone; once more, and all are shown again."});
  }
  end_rows();
}

void BatchView::draw_filters(const Look& look) {
  std::vector<std::string> planners;
  for (const PlannerSummary& each : table_.summaries()) planners.push_back(each.label());
  std::string planner = table_.planner(), status = table_.status();
  if (choose_one(look, "##planner", "All planners", planners, planner)) table_.show_planner(planner);
  ImGui::SameLine(0, look.px.s);
  if (choose_one(look, "##status", "Any status", table_.statuses(), status)) table_.show_status(status);
  const std::string words = (table_.shown() == table_.count()
                                 ? count_text(static_cast<std::int64_t>(table_.count()), "run", "runs")
                                 : grouped(table_.shown()) + " of " + grouped(table_.count()) + " runs") +
                            kOpensRuns;
  flow(look, look.px.xs + text_width(look.fonts.ui, words));
  ImGui::AlignTextToFramePadding();
  text(look.fonts.ui, look.theme.dim, words);
}

/// A click on a column's name sorts by it; the column in force has an arrow.
void BatchView::draw_header(const Look& look) {
  const std::vector<BatchColumn> columns = batch_columns(look);
  std::vector<Column> layout = layout_of(columns);
  std::vector<std::string> names;
  for (const BatchColumn each : columns)
    names.push_back(batch_heading(each) + (each != table_.order() ? "" : table_.descending() ? " ↓" : " ↑"));
  for (std::size_t i = 0; i < columns.size(); ++i) layout[i].name = names[i].c_str();
  const int at = table_header(look, layout);
  if (at < 0) return;
  const BatchColumn column = columns[static_cast<std::size_t>(at)];
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const std::string teach =
      std::string(info_of(column).help) + " Click to sort; once more, the other way round.";
  hint(look, {info_of(column).title, "", teach.c_str()});
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) table_.sort_by(column);
}

std::optional<std::int64_t> BatchView::take_keys(const Look& look, float height) {
  if (table_.shown() == 0 || open_lists() > 0 || ImGui::IsAnyItemActive()) return std::nullopt;
  const bool enters = selected_ && enter_pressed();
  const int by = (ImGui::IsKeyPressed(key::kDown) ? 1 : 0) - (ImGui::IsKeyPressed(key::kUp) ? 1 : 0);
  if (by == 0 && !enters) return std::nullopt;
  const auto at = selected_ ? table_.row_of(*selected_) : std::nullopt;
  if (enters) return at ? selected_ : std::nullopt;
  const auto last = static_cast<std::ptrdiff_t>(table_.shown()) - 1;
  const std::ptrdiff_t next =
      at ? std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(*at) + by, 0, last) : 0;
  selected_ = table_.row(static_cast<std::size_t>(next)).run;
  reveal_row(look, static_cast<std::size_t>(next), table_.shown(), height, scroll_);
  return std::nullopt;
}

std::optional<std::int64_t> BatchView::draw_rows(const Look& look, float height) {
  std::optional<std::int64_t> chosen = take_keys(look, height);
  const std::vector<BatchColumn> columns = batch_columns(look);
  const std::vector<Column> layout = layout_of(columns);
  const auto [first, last] = begin_rows(look, "runs", table_.shown(), height, scroll_);
  for (std::size_t i = first; i < last; ++i) {
    const BatchRow& run = table_.row(i);
    std::vector<std::string> texts;
    for (const BatchColumn column : columns) texts.push_back(table_.text(i, column));
    std::vector<TableCell> cells;
    for (std::size_t c = 0; c < columns.size(); ++c)
      cells.push_back({texts[c], colour_of(look.theme, run, columns[c])});
    if (table_row(look, static_cast<int>(i), layout, cells, selected_ == run.run)) {
      selected_ = run.run;
      chosen = run.run;
    }
    if (!ImGui::IsItemHovered()) continue;
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    hint(look, {"Open the run", "Enter", "Click to open this run in the debugger."});
  }
  end_rows();
  return chosen;
}

std::optional<std::int64_t> BatchView::draw(const Look& look, float height) {
  const float top = ImGui::GetCursorPosY();
  draw_summaries(look);
  ImGui::Dummy({0, look.px.xs});
  draw_filters(look);
  ImGui::Dummy({0, look.px(2)});
  draw_header(look);
  const float rest = std::max(height - (ImGui::GetCursorPosY() - top), look.px.row * 3);
  if (table_.shown() > 0) return draw_rows(look, rest);
  ImGui::BeginChild("empty", {0, rest});
  if (table_.count() == 0)
    empty_state(look, icon::table, "No run is done yet", "Each has its row here as soon as it is.");
  else
    empty_state(look, icon::filter, "No such runs", "Choose another planner or status above.");
  ImGui::EndChild();
  return std::nullopt;
}

}  // namespace replan::ui
