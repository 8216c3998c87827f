#include "ui/canvas/hand.hpp"

#include <algorithm>
#include <cmath>

namespace replan::ui {
namespace {

/// Numbers strokes over all canvases, so that no two are undone as one.
std::uint64_t next_stroke() {
  static std::uint64_t last = 0;
  return ++last;
}

Cell clamped(const Box& lattice, Cell cell) {
  return {std::clamp(cell.x, 0, lattice.width() - 1), std::clamp(cell.y, 0, lattice.height() - 1)};
}

bool is_wall(const Run& run, Cell cell) {
  return run.timeline().state().wall(run.lattice().node(cell));
}

/// The cell of a node that the log speaks of, or `otherwise` before it does.
Cell place(const Run& run, NodeId node, Cell otherwise) {
  return node == kNoNode ? otherwise : run.lattice().position(node);
}
Cell goal_cell(const Run& run) {
  return place(run, run.timeline().state().wanted_goal(), run.scenario().goal);
}
Cell robot_cell(const Run& run) {
  return place(run, run.timeline().state().node(Scalar::robot), run.scenario().start);
}

/// Start and goal keep standing on free ground while others are painted around them. What is painted over the
/// robot's own cell is there as it would be by a script: RobotSetup::robot_cell_blocks says what it does.
bool is_protected(const Run& run, Cell cell) {
  return cell == run.scenario().start || cell == goal_cell(run);
}

CellRect rectangle(Cell a, Cell b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

Brush brush_of(const ViewState& state) {
  return {state.brush, state.editing.round};
}

}  // namespace

void select_region(Editing& editing, const CellRect& region) {
  editing.region = region;
  editing.mover.reset();
  editing.surprise.reset();
}

std::optional<Hand::Action> Hand::grabbed(const Run& run, const Pointer& pointer) {
  if (!pointer.inside) return std::nullopt;
  const Cell start = run.scenario().start, robot = robot_cell(run);
  std::optional<Action> found;
  double nearest = pointer.reach;
  const auto try_one = [&](Cell at, Action action) {
    if (distance(pointer.cell, at) > nearest) return;
    nearest = distance(pointer.cell, at);
    found = action;
  };
  try_one(goal_cell(run), Action::goal);
  try_one(start, Action::start);
  if (robot != start) try_one(robot, Action::robot);  // before that it is the start that is seen
  return found;
}

bool Hand::could_hold(const Run& run, const Pointer& pointer) {
  return grabbed(run, pointer).has_value();
}

std::vector<CellSpan> Hand::preview(const ViewState& state, std::optional<Cell> hovered) const {
  switch (action_) {
    case Action::rectangle:
    case Action::surprise:
      return rectangle_spans(first_, last_);
    case Action::line:
      return stroke_spans(brush_of(state), first_, last_);
    case Action::brush:
      return brush_spans(brush_of(state), last_);
    case Action::none:
      break;
    default:
      return {};
  }
  const Tool tool = state.tool;
  if (!hovered || !(tool == Tool::paint || tool == Tool::erase || tool == Tool::line)) return {};
  return brush_spans(brush_of(state), *hovered);
}

void Hand::update(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
                  std::vector<Command>& commands) {
  if (action_ == Action::none) {
    if (!pointer.inside || !(pointer.left_pressed || pointer.right_pressed)) return;
    press(session, run, state, pointer, commands);
    move(session, run, state, pointer, commands);
  } else {
    const bool held = right_ ? pointer.right_down : pointer.left_down;
    move(session, run, state, pointer, commands);
    if (!held) release(session, run, state, commands);
  }
  const bool draws = action_ == Action::brush || action_ == Action::rectangle || action_ == Action::line;
  state.editing.stroke = !draws                                ? StrokeKind::none
                         : adds_                               ? StrokeKind::paints
                         : right_ || state.tool == Tool::erase ? StrokeKind::erases
                                                               : StrokeKind::erases_wall;
}

void Hand::press(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
                 std::vector<Command>& commands) {
  right_ = !pointer.left_pressed;
  stroke_ = next_stroke();
  done_.clear();
  moved_ = false;
  first_ = last_ = clamped(run.lattice(), pointer.cell);
  adds_ = !right_ && state.tool != Tool::erase && !is_wall(run, first_);
  const bool drawing_way = state.tool == Tool::mover && !state.editing.way.empty();
  if (right_ && drawing_way) {
    finish_way(session, state, commands);
    action_ = Action::idle;
    return;
  }
  if (!right_ && !drawing_way && state.tool != Tool::measure)
    if (const auto held = grabbed(run, pointer)) {
      action_ = *held;
      return;
    }
  press_tool(session, run, state, pointer, commands);
}

void Hand::press_tool(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
                      std::vector<Command>& commands) {
  switch (state.tool) {
    case Tool::rectangle:
      action_ = Action::rectangle;
      return;
    case Tool::line:
      action_ = Action::line;
      return;
    case Tool::fill: {
      action_ = Action::idle;
      const bool wall = is_wall(run, first_);
      if (right_ && !wall) return;  // nothing to clear
      PaintCells fill{{}, stroke_};
      write(run,
            connected_spans(run.lattice().width(), run.lattice().height(), first_,
                            [&](Cell cell) { return is_wall(run, cell) == wall; }),
            fill.cells);
      if (!fill.cells.empty()) commands.emplace_back(std::move(fill));
      return;
    }
    default:
      break;
  }
  action_ = Action::brush;
  if (right_) return;
  switch (state.tool) {
    case Tool::select:
      action_ = Action::region;
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
    case Tool::measure:
      action_ = Action::measure;
      state.editing.measure = Measure{first_, first_};
      break;
    case Tool::mover:
      press_way(session, state, pointer, commands);
      break;
    default:
      break;
  }
  moved_ = state.tool == Tool::start || state.tool == Tool::goal;  // a click puts them there
}

void Hand::move(const Session& session, const Run& run, ViewState& state, const Pointer& pointer,
                std::vector<Command>& commands) {
  const Cell to = action_ == Action::brush ? pointer.cell : clamped(run.lattice(), pointer.cell);
  const Cell from = last_;
  if (to != from) moved_ = true;
  last_ = to;
  if (holds()) {
    const bool fresh = done_.insert(run.lattice().node(to)).second || to != from;
    if (moved_ && fresh) move_held(session, run, state, to, commands);
  } else if (action_ == Action::region) {
    if (moved_) select_region(state.editing, rectangle(first_, to));
  } else if (action_ == Action::measure) {
    state.editing.measure->to = to;
  } else if (action_ == Action::brush) {
    // The mouse may have leapt over cells since the last frame.
    PaintCells paint{{}, stroke_};
    write(run, stroke_spans(brush_of(state), from, to), paint.cells);
    if (!paint.cells.empty()) commands.emplace_back(std::move(paint));
  }
}

void Hand::move_held(const Session& session, const Run& run, const ViewState& state, Cell to,
                     std::vector<Command>& commands) {
  switch (action_) {
    case Action::start:
      commands.emplace_back(SetStart{to, stroke_});
      break;
    case Action::goal:
      commands.emplace_back(SetGoal{to, stroke_});
      break;
    case Action::robot:
      if (!is_wall(run, to)) commands.emplace_back(PutRobot{to, stroke_});
      break;
    case Action::corner: {
      const std::vector<MovingObstacle>& movers = session.scenario().movers;
      if (!state.editing.mover || *state.editing.mover >= movers.size()) break;
      MovingObstacle changed = movers[*state.editing.mover];
      if (corner_ >= changed.way.size()) break;
      changed.way[corner_] =
          clamped(run.lattice(), {to.x - (changed.width - 1) / 2, to.y - (changed.height - 1) / 2});
      commands.emplace_back(ChangeMover{*state.editing.mover, std::move(changed), stroke_});
      break;
    }
    default:
      break;
  }
}

void Hand::release(const Session& session, const Run& run, ViewState& state, std::vector<Command>& commands) {
  switch (action_) {
    case Action::rectangle:
    case Action::line: {
      PaintCells paint{{}, stroke_};
      write(run, preview(state, std::nullopt), paint.cells);
      if (!paint.cells.empty()) commands.emplace_back(std::move(paint));
      break;
    }
    case Action::surprise:
      drop_surprise(session, run, state, commands);
      break;
    case Action::region:
      release_region(run, state);
      break;
    case Action::measure:
      if (!moved_) state.editing.measure.reset();
      break;
    case Action::start:
    case Action::goal:
    case Action::robot:
      if (!moved_ && state.tool == Tool::select) release_region(run, state);
      break;
    default:
      break;
  }
  action_ = Action::none;
}

/// A click pins a cell, or unpins it, and selects what is to happen there; a drag has selected a region.
void Hand::release_region(const Run& run, ViewState& state) const {
  if (moved_) return;
  const bool again = state.view.pinned == first_;
  state.view.pinned = again ? std::nullopt : std::optional<Cell>(first_);
  state.editing.region.reset();
  state.editing.mover.reset();
  state.editing.surprise = surprise_at(run, first_);
}

/// Of the spans what lies in the world and would change, each cell once in a stroke.
void Hand::write(const Run& run, const std::vector<CellSpan>& spans, std::vector<CellChange>& changes) {
  const Box& lattice = run.lattice();
  const bool once = action_ != Action::brush;  // these write all cells at once
  for (const CellSpan& span : spans) {
    if (span.y < 0 || span.y >= lattice.height()) continue;
    for (int x = std::max(0, span.first); x <= std::min(lattice.width() - 1, span.last); ++x) {
      const Cell at{x, span.y};
      if (is_wall(run, at) == adds_ || (adds_ && is_protected(run, at))) continue;
      if (once || done_.insert(lattice.node(at)).second) changes.push_back({at, adds_});
    }
  }
}

}  // namespace replan::ui
