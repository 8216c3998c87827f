// The open list against an ordered set under random use.
#include "core/plan/open_list.hpp"

#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::test::open_list_test {
namespace {

struct Slots {
  std::vector<std::uint32_t> slots;
  [[nodiscard]] std::size_t get(NodeId n) const { return slots[n]; }
  void set(NodeId n, std::uint32_t slot) { slots[n] = slot; }
};

using Reference = std::set<std::tuple<Key, NodeId>>;

Key random_key(Random& random) {
  // Few values, so that ties are common.
  return {Cost{static_cast<std::int64_t>(random.below(12))},
          Cost{static_cast<std::int64_t>(random.below(4))}};
}

/// An open list and a set that are always told the same.
class Twins {
 public:
  explicit Twins(NodeId nodes) : slots_{std::vector<std::uint32_t>(nodes)}, keys_(nodes) {}

  void push_or_update(NodeId node, const Key& key) {
    if (slots_.get(node) != 0) {
      reference_.erase({keys_[node], node});
      list_.update(slots_, key, node);
    } else {
      list_.push(slots_, key, node);
    }
    keys_[node] = key;
    reference_.insert({key, node});
  }
  void remove(NodeId node) {
    if (slots_.get(node) == 0) return;
    reference_.erase({keys_[node], node});
    list_.remove(slots_, node);
    EXPECT_EQ(slots_.get(node), 0u);
  }
  void pop() {
    if (reference_.empty()) return;
    reference_.erase(reference_.begin());
    list_.pop(slots_);
  }
  void clear() {
    reference_.clear();
    list_.clear(slots_);
  }
  void compare() const {
    ASSERT_EQ(list_.size(), reference_.size());
    ASSERT_EQ(list_.empty(), reference_.empty());
    if (!reference_.empty()) {
      ASSERT_EQ(list_.top().key, std::get<0>(*reference_.begin()));
      ASSERT_EQ(list_.top().node, std::get<1>(*reference_.begin()));
    }
  }
  /// Every slot points at its node's entry, with its key; no other slot is set.
  void compare_slots() const {
    std::size_t held = 0;
    for (NodeId n = 0; n < keys_.size(); ++n) {
      if (slots_.get(n) == 0) continue;
      ++held;
      const auto& entry = list_.entries()[slots_.get(n) - 1];
      ASSERT_EQ(entry.node, n);
      ASSERT_EQ(entry.key, keys_[n]);
      ASSERT_TRUE(reference_.contains({entry.key, n}));
    }
    ASSERT_EQ(held, list_.size());
  }
  [[nodiscard]] bool empty() const { return reference_.empty(); }

 private:
  OpenList<Key> list_;
  Slots slots_;
  std::vector<Key> keys_;
  Reference reference_;
};

TEST(OpenList, behavesLikeAnOrderedSetUnderRandomUse) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const NodeId nodes = 1 + random.below(80);
    Twins twins(nodes);
    for (int i = 0; i < 3000; ++i) {
      const std::uint32_t what = random.below(100);
      if (what < 55)
        twins.push_or_update(random.below(nodes), random_key(random));
      else if (what < 75)
        twins.remove(random.below(nodes));
      else if (what < 99)
        twins.pop();
      else if (random.chance(0.2))
        twins.clear();
      twins.compare();
      twins.compare_slots();
      ASSERT_FALSE(HasFatalFailure()) << "seed " << seed << ", operation " << i;
    }
  }
}

TEST(OpenList, equalKeysComeOutByIndexHoweverTheyWentIn) {
  Random random(9);
  for (int round = 0; round < 50; ++round) {
    Twins twins(200);
    for (int i = 0; i < 400; ++i) twins.push_or_update(random.below(200), {Cost{7}, Cost{i % 2}});
    while (!twins.empty()) {
      twins.pop();
      twins.compare();
      ASSERT_FALSE(HasFatalFailure());
    }
  }
}

TEST(OpenList, keysCompareLexicographically) {
  EXPECT_LT((Key{Cost{1}, Cost{9}}), (Key{Cost{2}, Cost{0}}));
  EXPECT_LT((Key{Cost{1}, Cost{0}}), (Key{Cost{1}, Cost{1}}));
  EXPECT_LT((Key{Cost{1}, Cost{0}}), (Key{}));
}

}  // namespace
}  // namespace replan::test::open_list_test
