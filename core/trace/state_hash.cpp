#include "core/trace/state_hash.hpp"

#include <algorithm>

#include "core/base/hash.hpp"

namespace replan {

/// Whole pages of a field, and what ends it once all are read.
template <class T>
void StateHash::read(const PagedArray<T>& field, std::size_t count, std::uint64_t end_mark) {
  constexpr std::size_t kPage = PagedArray<T>::kPage;
  const std::size_t end = std::min(field.size(), node_ + std::max(count / kPage, std::size_t{1}) * kPage);
  for (; node_ < end; node_ += kPage) {
    node_ = field.skip_untouched(node_);
    if (node_ >= end) break;
    const T* page = field.page(node_);
    if (page == nullptr) continue;
    for (std::size_t i = 0; i < std::min(kPage, field.size() - node_); ++i)
      if (page[i] != field.initial()) hash_ = hash_combine(hash_combine(hash_, node_ + i), page[i]);
  }
  if (node_ < field.size()) return;
  hash_ = hash_combine(hash_, end_mark);
  node_ = 0;
  ++field_;
}

void StateHash::read_scalars() {
  for (const std::uint64_t value : state_.scalars_) hash_ = hash_combine(hash_, value);
  ++field_;
}

bool StateHash::advance(std::size_t values) {
  const std::size_t wide = state_.declared().size();
  if (field_ < wide)
    read(state_.declared()[field_], values, 1);
  else if (field_ < fields())
    read(state_.narrow_[field_ - wide], values, 2);
  else if (field_ == fields())
    read_scalars();
  return field_ > fields();
}

bool StateHash::advance(const Deadline& deadline) {
  constexpr std::size_t kBetweenLooks = std::size_t{1} << 16;
  bool done = advance(kBetweenLooks);
  while (!done && !deadline.passed()) done = advance(kBetweenLooks);
  return done;
}

double StateHash::share() const {
  const double nodes = static_cast<double>(std::max(state_.node_count(), std::size_t{1}));
  const double done = static_cast<double>(field_) + static_cast<double>(node_) / nodes;
  return std::min(1.0, done / static_cast<double>(fields() + 1));
}

std::uint64_t SearchState::hash() const {
  StateHash hash(*this);
  while (!hash.advance(node_count())) {
  }
  return hash.value();
}

}  // namespace replan
