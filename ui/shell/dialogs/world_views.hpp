// What the dialogs about the world as a whole share: sliders of its size, and pictures of it from above and the front.
#pragma once

#include <algorithm>
#include <utility>

#include <imgui.h>

#include "ui/look.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

/// Of one side of the world, in cells; whether it was moved.
bool size_slider(const Look& look, const char* label, int initial, int& value);
/// Of the number of its layers.
bool layers_slider(const Look& look, int initial, int& layers);

/// Where a picture of these proportions lies in the middle of a box.
std::pair<ImVec2, ImVec2> fitted(ImVec2 origin, ImVec2 box, double width, double height);
/// Of the settings: as high as they are, but so that the buttons below are in the window.
float fitting_height(const Look& look, float wanted);

/// Settings, `wanted` design pixels high, beside a picture of the world; in a narrow dialog the picture stands above them.
template <class Settings, class Picture>
void settings_and_picture(const Look& look, float wanted, const Settings& settings, const Picture& picture) {
  const float whole = ImGui::GetContentRegionAvail().x, gap = look.px(24);
  const bool narrow = whole < look.px(480);
  const float height = fitting_height(look, narrow ? wanted * 1.7f : wanted);
  const float left = narrow ? whole : whole * 0.45f, above = narrow ? height * 0.42f : 0;
  const auto draw_picture = [&](ImVec2 size) {
    ImGui::BeginGroup();
    picture(size);
    ImGui::EndGroup();
  };
  if (narrow) draw_picture({whole, above});
  ImGui::BeginChild("settings", {left, height - above});
  settings();
  ImGui::EndChild();
  if (narrow) return;
  ImGui::SameLine(0, gap);
  draw_picture({whole - left - gap, height});
}

/// A world of layers from above and below that from the front, each with its name; both are as wide as `size`.
template <class Above, class Front>
void two_views(const Look& look, ImVec2 size, const Above& above, const Front& front) {
  const float line = look.fonts.ui->FontSize + look.px.xs, rest = size.y - 2 * line - look.px.s;
  const auto view = [&](const char* name, const auto& draw, float height) {
    text(look.fonts.ui, look.theme.faint, name);
    draw(ImVec2(size.x, std::max(height, 1.0f)));
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(look.px.s, look.px.xs));
  view("From above", above, rest * 0.64f);
  view("From the front", front, rest * 0.36f);
  ImGui::PopStyleVar();
}

}  // namespace replan::ui
