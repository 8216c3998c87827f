// Work that is done a slice at a time, so that a frame waits for no more than that.
#pragma once

#include <chrono>
#include <limits>

namespace replan {

class Deadline {
 public:
  explicit Deadline(double milliseconds) : milliseconds_(milliseconds) {}
  /// For work that is done to its end.
  static Deadline never() { return Deadline(std::numeric_limits<double>::infinity()); }
  [[nodiscard]] bool passed() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count() >=
           milliseconds_;
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double milliseconds_;
};

}  // namespace replan
