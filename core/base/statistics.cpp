#include "core/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/random.hpp"

namespace replan {
namespace {

/// The ranks of the sizes, twice over so that mean ranks are whole numbers, and the sum of t^3 - t over groups of equals.
struct DoubledRanks {
  std::vector<std::int64_t> of;  // by value
  double ties = 0;
};

DoubledRanks doubled_ranks(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return std::abs(values[a]) < std::abs(values[b]); });
  DoubledRanks ranks{std::vector<std::int64_t>(values.size()), 0};
  for (std::size_t from = 0, to = 0; from < order.size(); from = to) {
    while (to < order.size() && std::abs(values[order[to]]) == std::abs(values[order[from]])) ++to;
    for (std::size_t i = from; i < to; ++i) ranks.of[order[i]] = static_cast<std::int64_t>(from + to + 1);
    const auto equal = static_cast<double>(to - from);
    ranks.ties += equal * equal * equal - equal;
  }
  return ranks;
}

/// Of all ways to give the ranks signs, the part whose positive sum is at most `sum`.
double part_up_to(std::span<const std::int64_t> doubled, std::int64_t sum) {
  const std::int64_t all = std::accumulate(doubled.begin(), doubled.end(), std::int64_t{0});
  std::vector<double> part(static_cast<std::size_t>(all) + 1);
  part[0] = 1;
  for (const std::int64_t rank : doubled)
    for (auto i = static_cast<std::int64_t>(part.size()); i-- > 0;) {
      const double without = part[static_cast<std::size_t>(i)];
      const double with = i >= rank ? part[static_cast<std::size_t>(i - rank)] : 0;
      part[static_cast<std::size_t>(i)] = (without + with) / 2;
    }
  return std::accumulate(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(sum) + 1, 0.0);
}

double normal_p(double n, double positive, double ties) {
  const double mean = n * (n + 1) / 4, variance = n * (n + 1) * (2 * n + 1) / 24 - ties / 48;
  const double off = std::max(0.0, std::abs(positive - mean) - 0.5);
  return std::erfc(off / std::sqrt(2 * variance));
}

/// The median of values that may be reordered.
double median_in_place(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

}  // namespace

double quantile(std::span<const double> sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double part = place - static_cast<double>(below);
  return sorted[below] + part * (sorted[below + 1] - sorted[below]);
}

double median(std::vector<double> values) {
  return median_in_place(values);
}

double SignedRanks::effect() const {
  return pairs == 0 ? 0 : (positive - negative) / (positive + negative);
}

SignedRanks signed_ranks(std::span<const double> differences) {
  std::vector<double> values;
  for (const double each : differences)
    if (each != 0) values.push_back(each);
  const DoubledRanks ranks = doubled_ranks(values);
  std::int64_t positive = 0, negative = 0;
  for (std::size_t i = 0; i < values.size(); ++i) (values[i] > 0 ? positive : negative) += ranks.of[i];
  SignedRanks result;
  result.pairs = static_cast<std::int64_t>(values.size());
  result.positive = static_cast<double>(positive) / 2;
  result.negative = static_cast<double>(negative) / 2;
  if (result.pairs == 0) return result;
  result.p = result.pairs <= kExactPairs
                 ? std::min(1.0, 2 * part_up_to(ranks.of, std::min(positive, negative)))
                 : normal_p(static_cast<double>(result.pairs), result.positive, ranks.ties);
  return result;
}

double sign_test(std::int64_t one, std::int64_t other) {
  const std::int64_t tosses = one + other, fewer = std::min(one, other);
  double p = 0;
  for (std::int64_t k = 0; k <= fewer; ++k) {
    const auto n = static_cast<double>(tosses), each = static_cast<double>(k);
    p += std::exp(std::lgamma(n + 1) - std::lgamma(each + 1) - std::lgamma(n - each + 1) - n * std::log(2.0));
  }
  return std::min(1.0, 2 * p);
}

Interval bootstrap_median(std::span<const double> values, double confidence, std::uint64_t seed,
                          int resamples) {
  Random random(seed);
  const auto count = static_cast<std::uint32_t>(values.size());
  std::vector<double> medians, sample(values.size());
  for (int i = 0; i < resamples; ++i) {
    for (double& each : sample) each = values[random.below(count)];
    medians.push_back(median_in_place(sample));
  }
  std::sort(medians.begin(), medians.end());
  const double tail = (1 - confidence) / 2;
  return {quantile(medians, tail), quantile(medians, 1 - tail)};
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double least = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    least = std::max(least, std::min(1.0, static_cast<double>(p.size() - i) * p[order[i]]));
    adjusted[order[i]] = least;
  }
  return adjusted;
}

}  // namespace replan
