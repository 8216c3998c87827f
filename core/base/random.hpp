// Seeded random numbers that are the same everywhere. The standard distributions are not: each library
// draws its own way, so the ranges are drawn here.
#pragma once

#include <cstdint>

#include "core/base/hash.hpp"

namespace replan {

/// splitmix64: one word of state, good enough for worlds and tests, the same on every machine.
class Random {
 public:
  explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() {
    const std::uint64_t value = mix64(state_);
    state_ += 0x9E3779B97F4A7C15ull;
    return value;
  }
  /// Uniform in [0, bound); bound must be positive. Unbiased (Lemire's rejection on 32 bits).
  constexpr std::uint32_t below(std::uint32_t bound) {
    const std::uint32_t threshold = (0u - bound) % bound;
    for (;;) {
      const std::uint64_t product = (next() >> 32) * bound;
      if (static_cast<std::uint32_t>(product) >= threshold) return static_cast<std::uint32_t>(product >> 32);
    }
  }
  /// Uniform in [low, high], both included.
  constexpr int between(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::uint32_t>(high - low) + 1u));
  }
  /// Uniform in [0, 1).
  constexpr double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// True with the given probability.
  constexpr bool chance(double probability) { return unit() < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace replan
