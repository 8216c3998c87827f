#include "ui/tabs/cell_past.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/debug/event_words.hpp"
#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"
#include "ui/shell/term_hint.hpp"

namespace replan::ui {
namespace {

constexpr std::size_t kReadPerFrame = 512;
constexpr std::size_t kRowsShown = 7;

/// Costs and the robot's map, or all that the planner has declared, and the world.
KindSet kinds_shown(const SearchValues& values, bool every_value) {
  KindSet kinds{EventKind::known};
  if (every_value) kinds.add(EventKind::truth);
  for (const Field& field : values.fields)
    if (every_value || field.type == FieldType::cost) kinds.add(field.kind);
  return kinds;
}

/// Costs of trees and populations are lengths, told as elsewhere in the tab.
std::string raw_text(const Run& run, const Field& field, std::uint64_t raw, const LengthUnit& lengths) {
  if (field.type == FieldType::cost && run.info().can_miss())
    return lengths.text(Cost{static_cast<std::int64_t>(raw)}, 2);
  if (field.type == FieldType::visits) return std::to_string(raw >> 32) + "×";
  if (field.type == FieldType::queue && raw == 0) return "—";
  return value_text(run.lattice(), field, raw);
}

/// What the numbers of the history are in.
const char* history_units(const PlannerInfo& info, bool metric) {
  if (info.can_miss()) return metric ? "Costs are lengths, in metres." : "Costs are lengths, in cells.";
  return "Costs are in moves: one over a side costs 1, a diagonal one 1.41, and a penalty comes on top.";
}

/// One change; a click goes to behind it. What lies after the cursor stands back.
void change_row(Frame& frame, std::size_t row, const ValueChange& change, std::span<const Column> columns) {
  const Look& look = frame.look;
  const Run& run = frame.run();
  const std::size_t cursor = run.timeline().cursor();
  const bool ahead = change.event >= cursor, here = change.event + 1 == cursor;
  const Field& field = run.info().values.field(change.kind);
  const LengthUnit lengths = shown_lengths(frame.view, frame.session.scenario().map);
  const std::string event = grouped(change.event + 1), what(field.label),
                    before = raw_text(run, field, change.before, lengths),
                    after = raw_text(run, field, change.after, lengths);
  const ImU32 words = ahead ? look.theme.faint : look.theme.dim;
  const std::array<TableCell, 4> cells = {{{event, ahead ? look.theme.faint : look.theme.accent},
                                           {what, words},
                                           {before, words},
                                           {after, ahead ? look.theme.faint : look.theme.text}}};
  if (table_row(look, static_cast<int>(row % (std::size_t{1} << 30)), columns, cells, here))
    frame.commands.push_back(Seek{change.event + 1});
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const std::string title = "Event " + event + ", " + origin_text(frame, change.event);
  hint(look,
       {title.c_str(), "",
        ahead ? "Not yet, at the playhead. Click to go there." : "Click to go to where it was written."});
}

void title(const Look& look, CellPast& past) {
  const CellHistory& history = past.history;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  section_title(look, "History");
  const std::string count =
      history.size() == 0 ? "" : grouped(history.size()) + (history.complete() ? "" : "+");
  const ImFont* small = look.fonts.small;
  draw_text(*ImGui::GetWindowDrawList(), small,
            {right - look.px.small - look.px.xs - text_width(small, count), origin.y + look.px(1)},
            look.theme.faint, count);
  const BesideTitle place(look, 1);
  if (small_button(
          look, "every value",
          {.icon = icon::filter,
           .hint = {past.every_value ? "Costs alone" : "Every value", "",
                    "Whether parents, keys, expansions and the world are listed too, or g, rhs, dist and "
                    "the robot's map alone."},
           .selected = past.every_value}))
    past.every_value = !past.every_value;
}

/// Keeps the latest change before the cursor in sight while the cursor moves.
void keep_in_sight(Frame& frame, CellPast& past, std::size_t rows) {
  const CellHistory& history = past.history;
  const std::size_t cursor = frame.run().timeline().cursor();
  if (past.shown_cursor == cursor) return;
  past.shown_cursor = cursor;
  const std::size_t ahead = std::min(history.after(cursor), history.size() - 1);
  reveal_row(frame.look, ahead, history.size(), frame.look.px.row * static_cast<float>(rows), past.rows);
}

}  // namespace

void CellPast::draw(Frame& frame, Cell cell) {
  const Run& run = frame.run();
  history.follow(run.timeline(), run.log_id(), run.lattice().node(cell),
                 kinds_shown(run.info().values, every_value), kReadPerFrame);
  draw_rows(frame);
}

void CellPast::draw_vertex(Frame& frame, std::uint32_t vertex) {
  const Run& run = frame.run();
  KindSet kinds;
  for (const Field& field : run.info().values.vertex_fields)
    if (every_value || field.type == FieldType::vertex || field.kind == fields::kVertexCost.kind)
      kinds.add(field.kind);
  history.follow(run.timeline(), run.log_id(), vertex, kinds, kReadPerFrame);
  draw_rows(frame);
}

void CellPast::draw_rows(Frame& frame) {
  const Look& look = frame.look;
  if (!history.complete()) frame.panels.animated = true;
  title(look, *this);
  if (history.size() == 0) {
    paragraph(look.fonts.ui, look.theme.dim,
              history.complete() ? "Nothing has been written here in this run." : "Looking through the log…");
    return;
  }
  static constexpr std::array<Column, 4> kColumns = {
      {{"event", 1.1f, Align::left}, {"what", 1.0f}, {"before", 1.1f}, {"after", 1.1f}}};
  table_header(look, kColumns);
  const bool metric = shown_lengths(frame.view, frame.session.scenario().map).metric();
  hint(look, {"History", "", history_units(frame.run().info(), metric)});
  const std::size_t shown = std::min(history.size(), kRowsShown);
  keep_in_sight(frame, *this, shown);
  const RowsInSight sight =
      begin_rows(look, "history", history.size(), look.px.row * static_cast<float>(shown), rows);
  for (std::size_t row = sight.first; row < sight.last; ++row) change_row(frame, row, history[row], kColumns);
  end_rows();
}

}  // namespace replan::ui
