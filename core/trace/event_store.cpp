#include "core/trace/event_store.hpp"

#include <algorithm>
#include <bit>

namespace replan {

EventStore::EventStore(std::size_t chunk_events)
    : shift_(static_cast<unsigned>(std::countr_zero(chunk_events))), mask_(chunk_events - 1) {}

void EventStore::append(std::span<const Event> events) {
  while (!events.empty()) {
    if ((size_ & mask_) == 0) {
      chunks_.emplace_back().reserve(chunk_events());
      data_.push_back(chunks_.back().data());
      used_.push_back(++uses_);
      ++held_;
    }
    const auto piece = events.first(std::min(events.size(), chunk_events() - (size_ & mask_)));
    chunks_.back().insert(chunks_.back().end(), piece.begin(), piece.end());
    size_ += piece.size();
    events = events.subspan(piece.size());
  }
}

void EventStore::truncate(std::size_t size) {
  const std::size_t chunks = (size + mask_) >> shift_;
  for (std::size_t chunk = chunks; chunk < chunks_.size(); ++chunk) drop(chunk);
  chunks_.resize(chunks);
  data_.resize(chunks);
  used_.resize(chunks);
  if ((size & mask_) != 0) chunks_.back().resize(size & mask_);
  size_ = size;
}

void EventStore::put_back(std::size_t chunk, std::span<const Event> events) {
  // Room for all of it: the last chunk goes on growing.
  chunks_[chunk].reserve(chunk_events());
  chunks_[chunk].assign(events.begin(), events.end());
  data_[chunk] = chunks_[chunk].data();
  ++held_;
  use(chunk);
}

void EventStore::drop(std::size_t chunk) {
  if (!holds(chunk)) return;
  chunks_[chunk] = {};
  data_[chunk] = nullptr;
  --held_;
}

void EventStore::shrink(std::size_t bytes, std::size_t keep) {
  while (this->bytes() > bytes) {
    std::size_t oldest = chunks_.size();
    for (std::size_t chunk = 0; chunk + 1 < chunks_.size(); ++chunk)
      if (chunk != keep && holds(chunk) && (oldest == chunks_.size() || used_[chunk] < used_[oldest]))
        oldest = chunk;
    if (oldest == chunks_.size()) return;
    drop(oldest);
  }
}

}  // namespace replan
