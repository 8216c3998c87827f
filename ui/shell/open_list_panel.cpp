// The Open list tab: what the planner will take next, in its order, and what the last replan touched.
#include <algorithm>
#include <array>
#include <chrono>

#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kMostIds = std::size_t{1} << 30;  // ImGui's ids are made of ints

/// While it plays, a list that takes long to sort anew is sorted now and then, so that frames keep coming.
void follow(Frame& frame) {
  DebuggerState& state = frame.panels.debugger;
  const Run& run = frame.run();
  const bool plays = frame.session.playback().direction != 0 || run.busy();
  const bool far = state.order.far(run.log_view(), run.log_id());
  constexpr double kShort = 0.004, kShare = 10;
  if (far && plays && state.order_seconds > kShort && ImGui::GetTime() < state.order_due) return;
  const auto begin = std::chrono::steady_clock::now();
  state.order.follow(run.log_view(), run.log_id());
  if (!far) return;
  state.order_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  state.order_due = ImGui::GetTime() + kShare * state.order_seconds;
}

struct StateWord {
  const char* word;
  ImU32 colour;
};
StateWord state_word(const Theme& theme, const Run& run, NodeId node) {
  const SearchState& state = run.timeline().state();
  const Cost g = state.g(node), rhs = state.rhs(node);
  if (run.info().values == SearchValues::best_first) return {"open", theme.accent};
  if (g == rhs) return {"even", theme.dim};  // in the middle of a step
  return g > rhs ? StateWord{"over", theme.accent} : StateWord{"under", theme.warning};
}

void open_row(Frame& frame, std::size_t rank, const OpenEntry& entry, std::span<const Column> columns) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const SearchState& state = run.timeline().state();
  const bool lookahead = run.info().values == SearchValues::lookahead;
  const Cell cell = run.lattice().position(entry.node);
  const std::string number = grouped(rank + 1), at = cell_text(cell), k1 = cost_text(entry.k1, 2),
                    k2 = cost_text(entry.k2, 2), g = cost_text(state.g(entry.node), 2),
                    rhs = cost_text(state.rhs(entry.node), 2);
  const auto [word, colour] = state_word(look.theme, run, entry.node);
  std::vector<TableCell> cells = {{number, look.theme.faint}, {at}, {k1}, {k2}, {g}};
  if (lookahead) {
    cells.push_back({rhs});
    cells.push_back({word, colour});
  }
  const bool pinned = frame.view.view.pinned == cell;
  if (table_row(look, static_cast<int>(rank % kMostIds), columns, cells, pinned)) show_cell(frame, cell);
  point_at(frame, cell);
}

/// The columns for the planner at hand: A* has no rhs, and its list is ordered by f and h.
std::vector<Column> columns_of(const PlannerInfo& info) {
  if (info.values == SearchValues::best_first)
    return {{"rank", 0.9f}, {"cell", 1.5f}, {"f", 1}, {"h", 1}, {"g", 1}};
  return {{"#", 0.75f}, {"cell", 1.35f}, {"k1", 1}, {"k2", 1}, {"g", 1}, {"rhs", 1}, {"", 0.85f}};
}

void open_list(Frame& frame) {
  const Look& look = frame.look;
  follow(frame);
  const OpenOrder& order = frame.panels.debugger.order;
  const Run& run = frame.run();
  if (order.size() == 0) {
    empty_state(look, icon::list, "The open list is empty",
                run.timeline().cursor() == 0 ? "Press " + action(ActionId::step_forward).keys +
                                                   " for the first expansion; vertices that wait show here."
                                             : "No vertex waits: there is nothing left to expand.");
    return;
  }
  const std::string count =
      count_text(static_cast<std::int64_t>(order.size()), "vertex waits", "vertices wait");
  const bool late = order.position() != run.timeline().cursor();
  paragraph(look.fonts.ui, look.theme.dim,
            late ? count + " at event " + grouped(order.position())
                 : count + ", in the order in which they will be taken");
  const std::vector<Column> columns = columns_of(run.info());
  table_head(look, columns);
  const RowsInSight sight = begin_rows(look, "open list", order.size(), 0, frame.panels.debugger.order_rows);
  for (std::size_t rank = sight.first; rank < sight.last; ++rank) open_row(frame, rank, order[rank], columns);
  end_rows();
}

void touched_row(Frame& frame, std::size_t row, const Touched& each, std::span<const Column> columns) {
  const Look& look = frame.look;
  const Cell cell = frame.run().lattice().position(each.node);
  const std::string at = cell_text(cell), g_before = cost_text(each.g_before, 2),
                    g_after = cost_text(each.g_after, 2), rhs_before = cost_text(each.rhs_before, 2),
                    rhs_after = cost_text(each.rhs_after, 2);
  const ImU32 dim = look.theme.dim, faint = look.theme.faint, text = look.theme.text;
  const bool g = each.g_before != each.g_after, rhs = each.rhs_before != each.rhs_after;
  std::vector<TableCell> cells = {{at}, {g_before, g ? dim : faint}, {g_after, g ? text : faint}};
  if (columns.size() > 3) {
    cells.push_back({rhs_before, rhs ? dim : faint});
    cells.push_back({rhs_after, rhs ? text : faint});
  }
  const bool pinned = frame.view.view.pinned == cell;
  if (table_row(look, static_cast<int>(row % kMostIds), columns, cells, pinned)) show_cell(frame, cell);
  point_at(frame, cell);
}

void touched_list(Frame& frame) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const TouchedList* touched = touched_by_last_replan(frame.panels, run);
  if (touched == nullptr) {
    empty_state(look, icon::bolt, "No replan yet",
                "Paint an obstacle, or drop a surprise in the robot's way: the vertices that the repair "
                "touches are listed here.");
    return;
  }
  const ReplanSpan span = *last_replan(run);
  const auto count = static_cast<std::int64_t>(touched->list().size());
  ImGui::AlignTextToFramePadding();
  text(look.fonts.ui, look.theme.dim,
       "Replan " + grouped(span.number) + " touched " + count_text(count, "vertex", "vertices"));
  const float right = ImGui::GetContentRegionMax().x;
  ImGui::SameLine(right - look.px(52));
  if (small_button(look, "before", {.icon = icon::caret_left, .hint = action(ActionId::replan_back).hint()}))
    perform(frame, ActionId::replan_back);
  ImGui::SameLine(0, look.px.xs);
  if (small_button(look, "next",
                   {.icon = icon::caret_right, .hint = action(ActionId::replan_forward).hint()}))
    perform(frame, ActionId::replan_forward);
  if (touched->list().empty()) {
    paragraph(look.fonts.ui, look.theme.dim,
              "The change was of no consequence for any vertex: the plan stands as it was.");
    return;
  }
  std::vector<Column> columns = {{"cell", 1.3f, Align::left}, {"g"}, {"→ g"}};
  if (run.info().values == SearchValues::lookahead)
    columns.insert(columns.end(), {Column{"rhs"}, Column{"→ rhs"}});
  table_head(look, columns);
  const RowsInSight sight =
      begin_rows(look, "touched", touched->list().size(), 0, frame.panels.debugger.touched_rows);
  for (std::size_t row = sight.first; row < sight.last; ++row)
    touched_row(frame, row, touched->list()[row], columns);
  end_rows();
}

}  // namespace

void draw_open_list_panel(Frame& frame) {
  static constexpr std::array<const char*, 2> kParts = {"Open list U", "Touched by the last replan"};
  int part = frame.panels.debugger.repair ? 1 : 0;
  if (segments(frame.look, "part", kParts, part)) frame.panels.debugger.repair = part == 1;
  ImGui::Dummy({0, frame.look.px.xs});
  if (frame.panels.debugger.repair)
    touched_list(frame);
  else
    open_list(frame);
}

}  // namespace replan::ui
