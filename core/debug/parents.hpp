// What hangs on what in a search, as its planner declares it: vertices of the map, or those of a tree of samples.
#pragma once

#include <algorithm>

#include "core/debug/log_view.hpp"
#include "core/plan/tree_values.hpp"

namespace replan {

/// Points of a search are cells of the map by their nodes, or, of a planner that grows a tree, vertices by their numbers.
inline std::size_t point_count(const PlannerInfo& info, const SearchState& state) {
  return info.values.grows() ? vertex_count(state) : state.node_count();
}

/// Whether the planner keeps parents at all.
inline bool keeps_parents(const PlannerInfo& info) {
  return info.values.grows() || info.values.declares(EventKind::lp);
}

/// The point that it hangs on: its vertex of the tree, its remote parent in a search at any angle that has set one, else its
/// local one. kNoNode of a root, and where nothing is set.
inline NodeId parent_of(const PlannerInfo& info, const SearchState& state, NodeId point) {
  if (info.values.grows()) return vertex_parent(state, point);
  const NodeId remote = info.any_angle && info.values.declares(EventKind::rp) ? state.rp(point) : kNoNode;
  const NodeId parent = remote != kNoNode ? remote : state.lp(point);
  return parent == point ? kNoNode : parent;
}

/// Where a point lies.
inline Point place_of_point(const LogView& view, const SearchState& state, NodeId point) {
  if (!view.info.values.grows()) return centre_of(view.lattice.position(point));
  return point_of(vertex_place(state, point, view.lattice.solid()));
}

/// The cell that it lies in: at the far edges of the world the last one.
inline Cell cell_of_point(const LogView& view, const SearchState& state, NodeId point) {
  if (!view.info.values.grows()) return view.lattice.position(point);
  const Cell cell = cell_of(place_of_point(view, state, point));
  const Box& box = view.lattice;
  return {std::min(cell.x, box.width() - 1), std::min(cell.y, box.height() - 1),
          std::min(cell.z, box.depth() - 1)};
}

/// The point from which a finished search's path is read along parents; kNoNode before there is one.
inline NodeId path_end(const PlannerInfo& info, const SearchState& state) {
  return info.values.grows() ? goal_vertex(state) : state.node(info.target());
}

}  // namespace replan
