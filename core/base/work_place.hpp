// Where work is done that takes longer than a frame.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "core/base/steps.hpp"
#include "core/base/stop.hpp"

namespace replan {

/// One value, given by the program to all that works: on threads, which wake the window when something is done; in step
/// with its frames, a slice at a time; or, without a window, at once, so that pictures and tests need not wait.
struct WorkPlace {
  bool in_step = true;                ///< a build without threads knows nothing else
  std::function<void()> wake = {};    ///< called from a job's thread
  std::shared_ptr<Steps> steps = {};  ///< in step: by whom it is done; nobody: at once

  [[nodiscard]] bool on_thread() const { return kThreads && !in_step; }

  /// Beside the caller: on a thread if there are threads.
  static WorkPlace beside(std::function<void()> wake = {}) {
    return {.in_step = false, .wake = std::move(wake), .steps = {}};
  }
  /// In step, when these are pumped.
  static WorkPlace in_steps(std::shared_ptr<Steps> steps = std::make_shared<Steps>()) {
    return {.in_step = true, .wake = {}, .steps = std::move(steps)};
  }
  /// The place for a job that may be too short to be put off: then it is done at once.
  [[nodiscard]] WorkPlace only_if(bool takes_long) const { return takes_long ? *this : WorkPlace{}; }
};

}  // namespace replan
