#include "app/cli/interrupt.hpp"

#include <csignal>
#include <ctime>

namespace replan::cli {
namespace {

sigset_t interrupts() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

StopOnInterrupt::StopOnInterrupt() {
  const sigset_t set = interrupts();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiting_ = std::jthread([set, wish = wish_](const std::stop_token& over) mutable {
    constexpr timespec kBetween{0, 50'000'000};
    while (!over.stop_requested()) {
      const int signal = sigtimedwait(&set, nullptr, &kBetween);
      if (signal < 0) continue;
      if (wish.request_stop()) continue;
      std::signal(signal, SIG_DFL);
      pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
      std::raise(signal);
    }
  });
}

StopOnInterrupt::~StopOnInterrupt() {
  waiting_ = {};
  const sigset_t set = interrupts();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace replan::cli
