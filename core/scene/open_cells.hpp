// Which cells wait in the open list, for a view that shows all of them: kept up to date from the log.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/scene/stale_stretches.hpp"
#include "core/session/run.hpp"

namespace replan {

class OpenCells {
 public:
  /// Brings it to the run's cursor, or, where the time does not suffice, some of it. Only stretches of nodes of which the
  /// log tells that they were written are looked at.
  void follow(const Run& run, const Deadline& deadline);
  /// Whether some of it is not yet at the cursor: the next follow() goes on.
  [[nodiscard]] bool behind() const { return stale_.behind(); }
  /// Calls `visit(node)` for those that wait, in the order of their nodes, until it returns false.
  template <class Visit>
  void each(Visit&& visit) const {
    for (const std::vector<NodeId>& waiting : stretches_)
      for (const NodeId node : waiting)
        if (!visit(node)) return;
  }
  /// How many stretches were looked at, all times together.
  [[nodiscard]] std::size_t scanned() const { return scanned_; }

 private:
  void scan(const SearchState& state, std::size_t first, std::size_t end, std::vector<NodeId>& waiting);

  StaleStretches stale_{128 * SearchState::kPage};
  std::size_t scanned_ = 0;
  std::vector<std::vector<NodeId>> stretches_;  // the nodes of each that wait
};

}  // namespace replan
