// How the best path of a plan by samples became shorter, out of its log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/debug/log_view.hpp"
#include "core/debug/scalar_values.hpp"

namespace replan {

/// From the event on the best path has that cost.
struct PathGain {
  std::size_t event = 0;
  std::int64_t sample = 0;  ///< of this plan, the first one is 1; 0: before it has drawn any
  Cost cost = {};           ///< infinite: there is none any more
};

/// The gains of one plan in their order, read out of the log in slices while it grows; none of a planner that draws no samples.
class PathGains {
 public:
  /// Reads on in the events [begin, end), which are the plan's, by at most `most` gains. Starts over for another plan, another
  /// log (`log_id`), or an end before the one that was read to.
  void follow(const LogView& view, std::uint64_t log_id, std::size_t begin, std::size_t end,
              std::size_t most);

  [[nodiscard]] std::span<const PathGain> gains() const { return gains_; }
  /// Whether all up to the end are read.
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  struct Values {
    ScalarValues best, sample, first;
  };
  void settle(const Timeline& log);

  std::uint64_t log_id_ = 0;
  std::size_t begin_ = 0, end_ = 0;
  std::optional<Values> values_;  // at the latest gain; nothing: not yet begun
  std::vector<PathGain> gains_;
  bool complete_ = false;
};

}  // namespace replan
