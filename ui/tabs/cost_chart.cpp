#include "ui/tabs/cost_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/shell/format.hpp"
#include "ui/widgets/column_line.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {

void CostAxes::take(double cost) {
  low = std::min(low, cost);
  high = std::max(high, cost);
}

float CostAxes::x(std::int64_t at) const {
  return min.x + static_cast<float>(std::min(1.0, static_cast<double>(at) / count)) * (max.x - min.x);
}

float CostAxes::y(double cost) const {
  if (!(high > low)) return max.y;
  const double part = scale == CostScale::logarithmic
                          ? std::log(std::max(cost, low) / low) / std::log(high / low)
                          : (cost - low) / (high - low);
  return max.y - static_cast<float>(part) * (max.y - min.y);
}

double CostAxes::count_at(float x) const {
  return std::clamp(static_cast<double>((x - min.x) / std::max(max.x - min.x, 1.0f)), 0.0, 1.0) * count;
}

CostChart::CostChart(Frame& frame, const char* id, float height, CostScale scale)
    : look_(frame.look),
      list_(*ImGui::GetWindowDrawList()),
      origin_(ImGui::GetCursorScreenPos()),
      width_(std::max(ImGui::GetContentRegionAvail().x, 1.0f)),
      height_(height) {
  axes.scale = scale;
  ImGui::InvisibleButton(id, {width_, height + look_.px(20)});
  const bool pressed = ImGui::IsItemActive();
  over_ = pressed || ImGui::IsItemHovered();
  asks_ = pressed && (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0);
}

bool CostChart::lay_out(LengthUnit lengths, int decimals, const std::string& end) {
  if (axes.empty()) return false;
  const ImFont* small = look_.fonts.mono_small;
  const float right = origin_.x + width_;
  const std::string high = lengths.text(axes.high, decimals), low = lengths.text(axes.low, decimals);
  axes.min = {origin_.x, origin_.y + look_.px(6)};
  axes.max = {right - std::max(text_width(small, high), text_width(small, low)) - look_.px.s,
              origin_.y + height_ - look_.px(4)};
  list_.AddRectFilled({axes.min.x, axes.max.y}, {right, axes.max.y + look_.px.hair}, look_.theme.line);
  const auto label = [&](const std::string& words, float x, float y) {
    draw_text(list_, small, {x - text_width(small, words), y}, look_.theme.faint, words);
  };
  label(high, right, axes.min.y - look_.px(4));
  if (axes.high > axes.low) label(low, right, axes.max.y - small->FontSize);
  draw_text(list_, small, {axes.min.x, axes.max.y + look_.px(3)}, look_.theme.faint, "0");
  label(end, axes.max.x, axes.max.y + look_.px(3));
  return true;
}

float CostChart::thickness(CurveMark mark) const {
  return look_.px(mark == CurveMark::thick ? 1.5f : 1);
}

void CostChart::steps(std::span<const CostPoint> curve, std::int64_t end, ImU32 colour, CurveMark mark) {
  const float thick = thickness(mark);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (std::isinf(curve[i].cost)) continue;
    const bool last = i + 1 == curve.size();
    const float from = axes.x(curve[i].at), y = axes.y(curve[i].cost),
                to = axes.x(last ? end : curve[i + 1].at);
    list_.AddRectFilled({from, y - thick / 2}, {std::max(to, from + thick), y + thick / 2}, colour);
    if (last || std::isinf(curve[i + 1].cost)) continue;
    const float next = axes.y(curve[i + 1].cost);
    list_.AddRectFilled({to - thick / 2, std::min(y, next)}, {to + thick / 2, std::max(y, next)}, colour);
  }
}

void CostChart::line(std::span<const CostPoint> curve, ImU32 colour, CurveMark mark) {
  std::vector<ImVec2> points;
  for (const CostPoint& point : curve) points.push_back({axes.x(point.at), axes.y(point.cost)});
  draw_long_line(list_, points, colour, thickness(mark));
}

void CostChart::level(double cost, ImU32 colour) {
  const float y = axes.y(cost), dash = look_.px(4);
  for (float x = axes.min.x; x < axes.max.x; x += 2 * dash)
    list_.AddRectFilled({x, y}, {std::min(x + dash, axes.max.x), y + look_.px.hair}, colour);
}

void CostChart::dot(const CostPoint& point, ImU32 colour) {
  list_.AddCircleFilled({axes.x(point.at), axes.y(point.cost)}, look_.px(3), colour);
}

void CostChart::playhead(std::int64_t at) {
  const float x = std::round(axes.x(at));
  list_.AddRectFilled({x, origin_.y}, {x + look_.px.hair, origin_.y + height_}, look_.theme.text);
}

void CostChart::keys(std::span<const CurveKey> keys) {
  const ImFont* small = look_.fonts.small;
  const float swatch = look_.px(14), gap = look_.px(4), row = look_.px(18);
  const ImVec2 begin = ImGui::GetCursorScreenPos();
  ImVec2 at = begin;
  for (const CurveKey& key : keys) {
    const float room = swatch + gap + text_width(small, key.label);
    if (at.x > begin.x && at.x + room > begin.x + width_) at = {begin.x, at.y + row};
    const float y = std::round(at.y + small->FontSize / 2), thick = thickness(key.mark);
    if (key.mark == CurveMark::dot) {
      list_.AddCircleFilled({at.x + swatch / 2, y}, look_.px(3), key.colour);
    } else {
      const float dash = key.mark == CurveMark::dashes ? look_.px(4) : swatch;
      for (float x = 0; x < swatch; x += 2 * dash)
        list_.AddRectFilled({at.x + x, y - thick / 2}, {at.x + std::min(x + dash, swatch), y + thick / 2},
                            key.colour);
    }
    draw_text(list_, small, {at.x + swatch + gap, at.y}, look_.theme.dim, key.label);
    at.x += room + look_.px(12);
  }
  ImGui::Dummy({width_, at.y - begin.y + row});
}

std::optional<double> CostChart::pointed() const {
  if (!over_ || axes.empty()) return std::nullopt;
  return axes.count_at(ImGui::GetIO().MousePos.x);
}

ImU32 curve_colour(const Frame& frame, std::size_t pane) {
  const Theme& theme = frame.look.theme;
  const std::size_t lead = frame.session.lead();
  if (pane == lead) return theme.accent;
  const std::array<ImU32, 4> others = {theme.warning, theme.mover, theme.goal, theme.dim};
  return others[(pane < lead ? pane : pane - 1) % others.size()];
}

std::string curve_name(const Frame& frame, std::size_t pane) {
  const std::string name(frame.session.runs()[pane]->info().name);
  return frame.session.runs().size() < 2 ? name : std::to_string(pane + 1) + "  " + name;
}

}  // namespace replan::ui
