#include "core/trace/page_order.hpp"

#include <bit>
#include <numeric>

#include "core/trace/search_state.hpp"

namespace replan {

/// Sets the ends to where the first event of each key goes.
void PageOrder::count(std::span<const Event> events) {
  constexpr int kKindBits = 4;
  static_assert(kWideSlots <= 1 << kKindBits);
  ends_[0].assign((std::size_t{1} << low_bits_) + 1, 0);
  ends_[1].assign((std::size_t{1} << (kKindBits + page_bits_ - low_bits_)) + 1, 0);
  const std::size_t low = (std::size_t{1} << low_bits_) - 1;
  for (const Event& event : events) {
    if (!is_wide(event.kind)) continue;
    ++ends_[0][(key(event) & low) + 1];
    ++ends_[1][(key(event) >> low_bits_) + 1];
  }
  for (Ends& ends : ends_) std::partial_sum(ends.begin(), ends.end(), ends.begin());
}

std::span<const Event> PageOrder::sort(std::span<const Event> events, std::size_t nodes) {
  static_assert(kPage == SearchState::kPage);
  page_bits_ = static_cast<int>(std::bit_width(nodes / kPage));
  low_bits_ = page_bits_ / 2 + 1;
  count(events);
  const std::size_t wide = ends_[0].back();
  for (auto& sorted : sorted_)
    if (sorted.size() < wide) sorted.resize(events.size());
  const std::size_t low = (std::size_t{1} << low_bits_) - 1;
  for (const Event& event : events)
    if (is_wide(event.kind)) sorted_[0][ends_[0][key(event) & low]++] = event;
  for (const Event& event : std::span(sorted_[0]).first(wide))
    sorted_[1][ends_[1][key(event) >> low_bits_]++] = event;
  return std::span(sorted_[1]).first(wide);
}

}  // namespace replan
