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

RangeTracker::Ends RangeTracker::ends(const FieldReader& reader, const SearchState& state, std::size_t first,
                                      std::size_t end) {
  Ends ends;
  for (; first < end; first += SearchState::kPage) {
    const std::uint64_t* words = state.page(reader.kind, static_cast<NodeId>(first));
    if (words == nullptr) continue;
    const std::size_t count = std::min(SearchState::kPage, end - first);
    for (std::size_t i = 0; i < count; ++i) {
      // Without a branch, which it would often take wrongly: this goes over millions of cells.
      const std::int64_t value = reader.read(words[i]);
      ends.low = std::min(ends.low, value == FieldReader::kNone ? ends.low : value);
      ends.high = std::max(ends.high, value);  // kNone is less than all
    }
  }
  return ends;
}

std::optional<FieldRange> RangeTracker::follow(const FieldReader& reader, const Timeline& log,
                                               std::uint64_t log_id, const SearchState& state,
                                               std::size_t position, const Deadline& deadline) {
  if (stale_.follow({log, log_id, position, state.node_count()}, {reader.kind}))
    stretches_.assign(stale_.count(), {});
  stale_.refresh(deadline, [&](std::size_t stretch, std::size_t first, std::size_t end) {
    ++scanned_;
    stretches_[stretch] = ends(reader, state, first, end);
  });
  Ends all;
  for (const Ends& each : stretches_) {
    all.low = std::min(all.low, each.low);
    all.high = std::max(all.high, each.high);
  }
  if (all.high == FieldReader::kNone) return std::nullopt;
  return FieldRange{static_cast<double>(all.low) * reader.unit, static_cast<double>(all.high) * reader.unit};
}

std::optional<FieldRange> FieldRanges::at_cursor(const Run& run, Overlay field, FieldSpan span,
                                                 const Deadline& deadline) {
  const Timeline& log = run.timeline();
  const FieldReader reader = FieldReader::of(field);
  Pair& pair = trackers_[field];
  const auto here = pair.cursor.follow(reader, log, run.log_id(), log.state(), log.cursor(), deadline);
  behind_ = pair.cursor.behind();
  const bool at_end = log.cursor() == log.size();  // both are the same state
  if (span == FieldSpan::so_far || at_end) return here;
  const auto there = pair.head.follow(reader, log, run.log_id(), log.head(), log.size(), deadline);
  behind_ = behind_ || pair.head.behind();
  if (!here || !there) return here;
  return FieldRange{std::min(here->low, there->low), std::max(here->high, there->high)};
}

}  // namespace replan
