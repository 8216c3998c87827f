// Where a robot goes whose goal cannot be reached.
#pragma once

#include <vector>

#include "core/lattice/box_lattice.hpp"

namespace replan {

/// Of the cells that the robot can reach on its map the one nearest to the goal, from centre to centre; of
/// equally near ones the one with the shorter way (of moves alone, whatever a planner pays besides), then the
/// one with the smaller index. The goal itself if it can be reached. A robot in an obstacle reaches its own
/// cell only. `closed`: cells that it does not enter besides, by node; empty if there are none.
///
/// A flood over all that can be reached, which ends at the goal; where several cells are equally near,
/// Dijkstra's algorithm up to the first of them.
template <int D>
NodeId nearest_reachable(const BoxLattice<D>& known, NodeId robot, NodeId goal,
                         const std::vector<bool>& closed = {});

}  // namespace replan
