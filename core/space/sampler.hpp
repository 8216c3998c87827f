// Where the next sample of a sampling planner lies: drawn for each number of a sample anew, so that a search taken up
// in its middle goes on with the same ones.
//
//  uniform  drawn from all of the world
//  halton   Halton, "On the efficiency of certain quasi-random sequences of points in evaluating multi-dimensional
//           integrals", Numerische Mathematik 2, 1960, doi 10.1007/BF01386213, turned round by a seeded shift
//  grid     jittered: one from each box of a grid in seeded order, anywhere in it, round after round
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/random.hpp"
#include "core/space/free_space.hpp"
#include "core/space/informed_set.hpp"

namespace replan {

enum class SampleRule : std::uint8_t { uniform, halton, grid };

template <int D>
class Sampler {
 public:
  Sampler(const FreeSpace<D>& space, SampleRule rule, std::uint64_t seed)
      : space_(space), rule_(rule), seed_(seed) {}

  /// The numbers of the n-th sample, for what else it is decided by.
  [[nodiscard]] Random numbers(std::int64_t n) const {
    return Random(mix64(seed_ ^ mix64(static_cast<std::uint64_t>(n))));
  }
  /// The n-th sample in all of the world, n from 1 on.
  [[nodiscard]] Place anywhere(std::int64_t n) const {
    switch (rule_) {
      case SampleRule::halton:
        return halton(n);
      case SampleRule::grid:
        return jittered(n);
      case SampleRule::uniform:
        break;
    }
    Random random = numbers(n);
    return uniform(random);
  }
  /// The n-th one in an informed set, what of it lies in the world: uniform whatever the rule, since the set shrinks.
  [[nodiscard]] Place within(const InformedSet<D>& set, std::int64_t n) const {
    constexpr int kTries = 1000;  // a set around two places of the world has much of itself in it
    Random random = numbers(n);
    for (int i = 0; i < kTries; ++i)
      if (const Place place = set.draw(random); space_.contains(place)) return place;
    return uniform(random);
  }

 private:
  static constexpr std::array<std::uint32_t, 3> kPrimes = {2, 3, 5};
  /// Boxes of the grid along an axis: enough that a round of them is many samples, few enough that it ends.
  static constexpr std::uint32_t kBoxes = D == 2 ? 32 : 10;

  [[nodiscard]] Place middle() const {
    return {space_.extent(0) / 2, space_.extent(1) / 2, space_.extent(2) / 2};
  }
  [[nodiscard]] Place uniform(Random& random) const {
    Place place = middle();
    for (std::size_t i = 0; i < D; ++i) place[i] = part_of(i, random.next());
    return place;
  }
  /// That share of the world's extent along an axis, of 2^64.
  [[nodiscard]] std::int64_t part_of(std::size_t axis, std::uint64_t share) const {
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::int64_t>(Wide{share} * static_cast<std::uint64_t>(space_.extent(axis)) >> 64);
  }
  [[nodiscard]] Place halton(std::int64_t n) const {
    Random shift(seed_);
    Place place = middle();
    for (std::size_t i = 0; i < D; ++i)
      place[i] = part_of(i, radical_inverse(static_cast<std::uint64_t>(n), kPrimes[i]) + shift.next());
    return place;
  }
  /// The digits of n behind the point, of 2^64.
  static std::uint64_t radical_inverse(std::uint64_t n, std::uint32_t base) {
    __extension__ using Wide = unsigned __int128;
    std::uint64_t digits = 0, whole = 1;
    for (; n > 0 && whole < (std::uint64_t{1} << 58); n /= base, whole *= base)
      digits = digits * base + n % base;
    return static_cast<std::uint64_t>((Wide{digits} << 64) / whole);
  }
  [[nodiscard]] Place jittered(std::int64_t n) const {
    std::uint32_t boxes = 1;
    for (int i = 0; i < D; ++i) boxes *= kBoxes;
    const auto number = static_cast<std::uint64_t>(n - 1);
    std::uint32_t box = shuffled(static_cast<std::uint32_t>(number % boxes), boxes, number / boxes);
    Random random = numbers(n);
    Place place = middle();
    for (std::size_t i = 0; i < D; ++i, box /= kBoxes) {
      const std::int64_t low = space_.extent(i) * (box % kBoxes) / kBoxes,
                         high = space_.extent(i) * (box % kBoxes + 1) / kBoxes;
      place[i] = low + (high > low ? random.below(static_cast<std::uint32_t>(high - low)) : 0);
    }
    return place;
  }
  /// Where a number below `count` comes to in an order of its own for each round: by a permutation of the next power of
  /// two, walked until it is below.
  [[nodiscard]] std::uint32_t shuffled(std::uint32_t number, std::uint32_t count, std::uint64_t round) const {
    std::uint32_t bits = 1;
    while ((1u << bits) < count) ++bits;
    const std::uint32_t mask = (1u << bits) - 1;
    const std::uint64_t key = mix64(seed_ ^ mix64(round + 1));
    do {
      for (unsigned turn = 0; turn < 3; ++turn) {
        number = number * (static_cast<std::uint32_t>(key >> 8 * turn) | 1u) & mask;
        number = (number + static_cast<std::uint32_t>(key >> (8 * turn + 16))) & mask;
        number ^= number >> (bits / 2 + 1);
      }
    } while (number >= count);
    return number;
  }

  FreeSpace<D> space_;
  SampleRule rule_;
  std::uint64_t seed_;
};

}  // namespace replan
