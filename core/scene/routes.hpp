// The ways that views draw: from the run's cursor, by the coordinates of the view.
#pragma once

#include <vector>

#include "core/scene/context.hpp"

namespace replan {

/// Where the robot is, on its way between two cells too, or will be put.
Point robot_point(const SceneContext& context);
/// Where it has to go now: the goal may have moved.
Point goal_point(const SceneContext& context);
/// Whether it has moved: before that it would only hide the start.
bool robot_has_set_out(const SceneContext& context);

struct PathLine {
  std::vector<Point> points;  ///< fewer than two: there is none
  bool searching = false;     ///< no plan stands yet: these are the parents from the start on
};
/// The path from the robot on.
PathLine path_line(const SceneContext& context);
/// The way that it has come.
std::vector<Point> trail_points(const SceneContext& context);

struct SightCheck {
  Point from, to;
  bool free = false;
};
/// The sight checks since the last vertex was taken, or, where a path is read out leap by leap, those of the latest
/// vertex; the latest first.
std::vector<SightCheck> sight_checks(const SceneContext& context);

}  // namespace replan
