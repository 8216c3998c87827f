// Time that a thread has worked, whatever else the machine does.
#pragma once

#include <ctime>

namespace replan {

/// Milliseconds of processor time of the calling thread, from any moment on.
inline double thread_cpu_ms() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  std::timespec now{};
  if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0)
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
#endif
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace replan
