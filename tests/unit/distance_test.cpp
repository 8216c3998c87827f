// Whole-map distance transforms against brute force, and the clearance field against the chamfer transform.
#include "core/field/distance.hpp"

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/field/clearance.hpp"

namespace replan::distance_test {
namespace {

std::vector<std::uint8_t> random_cells(int width, int height, double share, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (auto& cell : cells) cell = random.chance(share) ? 1 : 0;
  return cells;
}

void expect_brute_force(int width, int height, const std::vector<std::uint8_t>& cells) {
  const auto squared = squared_distances(width, height, cells);
  const auto chamfer = chamfer_distances(width, height, cells);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::int32_t best = kNoObstacle;
      Cost octile = Cost::infinity();
      for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
          if (cells[static_cast<std::size_t>(j * width + i)] == 0) continue;
          const int dx = std::abs(x - i), dy = std::abs(y - j);
          best = std::min(best, dx * dx + dy * dy);
          octile =
              std::min(octile, {std::min(dx, dy) * kStepCost[2].raw + std::abs(dx - dy) * kStepCost[1].raw});
        }
      const auto index = static_cast<std::size_t>(y * width + x);
      ASSERT_EQ(squared[index], best) << x << ", " << y << " of " << width << " x " << height;
      ASSERT_EQ(chamfer[index], octile) << x << ", " << y << " of " << width << " x " << height;
    }
}

TEST(DistanceTransform, EqualsBruteForceOnRandomMaps) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const int width = random.between(1, 40), height = random.between(1, 40);
    expect_brute_force(width, height, random_cells(width, height, seed % 4 == 0 ? 0.01 : 0.2, seed));
  }
}

TEST(DistanceTransform, EqualsBruteForceWhereObstaclesAreFarApart) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    std::vector<std::uint8_t> cells(200 * 90);
    Random random(seed);
    for (std::uint64_t i = 0; i < seed; ++i) cells[random.below(200 * 90)] = 1;
    expect_brute_force(200, 90, cells);
  }
}

/// In space, every obstacle looked at for every cell.
void expect_brute_force_in_space(int width, int height, int depth, const std::vector<std::uint8_t>& cells) {
  const auto squared = squared_distances(width, height, depth, cells);
  const Box box(width, height, depth);
  std::vector<Cell> obstacles;
  for (NodeId n = 0; n < cells.size(); ++n)
    if (cells[n] != 0) obstacles.push_back(box.position(n));
  for (NodeId n = 0; n < cells.size(); ++n) {
    std::int64_t best = kNoObstacle;
    for (const Cell& obstacle : obstacles) best = std::min(best, squared_distance(obstacle, box.position(n)));
    ASSERT_EQ(squared[n], best) << "node " << n << " of " << width << " x " << height << " x " << depth;
  }
}

TEST(DistanceTransform, EqualsBruteForceInRandomVolumes) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Random random(seed);
    int width = random.between(1, 14), height = random.between(1, 14), depth = random.between(1, 14);
    if (seed % 6 == 0)
      width = random.between(1, 3), height = random.between(1, 3), depth = random.between(60, 150);
    if (seed % 6 == 1)
      width = random.between(60, 150), height = random.between(1, 3), depth = random.between(1, 3);
    const double share = seed % 4 == 0 ? 0.003 : seed % 4 == 1 ? 0.05 : 0.3;
    expect_brute_force_in_space(width, height, depth, random_cells(width, height * depth, share, seed));
  }
}

TEST(DistanceTransform, InSpaceOfOneLayerIsThatInThePlane) {
  const auto cells = random_cells(37, 29, 0.05, 3);
  EXPECT_EQ(squared_distances(37, 29, 1, cells), squared_distances(37, 29, cells));
  for (const auto squared : squared_distances(5, 4, 6, std::vector<std::uint8_t>(120)))
    EXPECT_EQ(squared, kNoObstacle);
}

/// Many obstacles and a wide range: made of the transform, few of single obstacles.
TEST(DistanceTransform, GivesThePenaltiesOfAWideFieldInSpace) {
  for (const double share : {0.3, 0.01}) {
    const auto cells = random_cells(20, 18 * 16, share, 9);
    const Voxel3 lattice({20, 18, 16}, cells);
    const ClearanceField<3> field(lattice, {.range = 6, .transform = Transform::euclidean});
    const auto squared = squared_distances(20, 18, 16, cells);
    for (NodeId n = 0; n < cells.size(); ++n) {
      const std::int64_t distance = euclidean_floor(squared[n]).raw, range = 6 * Cost::kScale;
      ASSERT_EQ(field.penalty(n).raw, squared[n] > 36 ? 0 : range - distance + Cost::kScale);
    }
  }
}

TEST(DistanceTransform, OfNothingIsInfinite) {
  const std::vector<std::uint8_t> empty(12 * 7);
  for (const auto squared : squared_distances(12, 7, empty)) EXPECT_EQ(squared, kNoObstacle);
  for (const auto chamfer : chamfer_distances(12, 7, empty)) EXPECT_TRUE(chamfer.is_infinite());
}

TEST(DistanceTransform, GivesThePenaltiesOfTheClearanceField) {
  const auto cells = random_cells(60, 45, 0.08, 5);
  const Grid2 lattice({60, 45}, cells);
  const ClearanceField<2> field(lattice,
                                {.range = 3, .transform = Transform::chamfer, .border_is_obstacle = false});
  const auto chamfer = chamfer_distances(60, 45, cells);
  const std::int64_t range = 3 * Cost::kScale;
  for (NodeId n = 0; n < cells.size(); ++n) {
    const std::int64_t r = chamfer[n].raw;
    EXPECT_EQ(field.penalty(n).raw, r > range ? 0 : range - r + Cost::kScale);
  }
}

}  // namespace
}  // namespace replan::distance_test
