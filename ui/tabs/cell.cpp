// The Cell tab: everything that the planner holds of one cell, who wrote it, and what the last replan made of
// it. Why its rhs is what it is stands in cell_why.cpp, its past in cell_past.cpp.
#include <algorithm>
#include <optional>
#include <vector>

#include "core/debug/offers.hpp"
#include "core/debug/open_order.hpp"
#include "core/debug/wave.hpp"
#include "core/lattice/box_words.hpp"
#include "core/trace/search_state.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"
#include "ui/tabs/cell_past.hpp"
#include "ui/tabs/cell_view.hpp"

namespace replan::ui {
namespace {

/// Of a search whose costs rise and fall in waves.
std::pair<const char*, ImU32> wave_state(const Theme& theme, const CellView& view) {
  const Wave wave = wave_of(view.state, view.node);
  const ImU32 colour = wave == Wave::raise   ? theme.warning
                       : wave == Wave::lower ? theme.accent
                       : wave == Wave::fresh ? theme.dim
                                             : theme.text;
  return {wave_name(wave), colour};
}

std::pair<const char*, ImU32> consistency(const Theme& theme, const CellView& view) {
  const Cost g = view.state.g(view.node), rhs = view.state.rhs(view.node);
  if (view.state.known_blocked(view.node)) return {"obstacle", theme.dim};
  if (too_near(view.run.log_view(), view.state, view.node)) return {"too near", theme.dim};
  if (view.run.info().values.waves) return wave_state(theme, view);
  if (!view.lookahead)
    return g.is_infinite()                ? std::pair{"not seen", theme.dim}
           : view.state.queued(view.node) ? std::pair{"open", theme.accent}
                                          : std::pair{"settled", theme.text};
  if (g.is_infinite() && rhs.is_infinite())
    return {view.state.order(view.node) == 0 ? "not seen" : "no value", theme.dim};
  if (g == rhs) return {"consistent", theme.text};
  return g > rhs ? std::pair{"g > rhs", theme.accent} : std::pair{"g < rhs", theme.warning};
}

/// Its place in the open list, counted; empty where that would take long.
std::string rank_text(const CellView& view) {
  constexpr std::size_t kMostNodes = std::size_t{1} << 20;
  if (!view.state.queued(view.node)) return "no";
  if (view.state.node_count() > kMostNodes) return "yes";
  const ListOrder& order = view.run.info().values.order;
  const OpenEntry mine = open_entry(view.state, order, view.node);
  std::size_t rank = 1;
  for (NodeId n = 0; n < view.state.node_count(); ++n) {
    if (n % SearchState::kPage == 0 && !view.state.touched(EventKind::queue, n)) {
      n += static_cast<NodeId>(SearchState::kPage) - 1;
      continue;
    }
    if (view.state.queued(n) && open_entry(view.state, order, n) < mine) ++rank;
  }
  return "yes, #" + std::to_string(rank);
}

/// One value of the block at the top: what it is called, what it is, and which events write it.
struct ValueRow {
  std::string name;
  std::string value;
  EventKind kind;
  ImU32 colour = 0;
  bool strong = false;
};

std::string key_text(const CellView& view) {
  if (!view.state.queued(view.node)) return "—";
  const ListOrder& order = view.run.info().values.order;
  const OpenEntry entry = open_entry(view.state, order, view.node);
  std::string text = cost_text(entry.k1, 1);
  if (view.lookahead || !order.third.empty()) text += " ; " + cost_text(entry.k2, 1);
  if (!order.third.empty()) text += " ; " + cost_text(entry.k3, 1);
  return text;
}

/// The rows of the declared values of one type.
void add_rows(std::vector<ValueRow>& rows, const CellView& view, FieldType type) {
  for (const Field& field : view.run.info().values.fields)
    if (field.shown && field.type == type)
      rows.push_back({std::string(field.label),
                      value_text(view.run.lattice(), field, view.state.value(field.kind, view.node)),
                      field.kind});
}

std::vector<ValueRow> rows_of(const Theme& theme, const CellView& view) {
  const SearchState& state = view.state;
  const auto [state_word, state_colour] = consistency(theme, view);
  const bool marked = state_colour != theme.text && state_colour != theme.dim;
  std::vector<ValueRow> rows;
  add_rows(rows, view, FieldType::cost);
  const SearchValues& declared = view.run.info().values;
  const bool of_parts = view.lookahead || declared.waves;
  rows.push_back({"state", state_word, view.lookahead ? EventKind::rhs : EventKind::g, state_colour, marked});
  rows.push_back({of_parts ? "key" : "f", key_text(view), EventKind::queue});
  rows.push_back({"in U", rank_text(view), EventKind::queue});
  for (const FieldType type : {FieldType::node, FieldType::name, FieldType::count})
    add_rows(rows, view, type);
  if (state.order(view.node) != 0) {
    rows.push_back({"expanded", std::to_string(state.times_expanded(view.node)) + "×", EventKind::visit});
    rows.push_back({"last exp.", "no. " + grouped(std::int64_t{state.order(view.node)}), EventKind::visit});
  }
  return rows;
}

/// Who wrote a value last, as a tooltip, and what a click on it does.
void value_hint(Frame& frame, const CellView& view, const ValueRow& row) {
  const auto written = view.run.timeline().last_event(view.node, {row.kind}, view.run.timeline().cursor());
  const std::string title = row.name + " = " + row.value;
  const GlossaryTerm* term = find_term(row.name);
  const std::string words = (term == nullptr ? "" : std::string(term->text) + "\n\n") +
                            (written ? "Written by event " + grouped(*written + 1) + ", " +
                                           origin_text(frame, *written) + ". Click to go there.\n"
                                     : std::string("Not written yet in this run.\n")) +
                            "Right click for its other changes, to break on it or to watch it.";
  hint(frame.look, {title.c_str(), "", words.c_str()});
  if (!written) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) frame.commands.push_back(Seek{*written + 1});
}

/// The block at the top. A value leads to the event that wrote it, and has a menu; `chosen` is the one whose menu is
/// open.
void values(Frame& frame, const CellView& view, int& chosen) {
  const Look& look = frame.look;
  const std::vector<ValueRow> rows = rows_of(look.theme, view);
  std::vector<KeyValue> pairs;
  for (const ValueRow& row : rows) pairs.push_back({row.name.c_str(), row.value, row.colour, row.strong});
  float name = 0, value = 0;
  for (const KeyValue& pair : pairs) {
    name = std::max(name, text_width(look.fonts.mono, pair.key));
    value = std::max(value, text_width(look.fonts.mono, pair.value));
  }
  // Places of a large world are long.
  const bool beside = 2 * (name + value + 2 * look.px.s) <= ImGui::GetContentRegionAvail().x;
  const int at = key_values(look, pairs, beside ? 2 : 1, Align::left, true);
  if (at >= 0) {
    value_hint(frame, view, rows[static_cast<std::size_t>(at)]);
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
      chosen = at;
      ImGui::OpenPopup("value menu");
    }
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.m, look.px(10)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.s, look.px.menu_gap));
  if (ImGui::BeginPopup("value menu")) {
    const ValueRow& row = rows[std::min(static_cast<std::size_t>(chosen), rows.size() - 1)];
    value_menu_items(frame, row.name.c_str(), row.kind, view.cell);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

/// What the last replan made of the cell's values.
std::string touched_text(const CellView& view, const Touched* mine) {
  if (mine == nullptr) return "did not touch it";
  const auto part = [](const char* name, Cost before, Cost after) {
    return std::string(name) + " " + cost_text(before) + " → " + cost_text(after);
  };
  const bool g = mine->g_before != mine->g_after, rhs = mine->rhs_before != mine->rhs_after;
  if (!g && !rhs) return "touched it, and its values came out the same";
  std::string words = "touched it\n";
  const std::string g_name(view.run.info().values.field(EventKind::g).label);
  if (g) words += part(g_name.c_str(), mine->g_before, mine->g_after);
  if (rhs) words += (g ? "  " : "") + part("rhs", mine->rhs_before, mine->rhs_after);
  return words;
}

/// Whether the last replan came to the cell; its name leads to the list of all that it touched.
void touched_line(Frame& frame, const CellView& view) {
  const Look& look = frame.look;
  const TouchedList* touched = touched_by_last_replan(frame, view.run);
  if (touched == nullptr) return;
  const Touched* mine = touched->find(view.node);
  ImGui::Dummy({0, look.px.xs});
  const ReplanSpan span = *last_replan(view.run);
  const std::string name = "Replan " + grouped(span.number);
  if (link(look, "touched", name, look.fonts.ui)) perform(frame, ActionId::show_touched);
  const std::string all = "It touched " +
                          count_text(static_cast<std::int64_t>(touched->list().size()), "cell", "cells") +
                          (touched->behind() || !span.over ? " so far" : "") + ". Click for all of them.";
  hint(look, {name.c_str(), "", all.c_str()});
  ImGui::SameLine(0, look.px.xs);
  const std::string words = touched_text(view, mine);
  const ImU32 colour = mine == nullptr ? look.theme.faint : look.theme.warning;
  const std::size_t line = words.find('\n');
  text(look.fonts.ui, colour, words.substr(0, line));
  if (line != std::string::npos) text(look.fonts.mono, colour, words.substr(line + 1));
}

/// The lines about the current one, as in the Code tab.
void code_excerpt(Frame& frame) {
  const Result<PlannerPage>& page = page_of(frame.panels, frame.run());
  if (!page) return;
  const PseudoBlock* block = page->block_of(current_line(frame.run()));
  if (block == nullptr) return;
  section_rule(frame.look);
  section_title(frame.look, block->title);
  draw_pseudo_code(frame, *block, 4);
}

/// Where the cell comes from.
std::string origin_of(const Frame& frame, Cell cell) {
  if (frame.view.view.pinned) return "pinned";
  const std::string words = frame.view.view.hovered == cell ? "under the cursor" : "last under the cursor";
  return frame.session.runs().size() == 1 ? words : words + ", in " + std::string(frame.run().info().name);
}

/// The cell, and the button that opens its menu.
void heading(Frame& frame, Cell cell) {
  const Look& look = frame.look;
  section_title(look, "Cell " + cell_text(cell, frame.run().lattice()) + " — " + origin_of(frame, cell));
  const Action& menu = action(ActionId::cell_menu);
  if (const BesideTitle place(look, 1);
      small_button(look, "cell menu", {.icon = icon::angle_down, .hint = menu.hint()}))
    frame.view.menu = cell;
  if (const auto metres = shown_frame(frame.view, frame.session.scenario().map))
    text(look.fonts.mono, look.theme.dim,
         "at " + metres_text(metres->to_metres(centre_of(cell)), frame.run().lattice().solid()));
}

class CellTab final : public SideTab {
  void draw(Frame& frame) override;
  [[nodiscard]] std::size_t pane(const Frame& frame) const override { return frame.cell_pane(); }
  void draw_cell(Frame& frame, Cell cell);

  int chosen_value_ = 0;
  CellPast past_;
  PathBirth leader_birth_;  // of a planner that breeds paths
};

void CellTab::draw(Frame& frame) {
  const std::optional<Cell> cell = frame.cell();
  if (!cell) {
    empty_state(frame.look, icon::crosshairs, "Point at a cell",
                "Its values show here. Click a cell with Select to pin it, then step and watch them change.");
    return;
  }
  frame.asked = frame.cell_pane();
  const std::size_t queued = frame.commands.size();
  draw_cell(frame, *cell);
  // What was clicked is a place in that pane's log.
  if (frame.commands.size() > queued && *frame.asked != frame.session.lead())
    frame.commands.insert(frame.commands.begin() + static_cast<std::ptrdiff_t>(queued), Lead{*frame.asked});
  frame.asked.reset();
}

void CellTab::draw_cell(Frame& frame, Cell cell) {
  const Look& look = frame.look;
  const CellView view(frame.run(), cell);
  heading(frame, cell);
  if (view.run.info().sampling) {
    draw_vertex(frame, view, past_);
    code_excerpt(frame);
    return;
  }
  if (view.run.info().evolving) {
    draw_paths(frame, view, leader_birth_);
    code_excerpt(frame);
    return;
  }
  values(frame, view, chosen_value_);
  touched_line(frame, view);
  section_rule(look);
  draw_why(frame, view);
  section_rule(look);
  past_.draw(frame, cell);
  code_excerpt(frame);
}

}  // namespace

TabKind cell_tab() {
  return {
      .name = "Cell",
      .label = "Cell",
      .icon = icon::crosshairs,
      .chord = fn(3),
      .teach =
          "Why the pinned cell, or the one under the cursor, has the values that it has, and who wrote them.",
      .make = make_part<SideTab, CellTab>,
      .at_first = true};
}

}  // namespace replan::ui
