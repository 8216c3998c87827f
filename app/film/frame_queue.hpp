// Frames on their way from the one who draws them to those who write them.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/result.hpp"
#include "ui/image.hpp"

namespace replan::app {

/// A bounded queue with its own threads: drawing and writing overlap, and a slow writer slows the drawing
/// down instead of losing frames.
class FrameQueue {
 public:
  /// Takes one frame, with its number from 0. Called on the queue's threads; with one thread in order.
  using Taker = std::function<Result<void>(std::size_t number, const ui::Image& frame)>;

  FrameQueue(Taker taker, int threads);
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;
  /// Drops the frames that still wait.
  ~FrameQueue();

  /// Waits while the queue is full. An Error is the taker's first; frames after it are not taken.
  Result<void> push(ui::Image frame);
  /// Waits until all frames are taken. Nothing may be pushed afterwards.
  Result<void> finish();
  /// No longer waits for anything.
  void cancel();

 private:
  void work();
  void end(bool drop);

  Taker taker_;
  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::deque<std::pair<std::size_t, ui::Image>> waiting_;
  std::size_t pushed_ = 0;
  bool ended_ = false;
  std::optional<std::string> error_;
  std::vector<std::jthread> threads_;  // last: they end before what they use
};

}  // namespace replan::app
