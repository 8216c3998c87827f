// All that core and ui know of threads: this header, and no other, differs in a build without.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <mutex>

#include "core/base/stop.hpp"

#if REPLAN_THREADS
#include <condition_variable>
#include <thread>
#include <vector>
#else
#include <cstdlib>
#endif

namespace replan {

#if REPLAN_THREADS

/// Asks its work to stop and waits for it when it is destroyed.
using Thread = std::jthread;
/// What threads wait for under a mutex.
using Signal = std::condition_variable_any;

/// How many the machine has.
inline std::size_t processor_count() {
  return std::max(1u, std::thread::hardware_concurrency());
}

/// Does the same work on so many threads, the caller's own among them, and returns when all have ended.
inline void work_on_threads(std::size_t count, const std::function<void()>& work) {
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < count; ++i) others.emplace_back(work);
  work();
}

#else

/// Nobody makes one that works: WorkPlace::on_thread() is never true.
class Thread {
 public:
  Thread() = default;
  template <class Work>
  explicit Thread(const Work&) {
    std::abort();
  }
  void request_stop() {}
  void join() {}
};

/// There is nobody to wait for: what has not come by now does not come.
class Signal {
 public:
  void notify_one() {}
  void notify_all() {}
  template <class Lock, class Condition>
  void wait(Lock&, Condition) {}
  template <class Lock, class Condition>
  bool wait(Lock&, const StopToken&, Condition condition) {
    return condition();
  }
  template <class Lock, class Time, class Condition>
  bool wait_until(Lock&, const Time&, Condition condition) {
    return condition();
  }
};

inline std::size_t processor_count() {
  return 1;
}

inline void work_on_threads(std::size_t, const std::function<void()>& work) {
  work();
}

#endif

}  // namespace replan
