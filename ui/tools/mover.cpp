#include "ui/tools/mover.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scene/script.hpp"
#include "ui/canvas/cell_pen.hpp"
#include "ui/canvas/view_state.hpp"
#include "ui/icons.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tools/cells.hpp"
#include "ui/tools/held.hpp"

namespace replan::ui {
namespace {

/// What a press of the tool meets: a moving obstacle, and a corner of its way if it meets one.
struct Met {
  std::size_t mover = 0;
  std::optional<std::size_t> corner;
};

double distance_to_segment(Point at, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((at.x - a.x) * dx + (at.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
  return std::hypot(at.x - a.x - t * dx, at.y - a.y - t * dy);
}

/// Corners before lines, and the selected one before the others.
std::optional<Met> met(const Scenario& scenario, const Editing& editing, const Sheet& sheet, Cell cell,
                       double reach) {
  const Point at = centre_of(sheet.box.seen(cell));
  const auto way_of = [&](std::size_t mover) {
    std::vector<Point> points = way_points(scenario.movers[mover]);
    for (Point& point : points) point = sheet.box.seen(point);
    return points;
  };
  std::optional<Met> best;
  double nearest = std::max(0.75, reach);
  for (std::size_t i = 0; i < scenario.movers.size(); ++i) {
    const std::vector<Point> way = way_of(i);
    const double bonus = editing.mover == i ? 0.25 : 0;
    for (std::size_t corner = 0; corner < scenario.movers[i].way.size(); ++corner) {
      const double away = std::hypot(at.x - way[corner].x, at.y - way[corner].y) - bonus;
      if (away >= nearest) continue;
      nearest = away;
      best = Met{i, corner};
    }
  }
  if (best) return best;
  for (std::size_t i = scenario.movers.size(); i-- > 0;) {
    const std::vector<Point> way = way_of(i);
    for (std::size_t k = 1; k < way.size(); ++k)
      if (distance_to_segment(at, way[k - 1], way[k]) < nearest) return Met{i, std::nullopt};
  }
  return std::nullopt;
}

/// The first cell of a box of that size with its middle at a cell, on the map.
Cell box_corner(Cell middle, Cell size, const Box& world) {
  return clamped(world,
                 {middle.x - (size.x - 1) / 2, middle.y - (size.y - 1) / 2, middle.z - (size.z - 1) / 2});
}

Cell size_of(const MovingObstacle& mover) {
  return {mover.width, mover.height, mover.depth};
}

/// The size of the next one, as large as the brush.
Cell next_size(const Box& world, int brush) {
  return {brush, brush, world.solid() ? std::min(brush, world.depth()) : 1};
}

/// Where a box of that size would stand with its middle at a cell, as a sheet shows it: where it is even, one half of it is
/// larger, and on an upright sheet z grows against the rows.
std::vector<CellSpan> spans_of_box(const Sheet& sheet, Cell middle, Cell size) {
  const Cell low = box_corner(middle, size, sheet.box.box());
  return rectangle_on(sheet, low, {low.x + size.x - 1, low.y + size.y - 1, low.z + size.z - 1});
}

/// A corner of the selected moving obstacle's way.
class HeldCorner final : public HeldDrag {
 public:
  explicit HeldCorner(std::size_t corner) : corner_(corner) {}

 private:
  void put(ToolContext& context, Cell to) override {
    const std::vector<MovingObstacle>& movers = context.session.scenario().movers;
    const std::optional<std::size_t> selected = context.view.editing.mover;
    if (!selected || *selected >= movers.size()) return;
    MovingObstacle changed = movers[*selected];
    if (corner_ >= changed.way.size()) return;
    changed.way[corner_] = box_corner(to, size_of(changed), context.run.lattice());
    context.commands.emplace_back(ChangeMover{*selected, std::move(changed), context.press.stroke});
  }

  std::size_t corner_;
};

/// Speed and what happens at the end; returns whether one was changed for good.
bool movement(Frame& frame, double& speed, WayEnd& at_end) {
  const Look& look = frame.look;
  static constexpr std::array<const char*, 3> kEnds = {"Turns back", "Goes round", "Stops"};
  const auto draft = frame.panels.drafts.find("mover speed");
  double shown = draft == frame.panels.drafts.end() ? speed : draft->second;
  if (slider(look,
             {.label = "Its speed",
              .min = 0.1,
              .max = 50,
              .initial = 2,
              .unit = "cells/s",
              .decimals = 1,
              .logarithmic = true},
             shown,
             {"Its speed", "",
              "A diagonal step takes as long as a straight one. The robot's driving speed is in the Planner "
              "tab."}))
    frame.panels.drafts["mover speed"] = shown;
  bool changed = false;
  // Handed on when the slider is let go: each change begins the run afresh.
  if (!ImGui::IsItemActive() && frame.panels.drafts.erase("mover speed") > 0) {
    speed = shown;
    changed = true;
  }
  text(look.fonts.ui, look.theme.dim, "At the end of its way");
  int end = static_cast<int>(at_end);
  if (segments(look, "end", kEnds, end)) {
    at_end = static_cast<WayEnd>(end);
    changed = true;
  }
  hint(look,
       {"At the end of its way", "",
        "Turns back: it returns the way it came, and so on. Goes round: straight to the way's beginning, "
        "and so on. Stops: it stays there for good."});
  return changed;
}

}  // namespace

/// Each press adds a corner; one on the last corner ends the way, so that a double click does. With no way begun, a
/// press on another's way selects that, and its corners can be dragged.
std::unique_ptr<Drag> MoverTool::press(ToolContext& context) {
  Editing& editing = context.view.editing;
  const Cell at = context.press.first;
  if (way_.empty()) {
    const Pointer& pointer = context.pointer;
    if (const auto hit =
            met(context.session.scenario(), editing, pointer.sheet, pointer.cell, pointer.reach)) {
      editing.surprise.reset();
      editing.mover = hit->mover;
      return hit->corner ? std::make_unique<HeldCorner>(*hit->corner) : nullptr;
    }
    editing.mover.reset();
  }
  if (!way_.empty() && way_.back() == at)
    finish(context.session, context.view, context.commands);
  else
    way_.push_back(at);
  return nullptr;
}

std::unique_ptr<Drag> MoverTool::press_right(ToolContext& context) {
  if (way_.empty()) return Tool::press_right(context);
  finish(context.session, context.view, context.commands);
  return nullptr;
}

/// The corners so far, the way to the cursor, and the box where it would stand.
void MoverTool::draw(const CellPen& pen, const ViewState& view, std::optional<Cell> hovered) const {
  if (way_.empty() && view.editing.mover) return;
  const Look& look = pen.look();
  const ImU32 colour = look.theme.mover;
  const Cell size = next_size(pen.sheet().box.box(), view.brush);
  for (std::size_t i = 1; i < way_.size(); ++i)
    pen.dashed(pen.middle(way_[i - 1]), pen.middle(way_[i]), colour);
  if (hovered && !way_.empty())
    pen.dashed(pen.middle(way_.back()), pen.middle(*hovered), with_alpha(colour, 0.6f));
  for (const Cell corner : way_) pen.list().AddCircleFilled(pen.middle(corner), look.px(3.5f), colour);
  if (!way_.empty()) pen.area(spans_of_box(pen.sheet(), way_.front(), size), colour, 0.25f);
  if (hovered) pen.area(spans_of_box(pen.sheet(), *hovered, size), colour, 0);
}

void MoverTool::choose(ViewState& view) {
  drop();
  show_script(view.view.overlays);
}

void MoverTool::leave(ViewState& view) {
  drop();
  view.editing.mover.reset();
}

void MoverTool::finish(const Session& session, ViewState& view, std::vector<Command>& commands) {
  if (way_.empty()) return;
  MovingObstacle mover;
  const Box world = session.scenario().map.box();
  const Cell size = next_size(world, view.brush);
  mover.width = size.x;
  mover.height = size.y;
  mover.depth = size.z;
  for (const Cell corner : way_) mover.way.push_back(box_corner(corner, size_of(mover), world));
  mover.speed = next_.speed;
  mover.at_end = next_.at_end;
  way_.clear();
  view.editing.surprise.reset();
  view.editing.mover = session.scenario().movers.size();
  commands.emplace_back(AddMover{std::move(mover)});
}

bool draws_way(const ViewState& view) {
  return view.tools.get<MoverTool>().holds();
}

void finish_way(const Session& session, ViewState& view, std::vector<Command>& commands) {
  view.tools.get<MoverTool>().finish(session, view, commands);
}

void MoverTool::draw_options(Frame& frame) {
  const Look& look = frame.look;
  section_title(look, "The next moving obstacle");
  movement(frame, next_.speed, next_.at_end);
  const std::string side = std::to_string(frame.view.brush);
  paragraph(look.fonts.ui, look.theme.dim,
            way_.empty()
                ? "Click the corners of its way. It is as large as the brush: " + side + " × " + side +
                      (frame.session.scenario().map.box().solid() ? " × " + side : "") + " cells."
                : "Click the next corner. A double click, Enter or the right button ends the way.");
}

void draw_selected_mover(Frame& frame) {
  const Look& look = frame.look;
  const std::size_t index = *frame.view.editing.mover;
  MovingObstacle mover = frame.session.scenario().movers[index];
  section_title(look, "Moving obstacle " + std::to_string(index + 1));
  bool changed = movement(frame, mover.speed, mover.at_end);
  const auto side = [&](const char* label, int& value) {
    const std::string key = std::string("mover ") + label;
    const auto draft = frame.panels.drafts.find(key);
    double shown = draft == frame.panels.drafts.end() ? value : draft->second;
    if (slider(look,
               {.label = label,
                .min = 1,
                .max = kMaxMoverSide,
                .initial = 1,
                .unit = "cells",
                .decimals = 0,
                .logarithmic = true},
               shown,
               {label, "", "Of the box of cells that moves; what lies outside the world is not there."}))
      frame.panels.drafts[key] = shown;
    if (ImGui::IsItemActive() || frame.panels.drafts.erase(key) == 0) return;
    value = static_cast<int>(shown);
    changed = true;
  };
  side("Width", mover.width);
  side("Height", mover.height);
  if (frame.session.scenario().map.box().solid()) side("Layers", mover.depth);
  if (changed) frame.commands.push_back(ChangeMover{index, mover, 0});
  draw_remove_button(frame);
}

ToolKind mover_tool() {
  return {.label = "Moving obstacle",
          .icon = icon::truck,
          .chord = plain('M'),
          .teach =
              "Click the corners of its way; a double click, Enter or the right button ends the way, Esc "
              "drops it. It is as large as the brush. Click a way to select it, drag its corners.",
          .group = ToolGroup::script,
          .make = make_part<Tool, MoverTool>,
          .colour = &Theme::mover};
}

}  // namespace replan::ui
