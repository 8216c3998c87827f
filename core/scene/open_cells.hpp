// Which cells wait in the open list, for a view that shows all of them: kept up to date from the log.
#pragma once

#include <cstdint>
#include <vector>

#include "core/session/run.hpp"

namespace replan {

class OpenCells {
 public:
  /// Brings it to the run's cursor; only stretches of nodes of which the log tells that they were written are looked at.
  void follow(const Run& run);
  /// Calls `visit(node)` for those that wait, in the order of their nodes, until it returns false.
  template <class Visit>
  void each(Visit&& visit) const {
    for (const auto& stretch : stretches_)
      for (const NodeId node : stretch)
        if (!visit(node)) return;
  }
  /// How many stretches were looked at, all times together.
  [[nodiscard]] std::size_t scanned() const { return scanned_; }

 private:
  static constexpr std::size_t kStretch = 128 * SearchState::kPage;

  void scan(const SearchState& state, std::size_t stretch);
  void scan_all(const SearchState& state);
  void scan_written(const Timeline& log, std::size_t from, std::size_t to);

  std::uint64_t log_id_ = 0;
  std::size_t position_ = 0;
  std::size_t scanned_ = 0;
  std::vector<std::vector<NodeId>> stretches_;  // the nodes that wait in each
};

}  // namespace replan
