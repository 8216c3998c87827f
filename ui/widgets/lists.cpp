// Lists that scroll by row (see widgets.hpp).
#include <algorithm>
#include <cmath>

#include <imgui_internal.h>

#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// The list between begin_rows() and end_rows(); lists do not nest.
struct OpenList {
  const Look* look = nullptr;
  RowScroll* scroll = nullptr;
  ImVec2 origin, size;
  double rows = 0;  // in all
  double fit = 0;   // that fit into the height
};
OpenList open;  // of the drawing thread, as all of ImGui's state

float height_or_rest(const Look& look, float height) {
  return std::max(height > 0 ? height : ImGui::GetContentRegionAvail().y, look.px.row);
}

double furthest(double rows, double fit) {
  return std::max(rows - fit, 0.0);
}

/// The bar beside the rows, in the padding of the window. Its knob never gets shorter than can be grabbed.
void scroll_bar() {
  const Look& look = *open.look;
  if (open.rows <= open.fit) return;
  const float width = look.px(6), left = open.origin.x + open.size.x + look.px(1);
  ImGui::SetCursorScreenPos({left, open.origin.y});
  ImGui::InvisibleButton("bar", {width, open.size.y});
  const bool active = ImGui::IsItemActive();
  const float knob = std::max(static_cast<float>(open.fit / open.rows) * open.size.y, look.px(20));
  const float way = open.size.y - knob;
  const double last = furthest(open.rows, open.fit);
  if (active && way > 0) {
    const double at = (ImGui::GetIO().MousePos.y - open.origin.y - knob * 0.5f) / way;
    open.scroll->first = std::clamp(at, 0.0, 1.0) * last;
  }
  const float top = open.origin.y + static_cast<float>(open.scroll->first / last) * way;
  const ImU32 colour = active ? look.theme.dim : ImGui::IsItemHovered() ? look.theme.faint : look.theme.line;
  ImGui::GetWindowDrawList()->AddRectFilled({left, top}, {left + width, top + knob}, colour, width * 0.5f);
}

}  // namespace

RowsInSight begin_rows(const Look& look, const char* id, std::size_t count, float height, RowScroll& scroll) {
  const float whole = height_or_rest(look, height), row = look.px.row;
  ImGui::PushID(id);
  open = {&look,
          &scroll,
          ImGui::GetCursorScreenPos(),
          {ImGui::GetContentRegionAvail().x, whole},
          static_cast<double>(count),
          static_cast<double>(whole) / static_cast<double>(row)};
  ImGui::BeginChild("rows", open.size, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const double last = furthest(open.rows, open.fit);
  constexpr double kRowsPerNotch = 3;
  if (ImGui::IsWindowHovered() && last > 0)
    scroll.first -= kRowsPerNotch * static_cast<double>(ImGui::GetIO().MouseWheel);
  scroll.first = std::clamp(scroll.first, 0.0, last);
  const auto first = static_cast<std::size_t>(scroll.first);
  const auto hidden = static_cast<float>(scroll.first - static_cast<double>(first)) * row;
  ImGui::SetCursorPosY(-std::floor(hidden));
  return {first, std::min(first + static_cast<std::size_t>(std::ceil(open.fit)) + 1, count)};
}

void end_rows() {
  ImGui::EndChild();
  scroll_bar();
  ImGui::PopID();
  ImGui::SetCursorScreenPos({open.origin.x, open.origin.y + open.size.y});
  ImGui::Dummy({0, 0});
}

void reveal_row(const Look& look, std::size_t row, std::size_t count, float height, RowScroll& scroll) {
  const double fit = static_cast<double>(height_or_rest(look, height)) / static_cast<double>(look.px.row);
  const auto at = static_cast<double>(row);
  if (at < scroll.first) scroll.first = at;
  if (at + 1 > scroll.first + fit) scroll.first = at + 1 - fit;
  scroll.first = std::clamp(scroll.first, 0.0, furthest(static_cast<double>(count), fit));
}

}  // namespace replan::ui
