#include "core/trace/search_state.hpp"

namespace replan {

SearchState::SearchState(std::size_t nodes, std::span<const Field> fields)
    : wide_pool_(std::make_shared<PagePool<std::uint64_t>>()),
      narrow_pool_(std::make_shared<PagePool<std::uint8_t>>()) {
  const auto make = [&](const Field& field) {
    const std::size_t size = field.table == FieldTable::nodes ? nodes : kMostVertices;
    wide_[wide_slot(field.kind)] = PagedArray<std::uint64_t>(size, field.initial, wide_pool_);
    longest_ = std::max(longest_, size);
  };
  for (const Field& field :
       {fields::kG, fields::kRhs, fields::kQueue, fields::kLp, fields::kRp, fields::kDist, fields::kVisit})
    make(field);
  for (const Field& field : fields) {
    if (!is_own_field(field.kind)) continue;
    make(field);
    ++wide_count_;
    if (field.forgotten) forgotten_.add(field.kind);
  }
  for (auto& field : narrow_) field = PagedArray<std::uint8_t>(nodes, 0, narrow_pool_);
}

SearchState::SearchState(SharedBytes known, SharedBytes truth, std::span<const Field> fields)
    : SearchState(known.size(), fields) {
  narrow_[0] = PagedArray<std::uint8_t>(std::move(known), narrow_pool_);
  narrow_[1] = PagedArray<std::uint8_t>(std::move(truth), narrow_pool_);
}

void SearchState::forget_search() {
  for (std::size_t slot = 0; slot < wide_count_; ++slot)
    if (forgotten_.has(wide_kind(slot)))
      wide_[slot] = PagedArray<std::uint64_t>(wide_[slot].size(), wide_[slot].initial(), wide_pool_);
  queued_ = 0;
}

void SearchState::apply(std::span<const Event> events, PageOrder& order) {
  for (const Event& event : events)
    if (!is_wide(event.kind)) apply(event);
  // So far ahead that what is asked for is there in time: some groups, and some pages, of the order.
  constexpr std::size_t kGroupsAhead = 64, kPagesAhead = 32;
  const std::span<const Event> sorted = order.sort(events, longest_);
  const auto field = [&](std::size_t i) -> auto& {
    return wide_[wide_slot(sorted[i].kind)];
  };
  for (std::size_t i = 0; i < sorted.size();) {
    if (i + kGroupsAhead < sorted.size()) field(i + kGroupsAhead).fetch_group(sorted[i + kGroupsAhead].node);
    if (i + kPagesAhead < sorted.size()) field(i + kPagesAhead).fetch_page(sorted[i + kPagesAhead].node);
    const std::uint64_t page = PageOrder::page_of(sorted[i]);
    std::uint64_t* values = field(i).own_page(sorted[i].node);
    for (; i < sorted.size() && PageOrder::page_of(sorted[i]) == page; ++i)
      write(values[sorted[i].node % kPage], sorted[i]);
  }
}

std::uint64_t SearchState::value(EventKind kind, NodeId node) const {
  if (is_wide(kind)) return wide(kind, node);
  const auto index = static_cast<std::size_t>(kind);
  if (index < kWideFields + kNarrowFields) return narrow_[index - kWideFields][node];
  return kind == EventKind::scalar ? scalars_[node] : 0;
}

bool SearchState::touched(EventKind kind, NodeId node) const {
  if (is_wide(kind)) return wide_[wide_slot(kind)].touched(node);
  const auto index = static_cast<std::size_t>(kind);
  return index < kWideFields + kNarrowFields && narrow_[index - kWideFields].touched(node);
}

std::size_t SearchState::page_bytes() const {
  std::size_t bytes = 0;
  for (const auto& field : declared()) bytes += field.page_bytes();
  for (const auto& field : narrow_) bytes += field.page_bytes();
  return bytes;
}

std::size_t SearchState::family_bytes() const {
  return wide_pool_ ? wide_pool_->bytes() + narrow_pool_->bytes() : 0;
}

std::size_t SearchState::table_bytes() const {
  std::size_t bytes = sizeof(*this);
  for (const auto& field : declared()) bytes += field.table_bytes();
  for (const auto& field : narrow_) bytes += field.table_bytes();
  return bytes;
}

}  // namespace replan
