// All keys on one page, from the table of actions.
#include <algorithm>
#include <array>

#include "ui/keys.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/shell/dialogs/parts.hpp"

namespace replan::ui {
namespace {

constexpr std::array<std::pair<Menu, const char*>, 9> kSections = {{{Menu::planner, "Play and step"},
                                                                    {Menu::debug, "Debug"},
                                                                    {Menu::file, "File"},
                                                                    {Menu::edit, "Edit and tools"},
                                                                    {Menu::world, "World"},
                                                                    {Menu::view, "View"},
                                                                    {Menu::overlays, "Overlays"},
                                                                    {Menu::record, "Record"},
                                                                    {Menu::help, "Help"}}};

float rows_height(const Look& look, Menu menu) {
  const auto rows = std::count_if(actions().begin(), actions().end(),
                                  [menu](const Action& a) { return a.menu == menu && !a.keys.empty(); });
  return look.px(23) * static_cast<float>(rows) + look.px(40);
}

void key_section(const Look& look, Menu menu, const char* title, float width) {
  section_title(look, title);
  for (const Action& each : actions()) {
    if (each.menu != menu || each.keys.empty()) continue;
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    text(look.fonts.ui, look.theme.text, elide(look.fonts.ui, each.label, width - look.px(96)));
    ImGui::SetCursorScreenPos(
        {origin.x + width - text_width(look.fonts.small, each.keys) - look.px(10), origin.y});
    key_chip(look, each.keys.c_str());
  }
  ImGui::Dummy({width, look.px.s});
}

}  // namespace

Decision Dialogs::keys_dialog(const Look& look) {
  heading(look, "Keys");
  const float gap = look.px(32);
  const float whole = ImGui::GetContentRegionAvail().x;
  const int count = whole > look.px(700) ? 3 : whole > look.px(460) ? 2 : 1;
  const float width = (whole - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
  float total = 0;
  for (const auto& [menu, title] : kSections) total += rows_height(look, menu);
  float filled = 0;
  ImGui::BeginGroup();
  for (const auto& [menu, title] : kSections) {
    // Sections fill one column after the other, each to its share of the height.
    if (filled > 0 && filled + rows_height(look, menu) * 0.5f > total / static_cast<float>(count)) {
      ImGui::EndGroup();
      ImGui::SameLine(0, gap);
      ImGui::BeginGroup();
      filled = 0;
    }
    key_section(look, menu, title, width);
    filled += rows_height(look, menu);
  }
  ImGui::EndGroup();
  paragraph(look.fonts.ui, look.theme.dim,
            "On the canvas: the wheel zooms, the middle button pans, the right button erases, a grabbed "
            "start or goal moves.");
  align_right(button_width(look, "Close"));
  const bool closed = button(look, "Close", ButtonKind::plain) || escape_pressed() || enter_pressed() ||
                      (!fresh_ && ImGui::IsKeyPressed(key::kF1, false));
  return closed ? Decision{.kind = Decision::Kind::cancel} : Decision{};
}

}  // namespace replan::ui
