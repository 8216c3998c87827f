#include "ui/tools/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "ui/canvas/cell_pen.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

class MeasureDrag final : public Drag {
 public:
  explicit MeasureDrag(std::optional<Measure>& measure) : measure_(measure) {}
  void move(ToolContext& context) override { measure_ = Measure{context.press.first, context.press.last}; }
  void end(ToolContext& context) override {
    if (!context.press.moved) measure_.reset();
  }

 private:
  std::optional<Measure>& measure_;
};

}  // namespace

std::unique_ptr<Drag> MeasureTool::press(ToolContext&) {
  return std::make_unique<MeasureDrag>(measure_);
}

void MeasureTool::draw(const CellPen& pen, const ViewState&, std::optional<Cell>) const {
  if (!measure_) return;
  const Look& look = pen.look();
  const ImVec2 a = pen.middle(measure_->from), b = pen.middle(measure_->to);
  const ImVec2 corner(b.x, a.y);
  pen.dashed(a, corner, with_alpha(look.theme.accent, 0.45f));
  pen.dashed(corner, b, with_alpha(look.theme.accent, 0.45f));
  pen.list().AddLine(a, b, look.theme.accent, look.px(2));
  for (const ImVec2 end : {a, b}) {
    pen.list().AddCircleFilled(end, look.px(4), look.theme.accent);
    pen.list().AddCircleFilled(end, look.px(2), look.theme.outline);
  }
  const std::string words = measure_text(measured(*measure_), pen.map().resolution, pen.map().box().solid());
  const std::array<TextRun, 1> runs = {{{words, look.theme.text, look.fonts.mono}}};
  // On the side of the end that the line does not come from, and inside the canvas.
  const float width = text_width(look.fonts.mono, words) + look.px(24);
  const ImVec2 low = pen.list().GetClipRectMin(), high = pen.list().GetClipRectMax();
  const float x =
      std::clamp(b.x - width * 0.5f, low.x + look.px.s, std::max(low.x + look.px.s, high.x - width));
  const float y = b.y >= a.y ? b.y + look.px.m : b.y - look.px(40);
  chip(look, pen.list(), {x, std::clamp(y, low.y + look.px.s, high.y - look.px(40))}, runs);
}

MeasureFigures measured(const Measure& measure) {
  MeasureFigures figures;
  figures.dx = measure.to.x - measure.from.x;
  figures.dy = measure.to.y - measure.from.y;
  figures.dz = measure.to.z - measure.from.z;
  figures.straight = distance(measure.from, measure.to);
  std::array<int, 3> ways = {std::abs(figures.dx), std::abs(figures.dy), std::abs(figures.dz)};
  std::sort(ways.begin(), ways.end());
  figures.octile =
      ways[0] * std::numbers::sqrt3 + (ways[1] - ways[0]) * std::numbers::sqrt2 + ways[2] - ways[1];
  figures.degrees = std::atan2(-figures.dy, figures.dx) * 180 / std::numbers::pi;
  if (figures.degrees < 0) figures.degrees += 360;
  return figures;
}

std::string measure_text(const MeasureFigures& figures, double resolution, bool solid) {
  std::array<char, 160> text{};
  std::array<char, 32> metres{}, last{};
  if (resolution != 1)
    std::snprintf(metres.data(), metres.size(), " · %.2f m", figures.straight * resolution);
  if (solid)
    std::snprintf(last.data(), last.size(), ", dz %d", figures.dz);
  else
    std::snprintf(last.data(), last.size(), " · %.1f°", figures.degrees + 0.0);
  std::snprintf(text.data(), text.size(), "%.2f cells%s · octile %.2f · dx %d, dy %d%s", figures.straight,
                metres.data(), figures.octile, figures.dx, figures.dy, last.data());
  return text.data();
}

ToolKind measure_tool() {
  return {.label = "Measure",
          .icon = icon::arrows_h,
          .chord = plain('D'),
          .teach = "Drag to read a distance: straight, over the grid, and its angle. Nothing is changed.",
          .group = ToolGroup::measure,
          .make = make_part<Tool, MeasureTool>};
}

}  // namespace replan::ui
