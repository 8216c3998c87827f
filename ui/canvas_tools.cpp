#include "ui/canvas_tools.hpp"

#include <algorithm>
#include <cmath>

namespace replan::ui {
namespace {

/// Numbers strokes over all canvases, so that no two are undone as one.
std::uint64_t next_stroke() {
  static std::uint64_t last = 0;
  return ++last;
}

Cell clamped(const Grid2& lattice, Cell cell) {
  return {std::clamp(cell.x, 0, lattice.width() - 1), std::clamp(cell.y, 0, lattice.height() - 1)};
}

double distance(Cell a, Cell b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

bool blocked(const Run& run, Cell cell) {
  return run.lattice().contains(cell) && run.timeline().state().truly_blocked(run.lattice().node(cell));
}

}  // namespace

CellRect Hand::brush(Cell cell, int side) {
  const Cell low{cell.x - (side - 1) / 2, cell.y - (side - 1) / 2};
  return {low, {low.x + side - 1, low.y + side - 1}};
}

bool Hand::could_hold(const Session& session, const Pointer& pointer) {
  const Scenario& scenario = session.scenario();
  return pointer.inside && std::min(distance(pointer.cell, scenario.start),
                                    distance(pointer.cell, scenario.goal)) <= pointer.reach;
}

std::optional<CellRect> Hand::preview() const {
  if (action_ != Action::rectangle && action_ != Action::surprise) return std::nullopt;
  return CellRect{{std::min(first_.x, last_.x), std::min(first_.y, last_.y)},
                  {std::max(first_.x, last_.x), std::max(first_.y, last_.y)}};
}

void Hand::update(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
                  std::vector<Command>& commands) {
  if (action_ == Action::none) {
    if (!pointer.inside || !(pointer.left_pressed || pointer.right_pressed)) return;
    press(session, run, state, pointer);
    move(run, state, pointer, commands);
    return;
  }
  const bool held = right_ ? pointer.right_down : pointer.left_down;
  move(run, state, pointer, commands);
  if (!held) release(run, state, commands);
}

void Hand::press(const Session& session, const Run& run, const ViewState& state, const Pointer& pointer) {
  const Scenario& scenario = session.scenario();
  right_ = !pointer.left_pressed;
  stroke_ = next_stroke();
  done_.clear();
  moved_ = false;
  first_ = last_ = clamped(run.lattice(), pointer.cell);
  blocked_ = !right_ && state.tool != Tool::erase && !blocked(run, first_);
  if (!right_ && could_hold(session, pointer)) {
    const bool start = distance(pointer.cell, scenario.start) <= distance(pointer.cell, scenario.goal);
    action_ = start ? Action::start : Action::goal;
    return;
  }
  if (right_) {
    action_ = Action::brush;
    return;
  }
  switch (state.tool) {
    case Tool::select:
      action_ = Action::pin;
      break;
    case Tool::paint:
    case Tool::erase:
      action_ = Action::brush;
      break;
    case Tool::rectangle:
      action_ = Action::rectangle;
      break;
    case Tool::start:
      action_ = Action::start;
      break;
    case Tool::goal:
      action_ = Action::goal;
      break;
    case Tool::surprise:
      action_ = Action::surprise;
      break;
  }
  moved_ = state.tool == Tool::start || state.tool == Tool::goal;  // a click puts them there
}

void Hand::move(const Run& run, const ViewState& state, const Pointer& pointer,
                std::vector<Command>& commands) {
  const Cell to = action_ == Action::brush ? pointer.cell : clamped(run.lattice(), pointer.cell);
  const Cell from = last_;
  if (to != from) moved_ = true;
  last_ = to;
  if (action_ == Action::start || action_ == Action::goal) {
    const bool fresh = done_.insert(run.lattice().node(to)).second || to != from;
    if (!moved_ || !fresh) return;
    if (action_ == Action::start)
      commands.emplace_back(SetStart{to, stroke_});
    else
      commands.emplace_back(SetGoal{to, stroke_});
    return;
  }
  if (action_ != Action::brush) return;
  // The mouse may have leapt over cells since the last frame.
  PaintCells paint{{}, stroke_};
  const int steps = std::max({std::abs(to.x - from.x), std::abs(to.y - from.y), 1});
  for (int i = 0; i <= steps; ++i) {
    const auto between = [&](int a, int b) {
      return a + static_cast<int>(std::lround((b - a) * (static_cast<double>(i) / steps)));
    };
    dab(run, {between(from.x, to.x), between(from.y, to.y)}, state.brush, paint.cells);
  }
  if (!paint.cells.empty()) commands.emplace_back(std::move(paint));
}

void Hand::release(const Run& run, ViewState& state, std::vector<Command>& commands) {
  if (action_ == Action::rectangle) {
    if (PaintCells paint{filled(run), stroke_}; !paint.cells.empty()) commands.emplace_back(std::move(paint));
  } else if (action_ == Action::surprise) {
    if (DropSurprise drop{filled(run), stroke_}; !drop.cells.empty()) commands.emplace_back(std::move(drop));
  } else if (!moved_ && (action_ == Action::pin || (holds() && state.tool == Tool::select))) {
    const bool again = state.view.pinned == first_;
    state.view.pinned = again ? std::nullopt : std::optional<Cell>(first_);
  }
  action_ = Action::none;
}

/// Start, goal and robot keep standing on free ground while others are painted around them.
bool Hand::protects(const Run& run, Cell cell) const {
  const NodeId robot = run.timeline().state().node(Scalar::robot);
  return blocked_ &&
         (cell == run.scenario().start || cell == run.scenario().goal || run.lattice().node(cell) == robot);
}

void Hand::dab(const Run& run, Cell cell, int side, std::vector<CellChange>& changes) {
  const CellRect area = brush(cell, side);
  for (int y = area.low.y; y <= area.high.y; ++y)
    for (int x = area.low.x; x <= area.high.x; ++x) {
      const Cell at{x, y};
      if (!run.lattice().contains(at) || protects(run, at) || !done_.insert(run.lattice().node(at)).second)
        continue;
      if (blocked(run, at) != blocked_) changes.push_back({at, blocked_});
    }
}

std::vector<CellChange> Hand::filled(const Run& run) const {
  std::vector<CellChange> changes;
  const CellRect area = *preview();
  for (int y = area.low.y; y <= area.high.y; ++y)
    for (int x = area.low.x; x <= area.high.x; ++x)
      if (const Cell at{x, y}; !protects(run, at) && blocked(run, at) != blocked_)
        changes.push_back({at, blocked_});
  return changes;
}

}  // namespace replan::ui
