#include "core/base/disposal.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

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
  void work(const std::stop_token& stop) {
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
  std::condition_variable_any wake_;
  std::deque<std::shared_ptr<void>> things_;
  std::jthread thread_{[this](const std::stop_token& stop) { work(stop); }};
};

}  // namespace

void dispose_of(std::shared_ptr<void> thing) {
  static Disposal disposal;
  disposal.take(std::move(thing));
}

}  // namespace replan
