// Work that is done a slice at a time, so that a frame waits for no more than that.
#pragma once

#include <chrono>

namespace replan {

class Deadline {
 public:
  explicit Deadline(double milliseconds) : milliseconds_(milliseconds) {}
  [[nodiscard]] bool passed() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count() >=
           milliseconds_;
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double milliseconds_;
};

}  // namespace replan
