#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/held.hpp"

namespace replan::ui {

ToolKind start_tool() {
  return {.label = "Move the start",
          .icon = icon::start,
          .chord = plain('O'),
          .teach = "Click where the robot shall set out. The plan begins afresh.",
          .group = ToolGroup::ends,
          .make = make_part<Tool, HoldingTool<hold_start>>,
          .colour = &Theme::start};
}

}  // namespace replan::ui
