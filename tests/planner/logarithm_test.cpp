// The house's own logarithm against the C library's in long double.
#include "core/base/logarithm.hpp"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/base/random.hpp"

namespace replan::test::logarithm_test {
namespace {

/// The error at x, in units of the bound that the header states.
double error_at(double x) {
  const long double right = std::log(static_cast<long double>(x));
  const long double bound = std::ldexp(1.0L, -51) * (std::abs(right) + 1);
  return static_cast<double>(std::abs(static_cast<long double>(natural_log(x)) - right) / bound);
}

TEST(Logarithm, IsWithinItsErrorOfLongDouble) {
  Random random(5);
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const double x = std::ldexp(0.5 + random.unit() / 2, random.between(-200, 200));
    worst = std::max(worst, error_at(x));
  }
  for (std::int64_t cells = 1; cells <= 4096; ++cells)  // as a planner asks
    for (const std::int64_t obstacles : {std::int64_t{1}, cells / 3 + 1, cells})
      worst = std::max(worst, error_at(static_cast<double>(cells) / static_cast<double>(obstacles)));
  std::printf("largest error: %.3f of the bound\n", worst);
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 0);
}

TEST(Logarithm, IsExactWhereItCanBe) {
  EXPECT_EQ(natural_log(1), 0);
  EXPECT_LT(natural_log(0.999), 0);
  EXPECT_GT(natural_log(1.001), 0);
  double last = natural_log(0.5);
  for (double x = 0.5 + 1e-4; x < 3; x += 1e-4) {
    EXPECT_GT(natural_log(x), last) << x;
    last = natural_log(x);
  }
}

}  // namespace
}  // namespace replan::test::logarithm_test
