// Which vertices a replan touched, and what it made of their values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/deadline.hpp"
#include "core/debug/log_view.hpp"
#include "core/trace/expansions.hpp"
#include "core/trace/paged.hpp"

namespace replan {

/// A vertex whose g or rhs a replan wrote, or that it expanded.
struct Touched {
  NodeId node = kNoNode;
  std::size_t event = 0;  ///< index of the first event that touched it
  Cost g_before, g_after, rhs_before, rhs_after;
  std::uint32_t expanded = 0;  ///< times, by this replan
};

/// The vertices that one plan touched up to a position of the log, in the order in which it came to them.
/// They are those that RunDigest counts: what a plan from scratch wipes before its first expansion is no
/// work.
class TouchedList {
 public:
  /// Shows the plan whose `plan_begin` is the event `begin`, up to position `end`; reads on from where it was
  /// if it can. `log_id` is another one when the log is another one, or was cut. At the deadline it stops and is behind:
  /// asked again, it goes on.
  void follow(const LogView& view, std::uint64_t log_id, std::size_t begin, std::size_t end,
              const Deadline& deadline = Deadline::never());
  [[nodiscard]] bool behind() const { return behind_; }

  [[nodiscard]] const std::vector<Touched>& list() const { return list_; }
  /// The entry of a vertex, or nullptr if it was not touched.
  [[nodiscard]] const Touched* find(NodeId node) const;

 private:
  void start(const LogView& view);
  void take(const Event& event, std::size_t index);
  Touched& touched(NodeId node, std::size_t index);

  std::uint64_t log_id_ = 0;
  std::size_t begin_ = 0, read_ = 0;
  bool behind_ = false;
  bool repairs_ = false;      // it goes on with what is there, and wipes nothing before it searches
  ExpansionCounter counter_;  // of this plan
  SearchState before_, now_;  // at the plan's beginning, and as far as it was read
  std::vector<Touched> list_;
  PagedArray<std::uint32_t> places_;  // index in list_ + 1
};

}  // namespace replan
