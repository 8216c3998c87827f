// The Tracer concept: whom a planner tells what it does. Either nobody, at no cost, or a Recorder.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/cost.hpp"
#include "core/trace/event.hpp"

namespace replan {

template <class T>
concept Tracer = requires(T tracer, EventKind kind, NodeId node, std::uint64_t word, Cost cost, int line,
                          Scalar scalar) {
  { T::kEnabled } -> std::convertible_to<bool>;
  tracer.line(line);
  tracer.change(kind, node, word, word);
  tracer.change(kind, node, cost, cost);
  tracer.change(scalar, word, word);
  tracer.note(kind, node, word);
};

/// Listens to nothing and compiles to nothing.
struct NoTrace {
  static constexpr bool kEnabled = false;
  static constexpr void line(int) {}
  static constexpr void change(EventKind, NodeId, std::uint64_t, std::uint64_t) {}
  static constexpr void change(EventKind, NodeId, Cost, Cost) {}
  static constexpr void change(Scalar, std::uint64_t, std::uint64_t) {}
  static constexpr void note(EventKind, NodeId, std::uint64_t = 0) {}
};

/// Writes events to a buffer that its owner empties between slices of the search.
class Recorder {
 public:
  static constexpr bool kEnabled = true;

  /// The pseudo-code line that the following events belong to.
  void line(int number) { line_ = static_cast<std::uint8_t>(number); }
  [[nodiscard]] int current_line() const { return line_; }
  void change(EventKind kind, NodeId node, std::uint64_t before, std::uint64_t after) {
    if (before != after) push(kind, node, before ^ after);
  }
  void change(EventKind kind, NodeId node, Cost before, Cost after) {
    change(kind, node, static_cast<std::uint64_t>(before.raw), static_cast<std::uint64_t>(after.raw));
  }
  void change(Scalar scalar, std::uint64_t before, std::uint64_t after) {
    change(EventKind::scalar, static_cast<NodeId>(scalar), before, after);
  }
  void note(EventKind kind, NodeId node, std::uint64_t payload = 0) { push(kind, node, payload); }

  /// What was recorded since it was last taken. Valid until more is.
  [[nodiscard]] std::span<const Event> buffer() const { return std::span(buffer_).first(count_); }
  /// Hands that over, and goes on in the memory of `next`, whatever it holds: memory that was written to
  /// before costs much less than fresh one.
  [[nodiscard]] std::vector<Event> take(std::vector<Event> next = {}) {
    buffer_.resize(count_);
    count_ = 0;
    return std::exchange(buffer_, std::move(next));
  }
  void clear() { count_ = 0; }

 private:
  void push(EventKind kind, NodeId node, std::uint64_t delta) {
    // Not push_back(), which is too large to be inlined and has each event pass through memory twice.
    if (count_ == buffer_.size()) buffer_.resize(std::max(kLeast, 2 * count_));
    buffer_[count_++] = {delta, node, kind, line_, 0};
  }

  static constexpr std::size_t kLeast = 256;
  std::vector<Event> buffer_;  // the first count_ were recorded, the rest is room
  std::size_t count_ = 0;
  std::uint8_t line_ = 0;
};

static_assert(Tracer<NoTrace> && Tracer<Recorder>);

}  // namespace replan
