// Which leaps a change of the map concerns.
#include "core/planners/kept_leaps.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::kept_leaps_test {
namespace {

constexpr int kSide = 40;
using Place = KeptLeaps<2>::Place;

Place place(NodeId n) {
  return {static_cast<int>(n % kSide), static_cast<int>(n / kSide)};
}
NodeId random_node(Random& random) {
  return random.below(kSide * kSide);
}

std::vector<std::pair<NodeId, NodeId>> pairs(const std::vector<Leap>& leaps) {
  std::vector<std::pair<NodeId, NodeId>> result;
  for (const Leap& leap : leaps) result.emplace_back(leap.from, leap.to);
  return result;
}

bool in_box(const std::pair<NodeId, NodeId>& leap, const Place& cell) {
  const Place a = place(leap.first), b = place(leap.second);
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (cell[axis] < std::min(a[axis], b[axis]) || cell[axis] > std::max(a[axis], b[axis])) return false;
  return true;
}

TEST(KeptLeaps, GivesUpThoseWithAPlaceInTheirBoxByIndex) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    KeptLeaps<2> kept;
    std::vector<std::pair<NodeId, NodeId>> expected;
    for (int i = random.between(0, 150); i > 0; --i) {
      const Leap leap{random_node(random), random_node(random)};
      const auto begins_there = [&leap](const auto& other) { return other.first == leap.from; };
      if (std::erase_if(expected, begins_there) != 0) kept.remove(leap.from, place(leap.from));
      kept.add(leap, place(leap.from), place(leap.to));
      expected.emplace_back(leap.from, leap.to);
    }
    for (int round = 0; round < 4; ++round) {
      std::vector<Place> places;
      for (int i = random.between(0, 3); i > 0; --i) places.push_back(place(random_node(random)));
      std::vector<std::pair<NodeId, NodeId>> touched;
      std::erase_if(expected, [&](const auto& leap) {
        const bool hit =
            std::any_of(places.begin(), places.end(), [&leap](const Place& at) { return in_box(leap, at); });
        if (hit) touched.push_back(leap);
        return hit;
      });
      std::sort(touched.begin(), touched.end());
      ASSERT_EQ(kept.size(), expected.size() + touched.size()) << "seed " << seed;
      ASSERT_EQ(pairs(kept.take_touched(places)), touched) << "seed " << seed;
    }
  }
}

TEST(KeptLeaps, GivesUpThoseBesideAPathAndKeepsTheOthersWithTheirBoxes) {
  KeptLeaps<2> kept;
  std::vector<NodeId> path;
  for (NodeId n = 0; n < 100; ++n) {
    kept.add({n, n + 41}, place(n), place(n + 41));
    if (n % 2 == 0) path.push_back(n);
  }
  const auto others = pairs(kept.take_others(path));
  ASSERT_EQ(others.size(), 50u);
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_EQ(others[i].first, 2 * i + 1);
  const std::vector<Place> places = {place(41)};
  EXPECT_EQ(pairs(kept.take_touched(places)), (std::vector<std::pair<NodeId, NodeId>>{{0, 41}, {40, 81}}));
  EXPECT_TRUE(kept.take_touched(places).empty());
}

}  // namespace
}  // namespace replan::kept_leaps_test
