// Ctrl-C as a wish to stop, not as an end: what is being made is put away first.
#pragma once

#include <stop_token>
#include <thread>

namespace replan::cli {

/// While it lives, SIGINT and SIGTERM ask for a stop; a second one ends the program at once. Threads that are begun later
/// leave the signals to it.
class StopOnInterrupt {
 public:
  StopOnInterrupt();
  ~StopOnInterrupt();
  StopOnInterrupt(const StopOnInterrupt&) = delete;
  StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

  [[nodiscard]] std::stop_token token() const { return wish_.get_token(); }

 private:
  std::stop_source wish_;
  std::jthread waiting_;
};

}  // namespace replan::cli
