// The events of a stretch of a log in the order of the pages that they write.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/trace/event.hpp"

namespace replan {

/// A search is now here, now there on its frontier, and so are its events: applied as the log has them,
/// nearly each of them waits for memory. In this order every page comes once, and it is known which comes
/// next. Keeps its memory: 32 bytes for each event of the longest stretch.
class PageOrder {
 public:
  /// The 64-bit values of two events are on the same page if these are equal.
  [[nodiscard]] static std::uint64_t page_of(const Event& event) {
    return static_cast<std::uint64_t>(event.kind) << 32 | event.node / kPage;
  }
  /// The events that change 64-bit values of a state with `nodes` nodes, those of one page together and in
  /// the order of the log. Valid until the next call.
  [[nodiscard]] std::span<const Event> sort(std::span<const Event> events, std::size_t nodes);

 private:
  static constexpr std::size_t kPage = 16;
  using Ends = std::vector<std::uint32_t>;

  void count(std::span<const Event> events);
  [[nodiscard]] std::size_t key(const Event& event) const {
    return wide_slot(event.kind) << page_bits_ | event.node / kPage;
  }

  int page_bits_ = 0, low_bits_ = 0;
  std::array<Ends, 2> ends_;  // by the low and the high bits of the key: where the next event goes
  std::array<std::vector<Event>, 2> sorted_;  // by the low bits, and by all
};

}  // namespace replan
