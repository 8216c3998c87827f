// The house's own elementary functions against the C library's in long double.
#include "core/base/trigonometry.hpp"

#include <bit>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/base/hash.hpp"
#include "core/base/random.hpp"

namespace replan::test::trigonometry_test {
namespace {

/// How far `value` is from what is right, in units of the last place of that.
double error_of(double value, long double right) {
  const auto rounded = static_cast<double>(std::abs(right));
  const long double unit = rounded - std::nextafter(rounded, 0.0);
  return static_cast<double>(std::abs(value - right) / unit);
}

void expect_within(const char* name, double worst, double bound) {
  std::printf("%s: largest error %.3f units in the last place\n", name, worst);
  EXPECT_LE(worst, bound) << name;
  EXPECT_GT(worst, 0.4) << name;  // rounding alone comes to half a unit
}

constexpr int kDraws = 1'000'000;
constexpr double kRange = 64 * kPi;

TEST(Trigonometry, SineAndCosineAreWithinTheirErrorOfLongDouble) {
  Random random(7);
  double worst_sine = 0, worst_cosine = 0;
  const auto take = [&](double angle) {
    const auto [sine, cosine] = sine_cosine(angle);
    const long double exact = angle;
    worst_sine = std::max(worst_sine, error_of(sine, std::sin(exact)));
    worst_cosine = std::max(worst_cosine, error_of(cosine, std::cos(exact)));
  };
  for (int i = 0; i < kDraws; ++i) take((2 * random.unit() - 1) * kRange);
  for (int i = 0; i < kDraws / 4; ++i) take(std::ldexp(2 * random.unit() - 1, random.between(-40, 2)));
  for (int quarter = -128; quarter <= 128; ++quarter) {  // where one of them all but vanishes
    const double zero = quarter * (kPi / 2);
    for (const double angle : {zero, std::nextafter(zero, 300), zero + 1e-9, zero - 1e-5}) {
      const auto [sine, cosine] = sine_cosine(angle);
      EXPECT_NEAR(sine, std::sin(angle), 1e-15);
      EXPECT_NEAR(cosine, std::cos(angle), 1e-15);
    }
  }
  expect_within("sine", worst_sine, 1);
  expect_within("cosine", worst_cosine, 1);
}

TEST(Trigonometry, TheArcTangentIsWithinItsErrorOfLongDouble) {
  Random random(8);
  double worst = 0;
  const auto take = [&](double y, double x) {
    worst = std::max(worst, error_of(arc_tangent(y, x), std::atan2(static_cast<long double>(y), x)));
  };
  for (int i = 0; i < kDraws; ++i) {
    const double y = 2 * random.unit() - 1, x = 2 * random.unit() - 1;
    take(y, x);
    take(std::ldexp(y, random.between(-30, 10)), x);
  }
  for (int k = 1; k <= 16; ++k)  // about the places of the table
    for (int i = -100; i <= 100; ++i) {
      take(k / 16.0 + i * 1e-5, 1);
      take(-3, k / 16.0 * 3 + i * 1e-12);
    }
  expect_within("arc tangent", worst, 1.25);
}

TEST(Trigonometry, TheExponentialIsWithinItsErrorOfLongDouble) {
  Random random(9);
  double worst = 0;
  const auto take = [&](double x) {
    worst = std::max(worst, error_of(exponential(x), std::exp(static_cast<long double>(x))));
  };
  for (int i = 0; i < kDraws; ++i) take((2 * random.unit() - 1) * 700);
  for (int i = 0; i < kDraws / 4; ++i) take(std::ldexp(2 * random.unit() - 1, random.between(-20, 4)));
  expect_within("exponential", worst, 1);
}

TEST(Trigonometry, IsExactWhereItCanBe) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(arc_tangent(0, 0), 0);
  EXPECT_EQ(arc_tangent(0, 2), 0);
  EXPECT_EQ(arc_tangent(0, -2), kPi);
  EXPECT_EQ(arc_tangent(2, 0), kPi / 2);
  EXPECT_EQ(arc_tangent(-2, 0), -kPi / 2);
  EXPECT_EQ(arc_tangent(3, 3), kPi / 4);
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(-1000), 0);
  EXPECT_EQ(wrapped_angle(kPi), kPi);
  EXPECT_EQ(wrapped_angle(1), 1);
  EXPECT_NEAR(wrapped_angle(1 + 2 * kPi), 1, 1e-15);
  EXPECT_NEAR(wrapped_angle(-1 - 20 * kPi), -1, 1e-14);
}

/// The same bits from every compiler, at every level of optimisation.
TEST(Trigonometry, GivesTheSameBitsEverywhere) {
  Random random(10);
  std::uint64_t hash = 0;
  const auto take = [&hash](double value) { hash = hash_combine(hash, std::bit_cast<std::uint64_t>(value)); };
  for (int i = 0; i < 100'000; ++i) {
    const double angle = (2 * random.unit() - 1) * kRange, other = 2 * random.unit() - 1;
    const auto [sine, cosine] = sine_cosine(angle);
    take(sine);
    take(cosine);
    take(arc_tangent(other, sine));
    take(exponential(angle));
    take(wrapped_angle(angle));
  }
  EXPECT_EQ(hash, 0x9d36694b4fb3a3d7u);
}

}  // namespace
}  // namespace replan::test::trigonometry_test
