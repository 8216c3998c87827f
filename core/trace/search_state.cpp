#include "core/trace/search_state.hpp"

#include "core/base/hash.hpp"

namespace replan {

SearchState::SearchState(std::size_t nodes)
    : wide_pool_(std::make_shared<PagePool<std::uint64_t>>()),
      narrow_pool_(std::make_shared<PagePool<std::uint8_t>>()) {
  const auto infinite = static_cast<std::uint64_t>(Cost::kInfinityRaw);
  for (std::size_t kind = 0; kind < kWideFields; ++kind) {
    const auto which = static_cast<EventKind>(kind);
    const bool is_cost = which == EventKind::g || which == EventKind::rhs;
    wide_[kind] = PagedArray<std::uint64_t>(nodes, is_cost ? infinite : 0, wide_pool_);
  }
  for (auto& field : narrow_) field = PagedArray<std::uint8_t>(nodes, 0, narrow_pool_);
}

SearchState::SearchState(std::span<const std::uint8_t> known, std::span<const std::uint8_t> truth)
    : SearchState(known.size()) {
  for (std::size_t n = 0; n < known.size(); ++n) {
    if (known[n] != 0) narrow_[0].at(n) = 1;
    if (truth[n] != 0) narrow_[1].at(n) = truth[n];
  }
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

std::vector<std::uint8_t> SearchState::known_map() const {
  std::vector<std::uint8_t> map(node_count());
  for (std::size_t first = 0; first < map.size(); first += kPage) {
    const std::uint8_t* page = narrow_[0].page(first);
    if (page == nullptr) continue;
    const std::size_t count = std::min(kPage, map.size() - first);
    std::copy_n(page, count, map.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return map;
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
    if (!field.touched(i)) {
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
