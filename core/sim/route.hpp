// A path as the robot drives it: cell by cell along its segments.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/plan/path.hpp"
#include "core/plan/planner.hpp"

namespace replan {

/// What a robot drives by. A run keeps every plan that it has had, and plans of one path share it.
struct Plan {
  std::shared_ptr<const Path> path = std::make_shared<const Path>();
  PlanStatus status = PlanStatus::searching;
  double length = 0;  ///< of the path, in cells
};

/// The cells that the robot enters along a path, in order, the first one left out. Much larger than the path,
/// so only the robot has one, and of its plan alone.
struct Route {
  std::vector<NodeId> cells;
  std::vector<double> along;  ///< way from the path's start to each of them, projected on its segment
  std::vector<Point> points;  ///< the projections: where on the path the robot is while it is in the cell
  std::vector<std::size_t> pieces;  ///< which of the path's segments that is on: number i ends at its point i

  /// The way along the path to the i-th of the cells from `at`, where the robot is in the one before: with all corners
  /// that it has in between. A body that cut them would come nearer to obstacles than the path does.
  struct Way {
    std::vector<Point> points;        // the first is `at`
    std::vector<std::size_t> pieces;  // which of the path's segments leads to each of the others
  };
  [[nodiscard]] Way way_to(const Path& path, std::size_t i, const Point& at) const;
};

/// Lays the path out in the cells of its world. Between two nodes these are, under the supercover rule, the cells
/// that the segment touches, else those of its Bresenham line: the cells that the line of sight has looked at.
/// Between other points they are all that the segment passes through, and in a cell with several of them the robot is at
/// the last: so the straight way to it from the cell before leaves out no square that the path goes round in.
/// Where a path touches obstacles, which are those of `known` (nonzero), they are the free cells beside it.
Route lay_out(const Box& box, std::span<const std::uint8_t> known, const Path& path);

}  // namespace replan
