#include "ui/tabs/open_list.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "core/debug/wave.hpp"
#include "core/lattice/box_words.hpp"
#include "ui/canvas/kept_words.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"

namespace replan::ui {
namespace {

/// Of more cells that changed at once these are listed: reading them must not hold up a frame.
constexpr std::size_t kMostChanged = 20'000;
constexpr std::size_t kMostIds = std::size_t{1} << 30;  // ImGui's ids are made of ints

struct StateWord {
  const char* word;
  ImU32 colour;
};
StateWord state_word(const Theme& theme, const Run& run, NodeId node) {
  const SearchState& state = run.timeline().state();
  const Cost g = state.g(node), rhs = state.rhs(node);
  if (run.info().values.waves) {
    const Wave wave = wave_of(state, node);
    return {wave_name(wave), wave == Wave::raise ? theme.warning : theme.accent};
  }
  if (!run.info().values.lookahead()) return {"open", theme.accent};
  if (g == rhs) return {"even", theme.dim};  // in the middle of a step
  return g > rhs ? StateWord{"g > rhs", theme.accent} : StateWord{"g < rhs", theme.warning};
}

/// What a row shows: as much as there is room for, whatever the size of the world and of the list.
struct OpenListLayout {
  std::vector<Column> columns = {};
  int decimals = 2;
  bool state = true;  ///< which of both is less, in words; g and rhs side by side tell it too
};

std::string widest_cell(const Run& run) {
  const Box& world = run.lattice();
  return cell_text({world.width() - 1, world.height() - 1, world.depth() - 1}, world);
}

/// The rows that a list is about to show: its columns are as wide as what stands in them.
RowsInSight rows_ahead(const Look& look, const RowScroll& scroll, std::size_t count) {
  const auto first = std::min(static_cast<std::size_t>(scroll.first), count - 1);
  const auto rows = static_cast<std::size_t>(ImGui::GetContentRegionAvail().y / look.px.row) + 2;
  return {first, std::min(first + rows, count)};
}

/// What those columns are called.
std::vector<const char*> cost_names(const SearchValues& values) {
  std::vector<const char*> names = {values.field(EventKind::queue).label.data()};
  for (const std::string_view part : {values.order.second, values.order.third})
    if (!part.empty()) names.push_back(part.data());
  names.push_back(values.field(EventKind::g).label.data());
  if (values.lookahead()) names.push_back("rhs");
  return names;
}

/// The costs of a row, in the order of their columns.
std::vector<Cost> costs_of(const Run& run, const OpenEntry& entry) {
  const SearchState& state = run.timeline().state();
  const ListOrder& order = run.info().values.order;
  std::vector<Cost> costs = {entry.k1};
  if (!order.second.empty()) costs.push_back(entry.k2);
  if (!order.third.empty()) costs.push_back(entry.k3);
  costs.push_back(state.g(entry.node));
  if (run.info().values.lookahead()) costs.push_back(state.rhs(entry.node));
  return costs;
}

/// The most letters that each column of costs shows in these rows.
std::vector<std::size_t> widest_costs(const Run& run, const OpenOrder& order, RowsInSight rows,
                                      int decimals) {
  std::vector<std::size_t> widest(cost_names(run.info().values).size(), 3);
  for (std::size_t rank = rows.first; rank < rows.last; ++rank) {
    const std::vector<Cost> costs = costs_of(run, order[rank]);
    for (std::size_t i = 0; i < costs.size(); ++i)
      widest[i] = std::max(widest[i], cost_text(costs[i], decimals).size());
  }
  return widest;
}

/// Columns as wide as the widest that stands in them in sight: where there is no room for all the state in words gives
/// way, which g and rhs side by side tell too, then decimals.
OpenListLayout open_list_layout(const Look& look, const Run& run, const OpenOrder& order, RowsInSight rows) {
  const bool lookahead = run.info().values.lookahead();
  const float digit = text_width(look.fonts.mono, "0"), padding = look.px(12);
  const float room = ImGui::GetContentRegionAvail().x;
  const auto chars = [digit, padding](std::size_t count) {
    return digit * static_cast<float>(count) + padding;
  };
  OpenListLayout layout;
  layout.state = lookahead || run.info().values.waves;
  const float rank = chars(grouped(order.size()).size()), cell = chars(widest_cell(run).size()),
              state = chars(std::string_view("g > rhs").size());
  std::vector<std::size_t> costs = widest_costs(run, order, rows, layout.decimals);
  const auto whole = [&] {
    float width = rank + cell + (layout.state ? state : 0.0f);
    for (const std::size_t each : costs) width += chars(each);
    return width;
  };
  if (whole() > room) layout.state = false;
  while (whole() > room && layout.decimals > 0) costs = widest_costs(run, order, rows, --layout.decimals);
  layout.columns = {{"#", rank}, {"cell", cell}};
  const std::vector<const char*> names = cost_names(run.info().values);
  for (std::size_t i = 0; i < costs.size(); ++i) layout.columns.push_back({names[i], chars(costs[i])});
  if (layout.state) layout.columns.push_back({"state", state});
  return layout;
}

void open_row(Frame& frame, std::size_t rank, const OpenEntry& entry, const OpenListLayout& layout) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const Cell cell = run.lattice().position(entry.node);
  const std::string number = grouped(rank + 1), at = cell_text(cell, run.lattice());
  std::vector<std::string> costs;
  for (const Cost value : costs_of(run, entry)) costs.push_back(cost_text(value, layout.decimals));
  const auto [word, colour] = state_word(look.theme, run, entry.node);
  std::vector<TableCell> cells = {{number, look.theme.faint}, {at}};
  for (const std::string& cost : costs) cells.push_back({cost});
  if (layout.state) cells.push_back({word, colour});
  const bool pinned = frame.view.view.pinned == cell;
  if (table_row(look, static_cast<int>(rank % kMostIds), layout.columns, cells, pinned))
    show_cell(frame, cell);
  point_at(frame, cell);
}

/// How the list of a repair's cells lies.
struct TouchedLayout {
  std::vector<Column> columns = {};
  int decimals = 2;
};

/// The cells whole, and the costs in what is left, where decimals give way.
TouchedLayout touched_layout(const Look& look, const Run& run, std::span<const Touched> in_sight) {
  const bool lookahead = run.info().values.lookahead(), waves = run.info().values.waves;
  const float gap = look.px(12), cell = text_width(look.fonts.mono, widest_cell(run)) + gap;
  const float cost = (ImGui::GetContentRegionAvail().x - cell) / (lookahead ? 4 : 2);
  TouchedLayout layout{
      .columns = {{"cell", cell, Align::left}, {waves ? "h" : "g", cost}, {waves ? "→h" : "→g", cost}}};
  if (lookahead) layout.columns.insert(layout.columns.end(), {Column{"rhs", cost}, Column{"→rhs", cost}});
  const auto fits = [&](Cost value) {
    return text_width(look.fonts.mono, cost_text(value, layout.decimals)) + gap <= cost;
  };
  const auto all_fit = [&](const Touched& each) {
    return fits(each.g_before) && fits(each.g_after) && fits(each.rhs_before) && fits(each.rhs_after);
  };
  while (layout.decimals > 0 && !std::all_of(in_sight.begin(), in_sight.end(), all_fit)) --layout.decimals;
  return layout;
}

void touched_row(Frame& frame, std::size_t row, const Touched& each, const TouchedLayout& layout) {
  const Look& look = frame.look;
  const Cell cell = frame.run().lattice().position(each.node);
  const auto cost = [&layout](Cost value) { return cost_text(value, layout.decimals); };
  const std::string at = cell_text(cell, frame.run().lattice()), g_before = cost(each.g_before),
                    g_after = cost(each.g_after), rhs_before = cost(each.rhs_before),
                    rhs_after = cost(each.rhs_after);
  const ImU32 dim = look.theme.dim, faint = look.theme.faint, text = look.theme.text;
  const bool g = each.g_before != each.g_after, rhs = each.rhs_before != each.rhs_after;
  std::vector<TableCell> cells = {{at}, {g_before, g ? dim : faint}, {g_after, g ? text : faint}};
  if (layout.columns.size() > 3) {
    cells.push_back({rhs_before, rhs ? dim : faint});
    cells.push_back({rhs_after, rhs ? text : faint});
  }
  const bool pinned = frame.view.view.pinned == cell;
  if (table_row(look, static_cast<int>(row % kMostIds), layout.columns, cells, pinned))
    show_cell(frame, cell);
  point_at(frame, cell);
}

/// The words above a list of a replan, and the ways to the others.
void repair_head(Frame& frame, const std::string& words) {
  const Look& look = frame.look;
  ImGui::AlignTextToFramePadding();
  text(look.fonts.ui, look.theme.dim, words);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 2 * look.px.small - look.px.xs);
  if (small_button(look, "before", {.icon = icon::caret_left, .hint = action(ActionId::replan_back).hint()}))
    perform(frame, ActionId::replan_back);
  ImGui::SameLine(0, look.px.xs);
  if (small_button(look, "next",
                   {.icon = icon::caret_right, .hint = action(ActionId::replan_forward).hint()}))
    perform(frame, ActionId::replan_forward);
}

std::pair<const char*, ImU32> change_words(const Theme& theme, ChangeKind kind) {
  switch (kind) {
    case ChangeKind::surprise:
      return {"blocked: a surprise", theme.warning};
    case ChangeKind::moving:
      return {"blocked: something moves", theme.text};
    case ChangeKind::wall:
      return {"blocked: not on its map", theme.text};
    case ChangeKind::free:
      return {"free", theme.good};
    case ChangeKind::forgotten:
      return {"forgotten: out of sight", theme.dim};
  }
  return {"", theme.text};
}

std::string changed_words(std::uint64_t replan, std::size_t cells) {
  const std::string number = grouped(replan);
  if (cells == 0) return "Replan " + number + ": no cell is another than the map said.";
  if (cells == 1) return "Replan " + number + ": one cell was another than the map said.";
  const std::string count = grouped(static_cast<std::int64_t>(cells));
  return cells < kMostChanged
             ? "Replan " + number + ": " + count + " cells were others than the map said."
             : "Replan " + number + ": the last " + count + " cells that were others than the map said.";
}

void changed_row(Frame& frame, std::size_t row, const ChangedCell& each, std::span<const Column> columns) {
  const Look& look = frame.look;
  const Cell cell = frame.run().lattice().position(each.node);
  const std::string at = cell_text(cell, frame.run().lattice());
  const auto [words, colour] = change_words(look.theme, each.kind);
  const std::string now = words;
  const std::vector<TableCell> cells = {{at}, {now, colour}};
  if (table_row(look, static_cast<int>(row % kMostIds), columns, cells, frame.view.view.pinned == cell))
    show_cell(frame, cell);
  point_at(frame, cell);
}

}  // namespace

/// While it plays, a list that takes long to sort anew is sorted now and then, so that frames keep coming.
void OpenListTab::follow(const Frame& frame) {
  const Run& run = frame.run();
  const bool plays = frame.session.playback().direction != 0 || run.busy();
  const bool far = order_.far(run.log_view(), run.log_id());
  constexpr double kShort = 0.004, kShare = 10;
  if (far && plays && order_seconds_ > kShort && ImGui::GetTime() < order_due_) return;
  const auto begin = std::chrono::steady_clock::now();
  order_.follow(run.log_view(), run.log_id());
  if (!far) return;
  order_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  order_due_ = ImGui::GetTime() + kShare * order_seconds_;
}

void OpenListTab::draw_open_list(Frame& frame) {
  if (lists_nothing(frame)) return;
  const Look& look = frame.look;
  follow(frame);
  const Run& run = frame.run();
  if (order_.size() == 0) {
    const bool searching = run.busy() && run.decisions().empty();
    empty_state(look, icon::list, "The open list is empty",
                searching ? "The planner is still setting up its search; cells that wait show here."
                : run.timeline().cursor() == 0 ? "Press " + action(ActionId::step_forward).keys +
                                                     " for the first expansion; cells that wait show here."
                                               : "No cell waits: there is nothing left to expand.");
    return;
  }
  const std::string count = count_text(static_cast<std::int64_t>(order_.size()), "cell waits", "cells wait");
  const bool late = order_.position() != run.timeline().cursor();
  paragraph(look.fonts.ui, look.theme.dim,
            late ? count + " at event " + grouped(order_.position()) : count + "; the first is taken next");
  const OpenListLayout layout =
      open_list_layout(look, run, order_, rows_ahead(look, order_rows_, order_.size()));
  table_head(look, layout.columns);
  const RowsInSight sight = begin_rows(look, "open list", order_.size(), 0, order_rows_);
  for (std::size_t rank = sight.first; rank < sight.last; ++rank) open_row(frame, rank, order_[rank], layout);
  end_rows();
}

void OpenListTab::draw_touched(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const TouchedList* touched = touched_by_last_replan(frame, run);
  if (touched == nullptr) {
    empty_state(look, icon::bolt, "No replan yet",
                run.info().values.lists()
                    ? "Paint an obstacle, or drop a surprise in the robot's way: the cells that the repair "
                      "touches are listed here."
                    : "Paint an obstacle, or drop a surprise in the robot's way: what the repair keeps and "
                      "what it loses is told here.");
    return;
  }
  const ReplanSpan span = *last_replan(run);
  if (const KeptInReplan* kept = kept_by_last_replan(frame)) {
    repair_head(frame, "Replan " + grouped(span.number));
    return draw_lost(frame, *kept, touched_rows_);
  }
  const auto count = static_cast<std::int64_t>(touched->list().size());
  repair_head(frame, "Replan " + grouped(span.number) + " touched " + count_text(count, "cell", "cells") +
                         (touched->behind() || !span.over ? " so far" : ""));
  if (touched->list().empty()) {
    paragraph(look.fonts.ui, look.theme.dim,
              span.over ? "The change made no difference to any cell: the plan is the same as before."
                        : "The playhead is in the midst of it, and no cell has been touched yet.");
    return;
  }
  const RowsInSight ahead = rows_ahead(look, touched_rows_, touched->list().size());
  const TouchedLayout layout =
      touched_layout(look, run, std::span(touched->list()).subspan(ahead.first, ahead.last - ahead.first));
  table_head(look, layout.columns);
  const RowsInSight sight = begin_rows(look, "touched", touched->list().size(), 0, touched_rows_);
  for (std::size_t row = sight.first; row < sight.last; ++row)
    touched_row(frame, row, touched->list()[row], layout);
  end_rows();
}

/// Every cell that made the robot plan again.
void OpenListTab::draw_changed(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const auto span = last_replan(run);
  if (!span) {
    empty_state(
        look, icon::bolt, "No replan yet",
        "Once the robot sees that the world is another than its map, the cells that differ are listed "
        "here.");
    return;
  }
  const std::pair of{run.log_id(), span->begin};
  if (changed_of_ != of)
    changed_ = changes_before(run.log_view(), span->begin, run.scenario().map.blocked, kMostChanged);
  changed_of_ = of;
  paragraph(look.fonts.ui, look.theme.dim, changed_words(span->number, changed_.size()));
  if (const KeptInReplan* kept = kept_by_last_replan(frame))
    paragraph(look.fonts.ui, look.theme.text,
              kept_sentence(run.info().values, kept->counts_before(run.timeline().cursor())));
  if (changed_.empty()) return;
  const float cell = text_width(look.fonts.mono, widest_cell(run)) + look.px(12);
  const std::array<Column, 2> columns = {Column{"cell", cell, Align::left},
                                         Column{"now", ImGui::GetContentRegionAvail().x - cell, Align::left}};
  table_head(look, columns);
  const RowsInSight sight = begin_rows(look, "changed", changed_.size(), 0, changed_rows_);
  for (std::size_t row = sight.first; row < sight.last; ++row)
    changed_row(frame, row, changed_[row], columns);
  end_rows();
}

void OpenListTab::draw(Frame& frame) {
  static constexpr std::array<const char*, 3> kParts = {"Open list", "Last repair", "What changed"};
  int part = static_cast<int>(part_);
  if (segments(frame.look, "part", kParts, part)) part_ = static_cast<Part>(part);
  ImGui::Dummy({0, frame.look.px.xs});
  if (part_ == Part::repair)
    draw_touched(frame);
  else if (part_ == Part::change)
    draw_changed(frame);
  else
    draw_open_list(frame);
}

void show_touched(ViewState& view, PanelState& panels) {
  show_tab(view, panels, "open_list");
  show_last_repair(view.view.overlays);
  panels.tabs.get<OpenListTab>().show_repair();
}

TabKind open_list_tab() {
  return {.name = "Open list",
          .label = "Open list",
          .icon = icon::list,
          .chord = fn(4),
          .teach = "The cells that wait, in the order in which the planner will take them.",
          .make = make_part<SideTab, OpenListTab>};
}

}  // namespace replan::ui
