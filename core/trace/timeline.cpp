#include "core/trace/timeline.hpp"

#include <algorithm>

#include "core/base/hash.hpp"

namespace replan {

Timeline::Timeline(SearchState initial, std::size_t frame_budget)
    : state_(initial), head_(std::move(initial)), frame_budget_(frame_budget) {
  frames_.emplace(0, head_);
}

void Timeline::append(const std::vector<Event>& events) {
  for (const Event& event : events) {
    if (size_ % kChunk == 0) chunks_.emplace_back().reserve(kChunk);
    chunks_.back().push_back(event);
    head_.apply(event);
    index_.add(size_, event.node);
    ++size_;
    if (size_ % frame_interval_ == 0) capture();
  }
}

void Timeline::capture() {
  // Pages that the head holds alone were written since the last frame: what this frame adds.
  frame_bytes_ += head_.own_bytes();
  frames_.emplace(size_, head_);
  while (frame_bytes_ > frame_budget_ && frames_.size() > 2) thin_out();
}

void Timeline::thin_out() {
  frame_interval_ *= 2;
  const std::size_t before = frames_.size();
  std::erase_if(frames_, [this](const auto& frame) { return frame.first % frame_interval_ != 0; });
  // A frame that goes leaves the pages that it shares with those that stay: the rest of the sum is an
  // estimate.
  frame_bytes_ = frame_bytes_ * frames_.size() / before;
}

void Timeline::truncate(std::size_t size) {
  if (size >= size_) return;
  if (cursor_ > size) seek(size);
  const std::size_t back = cursor_;
  seek(size);
  head_ = state_;
  seek(back);
  const std::size_t before = frames_.size();
  frames_.erase(frames_.upper_bound(size), frames_.end());
  frame_bytes_ = frame_bytes_ * frames_.size() / before;  // an estimate, as in thin_out()
  chunks_.resize((size + kChunk - 1) / kChunk);
  if (size % kChunk != 0) chunks_.back().resize(size % kChunk);
  size_ = size;
  index_.truncate(size / NodeIndex::kBlock);
  for (std::size_t i = size - size % NodeIndex::kBlock; i < size; ++i) index_.add(i, event(i).node);
}

void Timeline::seek(std::size_t position) {
  const auto distance = [position](std::size_t from) {
    return from > position ? from - position : position - from;
  };
  std::size_t best = distance(cursor_);
  const auto offer = [&](std::size_t at, const SearchState& state) {
    if (distance(at) >= best) return;
    best = distance(at);
    cursor_ = at;
    state_ = state;
  };
  offer(size_, head_);
  const auto after = frames_.lower_bound(position);
  if (after != frames_.end()) offer(after->first, after->second);
  if (after != frames_.begin()) offer(std::prev(after)->first, std::prev(after)->second);
  while (cursor_ < position) state_.apply(event(cursor_++));
  while (cursor_ > position) state_.apply(event(--cursor_));
}

SearchState Timeline::state_at(std::size_t position) const {
  std::size_t at = cursor_;
  const SearchState* nearest = &state_;
  const auto distance = [position](std::size_t from) {
    return from > position ? from - position : position - from;
  };
  const auto offer = [&](std::size_t where, const SearchState& state) {
    if (distance(where) >= distance(at)) return;
    at = where;
    nearest = &state;
  };
  offer(size_, head_);
  const auto after = frames_.lower_bound(position);
  if (after != frames_.end()) offer(after->first, after->second);
  if (after != frames_.begin()) offer(std::prev(after)->first, std::prev(after)->second);
  SearchState state = *nearest;
  while (at < position) state.apply(event(at++));
  while (at > position) state.apply(event(--at));
  return state;
}

std::optional<std::size_t> Timeline::last_event(NodeId node, KindSet kinds, std::size_t before) const {
  for (std::size_t end = std::min(before, size_); end > 0;) {
    const auto block = index_.last_block(node, (end - 1) / NodeIndex::kBlock + 1);
    if (!block) break;
    const std::size_t first = *block * NodeIndex::kBlock;
    for (std::size_t i = std::min(end, first + NodeIndex::kBlock); i-- > first;)
      if (const Event e = event(i); e.node == node && kinds.has(e.kind)) return i;
    end = first;
  }
  return std::nullopt;
}

std::optional<std::size_t> Timeline::next_event(NodeId node, KindSet kinds, std::size_t from) const {
  while (from < size_) {
    const auto block = index_.next_block(node, from / NodeIndex::kBlock);
    if (!block) break;
    const std::size_t end = std::min((*block + 1) * NodeIndex::kBlock, size_);
    for (std::size_t i = std::max(from, *block * NodeIndex::kBlock); i < end; ++i)
      if (const Event e = event(i); e.node == node && kinds.has(e.kind)) return i;
    from = end;
  }
  return std::nullopt;
}

std::uint64_t Timeline::log_hash() const {
  std::uint64_t seed = size_;
  for (std::size_t i = 0; i < size_; ++i) {
    const Event e = event(i);
    seed = hash_combine(seed, e.delta ^ mix64(std::uint64_t{e.node} << 16 | std::uint64_t{e.line} << 8 |
                                              static_cast<std::uint64_t>(e.kind)));
  }
  return seed;
}

}  // namespace replan
