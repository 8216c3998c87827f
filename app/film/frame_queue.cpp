#include "app/film/frame_queue.hpp"

namespace replan::app {
namespace {

constexpr std::size_t kMostWaiting = 4;

}  // namespace

FrameQueue::FrameQueue(Taker taker, int threads) : taker_(std::move(taker)) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

FrameQueue::~FrameQueue() {
  cancel();
}

void FrameQueue::end(bool drop) {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    if (drop) waiting_.clear();
  }
  changed_.notify_all();
}

void FrameQueue::cancel() {
  end(true);
  threads_.clear();
}

Result<void> FrameQueue::push(ui::Image frame) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.size() < kMostWaiting || error_ || ended_; });
  if (error_) return Error{*error_};
  waiting_.emplace_back(pushed_++, std::move(frame));
  lock.unlock();
  changed_.notify_all();
  return {};
}

Result<void> FrameQueue::finish() {
  end(false);
  threads_.clear();
  if (error_) return Error{*error_};
  return {};
}

void FrameQueue::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return !waiting_.empty() || ended_; });
    if (waiting_.empty()) return;
    const auto [number, frame] = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    changed_.notify_all();
    const Result<void> taken = taker_(number, frame);
    lock.lock();
    if (taken) continue;
    if (!error_) error_ = taken.error();
    waiting_.clear();
    ended_ = true;
    changed_.notify_all();
  }
}

}  // namespace replan::app
