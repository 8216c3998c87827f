// Which edges of a tree are drawn.
#pragma once

#include <vector>

#include "core/scene/edge_bins.hpp"

namespace replan {

/// An edge of the tree, in the world's coordinates.
struct TreeEdge {
  Point from, to;
  double cost = 0;  ///< of its vertex, as a share of the dearest one's
  bool from_goal = false;
};

/// What is drawn of a tree.
struct DrawnTree {
  std::vector<TreeEdge> edges;
  int every = 1;  ///< of those in sight every so manieth is there
};

/// Where more edges are in sight every n-th of them is drawn alone.
inline constexpr std::size_t kMostEdges = 40'000;
/// Of more vertices not all are looked at, so that a frame does not wait for them.
inline constexpr std::uint32_t kMostRead = 200'000;

/// The edges to draw of the tree at the run's cursor: all that are in sight, as far as these are not too many. `bins` are of
/// the same run, and tell of a large tree which ones may be; without them, where all of it is in sight, a large tree is
/// thinned.
DrawnTree drawn_tree(const Run& run, EdgeBins* bins, const EdgeBins::Seen& in_sight);

}  // namespace replan
