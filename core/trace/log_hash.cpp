#include "core/trace/log_hash.hpp"

#include <algorithm>

#include "core/base/hash.hpp"

namespace replan {
namespace {

/// Events between two looks at the clock.
constexpr std::size_t kHashedAtOnce = 16384;

}  // namespace

bool LogHash::advance(const Timeline& log, const Deadline& deadline) {
  while (next_ < events_) {
    for (const Event& e : log.peek(next_, std::min(events_, next_ + kHashedAtOnce))) {
      hash_ = hash_combine(hash_, e.delta ^ mix64(std::uint64_t{e.node} << 16 | std::uint64_t{e.line} << 8 |
                                                  static_cast<std::uint64_t>(e.kind)));
      ++next_;
    }
    if (deadline.passed()) break;
  }
  return next_ == events_;
}

std::uint64_t Timeline::log_hash() const {
  LogHash hash(size());
  hash.advance(*this, Deadline::never());
  return hash.value();
}

}  // namespace replan
