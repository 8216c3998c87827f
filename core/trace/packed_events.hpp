// A stretch of a log in less than half of its memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/trace/event.hpp"

namespace replan {

/// Events that nobody reads for now. What an event has in common with those before it is left out: its kind and line,
/// which come in few pairs; its node, which lies near the last one; its delta, which is often that of the same node's
/// last event, and otherwise near the last one of its kind. Every so many events this begins anew, so that a question
/// about a few of them need not unpack all.
class PackedEvents {
 public:
  /// Events of a stretch that can be unpacked by itself; the last one may be shorter.
  static constexpr std::size_t kStretch = 4096;

  PackedEvents() = default;
  explicit PackedEvents(std::span<const Event> events);

  /// The events again, all of them, into `events`.
  void unpack(std::vector<Event>& events) const;
  /// The events of one stretch again, into `events`.
  void unpack_stretch(std::size_t stretch, std::vector<Event>& events) const;

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Memory that they take.
  [[nodiscard]] std::size_t bytes() const { return bytes_.capacity() + begins_.capacity() * sizeof(begins_[0]); }

 private:
  void unpack_to(std::size_t stretch, std::span<Event> events) const;

  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint32_t> begins_;  // of each stretch in the bytes
  std::size_t count_ = 0;
};

}  // namespace replan
