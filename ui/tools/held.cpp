#include "ui/tools/held.hpp"

#include "ui/canvas/view_state.hpp"
#include "ui/tools/cells.hpp"

namespace replan::ui {
namespace {

class HeldStart final : public HeldDrag {
  void put(ToolContext& context, Cell to) override {
    context.commands.emplace_back(SetStart{to, context.press.stroke});
  }
};

class HeldGoal final : public HeldDrag {
  void put(ToolContext& context, Cell to) override {
    context.commands.emplace_back(SetGoal{to, context.press.stroke});
  }
};

class HeldRobot final : public HeldDrag {
  void put(ToolContext& context, Cell to) override {
    if (!is_wall(context.run, to)) context.commands.emplace_back(PutRobot{to, context.press.stroke});
  }
};

std::unique_ptr<Drag> hold_robot() {
  return std::make_unique<HeldRobot>();
}

}  // namespace

void HeldDrag::move(ToolContext& context) {
  const Press& press = context.press;
  const bool fresh =
      been_.insert(context.run.lattice().node(press.last)).second || press.last != press.before;
  if (press.moved && fresh) put(context, press.last);
}

void HeldDrag::end(ToolContext& context) {
  if (!context.press.moved) context.view.tools.chosen().click(context);
}

std::unique_ptr<Drag> hold_start() {
  return std::make_unique<HeldStart>();
}

std::unique_ptr<Drag> hold_goal() {
  return std::make_unique<HeldGoal>();
}

std::unique_ptr<Drag> grab(const Run& run, const Pointer& pointer) {
  if (!pointer.inside) return nullptr;
  std::unique_ptr<Drag> (*hold)() = nullptr;
  double nearest = pointer.reach;
  const auto try_one = [&](Cell at, std::unique_ptr<Drag> (*how)()) {
    if (distance(pointer.cell, at) > nearest) return;
    nearest = distance(pointer.cell, at);
    hold = how;
  };
  const Cell start = run.scenario().start, robot = robot_cell(run);
  try_one(goal_cell(run), hold_goal);
  try_one(start, hold_start);
  if (robot != start) try_one(robot, hold_robot);  // before that it is the start that is seen
  return hold == nullptr ? nullptr : hold();
}

}  // namespace replan::ui
