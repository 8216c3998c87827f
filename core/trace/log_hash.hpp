// The hash of the first events of a log, worked out a stretch at a time: a log may have hundreds of millions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/deadline.hpp"
#include "core/trace/timeline.hpp"

namespace replan {

/// Equal beginnings of runs have equal hashes. Of all events it is Timeline::log_hash().
class LogHash {
 public:
  /// Of so many first events.
  explicit LogHash(std::size_t events) : events_(events), hash_(events) {}

  /// Reads on in the log, which must be the same one each time and have so many events. Whether it has come to the end.
  bool advance(const Timeline& log, const Deadline& deadline);
  /// Once advance() has come to the end.
  [[nodiscard]] std::uint64_t value() const { return hash_; }
  /// Half as long, for where it has to be short: that two runs differ goes unseen once in four thousand million times.
  [[nodiscard]] std::uint32_t short_value() const { return static_cast<std::uint32_t>(hash_ >> 32); }
  /// How much was read, 0 to 1.
  [[nodiscard]] double share() const {
    return events_ == 0 ? 1 : static_cast<double>(next_) / static_cast<double>(events_);
  }

 private:
  std::size_t events_;
  std::uint64_t hash_;
  std::size_t next_ = 0;  // the event to be read next
};

}  // namespace replan
