#include "core/trace/event_store.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace replan {

EventStore::EventStore(std::size_t chunk_events)
    : shift_(static_cast<unsigned>(std::countr_zero(chunk_events))), mask_(chunk_events - 1) {}

void EventStore::append(std::span<const Event> events) {
  while (!events.empty()) {
    if ((size_ & mask_) == 0) {
      chunks_.emplace_back();
      open_.push_back(nullptr);
      take_memory(chunks_.size() - 1);
      use(chunks_.size() - 1);
    }
    const auto piece = events.first(std::min(events.size(), chunk_events() - (size_ & mask_)));
    std::vector<Event>& last = chunks_.back().events;
    last.insert(last.end(), piece.begin(), piece.end());
    size_ += piece.size();
    events = events.subspan(piece.size());
  }
}

std::vector<std::vector<Event>> EventStore::truncate(std::size_t size) {
  const std::size_t chunks = (size + mask_) >> shift_;
  peeked_.clear();
  std::vector<std::vector<Event>> gone;
  for (std::size_t chunk = chunks; chunk < chunks_.size(); ++chunk) {
    if (!holds(chunk)) --dropped_;
    packed_bytes_ -= chunks_[chunk].packed.bytes();
    if (open_[chunk] != nullptr) gone.push_back(close(chunk));
  }
  chunks_.resize(chunks);
  open_.resize(chunks);
  size_ = size;
  if ((size & mask_) == 0) return gone;
  // It goes on growing, so that what was packed of it is no longer all of it.
  Chunk& last = chunks_.back();
  last.events.resize(size & mask_);
  packed_bytes_ -= std::exchange(last.packed, {}).bytes();
  return gone;
}

std::span<const Event> EventStore::peek(std::size_t from, std::size_t to) {
  const std::size_t begin = from - from % stretch_events();
  to = std::min(to, begin + stretch_events());
  if (const Event* open = find(from); open != nullptr) return {open, to - from};
  if (peeked_.empty() || peeked_at_ != begin) {
    chunks_[chunk_of(from)].packed.unpack_stretch((begin & mask_) / PackedEvents::kStretch, peeked_);
    peeked_at_ = begin;
  }
  return std::span(peeked_).subspan(from - begin, to - from);
}

void EventStore::open(std::size_t chunk) {
  take_memory(chunk);
  chunks_[chunk].packed.unpack(chunks_[chunk].events);
  use(chunk);
}

void EventStore::put_back(std::size_t chunk, std::span<const Event> events) {
  --dropped_;
  take_memory(chunk);
  chunks_[chunk].events.assign(events.begin(), events.end());
  use(chunk);
}

/// Room for all of the chunk's events at once: the last one goes on growing.
void EventStore::take_memory(std::size_t chunk) {
  std::vector<Event>& events = chunks_[chunk].events;
  events.reserve(chunk_events());
  open_[chunk] = events.data();
  open_bytes_ += events.capacity() * sizeof(Event);
}

/// Hands the memory of a chunk that lies open over.
std::vector<Event> EventStore::close(std::size_t chunk) {
  open_bytes_ -= chunks_[chunk].events.capacity() * sizeof(Event);
  open_[chunk] = nullptr;
  return std::exchange(chunks_[chunk].events,
                       std::vector<Event>());  // not `= {}`, which would keep the memory
}

void EventStore::pack(std::size_t chunk) {
  if (chunks_[chunk].packed.empty()) {
    chunks_[chunk].packed = PackedEvents(chunks_[chunk].events);
    packed_bytes_ += chunks_[chunk].packed.bytes();
  }
  close(chunk);
}

void EventStore::drop(std::size_t chunk) {
  packed_bytes_ -= std::exchange(chunks_[chunk].packed, {}).bytes();
  ++dropped_;
}

/// Of the chunks from `first` on that fit, but the last one; size of all if there is none.
template <class Fits>
std::size_t EventStore::longest_unused(std::size_t first, Fits fits) const {
  std::size_t found = chunks_.size();
  for (std::size_t chunk = first; chunk + 1 < chunks_.size(); ++chunk)
    if (fits(chunk) && (found == chunks_.size() || chunks_[chunk].used < chunks_[found].used)) found = chunk;
  return found;
}

void EventStore::shrink(std::size_t open_bytes, std::size_t bytes, std::size_t keep,
                        std::size_t undroppable) {
  while (open_bytes_ > open_bytes) {
    const std::size_t chunk =
        longest_unused(0, [&](std::size_t c) { return c != keep && open_[c] != nullptr; });
    if (chunk == chunks_.size()) break;
    pack(chunk);
  }
  while (this->bytes() > bytes) {
    const std::size_t chunk =
        longest_unused(undroppable, [&](std::size_t c) { return open_[c] == nullptr && holds(c); });
    if (chunk == chunks_.size()) return;
    drop(chunk);
  }
}

}  // namespace replan
