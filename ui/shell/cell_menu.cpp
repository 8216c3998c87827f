// What can be done with one value of a cell, and with the cell: breakpoints, watches, and going to changes.
#include <imgui_internal.h>

#include "ui/icons.hpp"
#include "ui/shell/conditions.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

void breakpoint_item(Frame& frame, const std::string& label, const std::string& condition) {
  if (condition.empty()) return;
  const bool set = find_breakpoint(frame.session, condition).has_value();
  if (menu_item(frame.look, label.c_str(), {.icon = icon::circle, .on = set}))
    frame.commands.push_back(toggle_breakpoint(frame.session, condition));
}

void watch_item(Frame& frame, const std::string& expression) {
  if (expression.empty()) return;
  const std::string label = "Watch " + expression;
  const bool watched = is_watched(frame.session, expression);
  if (menu_item(frame.look, label.c_str(), {.icon = icon::line_chart, .on = watched}))
    frame.commands.push_back(toggle_watch(frame.session, expression));
}

void change_items(Frame& frame, const std::string& name, EventKind kind, NodeId node) {
  if (menu_item(frame.look, ("Previous change of " + name).c_str(), {icon::caret_left}))
    frame.commands.push_back(GoToChange{kind, node, -1});
  if (menu_item(frame.look, ("Next change of " + name).c_str(), {icon::caret_right}))
    frame.commands.push_back(GoToChange{kind, node, 1});
}

bool is_number(EventKind kind) {
  return kind != EventKind::lp && kind != EventKind::rp && kind != EventKind::known;
}

}  // namespace

void value_menu_items(Frame& frame, const char* name, EventKind kind, Cell cell) {
  const NodeId node = frame.run().lattice().node(cell);
  change_items(frame, name, kind, node);
  ImGui::Separator();
  breakpoint_item(frame, std::string("Break when ") + name + " changes",
                  when_changed(kind, cell, frame.run().lattice()));
  if (is_number(kind)) watch_item(frame, value_expression(kind, cell, frame.run().lattice()));
}

void cell_menu_items(Frame& frame, Cell cell) {
  const Look& look = frame.look;
  const PlannerInfo& info = frame.run().info();
  const bool lookahead = info.values.lookahead();
  const Box& world = frame.run().lattice();
  const NodeId node = world.node(cell);
  text(look.fonts.title, look.theme.text, "Cell " + cell_text(cell, world));
  ImGui::Separator();
  const bool pinned = frame.view.view.pinned == cell;
  if (menu_item(look, pinned ? "Unpin it" : "Pin it", {icon::pin})) {
    if (pinned)
      frame.view.view.pinned.reset();
    else
      frame.view.view.pinned = cell;
  }
  if (menu_item(look, "What hangs on it", {icon::sitemap})) {
    frame.view.view.pinned = cell;
    perform(frame, ActionId::parent_tree);
  }
  ImGui::Separator();
  change_items(frame, lookahead ? "rhs" : "g", lookahead ? EventKind::rhs : EventKind::g, node);
  ImGui::Separator();
  breakpoint_item(frame, "Break when it is taken from U", when_taken(cell, world));
  breakpoint_item(frame, "Break when g changes", when_changed(EventKind::g, cell, world));
  if (lookahead) breakpoint_item(frame, "Break when rhs changes", when_changed(EventKind::rhs, cell, world));
  ImGui::Separator();
  watch_item(frame, value_expression(EventKind::g, cell, world));
  if (lookahead) watch_item(frame, value_expression(EventKind::rhs, cell, world));
}

void draw_cell_menu(Frame& frame) {
  const Look& look = frame.look;
  std::optional<Cell>& cell = frame.view.menu;
  if (!cell) return;
  if (!frame.session.scenario().map.contains(*cell)) return cell.reset();
  constexpr const char* kName = "cell menu";
  bool& open = frame.panels.menu_open;
  if (!open) ImGui::OpenPopup(kName);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.m, look.px(10)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.s, look.px.menu_gap));
  open = ImGui::BeginPopup(kName, ImGuiWindowFlags_NoMove);
  if (open) {
    cell_menu_items(frame, *cell);
    ImGui::EndPopup();
  } else {
    cell.reset();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace replan::ui
