#include "ui/icons.hpp"
#include "ui/parts.hpp"
#include "ui/tools/held.hpp"

namespace replan::ui {
namespace {

class StartTool final : public Tool {
  std::unique_ptr<Drag> press(ToolContext& context) override {
    context.press.moved = true;  // a click puts it there
    return hold_start();
  }
};

}  // namespace

ToolKind start_tool() {
  return {.label = "Move the start",
          .icon = icon::start,
          .chord = plain('O'),
          .teach = "Click where the robot shall set out. The plan begins afresh.",
          .group = ToolGroup::ends,
          .make = make_part<Tool, StartTool>,
          .colour = &Theme::start};
}

}  // namespace replan::ui
