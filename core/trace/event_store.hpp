// The events of a log in chunks, some of which may have been dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/trace/event.hpp"

namespace replan {

/// Events by their position. Chunks can be dropped and put back; the last one is always held.
class EventStore {
 public:
  /// `chunk_events` is a power of two.
  explicit EventStore(std::size_t chunk_events);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t chunk_events() const { return mask_ + 1; }
  [[nodiscard]] std::size_t chunk_of(std::size_t index) const { return index >> shift_; }
  /// The event, or nullptr if its chunk was dropped. Valid until the next change.
  [[nodiscard]] const Event* find(std::size_t index) const {
    const Event* chunk = data_[index >> shift_];
    return chunk != nullptr ? chunk + (index & mask_) : nullptr;
  }
  [[nodiscard]] bool holds(std::size_t chunk) const { return data_[chunk] != nullptr; }

  /// The chunk that held the last event must not have been dropped.
  void append(std::span<const Event> events);
  /// Forgets all events from `size` on. The chunk that becomes the last one must be held. Returns the memory
  /// of the chunks that went, for whoever has the time to free it.
  std::vector<std::vector<Event>> truncate(std::size_t size);
  /// Puts a dropped chunk back: all of its events.
  void put_back(std::size_t chunk, std::span<const Event> events);
  /// Counts as a use of the chunk: those that were used longest ago are dropped first.
  void use(std::size_t chunk) { used_[chunk] = ++uses_; }
  /// Drops chunks until those held take at most `bytes`; the last one and `keep` stay.
  void shrink(std::size_t bytes, std::size_t keep);

  /// Bytes of memory that the chunks held take.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  void take_memory(std::size_t chunk);
  std::vector<Event> give_up(std::size_t chunk);

  unsigned shift_;
  std::size_t mask_;
  std::size_t size_ = 0;
  std::size_t bytes_ = 0;
  std::uint64_t uses_ = 0;
  std::vector<const Event*> data_;  // of each chunk, nullptr = dropped: all that find() needs
  std::vector<std::vector<Event>> chunks_;
  std::vector<std::uint64_t> used_;
};

}  // namespace replan
