// Over the canvas: why the playhead stopped where it did, and how far the search for the next stop is.
#include <algorithm>
#include <cmath>

#include "ui/icons.hpp"
#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

constexpr float kWidest = 460;

/// A small window with its lower right corner at a place; `draw` fills its one line.
template <class Draw>
void one_line(const Look& look, const char* id, ImVec2 corner, const Draw& draw) {
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowBgAlpha(0.96f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(look.px.m, look.px.s));
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  draw();
  ImGui::End();
  ImGui::PopStyleVar();
}

void raised_button_row(const Look& look) {
  ImGui::SameLine(0, look.px.s);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - look.px(5));
}

void hunt(Frame& frame, const Hunt& hunt) {
  const Look& look = frame.look;
  frame.panels.animated = true;
  std::string words = hunt.direction > 0 ? "Looking for the next stop…" : "Looking for the previous stop…";
  if (hunt.fraction >= 0) words += " " + fixed(hunt.fraction * 100, 0) + " %";
  draw_icon(*ImGui::GetWindowDrawList(), look.fonts.ui,
            {ImGui::GetCursorScreenPos().x + look.px(6), ImGui::GetCursorScreenPos().y + look.px(7)},
            look.theme.accent, icon::search);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + look.px(20));
  text(look.fonts.ui, look.theme.text, words);
  raised_button_row(look);
  const Action& stop = action(ActionId::cancel);
  if (small_button(look, "stop looking", {.icon = stop.icon, .hint = {"Stop looking", stop.keys.c_str()}}))
    frame.commands.push_back(Cancel{});
}

void stopped(Frame& frame, const std::string& why) {
  const Look& look = frame.look;
  status(look, look.theme.bad, "Stopped");
  ImGui::SameLine(0, look.px.s);
  const std::string words = elide(look.fonts.ui, why, look.px(kWidest) - look.px(160));
  text(look.fonts.ui, look.theme.text, words);
  if (words != why) hint(look, {"", "", why.c_str()});
  raised_button_row(look);
  for (const ActionId id : {ActionId::breakpoint_back, ActionId::breakpoint_forward}) {
    const Action& each = action(id);
    if (small_button(look, each.name, {.icon = each.icon, .hint = each.hint()})) perform(frame, id);
    ImGui::SameLine(0, 0);
  }
}

}  // namespace

void draw_stop(Frame& frame, ImVec2 corner) {
  const Breakpoints& breakpoints = frame.session.breakpoints();
  if (breakpoints.hunt())
    one_line(frame.look, "stop", corner, [&] { hunt(frame, *breakpoints.hunt()); });
  else if (!breakpoints.stopped().empty())
    one_line(frame.look, "stop", corner, [&] { stopped(frame, breakpoints.stopped()); });
}

}  // namespace replan::ui
