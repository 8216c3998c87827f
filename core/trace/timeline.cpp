#include "core/trace/timeline.hpp"

#include <algorithm>
#include <utility>

#include "core/base/disposal.hpp"

namespace replan {
namespace {

/// What key frames may take, of the limit and by the length of the log.
constexpr std::size_t kFrameShare = 4;
constexpr std::size_t kLeastFrameBytes = std::size_t{64} << 20;
constexpr std::size_t kFrameBytesPerEvent = 7;

/// The part of the limit that is left for what comes and goes: a frame too many, the sorting of events.
constexpr std::size_t kWorkShare = 16;

/// What events may take that lie open, of all of them.
constexpr std::size_t kOpenShare = 8;

/// The part of the distance of two frames from which on one is left before an epoch.
constexpr std::size_t kEpochShare = 8;

/// Events from which on it is worth while to sort them by page.
constexpr std::size_t kSortedEvents = 2048;

std::size_t distance(std::size_t a, std::size_t b) {
  return a > b ? a - b : b - a;
}

}  // namespace

Timeline::Timeline(SearchState initial, const LogLimits& limits)
    : limits_(limits),
      events_(limits.chunk_events),
      state_(initial),
      head_(std::move(initial)),
      frame_interval_(limits.frame_interval) {
  frames_.emplace(0, KeyFrame{head_, nullptr});
}

void Timeline::append(std::span<const Event> events, const std::shared_ptr<const Checkpoint>& checkpoint) {
  const auto is_epoch = [](const Event& event) { return event.kind == EventKind::epoch; };
  while (!events.empty()) {
    const auto epoch = std::find_if(events.begin(), events.end(), is_epoch);
    append_search(events.first(static_cast<std::size_t>(epoch - events.begin())));
    if (epoch == events.end()) break;
    take_epoch(*epoch);
    events = events.subspan(static_cast<std::size_t>(epoch - events.begin()) + 1);
  }
  // A search that is set up writes much in one go, in which nothing can be taken up: behind it something can.
  if (size() - last_frame() >= frame_interval_ ||
      (checkpoint && size() - last_checkpoint_ >= frame_interval_))
    capture(checkpoint);
  shrink(events_.chunk_of(cursor_));
}

/// Takes events without an epoch. Frames stand where the run can be taken up; only where that is far off also
/// in between.
void Timeline::append_search(std::span<const Event> events) {
  while (size() + events.size() - last_frame() >= 2 * frame_interval_) {
    const std::size_t gap = last_frame() + frame_interval_ - std::min(size(), last_frame() + frame_interval_);
    const auto piece = events.first(std::min(gap, events.size()));
    take(piece);
    events = events.subspan(piece.size());
    capture(nullptr);
  }
  take(events);
}

void Timeline::take(std::span<const Event> events) {
  std::size_t position = size();
  for (const Event& event : events) index_.add(position++, event.node);
  apply(head_, events);
  events_.append(events);
}

/// Nobody walks back over an epoch, so unless a frame is near, one is left before it.
void Timeline::take_epoch(const Event& epoch) {
  if (size() - last_frame() >= frame_interval_ / kEpochShare) capture(nullptr);
  epochs_.push_back(size());
  head_.apply(epoch);
  events_.append({&epoch, 1});
}

void Timeline::capture(const std::shared_ptr<const Checkpoint>& checkpoint) {
  frames_.insert_or_assign(size(), KeyFrame{head_, checkpoint});
  if (checkpoint) last_checkpoint_ = size();
  while (frame_bytes() > frame_allowance() && tidy()) {
  }
  while (frame_bytes() > frame_allowance() && drop_frame()) {
  }
}

/// Chunks before the first frame at which the run can be taken up can be worked out again from its beginning only,
/// all of them together: they stay.
void Timeline::shrink(std::size_t keep) const {
  const auto first = std::find_if(frames_.begin(), frames_.end(),
                                  [](const auto& frame) { return frame.second.checkpoint != nullptr; });
  const std::size_t undroppable =
      source_ && first != frames_.end() ? events_.chunk_of(first->first) + 1 : events_.size();
  const std::size_t allowance = event_allowance();
  events_.shrink(allowance / kOpenShare, allowance, keep, undroppable);
}

bool Timeline::tidy() {
  if (untidy_.empty()) return false;
  untidy_.pop_back();
  return true;
}

void Timeline::retire() {
  dispose(std::exchange(events_, EventStore(limits_.chunk_events)));
  dispose(std::exchange(index_, {}));
  for (auto& [position, frame] : frames_) untidy_.push_back(std::move(frame.state));
  frames_.clear();
}

bool Timeline::owns_its_states() const {
  return head_.family_size() == 2 + frames_.size() + untidy_.size() + (lent_ ? 1 : 0);
}

/// Drops the frame that is missed least; false if there is none to drop. One at a time, since whoever appends must not
/// wait for long. The first one at which the run can be taken up behind others where it cannot is not dropped: what
/// comes after it would have to be worked out from much farther off.
bool Timeline::drop_frame() {
  const auto gap = [](auto frame) { return std::next(frame)->first - std::prev(frame)->first; };
  const auto ends_a_stretch = [](auto frame) {
    return frame->second.checkpoint && !std::prev(frame)->second.checkpoint;
  };
  auto least = frames_.end();
  for (auto frame = std::next(frames_.begin()); frame != frames_.end() && std::next(frame) != frames_.end();
       ++frame)
    if (!ends_a_stretch(frame) && (least == frames_.end() || gap(frame) < gap(least))) least = frame;
  if (least == frames_.end()) return false;
  // Where none leaves a smaller gap, those to come need not stand closer either.
  if (gap(least) >= 2 * frame_interval_) frame_interval_ *= 2;
  frames_.erase(least);
  return true;
}

std::size_t Timeline::frame_bytes() const {
  std::size_t bytes = head_.family_bytes() - std::min(head_.family_bytes(), head_.page_bytes());
  return bytes + frames_.size() * head_.table_bytes();
}

std::size_t Timeline::frame_allowance() const {
  return std::min(limits_.bytes / kFrameShare, std::max(kLeastFrameBytes, kFrameBytesPerEvent * size()));
}

std::size_t Timeline::event_allowance() const {
  const std::size_t others = frame_bytes() + index_.bytes() + limits_.bytes / kWorkShare;
  return limits_.bytes - std::min(limits_.bytes, others);
}

Event Timeline::fetch(std::size_t index) const {
  const std::size_t chunk = events_.chunk_of(index), length = events_.chunk_events();
  if (events_.holds(chunk)) {
    events_.open(chunk);
    shrink(chunk);
    return *events_.find(index);
  }
  auto frame = std::prev(frames_.upper_bound(chunk * length));
  while (frame->first != 0 && !frame->second.checkpoint) --frame;
  // What lies between the frame and the chunk is worked out anyway: as much as there is room for is kept.
  const std::size_t room =
      std::max<std::size_t>(1, event_allowance() / kOpenShare / (length * sizeof(Event)) / 2);
  std::size_t first = (frame->first + length - 1) / length;
  if (chunk - first >= room) first = chunk + 1 - room;
  const std::size_t end = std::min((chunk + 1) * length, size());
  const std::vector<Event> events = source_(frame->first, frame->second, first * length, end);
  for (std::size_t each = first; each <= chunk; ++each) {
    const std::span<const Event> rest = std::span(events).subspan((each - first) * length);
    if (!events_.holds(each)) events_.put_back(each, rest.first(std::min(length, rest.size())));
  }
  shrink(chunk);
  return *events_.find(index);
}

void Timeline::truncate(std::size_t size) {
  if (size >= this->size()) return;
  answers_ = {};
  const std::size_t back = std::min(cursor_, size);
  seek(size);
  untidy_.push_back(std::move(head_));
  head_ = state_;
  seek(back);
  for (auto frame = frames_.upper_bound(size); frame != frames_.end(); frame = frames_.erase(frame))
    untidy_.push_back(std::move(frame->second.state));
  last_checkpoint_ = std::min(last_checkpoint_, size);
  epochs_.erase(std::lower_bound(epochs_.begin(), epochs_.end(), size), epochs_.end());
  if (size % events_.chunk_events() != 0)
    static_cast<void>(event(size - 1));  // the last chunk has to lie open
  dispose(events_.truncate(size));
  index_.truncate(size / NodeIndex::kBlock);
  for (std::size_t i = size - size % NodeIndex::kBlock; i < size; ++i) index_.add(i, event(i).node);
}

bool Timeline::reversible(std::size_t to, std::size_t from) const {
  const auto epoch = std::lower_bound(epochs_.begin(), epochs_.end(), to);
  return epoch == epochs_.end() || *epoch >= from;
}

std::pair<std::size_t, const SearchState*> Timeline::nearest(std::size_t position) const {
  const auto before = std::prev(frames_.upper_bound(position));
  std::pair<std::size_t, const SearchState*> best{before->first, &before->second.state};
  const auto offer = [&](std::size_t at, const SearchState& state) {
    if (distance(at, position) < distance(best.first, position) && reversible(position, at))
      best = {at, &state};
  };
  offer(cursor_, state_);
  offer(size(), head_);
  if (const auto after = std::next(before); after != frames_.end()) offer(after->first, after->second.state);
  return best;
}

/// The events from `from` on that lie together, up to `to`. Valid until others are read.
std::span<const Event> Timeline::events(std::size_t from, std::size_t to) const {
  if (events_.find(from) == nullptr) static_cast<void>(fetch(from));
  const std::size_t end = (events_.chunk_of(from) + 1) * events_.chunk_events();
  return {events_.find(from), std::min(to, end) - from};
}

/// Takes the state over all of them; none of them is an epoch.
void Timeline::apply(SearchState& state, std::span<const Event> events) const {
  if (events.size() < kSortedEvents)
    for (const Event& event : events) state.apply(event);
  else
    state.apply(events, order_);
}

void Timeline::walk(SearchState& state, std::size_t from, std::size_t to) const {
  // Backwards it is the same events, and what they come to together does not depend on their order.
  auto epoch = std::lower_bound(epochs_.begin(), epochs_.end(), std::min(from, to));
  for (std::size_t at = std::min(from, to), end = std::max(from, to); at < end;) {
    if (epoch != epochs_.end() && *epoch == at) {
      state.apply(event(at++));
      ++epoch;
      continue;
    }
    const std::size_t until = epoch == epochs_.end() ? end : std::min(end, *epoch);
    const std::span<const Event> stretch = events(at, until);
    apply(state, stretch);
    at += stretch.size();
  }
}

void Timeline::seek(std::size_t position) {
  if (position == cursor_) return;
  const auto [from, state] = nearest(position);
  if (state != &state_) state_ = *state;
  walk(state_, from, position);
  cursor_ = position;
  if (position < size()) events_.use(events_.chunk_of(position));
}

SearchState Timeline::state_at(std::size_t position) const {
  const auto [from, state] = nearest(position);
  SearchState copy = *state;
  walk(copy, from, position);
  return copy;
}

Timeline::Answer& Timeline::last_answer(NodeId node, KindSet kinds) const {
  for (Answer& answer : answers_)
    if (answer.node == node && answer.kinds == kinds) return answer;
  Answer& answer = answers_[next_answer_++ % answers_.size()];
  answer = {node, kinds, 0, std::nullopt};
  return answer;
}

std::span<const Event> Timeline::peek(std::size_t from, std::size_t to) const {
  if (!events_.holds(events_.chunk_of(from))) static_cast<void>(fetch(from));
  return events_.peek(from, to);
}

/// The last event of [from, to) that is about the node and of one of the kinds.
std::optional<std::size_t> Timeline::last_in(std::size_t from, std::size_t to, NodeId node,
                                             KindSet kinds) const {
  while (to > from) {
    const std::size_t begin = std::max(from, (to - 1) / events_.stretch_events() * events_.stretch_events());
    const std::span<const Event> stretch = peek(begin, to);
    for (std::size_t i = stretch.size(); i-- > 0;)
      if (stretch[i].node == node && kinds.has(stretch[i].kind)) return begin + i;
    to = begin;
  }
  return std::nullopt;
}

/// The first one.
std::optional<std::size_t> Timeline::first_in(std::size_t from, std::size_t to, NodeId node,
                                              KindSet kinds) const {
  while (from < to) {
    const std::span<const Event> stretch = peek(from, to);
    for (std::size_t i = 0; i < stretch.size(); ++i)
      if (stretch[i].node == node && kinds.has(stretch[i].kind)) return from + i;
    from += stretch.size();
  }
  return std::nullopt;
}

// A view asks in every frame who wrote a value, while the log grows by millions of events.
std::optional<std::size_t> Timeline::last_of_node(NodeId node, KindSet kinds, std::size_t before) const {
  before = std::min(before, size());
  Answer& known = last_answer(node, kinds);
  if (before < known.before) known = {node, kinds, 0, std::nullopt};
  const auto latest = [&](std::size_t from) -> std::optional<std::size_t> {
    for (std::size_t end = before; end > from;) {
      const auto block = index_.last_block(node, (end - 1) / NodeIndex::kBlock + 1);
      if (!block) break;
      const std::size_t first = std::max(*block * NodeIndex::kBlock, from);
      if (const auto found = last_in(first, std::min(end, (*block + 1) * NodeIndex::kBlock), node, kinds))
        return found;
      end = first;
    }
    return std::nullopt;
  };
  if (const auto found = latest(known.before)) known.found = found;
  known.before = before;
  return known.found;
}

std::optional<std::size_t> Timeline::next_of_node(NodeId node, KindSet kinds, std::size_t from) const {
  while (from < size()) {
    const auto block = index_.next_block(node, from / NodeIndex::kBlock);
    if (!block) break;
    const std::size_t end = std::min((*block + 1) * NodeIndex::kBlock, size());
    if (const auto found = first_in(std::max(from, *block * NodeIndex::kBlock), end, node, kinds))
      return found;
    from = end;
  }
  return std::nullopt;
}

std::optional<std::size_t> Timeline::last_event(NodeId node, KindSet kinds, std::size_t before) const {
  const auto found = last_of_node(node, kinds, before);
  if (!kinds.meets(head_.forgotten())) return found;
  const auto after = std::lower_bound(epochs_.begin(), epochs_.end(), before);
  if (after == epochs_.begin()) return found;
  return std::max(found.value_or(0), *std::prev(after));
}

std::optional<std::size_t> Timeline::next_event(NodeId node, KindSet kinds, std::size_t from) const {
  const auto found = next_of_node(node, kinds, from);
  if (!kinds.meets(head_.forgotten())) return found;
  const auto epoch = std::lower_bound(epochs_.begin(), epochs_.end(), from);
  if (epoch == epochs_.end()) return found;
  return std::min(found.value_or(*epoch), *epoch);
}

bool Timeline::changes(std::size_t index, NodeId node, EventKind kind) const {
  const Event e = event(index);
  if (e.kind != EventKind::epoch) return e.delta != 0;
  if (!last_of_node(node, {kind}, index)) return false;
  return state_at(index).value(kind, node) != head_.initial_value(kind);
}

}  // namespace replan
