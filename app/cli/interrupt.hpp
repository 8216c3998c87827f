// Ctrl-C as a wish to stop, not as an end: what is being made is put away first.
#pragma once

#include <thread>

#include "core/base/stop.hpp"

namespace replan::cli {

/// While it lives, SIGINT and SIGTERM ask for a stop; a second one ends the program at once. Threads that are begun later
/// leave the signals to it.
class StopOnInterrupt {
 public:
  StopOnInterrupt();
  ~StopOnInterrupt();
  StopOnInterrupt(const StopOnInterrupt&) = delete;
  StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

  [[nodiscard]] StopToken token() const { return wish_.get_token(); }

 private:
  StopSource wish_;
  std::jthread waiting_;
};

}  // namespace replan::cli
