// Which events of a log are expansions, and how many there are before a position.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/trace/timeline.hpp"

namespace replan {

/// Tells expansions from what a fresh plan wipes: both are `visit` events, but the wiping comes before the
/// first vertex is taken. Ask in either direction along a log; it remembers the latest stretch of wiping.
class ExpansionTeller {
 public:
  /// Whether the event is an expansion.
  bool operator()(const Timeline& log, std::size_t index);

 private:
  std::size_t wipe_begin_ = 0, wipe_end_ = 0;  // no vertex is taken in between
};

/// How many expansions there are before positions of a log that grows.
class ExpansionCount {
 public:
  static constexpr std::size_t kBlock = 4096;

  /// Looks through more of the log, at most `most` events (rounded up to a block). True if all is done.
  bool extend(const Timeline& log, std::size_t most);
  /// The events before `position`; at most as far as it was extended is free, the rest is counted.
  std::int64_t before(const Timeline& log, std::size_t position);
  /// The log was cut: what comes after `size` is forgotten.
  void truncate(std::size_t size);

 private:
  std::vector<std::int64_t> before_block_ = {0};  // expansions before each whole block
  ExpansionTeller teller_;
};

}  // namespace replan
