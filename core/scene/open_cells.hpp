// Which cells wait in the open list, for a view that shows all of them: kept up to date from the log.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/session/run.hpp"

namespace replan {

class OpenCells {
 public:
  /// Brings it to the run's cursor, or, where the time does not suffice, some of it. Only stretches of nodes of which the
  /// log tells that they were written are looked at.
  void follow(const Run& run, const Deadline& deadline);
  /// Whether some of it is not yet at the cursor: the next follow() goes on.
  [[nodiscard]] bool behind() const { return waiting_ > 0; }
  /// Calls `visit(node)` for those that wait, in the order of their nodes, until it returns false.
  template <class Visit>
  void each(Visit&& visit) const {
    for (const Stretch& stretch : stretches_)
      for (const NodeId node : stretch.waiting)
        if (!visit(node)) return;
  }
  /// How many stretches were looked at, all times together.
  [[nodiscard]] std::size_t scanned() const { return scanned_; }

 private:
  static constexpr std::size_t kStretch = 128 * SearchState::kPage;
  struct Stretch {
    std::vector<NodeId> waiting;
    bool stale = true;
  };

  void scan(const SearchState& state, std::size_t stretch);
  void mark(std::size_t stretch);
  void mark_all(std::size_t nodes);
  void mark_written(const Timeline& log, std::size_t from, std::size_t to);

  std::uint64_t log_id_ = 0;
  std::size_t position_ = 0;
  std::size_t scanned_ = 0;
  std::size_t waiting_ = 0;  // stretches that are stale
  std::vector<Stretch> stretches_;
};

}  // namespace replan
