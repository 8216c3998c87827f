#include "core/base/disposal.hpp"

#include <atomic>
#include <deque>
#include <mutex>

#include "core/base/threads.hpp"

namespace replan {
namespace {

class Disposal {
 public:
  void take(std::shared_ptr<void> thing) {
    const std::scoped_lock lock(mutex_);
    things_.push_back(std::move(thing));
    wake_.notify_one();
  }

 private:
  void work(const StopToken& stop) {
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return !things_.empty(); })) {
      std::shared_ptr<void> thing = std::move(things_.front());
      things_.pop_front();
      lock.unlock();
      thing.reset();
      lock.lock();
    }
  }

  std::mutex mutex_;
  Signal wake_;
  std::deque<std::shared_ptr<void>> things_;
  Thread thread_{[this](const StopToken& stop) { work(stop); }};
};

std::atomic<bool> disposes_at_once = !kThreads;

}  // namespace

void dispose_at_once() {
  disposes_at_once = true;
}

void dispose_of(std::shared_ptr<void> thing) {
  // Giving memory back cannot be cut up. Where there are no threads it does not go back to the system, and costs little.
  if (disposes_at_once) return thing.reset();
  static Disposal disposal;
  disposal.take(std::move(thing));
}

}  // namespace replan
