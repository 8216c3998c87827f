// A path as the robot drives it: cell by cell along its segments.
#pragma once

#include <memory>
#include <vector>

#include "core/lattice/sight.hpp"
#include "core/plan/planner.hpp"

namespace replan {

/// A point of the plane in cells; the centre of cell (x, y) is (x + 0.5, y + 0.5).
struct PlanePoint {
  double x = 0, y = 0;
  friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

constexpr PlanePoint centre_of(Cell cell) {
  return {cell.x + 0.5, cell.y + 0.5};
}

/// What a robot drives by. A run keeps every plan that it has had, and plans of one path share it.
struct Plan {
  std::shared_ptr<const Path> path = std::make_shared<const Path>();
  PlanStatus status = PlanStatus::searching;
  double length = 0;  ///< of the path, in cells

  [[nodiscard]] const std::vector<NodeId>& nodes() const { return path->nodes; }
};

/// The cells that the robot enters along a path, in order, the first vertex left out. Much larger than the
/// path, so only the robot has one, and of its plan alone.
struct Route {
  std::vector<NodeId> cells;
  std::vector<double> along;  ///< way from the path's start to each of them, projected on its segment
  std::vector<PlanePoint>
      points;  ///< the projections: where on the path the robot is while it is in the cell
};

/// Lays the path out in cells. Under the supercover rule these are the cells that each segment touches, else
/// those of its Bresenham line: the cells that the line of sight has looked at.
Route lay_out(const Grid2& lattice, const Path& path, SightRule sight);

}  // namespace replan
