#include "ui/canvas/slice_bar.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "ui/icons.hpp"

namespace replan::ui {
namespace {

constexpr float kHeight = 32, kAxesWidth = 116, kWidest = 440;
constexpr std::array<Axis, 3> kAxes = {Axis::x, Axis::y, Axis::z};

/// The axis that is looked along, or the whole world from outside. A pane that is turned shows the layer of the pinned
/// cell, else that in the middle.
void draw_axes(const Look& look, const Sheet& sheet, std::size_t pane, ViewState& state) {
  Slices& slices = state.slices;
  static constexpr std::array<const char*, 4> kNames = {"X", "Y", "Z", "3D"};
  int chosen = slices.orbits(pane) ? 3 : static_cast<int>(sheet.box.along());
  ImGui::BeginChild("axes", {look.px(kAxesWidth), look.px.control}, false, ImGuiWindowFlags_NoBackground);
  if (segments(look, "axis", kNames, chosen)) {
    slices.set_orbits(pane, chosen == 3);
    if (chosen < 3)
      turn_slice(slices, pane, sheet.box.box(), kAxes[static_cast<std::size_t>(chosen)], state.view.pinned);
  }
  ImGui::EndChild();
  hint(look,
       {"Slice, or 3D", "Shift+X, Shift+Y, Shift+Z, Shift+O",
        "The axis that the pane looks along: it shows one layer across it. Seen along x or y the world "
        "stands upright, with z growing upwards. 3D shows the whole world from outside, with that layer "
        "framed in it. Panes that show the same slice go together."});
}

void draw_track(const Look& look, const Sheet& sheet, std::size_t pane, Slices& slices, float width) {
  double layer = sheet.layer;
  ImGui::BeginChild("track", {width, look.px.control}, false, ImGuiWindowFlags_NoBackground);
  ImGui::SetCursorPosY((look.px.control - look.px.l) / 2);
  const SliderSpec spec{
      .label = "Layer", .min = 0, .max = static_cast<double>(sheet.box.depth() - 1), .decimals = 0};
  const bool moved = slider_track(look, spec, layer);
  ImGui::EndChild();
  hint(look, {"Layer", "Shift+wheel",
              "Which layer of the world the pane shows. On the canvas Shift and the wheel move it; with Ctrl "
              "too, the pane goes alone."});
  if (!moved) return;
  slices.follows_robot = false;
  slices.set(pane, {sheet.box.along(), static_cast<int>(layer)});
}

void draw_follow(const Look& look, Slices& slices) {
  const IconButton button{
      .icon = icon::crosshairs,
      .hint = {"Follow the robot", "", "The panes show the layer that the robot is in, wherever it goes."},
      .selected = slices.follows_robot,
      .colour = slices.follows_robot ? look.theme.accent : 0};
  if (small_button(look, "follow", button)) slices.follows_robot = !slices.follows_robot;
}

/// What a view from outside leaves out, so that one sees into the world.
void draw_solid_switches(const Look& look, SolidOptions& options) {
  const auto toggled = [&](const char* id, const char* sign, const Hint& words, bool& on) {
    ImGui::SameLine(0, 0);
    const IconButton button{
        .icon = sign, .hint = words, .selected = on, .colour = on ? look.theme.accent : 0};
    if (small_button(look, id, button)) on = !on;
  };
  toggled("cut", icon::cut,
          {"Cut at the slice", "", "Leaves out what lies between you and the layer that the slice shows."},
          options.cut);
  toggled("see-through", icon::adjust,
          {"See through obstacles", "", "Obstacles are like glass: what is behind them shows."},
          options.see_through);
}

}  // namespace

float slice_bar_height(const Look& look) {
  return look.px(kHeight) + look.px.xs;
}

std::string axes_text(Axis along) {
  switch (along) {
    case Axis::x:
      return "y → · z ↑";
    case Axis::y:
      return "x → · z ↑";
    case Axis::z:
      break;
  }
  return "x → · y ↓";
}

std::string short_layer_text(const Sheet& sheet) {
  return std::string(axis_name(sheet.box.along())) + " = " + std::to_string(sheet.layer);
}

std::string layer_text(const Sheet& sheet) {
  return short_layer_text(sheet) + " of 0 to " + std::to_string(sheet.box.depth() - 1);
}

void draw_slice_bar(const Look& look, const Sheet& sheet, std::size_t pane, ViewState& state, ImVec2 at,
                    float width) {
  Slices& slices = state.slices;
  width = std::min(width, look.px(kWidest));
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize({width, look.px(kHeight)});
  ImGui::SetNextWindowBgAlpha(0.94f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2(look.px.xs, (look.px(kHeight) - look.px.control) / 2));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  const std::string id = "slice##" + std::to_string(ImGui::GetID("slice"));
  ImGui::Begin(id.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar(2);
  draw_axes(look, sheet, pane, state);
  ImGui::SameLine(0, look.px.s);
  const float button = look.px(24), buttons = slices.orbits(pane) ? 3 * button : button;
  const float room = width - look.px(kAxesWidth) - buttons - 2 * look.px.xs - 2 * look.px.s;
  const std::string whole = layer_text(sheet);
  const std::string words = text_width(look.fonts.mono, whole) <= room ? whole : short_layer_text(sheet);
  const float track = room - text_width(look.fonts.mono, words) - 2 * look.px.s;
  if (track >= look.px(40)) {
    draw_track(look, sheet, pane, slices, track);
    ImGui::SameLine(0, look.px.s);
  }
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({origin.x, origin.y + (look.px.control - look.fonts.mono->FontSize) / 2});
  text(look.fonts.mono, look.theme.text, words);
  hint(look, {"The layer that shows", "", "By its coordinate along the axis that the pane looks along."});
  ImGui::SameLine(0, look.px.s);
  ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, origin.y + (look.px.control - button) / 2});
  draw_follow(look, slices);
  if (slices.orbits(pane)) draw_solid_switches(look, state.solid);
  ImGui::End();
}

}  // namespace replan::ui
