#include "ui/tools/held.hpp"

#include <algorithm>

#include "ui/canvas/cell_pen.hpp"
#include "ui/canvas/view_state.hpp"
#include "ui/tools/cells.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui {
namespace {

/// The start, the goal or the robot. None is put into a wall: where the mouse crosses one it waits before it, and goes
/// back to where it stood if it is let go of there.
class HeldMarker : public HeldDrag {
 public:
  void end(ToolContext& context) final {
    HeldDrag::end(context);
    const bool refused = context.press.moved && is_wall(context.run, context.press.last);
    if (refused && home_ && place(context.run) != *home_) set(context, *home_);
  }

 private:
  void put(ToolContext& context, Cell to) final {
    if (!home_) home_ = place(context.run);
    if (!is_wall(context.run, to)) set(context, to);
  }
  virtual void set(ToolContext& context, Cell to) = 0;
  [[nodiscard]] virtual Cell place(const Run& run) const = 0;

  std::optional<Cell> home_;  // where it stood
};

class HeldStart final : public HeldMarker {
  void set(ToolContext& context, Cell to) override {
    context.commands.emplace_back(SetStart{to, context.press.stroke});
  }
  [[nodiscard]] Cell place(const Run& run) const override { return run.scenario().start; }
};

class HeldGoal final : public HeldMarker {
  void set(ToolContext& context, Cell to) override {
    context.commands.emplace_back(SetGoal{to, context.press.stroke});
  }
  [[nodiscard]] Cell place(const Run& run) const override { return goal_cell(run); }
};

class HeldRobot final : public HeldMarker {
  void set(ToolContext& context, Cell to) override {
    context.commands.emplace_back(PutRobot{to, context.press.stroke});
  }
  [[nodiscard]] Cell place(const Run& run) const override { return robot_cell(run); }
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

void draw_ghost(const CellPen& pen, const ViewState& view, Cell at) {
  const Look& look = pen.look();
  const ImVec2 middle = pen.middle(at);
  const float radius = look.px(8);
  if (!is_wall(pen.run(), at)) {
    pen.list().AddCircleFilled(middle, radius, with_alpha(look.theme.*view.tools.kind().colour, 0.6f));
    pen.list().AddCircle(middle, radius, look.theme.outline, 0, look.px(2));
    return;
  }
  const float arm = radius * 0.7f;
  for (const float side : {-1.0f, 1.0f})
    pen.list().AddLine({middle.x - arm, middle.y - side * arm}, {middle.x + arm, middle.y + side * arm},
                       look.theme.bad, look.px(2.5f));
  const TextRun words{"This is an obstacle. Choose a free cell.", look.theme.bad, look.fonts.ui};
  // Inside the pane, also at its right edge.
  const float width = text_width(words.font, words.text) + 2 * look.px(10);
  const float left = std::min(middle.x + look.px.l, pen.list().GetClipRectMax().x - width - look.px.s);
  chip(look, pen.list(), {left, middle.y + look.px.l}, std::span(&words, 1));
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
    if (!pointer.sheet.has(at) || distance(pointer.cell, at) > nearest) return;
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
