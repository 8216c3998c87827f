// What a search has in hand at a moment of its log: the vertex that it works on, the neighbours that it tries, and the
// value that it has just written. Read from events and declared values alone, so that it holds for every planner.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/debug/offers.hpp"

namespace replan {

/// A neighbour with the sum that goes over it: c + g + dist. Ways across squares are not among them.
struct Trial {
  Offer offer;         ///< `offer.node` is the neighbour
  bool taken = false;  ///< the sum is the value that stands
};

struct InHand {
  /// A value that was written.
  struct Write {
    Event event;
    std::uint64_t before = 0, after = 0;
  };

  std::optional<NodeId> vertex;  ///< u: taken from the open list last, and not yet done with
  std::optional<Write> written;  ///< by the last event, if that wrote a value of a node
  std::vector<NodeId> touched;   ///< vertices of which values were written since u was taken, ascending
  NodeId centre = kNoNode;       ///< the vertex whose neighbours are tried; kNoNode: none are
  std::vector<Trial> trials;     ///< in the order of their sums

  [[nodiscard]] bool empty() const { return !vertex && !written && touched.empty(); }
};

/// What is in hand at the log's cursor. Empty while no search is under way.
InHand in_hand(const LogView& view);

}  // namespace replan
