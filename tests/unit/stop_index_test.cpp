#include "core/session/stop_index.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::stop_index_test {
namespace {

std::size_t next_of(const std::vector<bool>& bits, std::size_t from) {
  while (from < bits.size() && !bits[from]) ++from;
  return std::min(from, bits.size());
}

std::size_t previous_of(const std::vector<bool>& bits, std::size_t before) {
  for (std::size_t i = std::min(before, bits.size()); i-- > 0;)
    if (bits[i]) return i;
  return 0;
}

void expect_same(const BitRow& row, const std::vector<bool>& bits) {
  ASSERT_EQ(row.size(), bits.size());
  for (std::size_t i = 0; i < bits.size() + 3; ++i) {
    ASSERT_EQ(row.next(i), next_of(bits, i)) << "from " << i;
    ASSERT_EQ(row.previous(i), previous_of(bits, i)) << "before " << i;
  }
}

TEST(BitRow, FindsWhatALookAtEachBitFinds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const double share = random.unit() * random.unit();
    BitRow row;
    std::vector<bool> bits;
    for (int round = 0; round < 4; ++round) {
      for (std::uint32_t n = random.below(400); n > 0; --n) {
        bits.push_back(random.chance(share));
        row.add(bits.back());
      }
      expect_same(row, bits);
      const std::size_t size = random.below(static_cast<std::uint32_t>(bits.size()) + 1);
      bits.resize(size);
      row.truncate(size);
      expect_same(row, bits);
    }
  }
}

TEST(StopIndex, ALineBeginsWhereItsNumberChangesOrAnIterationBegins) {
  StopIndex stops;
  const auto add = [&stops](std::uint8_t line, bool begins) {
    stops.add(Event{.kind = EventKind::g, .line = line}, begins);
  };
  add(3, false);
  add(3, false);
  add(4, false);
  add(4, true);
  EXPECT_EQ(stops.lines().next(1), 2u);
  EXPECT_EQ(stops.lines().next(3), 3u);
  EXPECT_EQ(stops.iterations().next(0), 3u);
  stops.truncate(2, 3);
  add(3, false);
  add(5, false);
  EXPECT_EQ(stops.lines().next(1), 3u) << "the event before the cut was of line 3 too";
}

}  // namespace
}  // namespace replan::stop_index_test
