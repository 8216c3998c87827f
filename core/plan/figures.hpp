// Figures of a path, the same for every planner, computed in this one place from the geometry.
#pragma once

#include <cstdint>
#include <span>

#include "core/lattice/box_lattice.hpp"
#include "core/plan/path.hpp"

namespace replan {

/// Lengths in cells, angles in degrees. All zero for an empty path.
struct PathFigures {
  std::int64_t nodes = 0;  ///< vertices of the polyline, both ends counted
  double length = 0;
  std::int64_t turns = 0;        ///< inner vertices where the heading changes by more than 1e-9 rad
  double turning_angle_deg = 0;  ///< sum of all heading changes
  /// The most that the heading changes along the path, in radians for each cell of way: at every corner, and every 0.1
  /// cell, the angle between the way there from the point 0.5 cells before and the way on to that 0.5 cells behind,
  /// over 0.5 cells. Of a curve that bends no sharper than that its greatest curvature, 1 / radius; a corner of a
  /// right angle comes to pi, and turning back to 2 pi, the most there is.
  double greatest_curvature = 0;
  /// Distance from the polyline, sampled every 0.1 cell, to the square (cube) of the nearest obstacle cell;
  /// 0 if it enters one; infinite if there is no obstacle at all.
  double min_clearance = 0;
  double mean_clearance = 0;
};

/// The length alone: what a batch over thousands of problems needs.
double path_length(const Path& path);

/// The distance from a point to the polyline, in cells; infinite to an empty path.
double distance_to(const Path& path, const Point& point);

/// All figures of a path in a box of cells, nonzero = obstacle.
PathFigures path_figures(const Box& box, std::span<const std::uint8_t> cells, const Path& path);
template <int D>
PathFigures path_figures(const BoxLattice<D>& lattice, const Path& path) {
  return path_figures(lattice.box(), lattice.cells(), path);
}

/// True if every segment of a path over the lattice's nodes is one of its moves or a line of sight on its free
/// cells; every segment of another path must touch free cells only, unless the path may touch obstacles: then it must keep
/// to the rule of core/lattice/squares.hpp.
template <int D>
bool path_is_free(const BoxLattice<D>& lattice, const Path& path);

}  // namespace replan
