// What can be said of samples: quantiles, tests of pairs, intervals by resampling. The same numbers everywhere: what is
// drawn comes from a seed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace replan {

/// The p-quantile (0..1) of values in ascending order, of which there is one at least: between two of them by straight
/// interpolation, as R and NumPy do it (Hyndman & Fan's definition 7).
double quantile(std::span<const double> sorted, double p);
/// The median of values in any order, of which there is one at least.
double median(std::vector<double> values);

/// Wilcoxon's signed-rank test of paired differences: do they lie about 0? F. Wilcoxon, "Individual comparisons by ranking
/// methods", Biometrics Bulletin 1(6), 1945, doi 10.2307/3001968.
struct SignedRanks {
  std::int64_t pairs = 0;  ///< whose difference is not 0: the others are left out, as Wilcoxon has it
  double positive = 0;     ///< sum of the ranks of differences above 0; of equal sizes each has the mean rank
  double negative = 0;     ///< of those below
  double p = 1;            ///< two-sided

  /// Matched-pairs rank-biserial correlation, -1 (all below 0) to 1 (all above): D. S. Kerby, "The simple difference
  /// formula", Comprehensive Psychology 3, 2014, doi 10.2466/11.IT.3.1.
  [[nodiscard]] double effect() const;
};
/// Up to that many pairs that differ p is exact, equal sizes included: of all ways to give the ranks signs, the part that
/// is as far out. Beyond, by the normal distribution, with the variance that equal sizes leave and a correction for
/// continuity.
inline constexpr std::int64_t kExactPairs = 50;
SignedRanks signed_ranks(std::span<const double> differences);

/// Two-sided p of the sign test, which for pairs of yes and no is McNemar's exact test: of `one + other` fair tosses, that
/// they fall at least that unevenly. Q. McNemar, Psychometrika 12, 1947, doi 10.1007/BF02295996.
double sign_test(std::int64_t one, std::int64_t other);

/// An interval.
struct Interval {
  double low = 0, high = 0;
};
/// The interval that holds the median with that confidence (0..1), by the percentiles of `resamples` medians of samples
/// drawn from the values with replacement. B. Efron, "Bootstrap methods: another look at the jackknife", 1979, doi
/// 10.1214/aos/1176344552. At least one value.
Interval bootstrap_median(std::span<const double> values, double confidence, std::uint64_t seed,
                          int resamples = 2000);

/// p-values as they are when that many tests are made at once, in the order given: S. Holm, "A simple sequentially
/// rejective multiple test procedure", Scandinavian Journal of Statistics 6, 1979.
std::vector<double> holm(std::span<const double> p);

}  // namespace replan
