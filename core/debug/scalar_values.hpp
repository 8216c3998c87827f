// How a value of the run changes in a stretch of its log, without a look at all that lies between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/trace/timeline.hpp"

namespace replan {

/// The values that a scalar takes from a place of a log on, one after the other. Each call gets that log, which may have grown
/// since: only what has come is looked through.
class ScalarValues {
 public:
  ScalarValues(const SearchState& at_begin, Scalar which, std::size_t begin)
      : which_(which), value_(at_begin.scalar(which)), looked_to_(begin) {}
  /// That of the latest change that was taken.
  [[nodiscard]] std::uint64_t value() const { return value_; }
  [[nodiscard]] bool changes_before(const Timeline& log, std::size_t end) {
    find(log);
    return next_ && *next_ < end;
  }
  /// Takes the next change, which there is; its event.
  std::size_t take(const Timeline& log) {
    const std::size_t event = *next_;
    value_ ^= log.event(event).delta;
    next_.reset();
    return event;
  }
  void take_before(const Timeline& log, std::size_t end) {
    while (changes_before(log, end)) take(log);
  }
  [[nodiscard]] std::size_t next_or(const Timeline& log, std::size_t end) {
    return changes_before(log, end) ? *next_ : end;
  }

 private:
  void find(const Timeline& log) {
    if (next_ || looked_to_ == log.size()) return;
    next_ = log.next_event(static_cast<NodeId>(which_), {EventKind::scalar}, looked_to_);
    looked_to_ = next_ ? *next_ + 1 : log.size();
  }

  Scalar which_;
  std::uint64_t value_;
  std::size_t looked_to_;
  std::optional<std::size_t> next_;
};

}  // namespace replan
