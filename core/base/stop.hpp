// Asking work to stop, in builds with threads and without.
#pragma once

// CMake's option REPLAN_THREADS sets it to 0; a build with threads need not say so.
#ifndef REPLAN_THREADS
#define REPLAN_THREADS 1
#endif

#if REPLAN_THREADS
#include <stop_token>
#else
#include <atomic>
#include <memory>
#include <utility>
#endif

namespace replan {

/// Whether this build has threads. Where it has none, all work is done in step.
inline constexpr bool kThreads = REPLAN_THREADS != 0;

#if REPLAN_THREADS

using StopToken = std::stop_token;
using StopSource = std::stop_source;

#else

/// Tells work whether somebody wants it to stop; one that nobody has given a source says no.
class StopToken {
 public:
  StopToken() = default;
  [[nodiscard]] bool stop_requested() const { return flag_ && *flag_; }
  [[nodiscard]] bool stop_possible() const { return flag_ != nullptr; }

 private:
  friend class StopSource;
  // Atomic, since a program may set it when a signal comes.
  using Flag = std::shared_ptr<const std::atomic<bool> >;
  explicit StopToken(Flag flag) : flag_(std::move(flag)) {}

  Flag flag_;
};

class StopSource {
 public:
  [[nodiscard]] StopToken get_token() const { return StopToken(flag_); }
  [[nodiscard]] bool stop_requested() const { return *flag_; }
  /// True if nobody had asked before.
  bool request_stop() { return !flag_->exchange(true); }

 private:
  std::shared_ptr<std::atomic<bool> > flag_ = std::make_shared<std::atomic<bool> >(false);
};

#endif

}  // namespace replan
