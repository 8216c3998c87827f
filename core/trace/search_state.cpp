#include "core/trace/search_state.hpp"

#include "core/base/hash.hpp"

namespace replan {

SearchState::SearchState(std::size_t nodes) : meter_(std::make_shared<std::atomic<std::size_t>>()) {
  const auto infinite = static_cast<std::uint64_t>(Cost::kInfinityRaw);
  for (std::size_t kind = 0; kind < kWideFields; ++kind) {
    const auto which = static_cast<EventKind>(kind);
    const bool is_cost = which == EventKind::g || which == EventKind::rhs;
    wide_[kind] = PagedArray<std::uint64_t>(nodes, is_cost ? infinite : 0, meter_);
  }
  for (auto& field : narrow_) field = PagedArray<std::uint8_t>(nodes, 0, meter_);
}

SearchState::SearchState(std::span<const std::uint8_t> known, std::span<const std::uint8_t> truth)
    : SearchState(known.size()) {
  for (std::size_t n = 0; n < known.size(); ++n) {
    if (known[n] != 0) narrow_[0].at(n) = 1;
    if (truth[n] != 0) narrow_[1].at(n) = truth[n];
  }
}

std::uint64_t SearchState::value(EventKind kind, NodeId node) const {
  const auto index = static_cast<std::size_t>(kind);
  if (index < kWideFields) return wide_[index][node];
  if (index < kWideFields + kNarrowFields) return narrow_[index - kWideFields][node];
  return kind == EventKind::scalar ? scalars_[node] : 0;
}

std::vector<std::uint8_t> SearchState::known_map() const {
  std::vector<std::uint8_t> known(node_count());
  for (NodeId n = 0; n < known.size(); ++n) known[n] = known_blocked(n) ? 1 : 0;
  return known;
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
  return meter_ ? meter_->load(std::memory_order_relaxed) : 0;
}

std::size_t SearchState::table_bytes() const {
  std::size_t bytes = sizeof(*this);
  for (const auto& field : wide_) bytes += field.table_bytes();
  for (const auto& field : narrow_) bytes += field.table_bytes();
  return bytes;
}

}  // namespace replan
