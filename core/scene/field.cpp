#include "core/scene/field.hpp"

#include <algorithm>

#include "core/scene/overlay.hpp"

namespace replan {

FieldReader FieldReader::of(Overlay field) {
  return overlay_kind(field).field.value_or(FieldReader{});
}

bool shows_settled_alone(const Run& run, Overlay field) {
  return field == Overlay::g && !run.info().values.lookahead();
}

std::optional<double> field_value(const Run& run, Overlay field, Cell cell) {
  if (!run.lattice().contains(cell)) return std::nullopt;
  const FieldReader reader = FieldReader::of(field);
  const SearchState& state = run.timeline().state();
  const NodeId node = run.lattice().node(cell);
  if (shows_settled_alone(run, field) && state.queued(node)) return std::nullopt;
  const std::int64_t value = reader.read(state.value(reader.kind, node));
  if (value == FieldReader::kNone || state.known_blocked(node)) return std::nullopt;
  return static_cast<double>(value) * reader.unit;
}

void RangeTracker::scan(const FieldReader& reader, const SearchState& state, std::size_t stretch) {
  Ends ends;
  const std::size_t end = std::min((stretch + 1) * kStretch, state.node_count());
  for (std::size_t first = stretch * kStretch; first < end; first += SearchState::kPage) {
    const std::uint64_t* words = state.page(reader.kind, static_cast<NodeId>(first));
    if (words == nullptr) continue;
    const std::size_t count = std::min(SearchState::kPage, end - first);
    for (std::size_t i = 0; i < count; ++i) {
      // Without a branch, which it would often take wrongly: this goes over millions of cells in one frame.
      const std::int64_t value = reader.read(words[i]);
      ends.low = std::min(ends.low, value == FieldReader::kNone ? ends.low : value);
      ends.high = std::max(ends.high, value);  // kNone is less than all
    }
  }
  stretches_[stretch] = ends;
}

std::optional<FieldRange> RangeTracker::follow(const FieldReader& reader, const Timeline& log,
                                               std::uint64_t log_id, const SearchState& state,
                                               std::size_t position) {
  const std::size_t count = (state.node_count() + kStretch - 1) / kStretch;
  const std::size_t from = std::min(position_, position), to = std::max(position_, position);
  // Beyond that many events it is cheaper to look at everything than to find the written ones: an event, which may
  // have to be unpacked, takes some thirty times as long as a cell.
  const bool afresh = log_id != log_id_ || stretches_.size() != count ||
                      to - from > state.node_count() / 32 || !log.reversible(from, to);
  if (afresh) {
    stretches_.assign(count, {});
    for (std::size_t stretch = 0; stretch < count; ++stretch) scan(reader, state, stretch);
  } else {
    std::vector<bool> written(count);
    for (std::size_t at = from; at < to;) {
      const std::span<const Event> events = log.peek(at, to);
      for (const Event& event : events)
        if (event.kind == reader.kind) written[event.node / kStretch] = true;
      at += events.size();
    }
    for (std::size_t stretch = 0; stretch < count; ++stretch)
      if (written[stretch]) scan(reader, state, stretch);
  }
  log_id_ = log_id;
  position_ = position;
  Ends all;
  for (const Ends& ends : stretches_) {
    all.low = std::min(all.low, ends.low);
    all.high = std::max(all.high, ends.high);
  }
  if (all.high == FieldReader::kNone) return std::nullopt;
  return FieldRange{static_cast<double>(all.low) * reader.unit, static_cast<double>(all.high) * reader.unit};
}

std::optional<FieldRange> FieldRanges::at_cursor(const Run& run, Overlay field, FieldSpan span) {
  const Timeline& log = run.timeline();
  const FieldReader reader = FieldReader::of(field);
  Pair& pair = trackers_[field];
  const auto here = pair.cursor.follow(reader, log, run.log_id(), log.state(), log.cursor());
  const bool at_end = log.cursor() == log.size();  // both are the same state
  if (span == FieldSpan::so_far || at_end) return here;
  const auto there = pair.head.follow(reader, log, run.log_id(), log.head(), log.size());
  if (!here || !there) return here;
  return FieldRange{std::min(here->low, there->low), std::max(here->high, there->high)};
}

}  // namespace replan
