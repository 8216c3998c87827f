#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/cells.hpp"

namespace replan::ui {
namespace {

class EraseTool final : public DrawingTool {
  std::unique_ptr<Drag> press(ToolContext& context) override {
    context.press.kind = StrokeKind::erases;
    return brush_drag();
  }
  [[nodiscard]] CellPreview preview(const ViewState& view, const Sheet& sheet, Cell at) const override {
    return {brush_on(sheet, view, at), false};
  }
};

}  // namespace

ToolKind erase_tool() {
  return {.label = "Erase obstacles",
          .icon = icon::eraser,
          .chord = plain('E'),
          .teach =
              "Makes cells free again; the robot is told. With every tool that draws, the right button does "
              "the same.",
          .group = ToolGroup::draw,
          .make = make_part<Tool, EraseTool>};
}

}  // namespace replan::ui
