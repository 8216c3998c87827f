// Path costs as 64-bit fixed-point integers.
//
// Floating point is a trap in incremental search: D* Lite compares sums that are equal on paper and
// differ in the last bit, stops early and keeps a stale path. Integers make every such comparison exact.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>

namespace replan {

/// A path cost in fixed point: `raw` units of 2^-30 cells. Sums saturate at infinity.
///
/// Range: the longest loop-free path of the largest world (2^26 cells, each step at most sqrt 3 plus the
/// largest clearance penalty, 20) stays below infinity (2^31 cells), and two infinities add without overflow.
/// A box of 2^27 voxels has longer ones, but a path of fewest steps takes no short cuts between its cells,
/// and so passes at most five of the eight in any cube of two: the cheapest cannot cost more than that one.
struct Cost {
  std::int64_t raw = 0;

  static constexpr std::int64_t kScale = std::int64_t{1} << 30;
  static constexpr std::int64_t kInfinityRaw = std::int64_t{1} << 61;

  static constexpr Cost zero() { return {0}; }
  static constexpr Cost infinity() { return {kInfinityRaw}; }
  static constexpr Cost cells(std::int64_t n) { return {n * kScale}; }

  [[nodiscard]] constexpr bool is_infinite() const { return raw >= kInfinityRaw; }
  /// In cells, for showing; infinity becomes the double infinity.
  [[nodiscard]] double to_double() const {
    return is_infinite() ? HUGE_VAL : static_cast<double>(raw) / static_cast<double>(kScale);
  }

  friend constexpr auto operator<=>(const Cost&, const Cost&) = default;
  friend constexpr Cost operator+(Cost a, Cost b) {
    const std::int64_t sum = a.raw + b.raw;
    return {sum < kInfinityRaw ? sum : kInfinityRaw};
  }
};

/// floor(2^30 * sqrt(squared)), exactly: the length of a straight segment, rounded down.
/// `squared` is a squared length in cells, below 2^50.
inline Cost euclidean_floor(std::int64_t squared) {
  __extension__ using Wide = unsigned __int128;
  auto root =
      static_cast<std::uint64_t>(std::sqrt(static_cast<double>(squared)) * static_cast<double>(Cost::kScale));
  const Wide target = static_cast<Wide>(squared) << 60;
  // The double square root is correctly rounded; it can be one unit above the floor, never below it by more.
  while (static_cast<Wide>(root) * root > target) --root;
  while (static_cast<Wide>(root + 1) * (root + 1) <= target) ++root;
  return {static_cast<std::int64_t>(root)};
}

/// ceil(2^30 * sqrt(squared)).
inline Cost euclidean_ceil(std::int64_t squared) {
  __extension__ using Wide = unsigned __int128;
  const Cost down = euclidean_floor(squared);
  const auto root = static_cast<Wide>(down.raw);
  return {down.raw + (root * root == static_cast<Wide>(squared) << 60 ? 0 : 1)};
}

/// How a cost stands to the length of a straight segment, exactly and without a root. Neither is negative.
inline std::strong_ordering compare_to_segment(Cost cost, std::int64_t squared) {
  __extension__ using Wide = unsigned __int128;
  const auto side = static_cast<Wide>(cost.raw);
  return side * side <=> static_cast<Wide>(squared) << 60;
}

/// Costs of one step along 1, 2 or 3 axes: 1, sqrt 2, sqrt 3, rounded up. Rounding moves up and lower bounds
/// down keeps every heuristic of the lattices consistent (see lattice/lattice.hpp).
inline constexpr Cost kStepCost[4] = {{0}, {1073741824}, {1518500250}, {1859775394}};

}  // namespace replan
