#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/base/hash.hpp"
#include "core/world/generators/generators.hpp"
#include "core/world/generators/parts.hpp"

namespace replan {
namespace {

constexpr int kFractionBits = 12;  // of the place between two points of the noise
constexpr std::int64_t kOne = std::int64_t{1} << kFractionBits;

/// The noise at a point of its grid: 0 to 65535, the same everywhere.
std::int64_t noise_at(std::uint64_t seed, int x, int y) {
  const std::uint64_t place =
      std::uint64_t{static_cast<std::uint32_t>(x)} << 32 | static_cast<std::uint32_t>(y);
  return static_cast<std::int64_t>(mix64(seed ^ mix64(place)) >> 48);
}

/// 3 t^2 - 2 t^3 in parts of kOne: no edge is seen where two squares of the noise meet.
std::int64_t smoothed_step(std::int64_t t) {
  return t * t * (3 * kOne - 2 * t) >> (2 * kFractionBits);
}

std::int64_t blend(std::int64_t a, std::int64_t b, std::int64_t t) {
  return a + ((b - a) * t >> kFractionBits);
}

/// Noise whose points are `apart` cells apart.
std::int64_t smooth_noise(std::uint64_t seed, int x, int y, int apart) {
  const auto part = [apart](int at) { return smoothed_step(at % apart * kOne / apart); };
  const int left = x / apart, top = y / apart;
  const std::int64_t across = part(x), down = part(y);
  return blend(blend(noise_at(seed, left, top), noise_at(seed, left + 1, top), across),
               blend(noise_at(seed, left, top + 1), noise_at(seed, left + 1, top + 1), across), down);
}

/// The sum of noise of `feature` cells, of half as many, and so on, each `roughness` times as high as the one before.
std::vector<std::int64_t> fractal_heights(const Box& size, const SeaFloorShape& shape, std::uint64_t seed) {
  std::vector<std::int64_t> heights(static_cast<std::size_t>(size.width()) *
                                    static_cast<std::size_t>(size.height()));
  // A whole number, and every product below too.
  const auto fade = static_cast<std::int64_t>(std::llround(shape.roughness * static_cast<double>(kOne)));
  std::int64_t share = kOne;
  for (int apart = shape.feature; apart >= 2 && share > 0;
       apart /= 2, share = share * fade >> kFractionBits) {
    const std::uint64_t own = mix64(seed + static_cast<std::uint64_t>(apart));
    std::size_t column = 0;
    for (int y = 0; y < size.height(); ++y)
      for (int x = 0; x < size.width(); ++x) heights[column++] += share * smooth_noise(own, x, y, apart);
  }
  return heights;
}

}  // namespace

Result<GridMap> sea_floor(const Box& size, const SeaFloorShape& shape, std::uint64_t seed,
                          std::span<const Cell> keep_free) {
  if (auto checked = check_world_size(size); !checked) return Error{checked.error()};
  if (size.depth() < 2) return Error{"a sea floor needs water above it: give 2 layers or more"};
  for (const auto& [name, value] :
       {std::pair{"the relief", shape.relief}, std::pair{"the roughness", shape.roughness}})
    if (auto checked = check_fraction(name, value, 0, 1); !checked) return Error{checked.error()};
  if (shape.feature < 2)
    return Error{"hills cannot be " + std::to_string(shape.feature) + " cells apart: give 2 or more"};
  const std::vector<std::int64_t> heights = fractal_heights(size, shape, seed);
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const std::int64_t span = std::max<std::int64_t>(1, *high - *low);
  // Peaks end below the highest layer, which joins all free cells.
  const std::int64_t peak = std::llround(shape.relief * (size.depth() - 1));
  GridMap map(size.width(), size.height(), size.depth());
  std::vector<std::uint8_t> cells(size.node_count(), kFree);
  for (std::size_t column = 0; column < heights.size(); ++column) {
    const auto rock = static_cast<std::size_t>(((heights[column] - *low) * peak + span / 2) / span);
    for (std::size_t z = 0; z < rock; ++z) cells[z * heights.size() + column] = kObstacle;
  }
  map.blocked = cells;
  dig_to_largest_region(map, keep_free);
  return map;
}

}  // namespace replan
