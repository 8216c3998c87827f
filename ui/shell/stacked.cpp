// The parts of a tall, narrow window: the side stands under the world, and what is pressed most is where thumbs are.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/shell/panels.hpp"
#include "ui/shell/shell.hpp"

namespace replan::ui {
namespace {

constexpr float kLowestCanvas = 180, kLowestSide = 120, kGrip = 18, kLeastShare = 0.15f, kLargestShare = 0.7f;

/// One below the other, from the top of the window on or from its foot.
class Stack {
 public:
  Stack(float width, float top, float bottom) : width_(width), top_(top), bottom_(bottom) {}

  /// The corner of the next part from above.
  ImVec2 down(float height) { return {0, std::exchange(top_, top_ + height)}; }
  /// The corner of the next part from below.
  ImVec2 up(float height) { return {0, bottom_ -= height}; }
  [[nodiscard]] float room() const { return bottom_ - top_; }
  [[nodiscard]] ImVec2 min() const { return {0, top_}; }
  [[nodiscard]] ImVec2 max() const { return {width_, bottom_}; }

 private:
  float width_, top_, bottom_;
};

}  // namespace

/// Above the world: what it is about, or the lesson.
float Shell::stacked_words(Frame& frame, ImVec2 corner, float width) {
  const Look& look = frame.look;
  if (lesson_.open()) {
    const float height = lesson_.height(look, width);
    area("lesson", corner, {width, height}, look.theme.panel, {look.px.m, look.px.s},
         [&] { lesson_.draw(frame); });
    return height;
  }
  if (!panels_.caption || frame.session.scenario().caption.empty()) return 0;
  const float height = std::max(look.px(32), look.px.small + look.px.s);
  draw_caption(frame, corner, {width, height});
  return height;
}

void Shell::draw_stacked(Frame& frame) {
  const Look& look = frame.look;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  Stack stack(size.x, 0, size.y);
  draw_menu(frame, stack.down(look.px.menu), size.x);
  const ImVec2 status = stack.up(look.px.status);
  if (view_.panels) {
    const float row = look.px.tool + look.px.s;
    area("tools", stack.down(row), {size.x, row}, look.theme.panel, {look.px.s, look.px.xs},
         [&] { draw_tool_row(frame); });
  }
  stack.down(stacked_words(frame, stack.min(), size.x));
  const float transport = stacked_transport_height(look);
  const float most = stack.room() - transport - look.px(kLowestCanvas + kGrip);
  const bool options = view_.panels && has_tool_options(frame);
  const float tool = options ? std::clamp(panels_.tool_height, 0.0f, std::max(most, 0.0f)) : 0;
  const float wanted = std::min(std::round(size.y * panels_.side_share), most - tool);
  const float side = view_.panels && wanted >= look.px(kLowestSide) ? wanted : 0;
  if (options)
    area("tool options", stack.up(tool), {size.x, tool}, look.theme.panel, {look.px.l, look.px.m},
         [&] { draw_tool_options(frame); });
  if (side > 0)
    area("side", stack.up(side), {size.x, side}, look.theme.panel, {0, 0}, [&] { draw_side(frame); });
  const float grip = side > 0 ? look.px(look.px.fingers ? kGrip : 10) : 0;
  const ImVec2 bar = stack.up(grip), strip = stack.up(transport);
  draw_canvas(frame, stack.min(), stack.max());
  lesson_.enter_step(frame);
  area("transport", strip, {size.x, transport}, look.theme.panel, {look.px.l, look.px(14)},
       [&] { draw_transport(frame); });
  draw_status(frame, status, size.x);
  if (side > 0) draw_level_splitter(frame, bar.y, bar.y + grip, status.y - tool);
  draw_stop(frame, {size.x - look.px.m, strip.y - look.px(52)});
  message_.draw(look, stack.min(), stack.max());
}

/// Between the transport and the side: dragged, it gives the one what it takes from the other.
void Shell::draw_level_splitter(Frame& frame, float top, float bottom, float foot) {
  const Look& look = frame.look;
  const float width = ImGui::GetIO().DisplaySize.x, middle = std::round((top + bottom) * 0.5f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  area("level splitter", {0, top}, {width, bottom - top}, look.theme.panel, {0, 0}, [&] {
    ImGui::InvisibleButton("drag", {width, bottom - top});
    const bool held = ImGui::IsItemActive(), lit = held || ImGui::IsItemHovered();
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    const float grip = look.px(20), thick = look.px(2);
    ImGui::GetWindowDrawList()->AddRectFilled({width * 0.5f - grip, middle - thick},
                                              {width * 0.5f + grip, middle + thick},
                                              lit ? look.theme.accent : look.theme.faint, thick);
    if (!held) return;
    const float wanted =
        (foot - ImGui::GetIO().MousePos.y - (bottom - top) * 0.5f) / ImGui::GetIO().DisplaySize.y;
    panels_.side_share = std::clamp(wanted, kLeastShare, kLargestShare);
  });
  ImGui::PopStyleVar();
}

}  // namespace replan::ui
