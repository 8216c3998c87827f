// Work off the drawing thread: one job with one result, taken over at one point.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace replan {

/// How jobs are done: on threads of their own in a window, which is woken when one is done; in step without
/// one, so that pictures and tests need not wait.
struct WorkPlace {
  bool in_step = true;
  std::function<void()> wake;  ///< called from the job's thread
};

/// Runs one job at a time and keeps its result until it is taken. A job must own all that it reads. It gets a
/// stop token; one that does not listen goes on unheard, and is waited for only by the destructor.
template <class T>
class Background {
 public:
  explicit Background(WorkPlace place = {}) : place_(std::move(place)) {}
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  ~Background() { cancel(); }

  /// Begins a job. An older one that is still at work is cancelled.
  void start(std::function<T(const std::stop_token&)> job) {
    cancel();
    auto slot = std::make_shared<Slot>();
    current_ = slot;
    if (place_.in_step) {
      slot->result.emplace(job(std::stop_token()));
      return;
    }
    std::erase_if(threads_, [](const Worker& worker) { return worker.slot->is_done(); });
    threads_.push_back(
        {slot, std::jthread([slot, job = std::move(job), wake = place_.wake](const std::stop_token& stop) {
           work(*slot, job, wake, stop);
         })});
  }

  /// The result, once, when the job is done.
  std::optional<T> take() {
    const std::shared_ptr<Slot> slot = current_;
    if (!slot) return std::nullopt;
    const std::lock_guard lock(slot->mutex);
    if (!slot->result) return std::nullopt;
    current_.reset();
    return std::exchange(slot->result, std::nullopt);
  }

  /// Gives the job up: its result is never seen.
  void cancel() {
    if (current_ && !threads_.empty() && threads_.back().slot == current_)
      threads_.back().thread.request_stop();
    current_.reset();
  }

  /// Waits until no job is at work any more; take() then has the last one's result.
  void wait() {
    // A thread that is merely let go of would be asked to stop first, and its job end half done.
    for (Worker& worker : threads_) worker.thread.join();
    threads_.clear();
  }

  /// Whether a job was begun whose result was not taken yet.
  [[nodiscard]] bool busy() const { return current_ != nullptr; }

 private:
  struct Slot {
    std::mutex mutex;
    std::optional<T> result;
    bool done = false;
    bool is_done() {
      const std::lock_guard lock(mutex);
      return done;
    }
  };
  struct Worker {
    std::shared_ptr<Slot> slot;
    std::jthread thread;
  };

  static void work(Slot& slot, const std::function<T(const std::stop_token&)>& job,
                   const std::function<void()>& wake, const std::stop_token& stop) {
    T result = job(stop);
    {
      const std::lock_guard lock(slot.mutex);
      slot.result.emplace(std::move(result));
      slot.done = true;
    }
    if (wake) wake();
  }

  WorkPlace place_;
  std::shared_ptr<Slot> current_;
  std::list<Worker> threads_;  // the last one is at work for current_; the others were given up or are done
};

}  // namespace replan
