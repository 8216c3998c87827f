// How a value of the run changes in a stretch of its log, without a look at all that lies between.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/trace/timeline.hpp"

namespace replan {

/// The values that a scalar takes in a stretch of the log, one after the other.
class ScalarValues {
 public:
  ScalarValues(const Timeline& log, const SearchState& at_begin, Scalar which, std::size_t begin)
      : log_(log), which_(which), value_(at_begin.scalar(which)) {
    find(begin);
  }
  /// That of the latest change that was taken.
  [[nodiscard]] std::uint64_t value() const { return value_; }
  [[nodiscard]] bool changes_before(std::size_t end) const { return next_ && *next_ < end; }
  /// Takes the next change; its event.
  std::size_t take() {
    const std::size_t event = *next_;
    value_ ^= log_.event(event).delta;
    find(event + 1);
    return event;
  }
  void take_before(std::size_t end) {
    while (changes_before(end)) take();
  }
  [[nodiscard]] std::size_t next_or(std::size_t end) const { return changes_before(end) ? *next_ : end; }

 private:
  void find(std::size_t from) {
    next_ = log_.next_event(static_cast<NodeId>(which_), {EventKind::scalar}, from);
  }

  const Timeline& log_;
  Scalar which_;
  std::uint64_t value_;
  std::optional<std::size_t> next_;
};

}  // namespace replan
