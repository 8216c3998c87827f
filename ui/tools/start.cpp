#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/held.hpp"

namespace replan::ui {

ToolKind start_tool() {
  return {.label = "Move the start",
          .icon = icon::start,
          .chord = plain('O'),
          .teach = "Click the cell that the robot starts from. The plan begins afresh.",
          .group = ToolGroup::ends,
          .make = make_part<Tool, HoldingTool<hold_start>>,
          .colour = &Theme::start};
}

}  // namespace replan::ui
