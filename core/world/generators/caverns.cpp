#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/world/generators/generators.hpp"
#include "core/world/generators/parts.hpp"

namespace replan {
namespace {

constexpr double kThinnestRock = 0.4, kThickestRock = 0.6;
constexpr int kMostSmoothing = 20;
constexpr std::uint8_t kMostOf27 = 14;

/// Adds to each cell its two neighbours along one axis, whose cells lie `stride` apart in runs of `length`; beyond an
/// end of the run is rock, which counts `beyond`.
void add_neighbours(std::vector<std::uint8_t>& sums, std::size_t stride, std::size_t length,
                    std::uint8_t beyond) {
  for (std::size_t block = 0; block < sums.size(); block += stride * length)
    for (std::size_t first = block; first < block + stride; ++first) {
      std::uint8_t before = beyond;
      for (std::size_t i = 0; i < length; ++i) {
        std::uint8_t& sum = sums[first + i * stride];
        const std::uint8_t here = sum, after = i + 1 < length ? sums[first + (i + 1) * stride] : beyond;
        sum = static_cast<std::uint8_t>(before + here + after);
        before = here;
      }
    }
}

/// One round: a cell is rock if most of the 27 cells around it are. Sums along one axis, of these sums along the next
/// and so on take 6 additions a cell in place of 26.
void smooth(std::vector<std::uint8_t>& rock, const Box& size) {
  const auto width = static_cast<std::size_t>(size.width()), height = static_cast<std::size_t>(size.height());
  add_neighbours(rock, 1, width, 1);
  add_neighbours(rock, width, height, 3);
  add_neighbours(rock, width * height, static_cast<std::size_t>(size.depth()), 9);
  for (std::uint8_t& cell : rock) cell = cell >= kMostOf27 ? kObstacle : kFree;
}

std::vector<std::uint8_t> random_rock(const Box& size, double fraction, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint8_t> rock;
  rock.reserve(size.node_count());
  const auto outer = [](int at, int length) { return at == 0 || at == length - 1; };
  for (int z = 0; z < size.depth(); ++z)
    for (int y = 0; y < size.height(); ++y)
      for (int x = 0; x < size.width(); ++x) {
        const bool border = outer(x, size.width()) || outer(y, size.height()) || outer(z, size.depth());
        rock.push_back(random.chance(fraction) || border ? kObstacle : kFree);
      }
  return rock;
}

}  // namespace

Result<GridMap> caverns(const Box& size, const CavernsShape& shape, std::uint64_t seed,
                        std::span<const Cell> keep_free) {
  if (auto checked = check_world_size(size); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the fraction of rock", shape.fraction, kThinnestRock, kThickestRock);
      !checked)
    return Error{checked.error()};
  if (shape.rounds < 0 || shape.rounds > kMostSmoothing)
    return Error{"the caverns cannot be smoothed " + std::to_string(shape.rounds) + " times: give 0 to " +
                 std::to_string(kMostSmoothing)};
  // The outer cells are rock; and those next to two walls that face each other have 18 of their 27 in them.
  const int least = shape.rounds == 0 ? 3 : 4;
  if (std::min({size.width(), size.height(), size.depth()}) < least)
    return Error{"all of it would be rock, which caverns have all round: give " + std::to_string(least) +
                 " layers or more, and sides of " + std::to_string(least) + " cells or more"};
  std::vector<std::uint8_t> rock = random_rock(size, shape.fraction, seed);
  for (int i = 0; i < shape.rounds; ++i) smooth(rock, size);
  GridMap map(size.width(), size.height(), size.depth());
  map.blocked = rock;
  if (!keep_largest_region(map))
    return Error{"all of it is rock: give a smaller fraction, fewer rounds or a larger world"};
  dig_to_largest_region(map, keep_free);
  return map;
}

}  // namespace replan
