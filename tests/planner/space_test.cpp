// The continuous world that sampling planners draw from: samplers, the informed set, nearest places.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/space/place_index.hpp"
#include "core/space/sampler.hpp"

namespace replan::test::space_test {
namespace {

template <int D>
Place drawn_place(Random& random, const Place& extent) {
  Place place{0, 0, kPlaceUnits / 2};
  for (std::size_t i = 0; i < D; ++i) place[i] = random.below(static_cast<std::uint32_t>(extent[i]));
  return place;
}

/// Against looking at all of them, while places come and go.
template <int D>
void check_index(std::uint64_t seed) {
  Random random(seed);
  Place extent{kPlaceUnits, kPlaceUnits, kPlaceUnits};
  for (std::size_t i = 0; i < D; ++i) extent[i] = random.between(1, 40) * kPlaceUnits;
  PlaceIndex<D> index(extent);
  std::vector<Place> places;
  std::vector<bool> there;
  for (int turn = 0; turn < 400; ++turn) {
    if (random.chance(0.15) && !places.empty()) {
      const auto gone = random.below(static_cast<std::uint32_t>(places.size()));
      if (there[gone]) index.remove(places, gone);
      there[gone] = false;
    } else {
      const bool again = !places.empty() && random.chance(0.1);  // two at one place
      places.push_back(again ? places.back() : drawn_place<D>(random, extent));
      there.push_back(true);
      index.insert(places, static_cast<std::uint32_t>(places.size() - 1));
    }
    const Place at = drawn_place<D>(random, extent);
    const std::int64_t reach = random.between(0, 12) * kPlaceUnits / 4;
    std::uint32_t nearest = PlaceIndex<D>::kNone;
    std::vector<std::uint32_t> within, found;
    for (std::uint32_t n = 0; n < places.size(); ++n) {
      if (!there[n]) continue;
      const std::int64_t squared = squared_between(places[n], at);
      if (nearest == PlaceIndex<D>::kNone || squared < squared_between(places[nearest], at)) nearest = n;
      if (squared <= reach * reach) within.push_back(n);
    }
    ASSERT_EQ(index.nearest(places, at), nearest) << "seed " << seed << ", turn " << turn;
    index.each_within(places, at, reach, [&](std::uint32_t n) { found.push_back(n); });
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, within) << "seed " << seed << ", turn " << turn;
  }
}

TEST(PlaceIndex, FindsWhatBruteForceFindsIn2d) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) check_index<2>(seed);
}
TEST(PlaceIndex, FindsWhatBruteForceFindsIn3d) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) check_index<3>(seed);
}

/// Where a place lies in the set that is turned into the unit ball.
template <int D>
std::array<double, 3> in_ball(const InformedSet<D>& set, const Place& place) {
  std::array<double, 3> at{};
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      at[k] += (static_cast<double>(place[i]) + (i < D ? 0.5 : 0) - set.centre()[i]) * set.axis(k)[i] /
               (k == 0 ? set.along() : set.across());
  return at;
}

/// Pearson's statistic of counts that should be equal.
double chi_square(const std::vector<int>& counts, int total) {
  const double expected = static_cast<double>(total) / static_cast<double>(counts.size());
  double sum = 0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

/// Shells and sectors of equal size hold equally many samples; none lies outside.
template <int D>
void check_informed(const Place& start, const Place& goal, double times) {
  const InformedSet<D> set(start, goal,
                           {std::llround(times * static_cast<double>(length_between(start, goal).raw))});
  constexpr int kSamples = 40'000;
  constexpr std::size_t kShells = 10, kSectors = 8;
  std::vector<int> counts(kShells * kSectors);
  Random random(7);
  for (int n = 0; n < kSamples; ++n) {
    const Place place = set.draw(random);
    // The way over it is no longer than the best one, but for the rounding of a place.
    const double over = length_between(start, place).to_double() + length_between(place, goal).to_double();
    ASSERT_LE(over, times * length_between(start, goal).to_double() + 4.0 / kPlaceUnits);
    const auto at = in_ball(set, place);
    double squared = 0;
    for (const double part : at) squared += part * part;
    const double volume = std::pow(squared, D / 2.0);
    const auto shell = std::min(kShells - 1, static_cast<std::size_t>(volume * kShells));
    const double angle = std::atan2(at[1], at[0]) / (2 * 3.141592653589793) + 0.5;
    const auto sector = std::min(kSectors - 1, static_cast<std::size_t>(angle * kSectors));
    ++counts[shell * kSectors + sector];
  }
  // 79 degrees of freedom: more than 120 comes by chance once in 500 times, and the numbers are always the same.
  EXPECT_LT(chi_square(counts, kSamples), 120);
}

TEST(InformedSet, IsDrawnFromEvenlyAndNothingElseIs) {
  check_informed<2>({100'000, 200'000, 8192}, {900'000, 500'000, 8192}, 1.2);
  check_informed<2>({100'000, 200'000, 8192}, {100'000, 900'000, 8192}, 1.02);
  check_informed<3>({100'000, 200'000, 300'000}, {900'000, 500'000, 100'000}, 1.3);
  check_informed<3>({100'000, 200'000, 300'000}, {100'000, 200'000, 900'000}, 2);
}

TEST(InformedSet, OfAStraightPathIsALine) {
  const Place start{0, 0, 8192}, goal{163'840, 0, 8192};
  const InformedSet<2> set(start, goal, length_between(start, goal));
  Random random(1);
  for (int i = 0; i < 100; ++i) EXPECT_LE(std::abs(set.draw(random)[1]), 1);
}

/// Samples spread over all of the world, each rule in its own way; the n-th is the same whenever it is asked for.
TEST(Sampler, SpreadsItsSamplesEvenly) {
  const Grid2 lattice({64, 32});
  const FreeSpace<2> space(lattice);
  constexpr int kSamples = 32 * 32 * 8;
  for (const SampleRule rule : {SampleRule::uniform, SampleRule::halton, SampleRule::grid}) {
    const Sampler<2> sampler(space, rule, 5);
    std::vector<int> counts(16 * 16);
    for (int n = 1; n <= kSamples; ++n) {
      const Place place = sampler.anywhere(n);
      ASSERT_TRUE(space.contains(place));
      ASSERT_EQ(place[2], kPlaceUnits / 2);
      ASSERT_EQ(place, sampler.anywhere(n));
      ++counts[static_cast<std::size_t>(place[0] * 16 / space.extent(0) +
                                        16 * (place[1] * 16 / space.extent(1)))];
    }
    const double spread = chi_square(counts, kSamples);  // 255 degrees of freedom
    if (rule == SampleRule::uniform) {
      EXPECT_LT(spread, 340);
      EXPECT_GT(spread, 180);
    } else {
      EXPECT_LT(spread, 30) << "more evenly than by chance: rule " << static_cast<int>(rule);
    }
  }
}

TEST(Sampler, OfAnotherSeedDrawsOthers) {
  const Grid2 lattice({64, 32});
  const FreeSpace<2> space(lattice);
  for (const SampleRule rule : {SampleRule::uniform, SampleRule::halton, SampleRule::grid})
    EXPECT_NE(Sampler<2>(space, rule, 1).anywhere(10), Sampler<2>(space, rule, 2).anywhere(10));
}

TEST(Steer, GoesNoFartherThanAStep) {
  Random random(3);
  for (int i = 0; i < 10'000; ++i) {
    const Place extent{1 << 20, 1 << 20, 1 << 20};
    const Place from = drawn_place<3>(random, extent), to = drawn_place<3>(random, extent);
    const std::int64_t reach = random.between(1, 1 << 18);
    const Place place = steer(from, to, reach);
    ASSERT_LE(squared_between(from, place), reach * reach);
    if (squared_between(from, to) <= reach * reach) {
      ASSERT_EQ(place, to);
    } else {
      ASSERT_GE(std::sqrt(static_cast<double>(squared_between(from, place))), static_cast<double>(reach) - 2);
    }
  }
}

}  // namespace
}  // namespace replan::test::space_test
