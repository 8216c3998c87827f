#include "core/base/steps.hpp"

#include <algorithm>

namespace replan {

void Steps::pump(const Deadline& deadline) {
  ++pumps_;
  for (Entry& entry : entries_)
    if (entry.state == State::waits) entry.state = State::more;  // leave may have been given
  while (advance_next() && !deadline.passed()) {
  }
  std::erase_if(entries_, [](const Entry& entry) { return entry.over(); });
  next_ = entries_.empty() ? 0 : next_ % entries_.size();
}

/// A slice of the next task that has something to do. False if none has.
bool Steps::advance_next() {
  for (std::size_t tried = 0, count = entries_.size(); tried < count; ++tried) {
    const std::size_t at = next_++ % count;
    const std::shared_ptr<Task> task = entries_[at].task.lock();
    if (!task || entries_[at].state != State::more || entries_[at].added + 1 >= pumps_) continue;
    const State state = task->advance();
    entries_[at].state = state;  // the task may have added others: no reference outlives the slice
    return true;
  }
  return false;
}

bool Steps::busy() const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [](const Entry& entry) { return !entry.over() && entry.state != State::waits; });
}

}  // namespace replan
