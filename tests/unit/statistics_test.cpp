// Tests of pairs, intervals and corrections: published values, and all there are counted out.
#include "core/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/base/running_median.hpp"

namespace replan::statistics_test {
namespace {

/// The two-sided p of the signed ranks, by all ways to give them signs.
double p_of_all_signs(const std::vector<double>& differences) {
  std::vector<double> sizes;
  double positive = 0;
  for (const double d : differences)
    if (d != 0) sizes.push_back(std::abs(d));
  const auto rank = [&](double size) {
    double below = 0, equal = 0;
    for (const double other : sizes) (other < size ? below : equal) += other > size ? 0 : 1;
    return below + (equal + 1) / 2;
  };
  std::vector<double> ranks;
  for (const double size : sizes) ranks.push_back(rank(size));
  for (const double d : differences)
    if (d > 0) positive += rank(d);
  const double all = std::accumulate(ranks.begin(), ranks.end(), 0.0);
  const double fewer = std::min(positive, all - positive);
  double count = 0;
  for (std::size_t signs = 0; signs < (std::size_t{1} << ranks.size()); ++signs) {
    double sum = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) sum += (signs >> i & 1) != 0 ? ranks[i] : 0;
    count += sum <= fewer ? 1 : 0;
  }
  return std::min(1.0, 2 * count / std::pow(2.0, static_cast<double>(ranks.size())));
}

TEST(SignedRanks, AreThoseOfTheDepressionScores) {
  // M. Hollander & D. A. Wolfe, "Nonparametric statistical methods", 1973, p. 29: V = 40, one-sided p = 0.01953.
  const std::vector<double> first = {1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30},
                            second = {0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  std::vector<double> differences;
  for (std::size_t i = 0; i < first.size(); ++i) differences.push_back(first[i] - second[i]);
  const SignedRanks ranks = signed_ranks(differences);
  EXPECT_EQ(ranks.positive, 40);
  EXPECT_EQ(ranks.negative, 5);
  EXPECT_NEAR(ranks.p, 2 * 0.01953125, 1e-12);
  EXPECT_NEAR(ranks.effect(), 35.0 / 45, 1e-12);
}

TEST(SignedRanks, ReachTheTableOfCriticalValues) {
  // Wilcoxon's table: of 6 pairs a sum of 0 is significant at 0.05 (2/64), of 5 none is (2/32).
  EXPECT_NEAR(signed_ranks(std::vector<double>{1, 2, 3, 4, 5, 6}).p, 2.0 / 64, 1e-15);
  EXPECT_NEAR(signed_ranks(std::vector<double>{-1, -2, -3, -4, -5}).p, 2.0 / 32, 1e-15);
  // Of 10 pairs 8 is the critical sum at 0.05 (two-sided): p(8) <= 0.05 < p(9).
  EXPECT_LE(signed_ranks(std::vector<double>{-8, 1, 2, 3, 4, 5, 6, 7, 9, 10}).p, 0.05);
  EXPECT_GT(signed_ranks(std::vector<double>{-9, 1, 2, 3, 4, 5, 6, 7, 8, 10}).p, 0.05);
}

TEST(SignedRanks, CountAllSignsWithEqualSizesToo) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> differences;
    const int count = random.between(0, 11);
    for (int i = 0; i < count; ++i) differences.push_back(random.between(-4, 5));
    EXPECT_NEAR(signed_ranks(differences).p, p_of_all_signs(differences), 1e-12) << trial;
  }
}

TEST(SignedRanks, OfManyPairsAreNearTheExactOnes) {
  Random random(3);
  std::vector<double> differences;
  for (int i = 0; i < kExactPairs; ++i) differences.push_back(random.between(-20, 26));
  std::erase(differences, 0.0);
  const double exact = signed_ranks(differences).p;
  while (differences.size() <= kExactPairs) differences.push_back(differences.size() % 2 == 0 ? 1e-6 : -1e-6);
  EXPECT_NEAR(signed_ranks(differences).p, exact, 0.03);
  EXPECT_EQ(signed_ranks(std::vector<double>(80, 0.0)).p, 1) << "no pair differs";
}

TEST(SignedRanks, OfManyPairsAreThoseOfR) {
  // R 4.2: wilcox.test(d, exact = FALSE, correct = TRUE), of sizes that all differ and of many that are equal.
  std::vector<double> sizes, ties;
  for (int i = 1; i <= 60; ++i) sizes.push_back(i % 3 == 0 ? -i : i);
  for (int i = 0; i < 8; ++i) ties.insert(ties.end(), {1, 1, 2, -3, 4, 5, -5, 6});
  EXPECT_NEAR(signed_ranks(sizes).p, 0.03622649, 1e-8);
  EXPECT_NEAR(signed_ranks(ties).p, 0.004431662, 1e-9);
}

TEST(SignTest, IsMcNemarsExactTest) {
  // SAS and statsmodels, exact test of 121 and 59 changes: 4.434e-06.
  EXPECT_NEAR(sign_test(121, 59), 4.434e-6, 1e-9);
  EXPECT_NEAR(sign_test(6, 1), 2 * 8.0 / 128, 1e-12);
  EXPECT_EQ(sign_test(0, 0), 1);
  EXPECT_EQ(sign_test(4, 4), 1);
  EXPECT_EQ(sign_test(2, 9), sign_test(9, 2));
}

TEST(Holm, CorrectsAsPublished) {
  const std::vector<double> corrected = holm(std::vector<double>{0.01, 0.04, 0.03, 0.005});
  const std::vector<double> wanted = {0.03, 0.06, 0.06, 0.02};
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(corrected[i], wanted[i], 1e-12) << i;
  EXPECT_EQ(holm(std::vector<double>{0.7, 0.9}), (std::vector<double>{1, 1}));
}

TEST(Quantile, IsThatOfRAndNumPy) {
  const std::vector<double> sorted = {1, 2, 4, 8};  // R: quantile(c(1, 2, 4, 8)) is 1 1.75 3 5 8
  EXPECT_EQ(quantile(sorted, 0), 1);
  EXPECT_EQ(quantile(sorted, 0.25), 1.75);
  EXPECT_EQ(quantile(sorted, 0.5), 3);
  EXPECT_EQ(quantile(sorted, 0.75), 5);
  EXPECT_EQ(quantile(sorted, 1), 8);
  EXPECT_EQ(median({8, 1, 4, 2}), 3);
  EXPECT_EQ(median({5}), 5);
}

TEST(RunningMedian, IsAtAnyMomentThatOfAllSoFar) {
  for (const std::uint32_t different : {3u, 1000u, 4'000'000'000u}) {
    Random random(different);
    RunningMedian running;
    std::vector<double> sorted;
    EXPECT_TRUE(running.empty());
    for (int i = 0; i < 600; ++i) {
      // Rising, falling, and in no order.
      const double value = i < 200 ? i / 7.0 : i < 400 ? -i / 3.0 : random.below(different) / 11.0;
      running.add(value);
      sorted.insert(std::upper_bound(sorted.begin(), sorted.end(), value), value);
      ASSERT_EQ(running.count(), sorted.size());
      ASSERT_EQ(running.median(), quantile(sorted, 0.5)) << "after " << i + 1;
    }
  }
}

TEST(BootstrapMedian, IsWhatAllResamplesSay) {
  // Of three values 27 samples can be drawn: the median is the least in 7, the greatest in 7.
  const std::vector<double> values = {1, 2, 3};
  const Interval most = bootstrap_median(values, 0.95, 1);
  EXPECT_EQ(most.low, 1);
  EXPECT_EQ(most.high, 3);
  const Interval half = bootstrap_median(values, 0.4, 1);  // 7/27 = 0.26 lie below the tail of 0.3 nearly
  EXPECT_EQ(half.low, 2);
  EXPECT_EQ(half.high, 2);
}

TEST(BootstrapMedian, RepeatsAndHoldsTheMedianAsOftenAsItSays) {
  int held = 0;
  constexpr int kSamples = 300;
  for (std::uint64_t seed = 0; seed < kSamples; ++seed) {
    Random random(seed);
    std::vector<double> values;
    for (int i = 0; i < 31; ++i) values.push_back(random.unit());
    const Interval interval = bootstrap_median(values, 0.95, seed, 400);
    held += interval.low <= 0.5 && interval.high >= 0.5 ? 1 : 0;
    if (seed == 0) {
      const Interval again = bootstrap_median(values, 0.95, seed, 400);
      EXPECT_EQ(interval.low, again.low);
      EXPECT_EQ(interval.high, again.high);
    }
  }
  EXPECT_GT(held, kSamples * 90 / 100);
  EXPECT_LT(held, kSamples * 99 / 100);
}

}  // namespace
}  // namespace replan::statistics_test
