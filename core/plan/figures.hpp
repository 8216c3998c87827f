// Figures of a path, the same for every planner, computed in this one place from the geometry.
#pragma once

#include <span>

#include "core/base/shared_array.hpp"
#include "core/lattice/box.hpp"
#include "core/lattice/box_lattice.hpp"
#include "core/plan/planner.hpp"

namespace replan {

/// Lengths in cells, angles in degrees. All zero for an empty path.
struct PathFigures {
  std::int64_t nodes = 0;  ///< vertices of the polyline, both ends counted
  double length = 0;
  std::int64_t turns = 0;        ///< inner vertices where the heading changes by more than 1e-9 rad
  double turning_angle_deg = 0;  ///< sum of all heading changes
  /// Distance from the polyline, sampled every 0.1 cell, to the square (cube) of the nearest obstacle cell;
  /// 0 if it enters one; the lattice's diagonal if there is no obstacle at all.
  double min_clearance = 0;
  double mean_clearance = 0;
};

/// The length alone: what a batch over thousands of problems needs.
template <int D>
double path_length(const BoxLattice<D>& lattice, std::span<const NodeId> path);

/// All figures of a path on a map.
template <int D>
PathFigures path_figures(const BoxLattice<D>& lattice, std::span<const NodeId> path);
/// The same on a box of cells, nonzero = obstacle.
PathFigures path_figures(const Box& box, const SharedBytes& cells, MoveRules rules,
                         std::span<const NodeId> path);

/// True if every segment of the polyline is either a move of the lattice or a line of sight on its free
/// cells.
template <int D>
bool path_is_free(const BoxLattice<D>& lattice, std::span<const NodeId> path, SightRule sight);

}  // namespace replan
