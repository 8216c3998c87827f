#include "core/debug/cell_history.hpp"

#include <algorithm>

namespace replan {
namespace {

constexpr EventKind kMaps[] = {EventKind::known, EventKind::truth};

/// Calls `each` for the kinds among these that are values of nodes.
template <class Each>
void for_values(KindSet kinds, Each&& each) {
  for (std::size_t slot = 0; slot < kWideSlots; ++slot)
    if (kinds.has(wide_kind(slot))) each(wide_kind(slot));
  for (const EventKind map : kMaps)
    if (kinds.has(map)) each(map);
}

}  // namespace

/// Where the values of a kind are held.
std::size_t CellHistory::place(EventKind kind) {
  return is_wide(kind) ? wide_slot(kind) : kWideSlots + (kind == EventKind::truth ? 1 : 0);
}

void CellHistory::start(const Timeline& log) {
  older_.clear();
  newer_.clear();
  complete_ = false;
  begin_ = end_ = log.size();
  for_values(kinds_, [&](EventKind kind) { last_[place(kind)] = log.head().value(kind, node_); });
  first_ = last_;
}

void CellHistory::follow(const Timeline& log, std::uint64_t log_id, NodeId node, KindSet kinds,
                         std::size_t most) {
  KindSet values;
  for_values(kinds, [&](EventKind kind) { values.add(kind); });
  if (log_id != log_id_ || node != node_ || !(values == kinds_)) {
    log_id_ = log_id;
    node_ = node;
    kinds_ = values;
    start(log);
  }
  for (; most > 0 && end_ < log.size(); --most) {
    const auto next = log.next_event(node_, kinds_, end_);
    end_ = next ? *next + 1 : log.size();
    if (!next) break;
    const Event event = log.event(*next);
    if (event.kind == EventKind::epoch) {
      take_epoch(log, event, *next);
      continue;
    }
    std::uint64_t& value = last_[place(event.kind)];
    newer_.push_back({*next, event.kind, event.line, value, value ^ event.delta});
    value ^= event.delta;
  }
  for (; most > 0 && !complete_; --most) {
    const auto previous = log.last_event(node_, kinds_, begin_);
    complete_ = !previous;
    begin_ = previous.value_or(0);
    if (!previous) break;
    const Event event = log.event(*previous);
    if (event.kind == EventKind::epoch) {
      take_epoch_back(log, event, *previous);
      continue;
    }
    std::uint64_t& value = first_[place(event.kind)];
    older_.push_back({*previous, event.kind, event.line, value ^ event.delta, value});
    value ^= event.delta;
  }
}

/// Calls `each` for the kinds that are followed and that an epoch forgets.
template <class Each>
void CellHistory::for_forgotten(const Timeline& log, Each&& each) const {
  for_values(kinds_, [&](EventKind kind) {
    if (log.head().forgotten().has(kind)) each(kind);
  });
}

void CellHistory::take_epoch(const Timeline& log, const Event& epoch, std::size_t index) {
  for_forgotten(log, [&](EventKind kind) {
    std::uint64_t& value = last_[place(kind)];
    const std::uint64_t initial = log.head().initial_value(kind);
    if (value != initial) newer_.push_back({index, kind, epoch.line, value, initial});
    value = initial;
  });
}

/// What was forgotten is not in the log, but in the state before.
void CellHistory::take_epoch_back(const Timeline& log, const Event& epoch, std::size_t index) {
  const SearchState before = log.state_at(index);
  std::vector<ValueChange> changes;
  for_forgotten(log, [&](EventKind kind) {
    std::uint64_t& value = first_[place(kind)];
    const std::uint64_t was = before.value(kind, node_);
    if (was != value) changes.push_back({index, kind, epoch.line, was, value});
    value = was;
  });
  older_.insert(older_.end(), changes.rbegin(), changes.rend());
}

std::size_t CellHistory::after(std::size_t position) const {
  const auto is_behind = [position](const ValueChange& change) { return change.event >= position; };
  const auto in_newer = static_cast<std::size_t>(
      std::partition_point(newer_.rbegin(), newer_.rend(), is_behind) - newer_.rbegin());
  if (in_newer < newer_.size()) return in_newer;
  return in_newer + static_cast<std::size_t>(std::partition_point(older_.begin(), older_.end(), is_behind) -
                                             older_.begin());
}

}  // namespace replan
