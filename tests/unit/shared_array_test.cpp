// Arrays that copies share: what is written to one copy is seen in no other, and what stays takes no memory
// twice.
#include "core/base/shared_array.hpp"

#include <thread>

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::shared_array_test {
namespace {

using Array = SharedArray<int, 4>;

TEST(SharedArray, CopiesPartWhenOneIsWrittenTo) {
  const Array before{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  Array after = before;
  after[5] = 60;
  EXPECT_EQ(before.plain(), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(after.plain(), (std::vector<int>{1, 2, 3, 4, 5, 60, 7, 8, 9, 10}));
  EXPECT_NE(before, after);
  std::vector<std::size_t> unshared;
  Array::each_unshared(before, after, [&](std::size_t first, auto, auto) { unshared.push_back(first); });
  EXPECT_EQ(unshared, (std::vector<std::size_t>{4}));
  EXPECT_EQ(Array::common(before, after), 5u);
  after[5] = 6;
  EXPECT_EQ(before, after);
  EXPECT_EQ(Array::common(before, after), 10u);
}

TEST(SharedArray, WritesInPlaceWhereNobodyElseHoldsAChunk) {
  Array alone(8, 1);
  const int* place = &std::as_const(alone)[2];
  alone[2] = 5;
  EXPECT_NE(&std::as_const(alone)[2], place);  // eight equal values begin as one chunk
  place = &std::as_const(alone)[2];
  alone[3] = 6;
  EXPECT_EQ(&std::as_const(alone)[2], place);
  { const Array copy = alone; }
  alone[2] = 7;
  EXPECT_EQ(&std::as_const(alone)[2], place);
}

/// A version of the array and what it should hold.
struct Version {
  Array array;
  std::vector<int> plain;
};

TEST(SharedArray, IsAVectorWhateverItsCopiesDo) {
  Random random(1);
  std::vector<Version> versions(1);
  for (int round = 0; round < 20000; ++round) {
    Version& version = versions[random.below(static_cast<std::uint32_t>(versions.size()))];
    auto& [array, plain] = version;
    const auto size = static_cast<std::uint32_t>(plain.size());
    const int value = random.between(0, 9);
    switch (random.below(7)) {
      case 0:
      case 1:
        array.push_back(value);
        plain.push_back(value);
        break;
      case 2:
        if (size == 0) break;
        array[size - 1] = value;
        plain[size - 1] = value;
        break;
      case 3: {
        if (size == 0) break;
        const std::size_t at = random.below(size);
        array.edit(at) = plain[at] = value;
        break;
      }
      case 4: {
        const std::size_t kept = random.below(size + 1);
        if (!random.chance(0.1)) break;
        array.truncate(kept);
        plain.resize(kept);
        break;
      }
      case 5: {
        if (size == 0) break;
        const std::size_t at = random.below(size);
        array.erase(at);
        plain.erase(plain.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      }
      default: {
        const Version copy = version;
        if (versions.size() < 8)
          versions.push_back(copy);
        else
          versions[random.below(8)] = copy;
      }
    }
    for (const Version& each : versions) {
      ASSERT_EQ(each.array.size(), each.plain.size());
      ASSERT_TRUE(std::equal(each.array.begin(), each.array.end(), each.plain.begin(), each.plain.end()));
    }
  }
}

TEST(SharedArray, MayBeReadOnOneThreadWhileAnotherWritesACopy) {
  Array array(1000, 1);
  for (int round = 0; round < 50; ++round) {
    std::jthread reader([copy = array] {
      int sum = 0;
      for (const int value : copy) sum += value;
      EXPECT_GE(sum, 1000);
    });
    for (std::size_t i = 0; i < array.size(); i += 7) array[i] = round + 1;
  }
}

}  // namespace
}  // namespace replan::shared_array_test
