#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/cells.hpp"

namespace replan::ui {
namespace {

class PaintTool final : public DrawingTool {
  std::unique_ptr<Drag> press(ToolContext&) override { return brush_drag(); }
  [[nodiscard]] CellPreview preview(const ViewState& view, const Sheet& sheet, Cell at) const override {
    return {brush_on(sheet, view, at)};
  }
};

}  // namespace

ToolKind paint_tool() {
  return {.label = "Paint obstacles",
          .icon = icon::brush,
          .chord = plain('B'),
          .teach =
              "Draw walls that the robot is told of. A plan that was found is repaired under the brush. A "
              "stroke that "
              "begins on an obstacle erases, and so does the right button.",
          .group = ToolGroup::draw,
          .make = make_part<Tool, PaintTool>};
}

}  // namespace replan::ui
