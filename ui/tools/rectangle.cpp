#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/cells.hpp"

namespace replan::ui {
namespace {

std::vector<CellSpan> cells_between(const Press& press, const ViewState&) {
  return rectangle_on(press.sheet, press.first, press.last);
}

class RectangleTool final : public DrawingTool {
  std::unique_ptr<Drag> press(ToolContext&) override { return std::make_unique<ShapeDrag>(cells_between); }
  std::unique_ptr<Drag> press_right(ToolContext& context) override { return press(context); }
  [[nodiscard]] bool begins_outside(bool) const override { return true; }
};

}  // namespace

ToolKind rectangle_tool() {
  return {
      .label = "Rectangle",
      .icon = icon::square,
      .chord = plain('R'),
      .teach = "Drag from corner to corner to fill a rectangle with obstacles; the right button clears one.",
      .group = ToolGroup::draw,
      .make = make_part<Tool, RectangleTool>};
}

}  // namespace replan::ui
