// "Why?" beside the pinned cell on the canvas, and the answer.
#include <algorithm>
#include <cmath>

#include "core/scene/cover.hpp"
#include "ui/canvas/chips.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/icons.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/cell_view.hpp"

namespace replan::ui {
namespace {

constexpr float kAnswerWidth = 320;

/// Where a box of that size hides least: near the cell, or, for the answer, wherever there is room.
ImVec2 best_place(const Look& look, const Scene& scene, Cell cell, ImVec2 size, bool open, ImVec2 min,
                  ImVec2 max) {
  const auto px = [&look](float design) { return static_cast<double>(look.px(design)); };
  const double width = max.x - min.x, height = max.y - min.y;
  const PixelBox room{px(4), static_cast<double>(pane_title_height(look)), width - px(4),
                      height - static_cast<double>(Legend::height(look))};
  const PixelBox box{0, 0, static_cast<double>(size.x), static_cast<double>(size.y)};
  const double reach = open ? std::max(width, height) : px(96), farther = px(open ? 1.5f : 2);
  Cover cover(scene);
  const PixelBox about = Cover::cell(scene, cell);
  // The answer is about the neighbours as much as about the cell.
  if (open) {
    const double side = about.width();
    cover.add({about.left - side, about.top - side, about.right + side, about.bottom + side},
              4 * Cover::kWords);
  }
  const PixelBox best = cover.best_beside(box, about, room, px(4), reach, farther);
  return {min.x + std::round(static_cast<float>(best.left)),
          min.y + std::round(static_cast<float>(best.top))};
}

/// By the cell's place in the view, `seen`. It stays where it is while one steps through a run, and is closed where it is about another cell or another run.
ImVec2 place(Frame& frame, const Scene& scene, Cell cell, Cell seen, ImVec2 size, ImVec2 min, ImVec2 max) {
  WhyPlace& why = frame.panels.why;
  const WhyPlace::Key now{cell,         frame.run().log_id(),  scene.camera, scene.width,
                          scene.height, frame.panels.why_open, size.y > 0};
  if (why.key != now) {
    why.at = best_place(frame.look, scene, seen, size, frame.panels.why_open, min, max);
    why.key = now;
  }
  return {why.at.x, std::max(min.y, std::min(why.at.y, max.y - size.y))};
}

void answer(Frame& frame, Cell cell) {
  const Look& look = frame.look;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float right = origin.x + ImGui::GetContentRegionAvail().x;
  ImGui::SetCursorScreenPos({right - look.px.small, origin.y - look.px.xs});
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
  const auto& before = frame.panels.why.key;
  if (before && (before->cell != pinned || before->log_id != frame.run().log_id()))
    frame.panels.why_open = false;
  frame.view.view.taken.reset();
  if (!pinned || !frame.session.scenario().map.contains(*pinned)) return;
  const std::size_t lead = frame.session.lead();
  const Sheet sheet = sheet_of(frame.run().lattice(), frame.view.slices.of(lead));
  // Beside a cell that does not show there is nothing to ask.
  if (!sheet.has(*pinned) || (sheet.box.solid() && frame.view.slices.orbits(lead))) return;
  const Look& look = frame.look;
  const bool open = frame.panels.why_open;
  const float line = look.fonts.title->FontSize + look.px.s;
  const ImVec2 size = open ? ImVec2(look.px(kAnswerWidth), frame.panels.why_height)
                           : ImVec2(text_width(look.fonts.title, "Why?") + 2 * look.px.s, line);
  const ImVec2 at = place(frame, scene, *pinned, sheet.box.seen(*pinned), size, min, max);
  frame.view.view.taken = PixelBox{at.x - min.x, at.y - min.y, at.x - min.x + size.x, at.y - min.y + size.y};
  ImGui::SetNextWindowPos(at);
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
