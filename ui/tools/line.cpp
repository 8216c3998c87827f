#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/cells.hpp"

namespace replan::ui {
namespace {

std::vector<CellSpan> straight_stroke(const Press& press, const ViewState& view) {
  return stroke_on(press.sheet, view, press.first, press.last);
}

class LineTool final : public DrawingTool {
  std::unique_ptr<Drag> press(ToolContext&) override { return std::make_unique<ShapeDrag>(straight_stroke); }
  std::unique_ptr<Drag> press_right(ToolContext& context) override { return press(context); }
  [[nodiscard]] CellPreview preview(const ViewState& view, const Sheet& sheet, Cell at) const override {
    return {brush_on(sheet, view, at)};
  }
};

}  // namespace

ToolKind line_tool() {
  return {.label = "Straight line",
          .icon = icon::pencil,
          .chord = plain('I'),
          .teach = "Drag a straight line as wide as the brush; the right button erases one.",
          .group = ToolGroup::draw,
          .make = make_part<Tool, LineTool>};
}

}  // namespace replan::ui
