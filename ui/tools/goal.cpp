#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/held.hpp"

namespace replan::ui {

ToolKind goal_tool() {
  return {.label = "Move the goal",
          .icon = icon::goal_race,
          .chord = plain('G'),
          .teach = "Click the cell that the robot has to reach. The plan begins afresh.",
          .group = ToolGroup::ends,
          .make = make_part<Tool, HoldingTool<hold_goal>>,
          .colour = &Theme::goal};
}

}  // namespace replan::ui
