#include "ui/canvas/hand.hpp"

#include "ui/tools/cells.hpp"
#include "ui/tools/held.hpp"

namespace replan::ui {
namespace {

/// Numbers strokes over all canvases, so that no two are undone as one.
std::uint64_t next_stroke() {
  static std::uint64_t last = 0;
  return ++last;
}

}  // namespace

bool Hand::could_hold(const Run& run, const ViewState& state, const Pointer& pointer) const {
  return !busy_ && state.tools.chosen().grabs() && grab(run, pointer) != nullptr;
}

CellPreview Hand::preview(const ViewState& state, const Sheet& sheet, std::optional<Cell> hovered) const {
  if (drag_) return drag_->preview(press_, state);
  return busy_ || !hovered ? CellPreview{} : state.tools.chosen().preview(state, sheet, *hovered);
}

void Hand::update(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
                  std::vector<Command>& commands) {
  ToolContext context{session, run, state, commands, pointer, press_};
  if (!busy_) {
    if (!(pointer.left_pressed || pointer.right_pressed)) return;
    const bool beside = pointer.over && state.tools.chosen().begins_outside(!pointer.left_pressed);
    if (!pointer.inside && !beside) return;
    press(context);
    move(context);
  } else {
    move(context);
    if (press_.right ? !pointer.right_down : !pointer.left_down) {
      if (drag_) drag_->end(context);
      drag_.reset();
      busy_ = false;
    }
  }
  state.editing.stroke = drag_ && drag_->draws() ? press_.kind : StrokeKind::none;
}

void Hand::press(ToolContext& context) {
  const Run& run = context.run;
  const Cell at = context.pointer.cell;
  const bool right = !context.pointer.left_pressed, outside = !context.pointer.inside;
  press_ = {.right = right,
            .moved = false,
            .sheet = context.pointer.sheet,
            .first = at,
            .before = at,
            .last = at,
            .outside = outside,
            .kind = StrokeKind::paints,
            .stroke = next_stroke()};
  if (!outside && is_wall(run, at)) press_.kind = StrokeKind::erases_wall;
  if (right) press_.kind = StrokeKind::erases;
  busy_ = true;
  Tool& tool = context.view.tools.chosen();
  if (right) {
    drag_ = tool.press_right(context);
    return;
  }
  drag_ = tool.grabs() ? grab(run, context.pointer) : nullptr;
  if (!drag_) drag_ = tool.press(context);
}

void Hand::move(ToolContext& context) {
  const bool anywhere = drag_ && drag_->leaves_world();
  press_.before = press_.last;
  press_.last = anywhere ? context.pointer.cell : clamped(context.run.lattice(), context.pointer.cell);
  if (press_.last != press_.before) press_.moved = true;
  if (drag_) drag_->move(context);
}

}  // namespace replan::ui
