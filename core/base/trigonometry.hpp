// Sine, cosine, arc tangent and exponential from + - * / alone: the C library's differ between machines in their last
// bits, and what a robot decides by must not. Errors are in units in the last place of what is right and are held by
// tests/planner/trigonometry_test.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/bit_cast.hpp"

namespace replan {

inline constexpr double kPi = 3.141592653589793;

/// The sine and the cosine of one angle.
struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

namespace trigonometry {

/// A number as the sum of a double and what that is short of it.
struct Split {
  double high = 0;
  double low = 0;
};

constexpr Split kHalfPi{1.5707963267948966, 6.1257422745431001e-17};

/// arctan(k / 16).
inline constexpr std::array<Split, 17> kArcTangents{{
    {0, 0},
    {0.06241880999595735, -1.548376227580861e-18},
    {0.12435499454676144, -3.1238575094738597e-18},
    {0.18534794999569476, 4.1741783640691921e-18},
    {0.24497866312686414, 1.0692943926138287e-17},
    {0.30288486837497142, -1.100465205072787e-17},
    {0.35877067027057225, -2.4611389315420951e-17},
    {0.41241044159738732, -1.588356182691264e-17},
    {0.46364760900080609, 2.268693045925918e-17},
    {0.51238946031073773, -2.5478751053409354e-17},
    {0.55859931534356244, -5.4752209710517974e-18},
    {0.60228734613496415, 2.9490299091605721e-17},
    {0.64350110879328437, 1.5829351718288365e-17},
    {0.68231655487474807, 6.9388939039072284e-18},
    {0.71882999962162453, -2.1467203015212988e-17},
    {0.75315128096219441, -2.4286128663675299e-17},
    {0.78539816339744828, 3.06287113727155e-17},
}};

/// a + b exactly, for |a| >= |b| or a = 0.
constexpr Split exact_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// The whole number nearest to x.
constexpr std::int64_t nearest_whole(double x) {
  return static_cast<std::int64_t>(x < 0 ? x - 0.5 : x + 0.5);
}

/// x less n times half of pi. The first two parts of half of pi have 33 bits, so that n times each is exact
/// (Cody & Waite 1980).
constexpr Split less_quarters(double x, double n) {
  constexpr double kFirst = 0x1.921fb544p+0, kSecond = 0x1.0b4611a6p-34, kThird = 0x1.3198a2e037p-69;
  const double rest = x - n * kFirst, second = n * kSecond;
  const double high = rest - second;
  return exact_sum(high, ((rest - high) - second) - n * kThird);
}

/// sin x - x and cos x - 1 + x^2 / 2 for |x| <= pi / 4, by their series; what is left out is below 2^-60 of the value.
constexpr double sine_rest(double x) {
  constexpr std::array kTerms = {
      1 / 355687428096000.0, -1 / 1307674368000.0, 1 / 6227020800.0, -1 / 39916800.0,
      1 / 362880.0,          -1 / 5040.0,          1 / 120.0,        -1 / 6.0};
  const double square = x * x;
  double sum = 0;
  for (const double term : kTerms) sum = sum * square + term;
  return x * square * sum;
}
constexpr double cosine_rest(double x) {
  constexpr std::array kTerms = {1 / 20922789888000.0, -1 / 87178291200.0, 1 / 479001600.0, -1 / 3628800.0,
                                 1 / 40320.0,          -1 / 720.0,         1 / 24.0};
  const double square = x * x;
  double sum = 0;
  for (const double term : kTerms) sum = sum * square + term;
  return square * square * sum;
}

}  // namespace trigonometry

/// Sine and cosine of an angle in radians, |angle| <= 1000: each within 1 unit in its last place.
constexpr SineCosine sine_cosine(double angle) {
  using namespace trigonometry;
  const std::int64_t quarters = nearest_whole(angle * (2 / kPi));
  const auto [x, low] = less_quarters(angle, static_cast<double>(quarters));
  const double half_square = x * x / 2, nearly = 1 - half_square;
  const double sine = x + (sine_rest(x) + low * nearly);
  const double cosine = nearly + (((1 - nearly) - half_square) + (cosine_rest(x) - x * low));
  switch (quarters & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}
constexpr double sine(double angle) {
  return sine_cosine(angle).sine;
}
constexpr double cosine(double angle) {
  return sine_cosine(angle).cosine;
}

/// The angle from the x axis to (x, y), in (-pi, pi], within 1.25 units in its last place; 0 for (0, 0). Both finite, and
/// neither so large or small that their products leave the range of numbers.
///
/// With t the smaller of |x| and |y| over the larger, and c the nearest sixteenth to it,
/// arctan t = arctan c + arctan((t - c) / (1 + t c)), the last of something below 1/31.
constexpr double arc_tangent(double y, double x) {
  using namespace trigonometry;
  const double width = x < 0 ? -x : x, height = y < 0 ? -y : y;
  const bool steep = height > width;
  const double large = steep ? height : width, small = steep ? width : height;
  if (large == 0) return 0;
  const std::int64_t k = nearest_whole(16 * (small / large));
  const double c = static_cast<double>(k) / 16;
  // Of `large` the upper half of its bits: so that c times either part is exact.
  const double upper = bit_cast<double>(bit_cast<std::uint64_t>(large) & ~std::uint64_t{0x7FFFFFF});
  const double rest = ((small - c * upper) - c * (large - upper)) / (large + c * small);
  const double square = rest * rest;
  double sum = 0;
  for (int n = 11; n >= 3; n -= 2) sum = (sum + (n % 4 == 1 ? 1.0 : -1.0) / n) * square;
  // Within the first eighth turn it is base + rest; the other seven are mirrored from there.
  const Split base = kArcTangents[static_cast<std::size_t>(k)];
  double sign = 1;
  Split from;
  const auto mirror = [&](double half_pis) {  // from half_pis * pi / 2, backwards
    from = {half_pis * kHalfPi.high - from.high, half_pis * kHalfPi.low - from.low};
    sign = -sign;
  };
  if (steep) mirror(1);
  if (x < 0) mirror(2);
  const Split turned = exact_sum(from.high, sign * base.high);
  const Split whole = exact_sum(turned.high, sign * rest);
  const double low = whole.low + (turned.low + (from.low + sign * (base.low + rest * sum)));
  const double angle = whole.high + low;
  return y < 0 ? -angle : angle;
}

/// The same angle in [-pi, pi].
constexpr double wrapped_angle(double angle) {
  if (angle >= -kPi && angle <= kPi) return angle;
  const std::int64_t turns = trigonometry::nearest_whole(angle / (2 * kPi));
  return trigonometry::less_quarters(angle, 4 * static_cast<double>(turns)).high;
}

/// e^x within 1 unit in its last place for -708 <= x <= 709; 0 below, infinite above.
///
/// x = k ln 2 + r with |r| <= 0.35, and e^r by its series; what is left out is below 2^-58.
constexpr double exponential(double x) {
  constexpr double kLn2High = 6.93147180369123816490e-01;  // 21 bits short, so that k times it is exact
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  if (x < -708) return 0;
  if (x > 709) return std::numeric_limits<double>::infinity();
  const std::int64_t k = trigonometry::nearest_whole(x / 0.69314718055994531);
  const double high = x - static_cast<double>(k) * kLn2High, low = static_cast<double>(k) * kLn2Low;
  const auto [r, lost] = trigonometry::exact_sum(high, -low);
  double sum = 0;
  for (int n = 13; n >= 3; --n) sum = (sum + 1) * r / n;
  const double square = r * r / 2;
  const double value = 1 + (r + (square + square * sum + lost));
  const auto exponent = static_cast<std::uint64_t>(k + 1022) << 52;
  return value * bit_cast<double>(exponent) * 2;
}

}  // namespace replan
