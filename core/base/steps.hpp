// Work without threads: pieces of it that are done in step with frames, a slice at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/deadline.hpp"

namespace replan {

/// What one window, or one program without a window, has to do in step. Everything is done by pump(), in turn, a slice
/// of each; nothing that is asked for is done at once.
class Steps {
 public:
  class Task {
   public:
    enum class State : std::uint8_t { more, waits, done };
    virtual ~Task() = default;
    /// One slice. `waits`: there is nothing to do before somebody gives leave.
    virtual State advance() = 0;
  };

  /// Begins with it at the second pump() from now: by then a frame was seen that says what is waited for, so that work
  /// that cannot be cut does not stand before it. Whoever lets go of a task gives it up.
  void add(std::weak_ptr<Task> task) { entries_.push_back({std::move(task), pumps_, State::more}); }

  /// Does slices until the deadline has passed or nothing is left to do: one at least, if there is any. So it is over the
  /// deadline by one slice at most.
  void pump(const Deadline& deadline);

  /// Whether something is to be done at the next pump(), or the one after it.
  [[nodiscard]] bool busy() const;

 private:
  using State = Task::State;
  struct Entry {
    std::weak_ptr<Task> task;
    std::uint64_t added;  // after so many pumps
    State state;          // after its last slice
    [[nodiscard]] bool over() const { return state == State::done || task.expired(); }
  };

  bool advance_next();

  std::vector<Entry> entries_;
  std::size_t next_ = 0;  // in them, whose turn it is
  std::uint64_t pumps_ = 0;
};

}  // namespace replan
