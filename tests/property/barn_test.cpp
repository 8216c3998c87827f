// The BARN benchmark: the laser and the robot's map against brute force, and a sample of the published worlds.
#include "core/study/barn.hpp"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/study/barn_map.hpp"
#include "tests/support/shared_data.hpp"

namespace replan::barn_test {
namespace {

BarnWorld any_world(Random& random) {
  BarnWorld world;
  world.width = world.height = 6;
  world.cell = 0.15;
  world.disc_radius = 0.075;
  const CellFrame frame{Box(40, 40), 0.15};
  for (NodeId node = 0; node < 1600; ++node)
    if (random.chance(0.05)) world.discs.push_back(frame.centre(frame.box.position(node)));
  return world;
}

TEST(Barn, TheLaserHitsTheNearestDisc) {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const BarnWorld world = any_world(random);
    BarnSettings settings = barn_settings({}, "");
    settings.rays = 90;
    const ObstacleSet discs({0, world.disc_radius}, world.discs);
    const Pose from{1 + 4 * random.unit(), 1 + 4 * random.unit(), 6 * random.unit() - 3};
    if (discs.distance(from.spot(), 1) < 0.01) continue;
    const std::vector<Spot> hits = BarnLaser(world, settings).scan(from);
    std::size_t hit = 0;
    for (int ray = 0; ray < settings.rays; ++ray) {
      const double angle = from.heading + 1.5 * kPi * ((ray + 0.5) / settings.rays - 0.5);
      Spot at = from.spot();
      double far = 0, gap = 1;  // forwards by the distance to the nearest disc, again and again
      while (far < settings.range && gap > 1e-9) {
        gap = discs.distance(at, 1);
        far += gap;
        at = {from.x + far * cosine(angle), from.y + far * sine(angle)};
      }
      if (far >= settings.range) continue;
      ASSERT_LT(hit, hits.size());
      EXPECT_LT(distance(hits[hit++], at), 1e-4);
    }
    EXPECT_EQ(hit, hits.size());
  }
}

TEST(Barn, TheMapIsGrownByTheRadiusHoweverItIsMarked) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const BarnWorld world = any_world(random);
    BarnMap map(world, 0.05, 0.267);
    std::vector<CellEdit> closed;
    std::vector<Spot> centres;
    for (const Spot& disc : world.discs) {
      map.mark({disc}, closed);
      centres.push_back(map.frame().centre(map.frame().cell(disc)));
    }
    const ObstacleSet marked({0.025, 0}, centres);
    std::size_t count = 0;
    for (NodeId node = 0; node < map.closed().size(); ++node) {
      const double gap = marked.distance(map.frame().centre(map.frame().box.position(node)), 1) - 0.267;
      if (std::abs(gap) < 1e-9) continue;
      EXPECT_EQ(map.inflated(node), gap < 0);
    }
    for (const std::uint8_t cell : map.closed()) count += cell;
    EXPECT_EQ(closed.size(), count);
  }
}

TEST(Barn, DrivesTheSampledWorldsWithoutACollision) {
  REPLAN_NEED_SHARED_DATA();
  const auto all = read_barn((test::shared_data() / "barn").string());
  ASSERT_TRUE(all) << all.error();
  EXPECT_EQ(all->size(), 200u);
  std::vector<BarnWorld> sample;
  for (std::size_t i = 0; i < all->size(); i += 10) sample.push_back((*all)[i]);
  std::vector<BarnSummary> summaries;
  for (const char* global : {"", "astar", "dstar-lite", "adaptive-astar"})
    summaries.push_back(summary_of(global, drive_barn(sample, barn_settings({}, global))));
  std::printf("%s", barn_table(summaries).c_str());
  for (const BarnSummary& sum : summaries) {
    EXPECT_EQ(sum.collision, 0) << sum.name;
    EXPECT_GE(sum.success, sum.name.empty() ? 0.75 : 0.98) << sum.name;
    EXPECT_GE(sum.score, sum.name.empty() ? 0.17 : 0.25) << sum.name;
  }
}

}  // namespace
}  // namespace replan::barn_test
