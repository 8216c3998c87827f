// Work that is done a slice at a time, so that a frame waits for no more than that.
#pragma once

#include <chrono>
#include <limits>

namespace replan {

class Deadline {
 public:
  /// Milliseconds that go by; another one than this for tests.
  using Clock = double (*)();
  static double steady_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }

  explicit Deadline(double milliseconds, Clock clock = steady_ms)
      : clock_(clock), begin_(clock()), milliseconds_(milliseconds) {}
  /// For work that is done to its end.
  static Deadline never() { return Deadline(std::numeric_limits<double>::infinity()); }
  [[nodiscard]] bool passed() const { return clock_() - begin_ >= milliseconds_; }

 private:
  Clock clock_;
  double begin_, milliseconds_;
};

}  // namespace replan
