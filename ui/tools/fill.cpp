#include <algorithm>

#include "ui/canvas/view_state.hpp"
#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/cells.hpp"

namespace replan::ui {
namespace {

class FillTool final : public DrawingTool {
  std::unique_ptr<Drag> press(ToolContext& context) override {
    const Run& run = context.run;
    const Cell at = context.press.first;
    const bool wall = is_wall(run, at);
    if (context.press.right && !wall) return nullptr;  // nothing to clear
    const Sheet& sheet = context.press.sheet;
    const int layers = std::min(context.view.layers, sheet.box.depth() - sheet.layer);
    const std::vector<CellSpan> region = connected_spans(
        sheet.box.width(), sheet.box.height(), sheet.box.seen(at),
        [&](Cell cell) { return is_wall(run, sheet.cell(cell.x, cell.y)) == wall; }, kLargeWorld);
    if (count_cells(region) * static_cast<std::size_t>(layers) > kLargeWorld)
      context.commands.emplace_back(FillRegion{at, context.press.adds(), sheet.box.along(), layers});
    else
      paint(context, changes(context, region));
    return nullptr;
  }
  std::unique_ptr<Drag> press_right(ToolContext& context) override { return press(context); }
};

}  // namespace

ToolKind fill_tool() {
  return {
      .label = "Fill a region",
      .icon = icon::fill,
      .chord = plain('K'),
      .teach =
          "Fills the free cells around the cursor up to the next obstacles, or clears connected obstacles.",
      .group = ToolGroup::draw,
      .make = make_part<Tool, FillTool>};
}

}  // namespace replan::ui
