// How a robot with a size gets away from obstacles that came too near.
#pragma once

#include <vector>

#include "core/lattice/box_lattice.hpp"

namespace replan {

/// The way out of the cells that are too near an obstacle, cell by cell: the robot's own, and on to the first that is
/// free for its centre. On the way it never comes nearer to obstacles than it is already: each step leads over cells
/// (both ends, and those that a diagonal squeezes past) none of which is nearer to an obstacle than the cell it leaves,
/// so that no point of it is either (see BoxLattice).
///
/// Empty if the robot's cell is free, an obstacle, or if no such way leads out. Of all cells that can be reached so it
/// ends at the one with the shortest way from which the goal can be reached, or, if none is one, at that with the
/// shortest way; of equally long ones at the one with the smaller index.
///
/// Dijkstra's algorithm among the cells around; and a flood over the map for each region that they lead to, until one
/// has the goal in it.
template <int D>
std::vector<NodeId> way_out(const BoxLattice<D>& known, NodeId robot, NodeId goal);

}  // namespace replan
