// "Why?" beside the pinned cell on the canvas, and the answer.
#include <algorithm>

#include "ui/canvas/draw.hpp"
#include "ui/icons.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/cell_view.hpp"

namespace replan::ui {
namespace {

constexpr float kAnswerWidth = 320;

/// The upper left corner of a box of that size beside a cell: at its right, or at its left if there is more room.
ImVec2 beside(const Look& look, const Projection& screen, Cell cell, ImVec2 size, ImVec2 min, ImVec2 max) {
  const double x = cell.x, y = cell.y;
  const ImVec2 low = screen({x, y}), high = screen({x + 1, y + 1});
  const float gap = look.px.s;
  const bool left = high.x + gap + size.x > max.x;
  const float wanted = left ? low.x - gap - size.x : high.x + gap;
  return {std::clamp(wanted, min.x, std::max(min.x, max.x - size.x)),
          std::clamp(low.y, min.y, std::max(min.y, max.y - size.y))};
}

void answer(Frame& frame, Cell cell) {
  const Look& look = frame.look;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  ImGui::SetCursorScreenPos({right - look.px(24), origin.y - look.px.xs});
  if (small_button(look, "close", {.icon = icon::times, .hint = {"Close"}})) frame.panels.why_open = false;
  ImGui::SetCursorScreenPos(origin);
  draw_why(frame, CellView(frame.run(), cell));
  if (link(look, "more", "More in the Cell tab", look.fonts.ui)) show_cell(frame, cell);
}

void question(Frame& frame) {
  const Look& look = frame.look;
  if (link(look, "why", "Why?", look.fonts.title)) perform(frame, ActionId::why);
  hint(look, action(ActionId::why).hint());
}

}  // namespace

void draw_why_chip(Frame& frame, const Scene& scene, ImVec2 min, ImVec2 max) {
  const std::optional<Cell>& pinned = frame.view.view.pinned;
  if (!pinned || !frame.session.scenario().map.contains(*pinned)) return;
  const Look& look = frame.look;
  const bool open = frame.panels.why_open;
  const float line = look.fonts.title->FontSize + look.px.s;
  const ImVec2 size = open ? ImVec2(look.px(kAnswerWidth), frame.panels.why_height)
                           : ImVec2(text_width(look.fonts.title, "Why?") + 2 * look.px.s, line);
  ImGui::SetNextWindowPos(beside(look, Projection(scene, min), *pinned, size, min, max));
  ImGui::SetNextWindowSize(open ? ImVec2(size.x, 0) : size);
  ImGui::SetNextWindowBgAlpha(0.96f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      open ? ImVec2(look.px.m, look.px.m) : ImVec2(look.px.s, look.px.xs));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::Begin(open ? "answer" : "question", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar(2);
  if (open)
    answer(frame, *pinned);
  else
    question(frame);
  if (open) frame.panels.why_height = ImGui::GetWindowHeight();
  ImGui::End();
}

}  // namespace replan::ui
