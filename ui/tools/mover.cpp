// The tool for moving obstacles: draws their ways, selects and changes them.
#include <algorithm>
#include <cmath>

#include "core/scene/script.hpp"
#include "ui/canvas/hand.hpp"

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
std::optional<Met> met(const Scenario& scenario, const Editing& editing, Cell cell, double reach) {
  const Point at{cell.x + 0.5, cell.y + 0.5};
  std::optional<Met> best;
  double nearest = std::max(0.75, reach);
  for (std::size_t i = 0; i < scenario.movers.size(); ++i) {
    const std::vector<Point> way = way_points(scenario.movers[i]);
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
    const std::vector<Point> way = way_points(scenario.movers[i]);
    for (std::size_t k = 1; k < way.size(); ++k)
      if (distance_to_segment(at, way[k - 1], way[k]) < nearest) return Met{i, std::nullopt};
  }
  return std::nullopt;
}

}  // namespace

Cell box_corner(Cell middle, int side, const GridMap& map) {
  const int before = (side - 1) / 2;
  return {std::clamp(middle.x - before, 0, map.width - 1), std::clamp(middle.y - before, 0, map.height - 1)};
}

void finish_way(const Session& session, ViewState& state, std::vector<Command>& commands) {
  Editing& editing = state.editing;
  if (editing.way.empty()) return;
  MovingObstacle mover;
  for (const Cell corner : editing.way)
    mover.way.push_back(box_corner(corner, state.brush, session.scenario().map));
  mover.width = mover.height = state.brush;
  mover.speed = editing.mover_speed;
  mover.at_end = editing.mover_end;
  editing.way.clear();
  editing.surprise.reset();
  editing.mover = session.scenario().movers.size();
  commands.emplace_back(AddMover{std::move(mover)});
}

/// Each press adds a corner; one on the last corner ends the way, so that a double click does. With no way
/// begun, a press on another's way selects that, and its corners can be dragged.
void Hand::press_way(const Session& session, ViewState& state, const Pointer& pointer,
                     std::vector<Command>& commands) {
  Editing& editing = state.editing;
  action_ = Action::idle;
  if (editing.way.empty()) {
    if (const auto hit = met(session.scenario(), editing, pointer.cell, pointer.reach)) {
      editing.surprise.reset();
      editing.mover = hit->mover;
      if (!hit->corner) return;
      corner_ = *hit->corner;
      action_ = Action::corner;
      return;
    }
    editing.mover.reset();
  }
  if (!editing.way.empty() && editing.way.back() == first_)
    finish_way(session, state, commands);
  else
    editing.way.push_back(first_);
}

}  // namespace replan::ui
