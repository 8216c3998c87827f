// What a cell's neighbours offer it: why its rhs (A*: its g) is what it is.
#pragma once

#include <vector>

#include "core/debug/log_view.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

/// One neighbour's offer: the move, its g, the dist of the cell that the move enters (the neighbour, or in a search from
/// the start the cell itself), and what these come to, sum = step + g + dist. Of a search that
/// interpolates it may be that of a way across to a point between the neighbour and another, `side`; step is then what
/// is left of the sum without g.
struct Offer {
  NodeId node;
  Cost step, g, dist, sum;
  NodeId side = kNoNode;
};

/// The offers of all neighbours that the robot's map lets it move to, the least first, equal ones in the
/// order of their directions, ways across after moves. `state` is one of the log's.
std::vector<Offer> offers_to(const LogView& view, const SearchState& state, NodeId node);

/// Whether a free cell of the robot's map is nearer to an obstacle than its radius, so that its centre keeps out.
bool too_near(const LogView& view, const SearchState& state, NodeId node);

}  // namespace replan
