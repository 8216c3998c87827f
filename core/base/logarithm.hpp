// The natural logarithm from + - * / alone: the C library's differs between machines in its last bits, and what a
// search decides by must not.
#pragma once

#include <cstdint>

#include "core/base/bit_cast.hpp"

namespace replan {

/// ln x for a normal x > 0, within 2^-51 of itself plus 2^-51 (tests/planner/logarithm_test.cpp).
///
/// x is 2^e m with m between the roots of 1/2 and 2, and ln m = 2 artanh s with s = (m - 1) / (m + 1). As |s| < 0.172
/// the series' terms behind s^23 are below 2^-60.
inline double natural_log(double x) {
  constexpr double kRootOfHalf = 0.70710678118654757;
  constexpr double kLn2High = 6.93147180369123816490e-01;  // 21 bits short, so that e times it is exact
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52) - 1;
  const auto bits = bit_cast<std::uint64_t>(x);
  auto exponent = static_cast<int>(bits >> 52) - 1022;
  double m = bit_cast<double>((bits & kFraction) | std::uint64_t{1022} << 52);  // 1/2 <= m < 1
  if (m < kRootOfHalf) {
    m *= 2;
    --exponent;
  }
  const double s = (m - 1) / (m + 1), square = s * s;
  double sum = 0;
  for (int n = 23; n >= 3; n -= 2) sum = (sum + 1.0 / n) * square;
  return exponent * kLn2High + (2 * s + (2 * s * sum + exponent * kLn2Low));
}

}  // namespace replan
