// A path as the robot drives it: cell by cell along its segments.
#pragma once

#include <vector>

#include "core/lattice/sight.hpp"
#include "core/plan/planner.hpp"

namespace replan {

/// The cells that the robot enters along a path, in order, the first vertex left out.
struct Route {
  Path path;
  PlanStatus status = PlanStatus::searching;
  std::vector<NodeId> cells;
  std::vector<double> along;  ///< way from the path's start to each of them, projected on its segment
};

/// Lays the path out in cells. Under the supercover rule these are the cells that each segment touches, else those of
/// its Bresenham line: the cells that the line of sight has looked at.
Route lay_out(const Grid2& lattice, Path path, PlanStatus status, SightRule sight);

}  // namespace replan
