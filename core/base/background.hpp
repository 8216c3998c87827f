// Work off the drawing moment: one job with one result, taken over at one point.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "core/base/stop.hpp"
#include "core/base/threads.hpp"
#include "core/base/work_place.hpp"

namespace replan {

/// Runs one job at a time and keeps its result until it is taken. A job must own all that it reads. On a thread it gets a
/// stop token; one that does not listen goes on unheard, and is waited for only by the destructor. In step it is never
/// interrupted: one that is given up gets no further slice.
template <class T>
class Background {
 public:
  /// A job in one piece, and one that is cut up: each call is a slice, and the last one gives the result.
  using Job = std::function<T(const StopToken&)>;
  using Slice = std::function<std::optional<T>(const StopToken&)>;

  explicit Background(WorkPlace place = {}) : place_(std::move(place)) {}
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  ~Background() { cancel(); }

  /// Begins a job. An older one that is still at work is cancelled.
  void start(Job job) {
    start_slices([job = std::move(job)](const StopToken& stop) { return std::optional<T>(job(stop)); });
  }
  /// While `waits` says so, nobody need ask for a slice.
  void start_slices(Slice slice, std::function<bool()> waits = {}) {
    cancel();
    current_ = std::make_shared<Slot>(std::move(slice), std::move(waits));
    if (place_.on_thread())
      start_thread();
    else if (place_.steps)
      place_.steps->add(current_);
    else
      finish(*current_);
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

  /// Waits until no job is at work any more, or does it; take() then has the last one's result.
  void wait() {
    // A thread that is merely let go of would be asked to stop first, and its job end half done.
    for (Worker& worker : threads_) worker.thread.join();
    threads_.clear();
    if (current_) finish(*current_);
  }

  /// Whether a job was begun whose result was not taken yet.
  [[nodiscard]] bool busy() const { return current_ != nullptr; }

 private:
  struct Slot final : Steps::Task {
    Slot(Slice its_slice, std::function<bool()> its_waits)
        : slice(std::move(its_slice)), waits(std::move(its_waits)) {}

    bool is_done() {
      const std::lock_guard lock(mutex);
      return done;
    }
    /// What is made of the job is freed here too, not where the result is taken.
    void end(std::optional<T> with) {
      slice = {};
      const std::lock_guard lock(mutex);
      result = std::move(with);
      done = true;
    }
    State advance() override {
      if (done) return State::done;
      if (waits && waits()) return State::waits;
      if (auto whole = slice(StopToken())) end(std::move(whole));
      return done ? State::done : State::more;
    }

    Slice slice;
    std::function<bool()> waits;
    std::mutex mutex;  // guards what follows
    std::optional<T> result;
    bool done = false;
  };
  struct Worker {
    std::shared_ptr<Slot> slot;
    Thread thread;
  };

  void start_thread() {
    std::erase_if(threads_, [](const Worker& worker) { return worker.slot->is_done(); });
    threads_.push_back({current_, Thread([slot = current_, wake = place_.wake](const StopToken& stop) {
                          std::optional<T> whole;
                          while (!whole && !stop.stop_requested()) whole = slot->slice(stop);
                          slot->end(std::move(whole));
                          if (wake) wake();
                        })});
  }
  static void finish(Slot& slot) {
    while (slot.advance() == Steps::Task::State::more) {
    }
  }

  WorkPlace place_;
  std::shared_ptr<Slot> current_;
  std::list<Worker> threads_;  // the last one is at work for current_; the others were given up or are done
};

}  // namespace replan
