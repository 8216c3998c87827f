#include "core/debug/cell_history.hpp"

#include <algorithm>

namespace replan {
namespace {

/// Values of nodes among the kinds.
KindSet node_values(KindSet kinds) {
  KindSet kept;
  for (int kind = 0; kind < kWideFields + kNarrowFields; ++kind)
    if (kinds.has(static_cast<EventKind>(kind))) kept.add(static_cast<EventKind>(kind));
  return kept;
}

}  // namespace

void CellHistory::start(const Timeline& log) {
  older_.clear();
  newer_.clear();
  complete_ = false;
  begin_ = end_ = log.size();
  for (int kind = 0; kind < kWideFields + kNarrowFields; ++kind)
    last_[static_cast<std::size_t>(kind)] = log.head().value(static_cast<EventKind>(kind), node_);
  first_ = last_;
}

void CellHistory::follow(const Timeline& log, std::uint64_t log_id, NodeId node, KindSet kinds,
                         std::size_t most) {
  kinds = node_values(kinds);
  if (log_id != log_id_ || node != node_ || !(kinds == kinds_)) {
    log_id_ = log_id;
    node_ = node;
    kinds_ = kinds;
    start(log);
  }
  for (; most > 0 && end_ < log.size(); --most) {
    const auto next = log.next_event(node_, kinds_, end_);
    end_ = next ? *next + 1 : log.size();
    if (!next) break;
    const Event event = log.event(*next);
    if (event.kind == EventKind::epoch) {
      take_epoch(event, *next);
      continue;
    }
    std::uint64_t& value = last_[static_cast<std::size_t>(event.kind)];
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
    std::uint64_t& value = first_[static_cast<std::size_t>(event.kind)];
    older_.push_back({*previous, event.kind, event.line, value ^ event.delta, value});
    value ^= event.delta;
  }
}

/// Calls `each` for the kinds that are followed and that an epoch forgets.
template <class Each>
void CellHistory::for_forgotten(Each&& each) const {
  for (int kind = 0; kind < kWideFields; ++kind)
    if (const auto which = static_cast<EventKind>(kind); kinds_.has(which) && kForgotten.has(which))
      each(which);
}

void CellHistory::take_epoch(const Event& epoch, std::size_t index) {
  for_forgotten([&](EventKind kind) {
    std::uint64_t& value = last_[static_cast<std::size_t>(kind)];
    const std::uint64_t initial = SearchState::initial_value(kind);
    if (value != initial) newer_.push_back({index, kind, epoch.line, value, initial});
    value = initial;
  });
}

/// What was forgotten is not in the log, but in the state before.
void CellHistory::take_epoch_back(const Timeline& log, const Event& epoch, std::size_t index) {
  const SearchState before = log.state_at(index);
  std::vector<ValueChange> changes;
  for_forgotten([&](EventKind kind) {
    std::uint64_t& value = first_[static_cast<std::size_t>(kind)];
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
