// The timeline: the curve of expansions, what happened when, and the playhead, which can be dragged.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ui/shell/format.hpp"
#include "ui/shell/panels.hpp"

namespace replan::ui {
namespace {

/// Where events stand on the strip.
struct Scale {
  float left;
  float right;
  std::size_t size;  // of the log

  [[nodiscard]] float x(std::size_t event) const {
    return size == 0 ? left
                     : left + static_cast<float>(static_cast<double>(event) / static_cast<double>(size)) *
                                  (right - left);
  }
  [[nodiscard]] std::size_t event(float at) const {
    const double part = std::clamp((at - left) / std::max(right - left, 1.0f), 0.0f, 1.0f);
    return static_cast<std::size_t>(std::llround(part * static_cast<double>(size)));
  }
};

/// Expansions per event at a place between 0 and 1 of the curve, between its chunks' middles.
float density(std::span<const std::uint32_t> curve, double place) {
  const double at = std::max(0.0, place * static_cast<double>(curve.size()) - 0.5);
  const auto low = std::min(static_cast<std::size_t>(at), curve.size() - 1);
  const auto high = std::min(low + 1, curve.size() - 1);
  const auto part = static_cast<float>(at - static_cast<double>(low));
  return static_cast<float>(curve[low]) * (1 - part) + static_cast<float>(curve[high]) * part;
}

/// The mean over the chunks that a column of the strip covers.
float column(std::span<const std::uint32_t> curve, double from, double to) {
  const auto count = static_cast<double>(curve.size());
  const auto first = static_cast<std::size_t>(from * count), last = static_cast<std::size_t>(to * count);
  if (last <= first + 1) return density(curve, (from + to) * 0.5);
  double sum = 0;
  for (std::size_t i = first; i < std::min(last, curve.size()); ++i) sum += curve[i];
  return static_cast<float>(sum / static_cast<double>(last - first));
}

void draw_curve(const Look& look, ImDrawList& list, const Run& run, const Scale& scale, float top,
                float bottom) {
  // The last chunk is as a rule not full; it would look like a drop.
  const std::size_t whole = run.timeline().size() / Run::kCurveChunk;
  const auto curve =
      run.expansion_curve().first(std::min(std::max<std::size_t>(whole, 1), run.expansion_curve().size()));
  if (curve.empty()) return;
  const float step = std::max(look.px(2), 1.0f);
  std::vector<float> heights;
  for (float x = scale.left; x < scale.right; x += step) {
    const double from = (x - scale.left) / (scale.right - scale.left);
    heights.push_back(column(curve, from, from + step / (scale.right - scale.left)));
  }
  if (heights.empty()) return;  // no room for a curve
  const float highest = std::max(*std::max_element(heights.begin(), heights.end()), 1.0f);
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const float x = scale.left + static_cast<float>(i) * step;
    const float a = bottom - heights[i] / highest * (bottom - top),
                b = bottom - heights[i + 1] / highest * (bottom - top);
    list.AddQuadFilled({x, a}, {x + step, b}, {x + step, bottom}, {x, bottom}, look.theme.series);
  }
}

/// How an event of the log is marked: by shape and by colour.
enum class Shape { triangle, diamond, circle, cross };
struct MarkStyle {
  Shape shape;
  ImU32 colour;
  const char* name;
};

std::optional<MarkStyle> style_of(const Theme& theme, const Run& run, const Marker& marker) {
  switch (marker.kind) {
    case EventKind::plan_begin: {
      const std::uint64_t number = run.timeline().event(marker.event).delta;
      if (number == 0) return MarkStyle{Shape::triangle, theme.start, "The first plan begins"};
      return MarkStyle{Shape::triangle, theme.surprise, "A replan begins"};
    }
    case EventKind::surprise:
      return MarkStyle{Shape::diamond, theme.surprise, "A surprise: the world changes"};
    case EventKind::new_goal:
      return MarkStyle{Shape::diamond, theme.goal, "The goal moves: a plan from scratch"};
    case EventKind::put_down:
      return MarkStyle{Shape::diamond, theme.start, "The robot is put down elsewhere"};
    case EventKind::arrival:
      return MarkStyle{Shape::circle, theme.goal, "The robot arrives"};
    case EventKind::collision:
      return MarkStyle{Shape::cross, theme.bad, "The robot would hit an obstacle"};
    case EventKind::gave_up:
      return MarkStyle{Shape::cross, theme.bad, "The mission ends without arrival"};
    default:
      return std::nullopt;
  }
}

void draw_mark(const Look& look, ImDrawList& list, ImVec2 at, const MarkStyle& style) {
  const float r = look.px(5);
  switch (style.shape) {
    case Shape::triangle:
      list.AddTriangleFilled({at.x, at.y - r}, {at.x + r, at.y + r}, {at.x - r, at.y + r}, style.colour);
      break;
    case Shape::diamond:
      list.AddQuadFilled({at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y},
                         style.colour);
      break;
    case Shape::circle:
      list.AddCircleFilled(at, r, style.colour);
      break;
    case Shape::cross:
      list.AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, style.colour, look.px(2));
      list.AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, style.colour, look.px(2));
      break;
  }
}

/// Draws the marks and returns the one under the mouse.
std::optional<std::pair<Marker, MarkStyle>> draw_marks(const Look& look, ImDrawList& list, const Run& run,
                                                       const Scale& scale, float y) {
  std::optional<std::pair<Marker, MarkStyle>> hovered;
  std::array<float, 4> last;
  last.fill(-1e9f);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (const Marker& marker : run.markers()) {
    const std::optional<MarkStyle> style = style_of(look.theme, run, marker);
    if (!style) continue;
    const float x = scale.x(marker.event);
    float& before = last[static_cast<std::size_t>(style->shape)];
    if (x - before < look.px(3)) continue;  // a crowd of one kind is one mark
    before = x;
    draw_mark(look, list, {x, y}, *style);
    if (std::abs(mouse.x - x) < look.px(6) && std::abs(mouse.y - y) < look.px(8)) hovered = {marker, *style};
  }
  return hovered;
}

void draw_playhead(const Look& look, ImDrawList& list, const Scale& scale, std::size_t cursor, float top,
                   float track) {
  const float x = std::round(scale.x(cursor));
  const float half = look.px(2);
  list.AddRectFilled({scale.left, track - half}, {scale.right, track + half}, look.theme.line, half);
  list.AddRectFilled({scale.left, track - half}, {x, track + half}, look.theme.accent, half);
  list.AddRectFilled({x - look.px.hair, top}, {x + look.px.hair, track}, look.theme.text);
  list.AddCircleFilled({x, track}, look.px(6), look.theme.text);
}

void marker_hint(const Look& look, const Run& run, const Marker& marker, const MarkStyle& style) {
  std::string title = style.name;
  if (marker.kind == EventKind::plan_begin && run.timeline().event(marker.event).delta != 0)
    title = "Replan " + std::to_string(run.timeline().event(marker.event).delta) + " begins";
  hint(look, {title.c_str(), "", ("Event " + grouped(marker.event) + ". Click to go there.").c_str()});
}

}  // namespace

void draw_timeline(Frame& frame, ImVec2 min, ImVec2 max) {
  const Look& look = frame.look;
  const Run& run = frame.session.run();
  const Scale scale{min.x, max.x, run.timeline().size()};
  const float track = max.y - look.px(17);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_curve(look, list, run, scale, min.y + look.px(6), track - look.px(2));
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("timeline", {std::max(max.x - min.x, 1.0f), max.y - min.y});
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const auto mark = draw_marks(look, list, run, scale, track + look.px(12));
  if (active) {
    // A click on a mark goes behind its event, where its effect shows; a drag goes where the mouse is.
    const bool clicked = ImGui::IsItemActivated() && mark;
    const std::size_t target = clicked ? mark->first.event + 1 : scale.event(ImGui::GetIO().MousePos.x);
    if (frame.session.playback().direction != 0) frame.commands.push_back(Play{0});
    if (ImGui::IsItemActivated() || ImGui::GetIO().MouseDelta.x != 0) frame.commands.push_back(Seek{target});
  } else if (hovered && mark) {
    marker_hint(look, run, mark->first, mark->second);
  }
  draw_playhead(look, list, scale, run.timeline().cursor(), min.y, track);
}

}  // namespace replan::ui
