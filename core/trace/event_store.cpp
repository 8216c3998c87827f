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
      data_.push_back(nullptr);
      used_.push_back(++uses_);
      take_memory(chunks_.size() - 1);
    }
    const auto piece = events.first(std::min(events.size(), chunk_events() - (size_ & mask_)));
    chunks_.back().insert(chunks_.back().end(), piece.begin(), piece.end());
    size_ += piece.size();
    events = events.subspan(piece.size());
  }
}

std::vector<std::vector<Event>> EventStore::truncate(std::size_t size) {
  const std::size_t chunks = (size + mask_) >> shift_;
  std::vector<std::vector<Event>> gone;
  for (std::size_t chunk = chunks; chunk < chunks_.size(); ++chunk)
    if (holds(chunk)) gone.push_back(give_up(chunk));
  chunks_.resize(chunks);
  data_.resize(chunks);
  used_.resize(chunks);
  if ((size & mask_) != 0) chunks_.back().resize(size & mask_);
  size_ = size;
  return gone;
}

void EventStore::put_back(std::size_t chunk, std::span<const Event> events) {
  take_memory(chunk);
  chunks_[chunk].assign(events.begin(), events.end());
  use(chunk);
}

/// Room for all of the chunk's events at once: the last one goes on growing.
void EventStore::take_memory(std::size_t chunk) {
  chunks_[chunk].reserve(chunk_events());
  data_[chunk] = chunks_[chunk].data();
  bytes_ += chunks_[chunk].capacity() * sizeof(Event);
}

/// Hands the memory of a chunk that is held over.
std::vector<Event> EventStore::give_up(std::size_t chunk) {
  bytes_ -= chunks_[chunk].capacity() * sizeof(Event);
  data_[chunk] = nullptr;
  return std::exchange(chunks_[chunk], std::vector<Event>());  // not `= {}`, which would keep the memory
}

void EventStore::shrink(std::size_t bytes, std::size_t keep) {
  while (this->bytes() > bytes) {
    std::size_t oldest = chunks_.size();
    for (std::size_t chunk = 0; chunk + 1 < chunks_.size(); ++chunk)
      if (chunk != keep && holds(chunk) && (oldest == chunks_.size() || used_[chunk] < used_[oldest]))
        oldest = chunk;
    if (oldest == chunks_.size()) return;
    give_up(oldest);
  }
}

}  // namespace replan
