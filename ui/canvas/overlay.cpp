#include "ui/canvas/overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// Draws in cells.
class Overlayer {
 public:
  Overlayer(const Look& look, ImDrawList& list, const Projection& screen)
      : look_(look), list_(list), screen_(screen) {}

  /// Fills spans and draws the line around all of them; rows must be in order, one span each.
  void area(const std::vector<CellSpan>& spans, ImU32 colour, float fill) {
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const CellSpan& span = spans[i];
      const ImVec2 a = at(span.first, span.y), b = at(span.last + 1, span.y + 1);
      if (fill > 0) list_.AddRectFilled(a, b, with_alpha(colour, fill));
      side({a.x, a.y}, {a.x, b.y}, colour);
      side({b.x, a.y}, {b.x, b.y}, colour);
      edge_towards(span, i > 0 ? &spans[i - 1] : nullptr, a.y, colour);
      edge_towards(span, i + 1 < spans.size() ? &spans[i + 1] : nullptr, b.y, colour);
    }
  }

  void dashed(ImVec2 a, ImVec2 b, ImU32 colour) {
    const float dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy), dash = look_.px(5);
    if (length <= 0) return;
    for (float from = 0; from < length; from += 2 * dash) {
      const float to = std::min(length, from + dash);
      list_.AddLine({a.x + dx * from / length, a.y + dy * from / length},
                    {a.x + dx * to / length, a.y + dy * to / length}, colour, look_.px(1.6f));
    }
  }
  void dashed_frame(const CellRect& rect, ImU32 colour) {
    const ImVec2 a = at(rect.low.x, rect.low.y), b = at(rect.high.x + 1, rect.high.y + 1);
    dashed(a, {b.x, a.y}, colour);
    dashed({b.x, a.y}, b, colour);
    dashed({a.x, b.y}, b, colour);
    dashed(a, {a.x, b.y}, colour);
  }
  [[nodiscard]] ImVec2 at(int x, int y) const {
    const ImVec2 point = screen_({static_cast<double>(x), static_cast<double>(y)});
    return {std::round(point.x), std::round(point.y)};
  }
  [[nodiscard]] ImVec2 middle(Cell cell) const { return screen_({cell.x + 0.5, cell.y + 0.5}); }

 private:
  void side(ImVec2 a, ImVec2 b, ImU32 colour) { list_.AddLine(a, b, colour, look_.px(1.5f)); }
  /// The part of a span's edge at height `y` that its neighbour does not cover.
  void edge_towards(const CellSpan& span, const CellSpan* next, float y, ImU32 colour) {
    const auto part = [&](int first, int last) {
      if (first <= last) side({at(first, 0).x, y}, {at(last + 1, 0).x, y}, colour);
    };
    if (next == nullptr || next->last < span.first || next->first > span.last) {
      part(span.first, span.last);
      return;
    }
    part(span.first, next->first - 1);
    part(next->last + 1, span.last);
  }

  const Look& look_;
  ImDrawList& list_;
  const Projection& screen_;
};

/// What of the spans lies in the world.
std::vector<CellSpan> on_map(const std::vector<CellSpan>& spans, const GridMap& map) {
  std::vector<CellSpan> inside;
  for (const CellSpan& span : spans) {
    const CellSpan cut{span.y, std::max(0, span.first), std::min(map.width - 1, span.last)};
    if (cut.y >= 0 && cut.y < map.height && cut.first <= cut.last) inside.push_back(cut);
  }
  return inside;
}

void draw_measure(const Look& look, ImDrawList& list, Overlayer& over, const Measure& measure,
                  const GridMap& map) {
  const ImVec2 a = over.middle(measure.from), b = over.middle(measure.to);
  const ImVec2 corner(b.x, a.y);
  over.dashed(a, corner, with_alpha(look.theme.accent, 0.45f));
  over.dashed(corner, b, with_alpha(look.theme.accent, 0.45f));
  list.AddLine(a, b, look.theme.accent, look.px(2));
  for (const ImVec2 end : {a, b}) {
    list.AddCircleFilled(end, look.px(4), look.theme.accent);
    list.AddCircleFilled(end, look.px(2), look.theme.outline);
  }
  const std::string words = measure_text(measured(measure), map.resolution);
  const std::array<TextRun, 1> runs = {{{words, look.theme.text, look.fonts.mono}}};
  // On the side of the end that the line does not come from, and inside the canvas.
  const float width = text_width(look.fonts.mono, words) + look.px(24);
  const ImVec2 low = list.GetClipRectMin(), high = list.GetClipRectMax();
  const float x =
      std::clamp(b.x - width * 0.5f, low.x + look.px.s, std::max(low.x + look.px.s, high.x - width));
  const float y = b.y >= a.y ? b.y + look.px.m : b.y - look.px(40);
  chip(look, list, {x, std::clamp(y, low.y + look.px.s, high.y - look.px(40))}, runs);
}

/// The corners so far, the way to the cursor, and the box where it would stand.
void draw_way(const Look& look, ImDrawList& list, Overlayer& over, const ViewState& state,
              std::optional<Cell> hovered) {
  const std::vector<Cell>& way = state.editing.way;
  const ImU32 colour = look.theme.mover;
  const Brush box{state.brush, false};
  for (std::size_t i = 1; i < way.size(); ++i)
    over.dashed(over.middle(way[i - 1]), over.middle(way[i]), colour);
  if (hovered && !way.empty())
    over.dashed(over.middle(way.back()), over.middle(*hovered), with_alpha(colour, 0.6f));
  for (const Cell corner : way) list.AddCircleFilled(over.middle(corner), look.px(3.5f), colour);
  if (!way.empty()) over.area(brush_spans(box, way.front()), colour, 0.25f);
  if (hovered) over.area(brush_spans(box, *hovered), colour, 0);
}

}  // namespace

MeasureFigures measured(const Measure& measure) {
  MeasureFigures figures;
  figures.dx = measure.to.x - measure.from.x;
  figures.dy = measure.to.y - measure.from.y;
  figures.straight = std::hypot(figures.dx, figures.dy);
  const int longer = std::max(std::abs(figures.dx), std::abs(figures.dy)),
            shorter = std::min(std::abs(figures.dx), std::abs(figures.dy));
  figures.octile = longer - shorter + shorter * std::numbers::sqrt2;
  figures.degrees = std::atan2(-figures.dy, figures.dx) * 180 / std::numbers::pi;
  if (figures.degrees < 0) figures.degrees += 360;
  return figures;
}

std::string measure_text(const MeasureFigures& figures, double resolution) {
  std::array<char, 160> text{};
  std::array<char, 32> metres{};
  if (resolution != 1)
    std::snprintf(metres.data(), metres.size(), " · %.2f m", figures.straight * resolution);
  std::snprintf(text.data(), text.size(), "%.2f cells%s · octile %.2f · dx %d, dy %d · %.1f°",
                figures.straight, metres.data(), figures.octile, figures.dx, figures.dy,
                figures.degrees + 0.0);
  return text.data();
}

void draw_tool_overlay(const Look& look, ImDrawList& list, const Projection& screen, const ViewState& state,
                       const GridMap& map, const ToolPreview& preview) {
  Overlayer over(look, list, screen);
  const Editing& editing = state.editing;
  if (editing.region) {
    const CellRect& region = *editing.region;
    over.dashed_frame(region, look.theme.accent);
    list.AddRectFilled(over.at(region.low.x, region.low.y), over.at(region.high.x + 1, region.high.y + 1),
                       with_alpha(look.theme.accent, 0.1f));
  }
  if (const std::vector<CellSpan> cells = on_map(preview.cells, map); !cells.empty()) {
    const bool adds = preview.drawing ? preview.adds : state.tool != Tool::erase;
    const ImU32 colour = !adds                          ? look.theme.dim
                         : state.tool == Tool::surprise ? look.theme.surprise
                                                        : look.theme.accent;
    const bool fills = preview.drawing && adds && state.tool != Tool::paint;
    over.area(cells, colour, fills ? 0.3f : 0);
  }
  if (editing.measure) draw_measure(look, list, over, *editing.measure, map);
  if (state.tool == Tool::mover && (!editing.way.empty() || !editing.mover))
    draw_way(look, list, over, state, preview.hovered);
}

}  // namespace replan::ui
