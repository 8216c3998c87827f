#include "core/debug/touch_order.hpp"

#include <algorithm>

#include "core/trace/expansions.hpp"

namespace replan {
namespace {

/// Events between two looks at the clock.
constexpr std::size_t kTouchSlice = 4096;

/// What the search itself writes for a point: the penalties are the map's.
KindSet kinds_of_points(const SearchValues& values) {
  KindSet kinds;
  const bool grows = values.grows();
  for (const Field& field : grows ? values.vertex_fields : values.fields)
    if (field.forgotten && field.table == (grows ? FieldTable::vertices : FieldTable::nodes))
      kinds.add(field.kind);
  return kinds;
}

/// Behind the last epoch before a position.
std::size_t search_begin(const Timeline& log, std::size_t position) {
  const auto epochs = log.epochs();
  const auto after = std::lower_bound(epochs.begin(), epochs.end(), position);
  return after == epochs.begin() ? 0 : *std::prev(after) + 1;
}

}  // namespace

void TouchOrder::start(const LogView& view, std::size_t begin) {
  begin_ = read_ = begin;
  shown_ = 0;
  expanded_ = 0;
  kinds_ = kinds_of_points(view.info.values);
  const std::size_t points = view.info.values.grows() ? kMostVertices : view.lattice.node_count();
  list_.clear();
  list_.reserve(points);  // what grew by doubling would be copied within a frame
  seen_.assign(points, false);
}

void TouchOrder::follow(const LogView& view, std::uint64_t log_id, std::size_t end,
                        const Deadline& deadline) {
  const std::size_t begin = search_begin(view.log, end);
  if (log_id != log_id_ || begin != begin_ || seen_.empty()) start(view, begin);
  log_id_ = log_id;
  while (read_ < end) {
    for (const Event& event : view.log.peek(read_, std::min(end, read_ + kTouchSlice))) take(event, read_++);
    if (deadline.passed()) break;
  }
  behind_ = read_ < end;
  const auto past = std::partition_point(list_.begin(), list_.end(),
                                         [end](const FirstTouch& touch) { return touch.event < end; });
  shown_ = static_cast<std::size_t>(past - list_.begin());
}

void TouchOrder::take(const Event& event, std::size_t index) {
  if (is_expansion(event)) ++expanded_;
  if (!kinds_.has(event.kind) || event.node >= seen_.size() || seen_[event.node]) return;
  seen_[event.node] = true;
  list_.push_back({event.node, expanded_, index});
}

}  // namespace replan
