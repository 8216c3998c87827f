#include "core/trace/search_state.hpp"

#include "core/base/hash.hpp"

namespace replan {

SearchState::SearchState(std::size_t nodes)
    : wide_pool_(std::make_shared<PagePool<std::uint64_t>>()),
      narrow_pool_(std::make_shared<PagePool<std::uint8_t>>()) {
  for (std::size_t kind = 0; kind < kWideFields; ++kind)
    wide_[kind] = untouched(static_cast<EventKind>(kind), nodes);
  for (auto& field : narrow_) field = PagedArray<std::uint8_t>(nodes, 0, narrow_pool_);
}

SearchState::SearchState(SharedBytes known, SharedBytes truth) : SearchState(known.size()) {
  narrow_[0] = PagedArray<std::uint8_t>(std::move(known), narrow_pool_);
  narrow_[1] = PagedArray<std::uint8_t>(std::move(truth), narrow_pool_);
}

PagedArray<std::uint64_t> SearchState::untouched(EventKind kind, std::size_t nodes) const {
  return PagedArray<std::uint64_t>(nodes, initial_value(kind), wide_pool_);
}

void SearchState::forget_search() {
  for (std::size_t kind = 0; kind < kWideFields; ++kind)
    if (const auto which = static_cast<EventKind>(kind); kForgotten.has(which))
      wide_[kind] = untouched(which, node_count());
  queued_ = 0;
}

void SearchState::apply(std::span<const Event> events, PageOrder& order) {
  for (const Event& event : events)
    if (static_cast<int>(event.kind) >= kWideFields) apply(event);
  // So far ahead that what is asked for is there in time: some groups, and some pages, of the order.
  constexpr std::size_t kGroupsAhead = 64, kPagesAhead = 32;
  const std::span<const Event> sorted = order.sort(events, node_count());
  const auto field = [&](std::size_t i) -> auto& {
    return wide_[static_cast<std::size_t>(sorted[i].kind)];
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
  const auto index = static_cast<std::size_t>(kind);
  if (index < kWideFields) return wide_[index][node];
  if (index < kWideFields + kNarrowFields) return narrow_[index - kWideFields][node];
  return kind == EventKind::scalar ? scalars_[node] : 0;
}

bool SearchState::touched(EventKind kind, NodeId node) const {
  const auto index = static_cast<std::size_t>(kind);
  if (index < kWideFields) return wide_[index].touched(node);
  return index < kWideFields + kNarrowFields && narrow_[index - kWideFields].touched(node);
}

namespace {

template <class T>
std::uint64_t hash_field(std::uint64_t seed, const PagedArray<T>& field) {
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field.page(i) == nullptr) {
      i += PagedArray<T>::kPage - 1 - i % PagedArray<T>::kPage;
    } else if (field[i] != field.initial()) {
      seed = hash_combine(hash_combine(seed, i), field[i]);
    }
  }
  return seed;
}

}  // namespace

std::uint64_t SearchState::hash() const {
  std::uint64_t seed = node_count();
  for (const auto& field : wide_) seed = hash_combine(hash_field(seed, field), 1);
  for (const auto& field : narrow_) seed = hash_combine(hash_field(seed, field), 2);
  for (const std::uint64_t value : scalars_) seed = hash_combine(seed, value);
  return seed;
}

std::size_t SearchState::page_bytes() const {
  std::size_t bytes = 0;
  for (const auto& field : wide_) bytes += field.page_bytes();
  for (const auto& field : narrow_) bytes += field.page_bytes();
  return bytes;
}

std::size_t SearchState::family_bytes() const {
  return wide_pool_ ? wide_pool_->bytes() + narrow_pool_->bytes() : 0;
}

std::size_t SearchState::table_bytes() const {
  std::size_t bytes = sizeof(*this);
  for (const auto& field : wide_) bytes += field.table_bytes();
  for (const auto& field : narrow_) bytes += field.table_bytes();
  return bytes;
}

}  // namespace replan
