// The events of a log in chunks: as they are, packed, or dropped.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/trace/event.hpp"
#include "core/trace/packed_events.hpp"

namespace replan {

/// Events by their position. Chunks that are not read for long are packed, and dropped when even that takes too much;
/// the last one always lies open.
class EventStore {
 public:
  /// `chunk_events` is a power of two.
  explicit EventStore(std::size_t chunk_events);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t chunk_events() const { return mask_ + 1; }
  [[nodiscard]] std::size_t chunk_of(std::size_t index) const { return index >> shift_; }
  /// The event, or nullptr if its chunk does not lie open. Valid until the next change.
  [[nodiscard]] const Event* find(std::size_t index) const {
    const Event* chunk = open_[index >> shift_];
    return chunk != nullptr ? chunk + (index & mask_) : nullptr;
  }
  /// The events from `from` on that can be read together, at most up to `to` and never beyond a multiple of
  /// stretch_events(), without opening their chunk, which is held. Valid until the next call or change.
  [[nodiscard]] std::span<const Event> peek(std::size_t from, std::size_t to);
  [[nodiscard]] std::size_t stretch_events() const { return std::min(chunk_events(), PackedEvents::kStretch); }
  /// Whether it has the chunk's events, open or packed.
  [[nodiscard]] bool holds(std::size_t chunk) const {
    return open_[chunk] != nullptr || !chunks_[chunk].packed.empty();
  }

  /// The chunk that held the last event must not have been dropped.
  void append(std::span<const Event> events);
  /// Forgets all events from `size` on. The chunk that becomes the last one must lie open. Returns the memory
  /// of the chunks that went, for whoever has the time to free it.
  std::vector<std::vector<Event>> truncate(std::size_t size);
  /// Opens a chunk that is held.
  void open(std::size_t chunk);
  /// Puts a dropped chunk back: all of its events.
  void put_back(std::size_t chunk, std::span<const Event> events);
  /// Counts as a use of the chunk: those that were used longest ago are packed and dropped first.
  void use(std::size_t chunk) { chunks_[chunk].used = ++uses_; }
  /// Packs chunks until those that lie open take at most `open_bytes`, and drops packed ones until all take at most
  /// `bytes`. The last one and `keep` stay open; of the first `undroppable` chunks none is dropped.
  void shrink(std::size_t open_bytes, std::size_t bytes, std::size_t keep, std::size_t undroppable);

  /// Bytes of memory that the chunks take.
  [[nodiscard]] std::size_t bytes() const { return open_bytes_ + packed_bytes_; }
  /// Whether events were dropped.
  [[nodiscard]] bool dropped() const { return dropped_ > 0; }

 private:
  struct Chunk {
    std::vector<Event> events;  // empty if it does not lie open
    PackedEvents packed;        // empty if it was never packed
    std::uint64_t used = 0;
  };

  void take_memory(std::size_t chunk);
  std::vector<Event> close(std::size_t chunk);
  void pack(std::size_t chunk);
  void drop(std::size_t chunk);
  template <class Fits>
  [[nodiscard]] std::size_t longest_unused(std::size_t first, Fits fits) const;

  unsigned shift_;
  std::size_t mask_;
  std::size_t size_ = 0;
  std::size_t open_bytes_ = 0, packed_bytes_ = 0;
  std::size_t dropped_ = 0;  // chunks
  std::uint64_t uses_ = 0;
  std::vector<const Event*> open_;  // of each chunk, nullptr = not open: all that find() needs
  std::vector<Chunk> chunks_;
  std::vector<Event> peeked_;  // the stretch that was read last out of a packed chunk
  std::size_t peeked_at_ = 0;
};

}  // namespace replan
