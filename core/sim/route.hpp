// A path as the robot drives it: cell by cell along its segments.
#pragma once

#include <vector>

#include "core/lattice/sight.hpp"
#include "core/plan/planner.hpp"

namespace replan {

/// A point of the plane in cells; the centre of cell (x, y) is (x + 0.5, y + 0.5).
struct PlanePoint {
  double x = 0, y = 0;
};

/// The cells that the robot enters along a path, in order, the first vertex left out.
struct Route {
  Path path;
  PlanStatus status = PlanStatus::searching;
  std::vector<NodeId> cells;
  std::vector<double> along;  ///< way from the path's start to each of them, projected on its segment
  std::vector<PlanePoint>
      points;  ///< the projections: where on the path the robot is while it is in the cell
};

/// Lays the path out in cells. Under the supercover rule these are the cells that each segment touches, else
/// those of its Bresenham line: the cells that the line of sight has looked at.
Route lay_out(const Grid2& lattice, Path path, PlanStatus status, SightRule sight);

}  // namespace replan
