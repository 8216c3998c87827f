// Which points of a search its log has come to, in the order in which it came to them first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/debug/log_view.hpp"

namespace replan {

/// When a search came to a point.
struct FirstTouch {
  NodeId point = kNoNode;      ///< a node, or the vertex of a tree: core/debug/parents.hpp
  std::uint32_t expanded = 0;  ///< expansions, or samples, before that, since the search began
  std::size_t event = 0;       ///< index in the log
};

/// The points of which a value was written since the search last began afresh (`epoch`). A shorter log comes to a first part of them
/// in the same order, so that a playhead that goes back needs nothing read again.
class TouchOrder {
 public:
  /// Reads on, if need be, up to the position `end` of the log. `log_id` is another one when the log is another one, or was
  /// cut. At the deadline it stops and is behind: asked again, it goes on.
  void follow(const LogView& view, std::uint64_t log_id, std::size_t end, const Deadline& deadline);
  [[nodiscard]] bool behind() const { return behind_; }
  /// Those up to the position that was asked for last, as far as they are read.
  [[nodiscard]] std::span<const FirstTouch> points() const { return {list_.data(), shown_}; }

 private:
  void start(const LogView& view, std::size_t begin);
  void take(const Event& event, std::size_t index);

  std::uint64_t log_id_ = 0;
  std::size_t begin_ = 0, read_ = 0, shown_ = 0;
  std::uint32_t expanded_ = 0;
  bool behind_ = false;
  KindSet kinds_;  // whose events are about a point
  std::vector<FirstTouch> list_;
  std::vector<bool> seen_;
};

}  // namespace replan
