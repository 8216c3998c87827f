// Buttons, tabs and structure (see widgets.hpp).
#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "ui/icons.hpp"
#include "ui/keys.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

struct Pressed {
  bool clicked;
  bool hovered;
  bool held;
  ImVec2 min;
  ImVec2 max;
};

/// The behaviour of every button: an area that can be hovered, pressed and disabled.
Pressed press(const Look& look, const char* id, ImVec2 size, bool enabled, bool stop = true) {
  ImGui::BeginDisabled(!enabled);
  Pressed result{};
  result.clicked = ImGui::InvisibleButton(id, size);
  if (stop) tab_stop(look);
  result.hovered = enabled && ImGui::IsItemHovered();
  result.held = enabled && ImGui::IsItemActive();
  result.min = ImGui::GetItemRectMin();
  result.max = ImGui::GetItemRectMax();
  ImGui::EndDisabled();
  return result;
}

ImVec2 centre(const Pressed& area) {
  return {(area.min.x + area.max.x) * 0.5f, (area.min.y + area.max.y) * 0.5f};
}

std::string_view visible_part(const char* label) {
  const std::string_view whole(label);
  return whole.substr(0, whole.find("##"));
}

struct ButtonColours {
  ImU32 ground;
  ImU32 border;
  ImU32 text;
};

ButtonColours colours_of(const Theme& theme, ButtonKind kind, bool hovered) {
  switch (kind) {
    case ButtonKind::primary:
      return {hovered ? mix(theme.accent, theme.text, 0.12f) : theme.accent, 0, theme.on_accent};
    case ButtonKind::plain:
      return {hovered ? theme.hover : theme.raised, theme.line, theme.text};
    case ButtonKind::quiet:
      return {hovered ? theme.hover : 0, 0, hovered ? theme.text : theme.dim};
    case ButtonKind::danger:
      return {hovered ? danger_ground(theme) : theme.raised, theme.line, theme.bad};
  }
  return {theme.raised, theme.line, theme.text};
}

}  // namespace

void tab_stop(const Look& look) {
  if (look.focus != nullptr) look.focus->offer(look.theme.accent, look.px.radius, look.px(2));
}

void first_tab_stop(const Look& look) {
  if (look.focus != nullptr) look.focus->begin_at_item();
}

int arrow_steps(const Look& look) {
  if (look.focus == nullptr || !look.focus->takes_arrows() || ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyAlt)
    return 0;
  return (ImGui::IsKeyPressed(key::kRight) ? 1 : 0) - (ImGui::IsKeyPressed(key::kLeft) ? 1 : 0);
}

bool menu_item(const Look& look, const char* label, const MenuEntry& entry) {
  const bool chosen = ImGui::MenuItemEx(label, entry.icon, entry.keys, entry.on, entry.enabled);
  tab_stop(look);
  return chosen;
}

bool tool_button(const Look& look, const char* id, const IconButton& button) {
  const Pressed area = press(look, id, {look.px.tool, look.px.tool}, button.enabled);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (button.selected || area.hovered) {
    list.AddRectFilled(area.min, area.max, button.selected ? look.theme.selected : look.theme.hover,
                       look.px.radius_l);
  }
  ImU32 colour = button.colour != 0 ? button.colour : area.hovered ? look.theme.text : look.theme.dim;
  if (button.selected && button.colour == 0) colour = look.theme.accent;
  if (!button.enabled) colour = look.theme.faint;
  draw_icon(list, look.fonts.icons, centre(area), colour, button.icon);
  hint(look, button.hint);
  return area.clicked;
}

bool transport_button(const Look& look, const char* id, const IconButton& button) {
  const Pressed area = press(look, id, {look.px(look.px.fingers ? 38 : 32), look.px.control}, button.enabled);
  const ButtonKind kind = button.selected ? ButtonKind::primary : ButtonKind::plain;
  const ButtonColours colours = colours_of(look.theme, kind, area.hovered);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, colours.ground, look.px.radius);
  draw_icon(list, look.fonts.ui, centre(area), button.enabled ? colours.text : look.theme.faint, button.icon);
  hint(look, button.hint);
  return area.clicked;
}

bool small_button(const Look& look, const char* id, const IconButton& button) {
  const Pressed area = press(look, id, {look.px.small, look.px.small}, button.enabled, button.tab_stop);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (area.hovered) list.AddRectFilled(area.min, area.max, look.theme.hover, look.px.radius);
  ImU32 colour = button.colour != 0 ? button.colour : area.hovered ? look.theme.text : look.theme.dim;
  if (button.selected) colour = look.theme.accent;
  draw_icon(list, look.fonts.ui, centre(area), button.enabled ? colour : look.theme.faint, button.icon);
  hint(look, button.hint);
  return area.clicked;
}

bool button(const Look& look, const char* label, ButtonKind kind, const char* icon) {
  const std::string_view words = visible_part(label);
  const ImFont* font = look.fonts.ui;
  const float icon_room = icon[0] == '\0' ? 0 : look.px(22);
  const Pressed area =
      press(look, label, {text_width(font, words) + icon_room + look.px(24), look.px.control}, true);
  const ButtonColours colours = colours_of(look.theme, kind, area.hovered);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(area.min, area.max, colours.ground, look.px.radius);
  if (colours.border != 0) list.AddRect(area.min, area.max, colours.border, look.px.radius, 0, look.px.hair);
  if (icon_room > 0) draw_icon(list, font, {area.min.x + look.px(19), centre(area).y}, colours.text, icon);
  draw_text_centred(list, font, {area.min.x + icon_room, area.min.y}, area.max, colours.text, words);
  return area.clicked;
}

bool tabs(const Look& look, const char* id, std::span<const Tab> all, int& current) {
  ImGui::PushID(id);
  const float height = look.px(38), width = ImGui::GetContentRegionAvail().x;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float words = 0;
  for (const Tab& tab : all) words += text_width(look.fonts.ui, tab.name);
  // As much space between them as there is room for; in a narrow panel they stand in two rows.
  const auto count = static_cast<float>(all.size());
  const float least = look.px(2.25f);
  const bool two = width - look.px(16) - words < 2 * count * least;
  const float room = two ? 2 * width - look.px(64) - words : width - look.px(16) - words;
  const float whole = std::floor(room / (2 * count));
  const float gap = whole < look.px(3) ? std::max(room / (2 * count), least) : std::min(whole, look.px(10));
  const float bottom = origin.y + (two ? 2 * height : height);
  list.AddRectFilled({origin.x, bottom - look.px.hair}, {origin.x + width, bottom}, look.theme.line);
  const int before = current;
  ImVec2 at(origin.x + look.px(8), origin.y);
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const auto& [name, teach] = all[static_cast<std::size_t>(i)];
    const float wide = text_width(look.fonts.ui, name) + 2 * gap;
    if (two && at.y == origin.y && at.x + wide > origin.x + width)
      at = {origin.x + look.px(8), at.y + height};
    ImGui::SetCursorScreenPos(at);
    const Pressed area = press(look, name, {wide, height}, true);
    if (area.clicked) current = i;
    if (*teach.title != '\0') hint(look, teach);
    const ImU32 colour = i == current || area.hovered ? look.theme.text : look.theme.dim;
    draw_text(list, look.fonts.ui, {at.x + gap, at.y + look.px(14)}, colour, name);
    if (i == current) list.AddRectFilled({area.min.x, area.max.y - look.px(2)}, area.max, look.theme.accent);
    // Between two that are not chosen: the ground and the line of the chosen one part it from its neighbours.
    if (at.x > origin.x + look.px(8))
      list.AddRectFilled({area.min.x, area.min.y + look.px(13)},
                         {area.min.x + look.px.hair, area.max.y - look.px(11)}, look.theme.line);
    at.x = area.max.x;
  }
  ImGui::SetCursorScreenPos({origin.x, bottom});
  ImGui::PopID();
  return current != before;
}

bool segments(const Look& look, const char* id, std::span<const char* const> names, int& current) {
  ImGui::PushID(id);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float whole = ImGui::GetContentRegionAvail().x, width = whole / static_cast<float>(names.size());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(origin, {origin.x + whole, origin.y + look.px.control}, look.theme.raised,
                     look.px.radius);
  const int before = current;
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const char* name = names[static_cast<std::size_t>(i)];
    ImGui::SetCursorScreenPos({origin.x + width * static_cast<float>(i), origin.y});
    const Pressed area = press(look, name, {width, look.px.control}, true);
    if (area.clicked) current = i;
    if (i == current) list.AddRectFilled(area.min, area.max, look.theme.selected, look.px.radius);
    draw_text_centred(list, look.fonts.ui, area.min, area.max,
                      i == current || area.hovered ? look.theme.text : look.theme.dim, name);
  }
  ImGui::PopID();
  return current != before;
}

void section_title(const Look& look, std::string_view title) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, look.px(6)));
  text(look.fonts.section, look.theme.dim, title);
  ImGui::PopStyleVar();
}

BesideTitle::BesideTitle(const Look& look, int buttons) : below_(ImGui::GetCursorScreenPos()) {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const auto count = static_cast<float>(buttons);
  ImGui::SetCursorScreenPos({right - count * look.px.small - (count - 1) * look.px.xs,
                             std::floor((min.y + max.y - look.px.small) * 0.5f)});
}

BesideTitle::~BesideTitle() {
  ImGui::SetCursorScreenPos(below_);
}

void section_rule(const Look& look) {
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  // From the end of the content, not from the cursor: rows of tables leave no space behind them.
  const float y = window.DC.CursorMaxPos.y + look.px.m;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // From edge to edge, beyond the content's padding.
  const ImRect visible = window.OuterRectClipped;
  list.PushClipRect(visible.Min, visible.Max);
  list.AddRectFilled({visible.Min.x, y}, {visible.Max.x, y + look.px.hair}, look.theme.line);
  list.PopClipRect();
  ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, y + look.px.hair + look.px.m});
}

void edge(const Look& look, Edge side) {
  const ImRect area = ImGui::GetCurrentWindow()->OuterRectClipped;
  ImVec2 min = area.Min;
  ImVec2 max = area.Max;
  if (side == Edge::left) max.x = min.x + look.px.hair;
  if (side == Edge::right) min.x = max.x - look.px.hair;
  if (side == Edge::top) max.y = min.y + look.px.hair;
  if (side == Edge::bottom) min.y = max.y - look.px.hair;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(area.Min, area.Max);
  list.AddRectFilled(min, max, look.theme.line);
  list.PopClipRect();
}

void tool_separator(const Look& look) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float y = min.y + look.px.xs;
  ImGui::GetWindowDrawList()->AddRectFilled(
      {min.x + look.px(5), y}, {min.x + look.px.tool - look.px(5), y + look.px.hair}, look.theme.line);
  ImGui::Dummy({look.px.tool, look.px.s + look.px.hair});
}

void empty_state(const Look& look, const char* icon, std::string_view title, std::string_view advice) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = std::min(room.x, look.px(320));
  const ImFont* words = look.fonts.ui;
  const float line_height = look.px(20);
  const float middle = origin.x + room.x * 0.5f;
  float y = std::floor(origin.y + std::max(0.0f, (room.y - look.px(120)) * 0.45f));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_icon(list, look.fonts.icons, {middle, y + look.px(12)}, look.theme.faint, icon);
  y += look.px(36);
  draw_text_centred(list, look.fonts.title, {middle, y}, {middle, y + look.px.l}, look.theme.text, title);
  y += look.px(26);
  while (!advice.empty()) {
    const char* end = advice.data() + advice.size();
    const char* cut = words->CalcWordWrapPositionA(1.0f, advice.data(), end, width);
    // A word wider than the room is cut after its first character rather than never.
    const auto length = std::max<std::size_t>(static_cast<std::size_t>(cut - advice.data()), 1);
    draw_text_centred(list, words, {middle, y}, {middle, y + line_height}, look.theme.dim,
                      advice.substr(0, length));
    advice.remove_prefix(std::min(advice.find_first_not_of(' ', length), advice.size()));
    y += line_height;
  }
  ImGui::Dummy({room.x, y - origin.y});
}

void progress(const Look& look, float fraction, std::string_view label) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = look.px(6);
  if (!label.empty()) text(look.fonts.ui, look.theme.dim, label);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width, height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, {min.x + width, min.y + height}, look.theme.line, height * 0.5f);
  const float phase = std::fmod(static_cast<float>(ImGui::GetTime()) * 0.6f, 1.3f) - 0.3f;
  const float from = fraction < 0 ? std::clamp(phase, 0.0f, 1.0f) : 0.0f;
  const float to = fraction < 0 ? std::clamp(phase + 0.3f, 0.0f, 1.0f) : std::min(fraction, 1.0f);
  if (to - from < 1e-3f) return;
  const float shortest = std::max((to - from) * width, height);  // a round dot at least
  list.AddRectFilled({min.x + from * width, min.y},
                     {std::min(min.x + from * width + shortest, min.x + width), min.y + height},
                     look.theme.accent, height * 0.5f);
}

}  // namespace replan::ui
