// Which stretches of nodes have to be looked at again, because the log tells that a value in them was written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/trace/timeline.hpp"

namespace replan {

/// What somebody keeps of each stretch of so many nodes is theirs; here is only what of it is out of date.
class StaleStretches {
 public:
  explicit StaleStretches(std::size_t stretch_nodes) : stretch_(stretch_nodes) {}

  /// Where the state that is looked at stands: a position of the log numbered `log_id`.
  struct Place {
    const Timeline& log;
    std::uint64_t log_id;
    std::size_t position;
    std::size_t nodes;
  };
  /// Marks what was written of those kinds on the way from the last place to this one. True if nothing that is kept holds any
  /// more: the log or its world is another one.
  bool follow(const Place& now, KindSet kinds);
  /// Calls `scan(stretch, first node, end)` for those that are stale until the deadline, and for some of them in any case.
  /// Goes on where it left off, so that each has its turn even where all of them are stale again each time.
  template <class Scan>
  void refresh(const Deadline& deadline, Scan&& scan) {
    std::size_t scanned = 0;
    for (std::size_t i = 0; i < stale_.size() && waiting_ > 0; ++i) {
      const std::size_t at = next_;
      next_ = at + 1 < stale_.size() ? at + 1 : 0;
      if (!stale_[at]) continue;
      stale_[at] = false;
      --waiting_;
      scan(at, at * stretch_, std::min((at + 1) * stretch_, nodes_));
      if ((scanned += stretch_) % kBetweenLooks < stretch_ && deadline.passed()) return;
    }
  }
  [[nodiscard]] std::size_t count() const { return stale_.size(); }
  /// Whether some are stale: the next refresh() goes on.
  [[nodiscard]] bool behind() const { return waiting_ > 0; }

 private:
  static constexpr std::size_t kBetweenLooks = 2048;  ///< nodes

  void mark(std::size_t stretch) {
    waiting_ += stale_[stretch] ? 0 : 1;
    stale_[stretch] = true;
  }
  void mark_all() {
    stale_.assign((nodes_ + stretch_ - 1) / stretch_, true);
    waiting_ = stale_.size();
  }
  void mark_written(const Timeline& log, KindSet kinds, std::size_t from, std::size_t to);

  std::size_t stretch_;
  std::uint64_t log_id_ = 0;
  std::size_t position_ = 0, nodes_ = 0;
  std::size_t next_ = 0, waiting_ = 0;
  std::vector<bool> stale_;
};

}  // namespace replan
