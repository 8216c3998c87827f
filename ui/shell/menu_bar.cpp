// The menu bar: menus from the table of actions, the planner list, and the name of the file.
#include <algorithm>
#include <utility>

#include <imgui_internal.h>

#include "core/base/file.hpp"
#include "ui/canvas/planner_menu.hpp"
#include "ui/documents/files.hpp"
#include "ui/icons.hpp"
#include "ui/shell/menus.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

void action_item(Frame& frame, const Action& each) {
  const ActionContext context = context_of(frame);
  if (menu_item(frame.look, each.words(context).c_str(),
                {each.icon, frame.panels.stacked ? "" : each.keys.c_str(), each.checked(context),
                 each.available(context)}))
    perform(frame, each.id);
  hint(frame.look, {"", "", each.lesson(context).c_str()});
}

/// The entries of a menu, with a line between groups.
void menu_items(Frame& frame, Menu menu) {
  int group = -1;
  for (const Action& each : actions()) {
    if (each.menu != menu || each.hidden(context_of(frame))) continue;
    if (group >= 0 && each.group != group) ImGui::Separator();
    group = each.group;
    action_item(frame, each);
    if (each.rules.below != nullptr) each.rules.below(frame);
  }
}

/// What would make a menu taller than a small window stands in menus beside it.
void submenus(Frame& frame, Menu of) {
  bool first = true;
  for (const MenuKind& each : menu_kinds()) {
    if (each.of != of || each.in_bar()) continue;
    if (std::exchange(first, false)) ImGui::Separator();
    if (frame.panels.open_menu == each.menu) {
      ImGui::OpenPopup(each.name);
      frame.panels.open_menu.reset();
    }
    if (!ImGui::BeginMenuEx(each.name, each.icon)) continue;
    menu_items(frame, each.menu);
    ImGui::EndMenu();
  }
}

void menu(Frame& frame, const MenuKind& kind) {
  const Menu which = kind.menu;
  ImGui::PushStyleColor(ImGuiCol_Text, frame.look.theme.dim);
  if (std::optional<Menu>& wanted = frame.panels.open_menu; wanted && menu_kind(*wanted).of == which) {
    ImGui::OpenPopup(kind.name);
    if (wanted == which) wanted.reset();
  }
  const bool open = ImGui::BeginMenu(kind.name);
  ImGui::PopStyleColor();
  if (!open) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(frame.look.px.s, frame.look.px.menu_gap));
  if (which == Menu::planner) {
    planner_items(frame.look, frame.session, frame.session.lead(), frame.commands);
    ImGui::Separator();
  }
  menu_items(frame, which);
  submenus(frame, which);
  ImGui::PopStyleVar();
  ImGui::EndMenu();
}

void menus(Frame& frame) {
  for (const MenuKind& each : menu_kinds())
    if (each.in_bar()) menu(frame, each);
}

/// All of them in one, where the bar has no room for them.
void one_menu(Frame& frame) {
  const Look& look = frame.look;
  if (frame.panels.open_menu) ImGui::OpenPopup(icon::bars);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.l, look.px.xs));
  const bool open = ImGui::BeginMenu(icon::bars);
  ImGui::PopStyleVar();
  if (!open) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.s, look.px.menu_gap));
  menus(frame);
  ImGui::PopStyleVar();
  ImGui::EndMenu();
}

/// What looks like a box to type into opens the command palette. Returns its left end; in a narrow window it
/// is an icon alone.
float search_box_at_right(Frame& frame, const ImRect& bar) {
  const Look& look = frame.look;
  const Action& palette = action(ActionId::palette);
  const bool wide = bar.GetWidth() > look.px(1180);
  const float width = wide ? look.px(222) : std::max(look.px(28), look.px.small),
              height = std::max(look.px(26), look.px.small);
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  const ImVec2 min(bar.Max.x - look.px.m - width, bar.Min.y + (look.px.menu - height) * 0.5f);
  const ImVec2 max(min.x + width, min.y + height);
  ImGui::SetCursorScreenPos(min);
  if (ImGui::InvisibleButton("search", {width, height})) perform(frame, ActionId::palette);
  tab_stop(look);
  const bool hovered = ImGui::IsItemHovered();
  hint(look, palette.hint());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max, hovered ? look.theme.hover : look.theme.raised, look.px.radius);
  const float y = bar.Min.y + (look.px.menu - look.fonts.ui->FontSize) * 0.5f;
  if (wide) {
    draw_text(list, look.fonts.ui, {min.x + look.px(10), y}, look.theme.faint, palette.label);
    draw_text(list, look.fonts.ui, {max.x - look.px(10) - text_width(look.fonts.ui, palette.keys), y},
              look.theme.faint, palette.keys);
  } else {
    draw_icon(list, look.fonts.ui, {(min.x + max.x) * 0.5f, (min.y + max.y) * 0.5f}, look.theme.dim,
              icon::search);
  }
  ImGui::SetCursorScreenPos(cursor);
  return min.x;
}

void file_name_at_right(Frame& frame) {
  const Look& look = frame.look;
  const Session& session = frame.session;
  const std::string shown = document_name(session);
  const char* state = session.modified() ? " — edited" : session.file().empty() ? " — not saved yet" : "";
  const ImRect bar = ImGui::GetCurrentWindow()->MenuBarRect();
  const float right = search_box_at_right(frame, bar) - look.px.l;
  const float room = right - ImGui::GetCursorScreenPos().x - look.px.l - text_width(look.fonts.ui, state);
  const float width = std::min(text_width(look.fonts.ui, shown), room);
  const float y = bar.Min.y + (look.px.menu - look.fonts.ui->FontSize) * 0.5f;
  const float state_x = right - text_width(look.fonts.ui, state);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (room < look.px(40)) return;
  draw_line(look, list, look.fonts.ui, {state_x - width, y}, look.theme.text, shown, room);
  draw_text(list, look.fonts.ui, {state_x, y}, look.theme.dim, state);
}

}  // namespace

void draw_recent_files(Frame& frame) {
  if (!ImGui::BeginMenuEx("Open recent", icon::history, !frame.panels.recent.empty())) return;
  for (const std::string& path : frame.panels.recent) {
    ImGui::PushID(path.c_str());
    if (menu_item(frame.look, file_name(path).c_str(), {icon::file})) {
      frame.wish = Wish::recent;
      frame.panels.wished = path;
    }
    ImGui::PopID();
    hint(frame.look, {"", "", path.c_str()});
  }
  ImGui::Separator();
  if (menu_item(frame.look, "Forget these", {icon::trash})) frame.wish = Wish::forget_recent;
  ImGui::EndMenu();
}

void draw_menu_bar(Frame& frame) {
  const Look& look = frame.look;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px(10), look.px.xs));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.m, look.px(10)));
  if (ImGui::BeginMenuBar()) {
    ImGui::SetCursorPosX(look.px(frame.panels.stacked ? 4 : 14));
    if (!frame.panels.stacked) text(look.fonts.title, look.theme.text, "Replan");
    if (frame.panels.stacked)
      one_menu(frame);
    else
      menus(frame);
    draw_recording(frame);
    file_name_at_right(frame);
    ImGui::EndMenuBar();
  }
  ImGui::PopStyleVar(2);
  edge(look, Edge::bottom);
}

}  // namespace replan::ui
