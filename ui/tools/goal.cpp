#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/held.hpp"

namespace replan::ui {
namespace {

class GoalTool final : public Tool {
  std::unique_ptr<Drag> press(ToolContext& context) override {
    context.press.moved = true;  // a click puts it there
    return hold_goal();
  }
};

}  // namespace

ToolKind goal_tool() {
  return {.label = "Move the goal",
          .icon = icon::goal_race,
          .chord = plain('G'),
          .teach = "Click where the robot shall go. The plan begins afresh.",
          .group = ToolGroup::ends,
          .make = make_part<Tool, GoalTool>,
          .colour = &Theme::goal};
}

}  // namespace replan::ui
