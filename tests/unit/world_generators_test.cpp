#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/hash.hpp"
#include "core/world/generators.hpp"

namespace replan {
namespace {

double covered(const GridMap& map) {
  return static_cast<double>(std::count(map.blocked.begin(), map.blocked.end(), 1)) /
         static_cast<double>(map.blocked.size());
}

std::uint64_t hash(const GridMap& map) {
  return hash_bytes({reinterpret_cast<const char*>(map.blocked.data()), map.blocked.size()});
}

/// Free cells, moves between free straight neighbours, and connected parts.
struct Shape {
  std::int64_t cells = 0, moves = 0, parts = 0;
};

Shape shape_of(const GridMap& map) {
  Shape shape;
  std::vector<std::uint8_t> seen(map.blocked.size());
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      if (map.at({x, y})) continue;
      ++shape.cells;
      for (const Cell next : {Cell{x + 1, y}, Cell{x, y + 1}})
        shape.moves += map.contains(next) && !map.at(next);
      if (seen[map.index({x, y})] != 0) continue;
      ++shape.parts;
      std::vector<Cell> open{{x, y}};
      seen[map.index({x, y})] = 1;
      while (!open.empty()) {
        const Cell c = open.back();
        open.pop_back();
        for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x - 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x, c.y - 1}})
          if (map.contains(n) && !map.at(n) && seen[map.index(n)] == 0) {
            seen[map.index(n)] = 1;
            open.push_back(n);
          }
      }
    }
  return shape;
}

TEST(Generators, RectanglesAreThePapersWorld) {
  const Cell ends[] = {{15, 15}, {175, 175}};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto map = random_rectangles(200, 200, 0.17, 5, 15, seed, ends);
    ASSERT_TRUE(map.ok()) << map.error();
    EXPECT_GE(covered(*map), 0.17);
    EXPECT_LT(covered(*map), 0.17 + 225.0 / 40000);
    for (const Cell end : ends) EXPECT_FALSE(map->at(end));
  }
}

TEST(Generators, RectanglesEndWhereNothingMoreFits) {
  const std::vector<Cell> all = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  const auto kept = random_rectangles(2, 2, 0.9, 1, 1, 1, all);
  ASSERT_TRUE(kept.ok());
  EXPECT_EQ(covered(*kept), 0);
  const auto small = random_rectangles(3, 2, 0.5, 5, 15, 1);  // sides are cut to the map's
  ASSERT_TRUE(small.ok());
  EXPECT_EQ(covered(*small), 1);
}

TEST(Generators, CellsHaveTheirShare) {
  const Cell kept[] = {{0, 0}, {-5, 3}};
  const auto map = random_cells(300, 300, 0.3, 5, kept);
  ASSERT_TRUE(map.ok());
  EXPECT_NEAR(covered(*map), 0.3, 0.01);
  EXPECT_FALSE(map->at({0, 0}));
  EXPECT_EQ(covered(*random_cells(20, 20, 0, 1)), 0);
  EXPECT_EQ(covered(*random_cells(20, 20, 1, 1)), 1);
}

TEST(Generators, AMazeIsATree) {
  const auto map = maze(41, 31, 1, 3);
  ASSERT_TRUE(map.ok()) << map.error();
  const Shape shape = shape_of(*map);
  EXPECT_EQ(shape.parts, 1);
  EXPECT_EQ(shape.cells, 20 * 15 * 2 - 1);  // the places and the openings between them
  EXPECT_EQ(shape.moves, shape.cells - 1);
  EXPECT_FALSE(map->at({1, 1}));
  for (int x = 0; x < 41; ++x) EXPECT_TRUE(map->at({x, 0}) && map->at({x, 30}));
}

TEST(Generators, WideMazesAreConnectedAndKnockingOutMakesLoops) {
  for (const int corridor : {1, 2, 3, 8}) {
    const auto perfect = maze(100, 80, corridor, 9);
    const auto looped = maze(100, 80, corridor, 9, 0.2);
    ASSERT_TRUE(perfect.ok() && looped.ok());
    EXPECT_EQ(shape_of(*perfect).parts, 1);
    EXPECT_EQ(shape_of(*looped).parts, 1);
    EXPECT_LT(covered(*looped), covered(*perfect));
  }
  EXPECT_EQ(shape_of(*maze(3, 3, 1, 1)).cells, 1);
}

TEST(Generators, AreTheSameEverywhere) {
  EXPECT_EQ(hash(*random_rectangles(200, 200, 0.17, 5, 15, 1)), 8725219793958398866u);
  EXPECT_EQ(hash(*random_cells(64, 64, 0.4, 1)), 2791358616555902477u);
  EXPECT_EQ(hash(*maze(65, 65, 1, 1, 0.1)), 12693430590457760476u);
  EXPECT_NE(hash(*random_cells(64, 64, 0.4, 1)), hash(*random_cells(64, 64, 0.4, 2)));
}

TEST(Generators, RefuseWhatCannotBe) {
  EXPECT_FALSE(random_cells(0, 5, 0.1, 1).ok());
  EXPECT_FALSE(random_cells(-3, 5, 0.1, 1).ok());
  EXPECT_FALSE(random_cells(1'000'000'000, 1'000'000'000, 0.1, 1).ok());
  EXPECT_FALSE(random_cells(5, 5, 1.5, 1).ok());
  EXPECT_FALSE(random_cells(5, 5, std::nan(""), 1).ok());
  EXPECT_FALSE(random_rectangles(9, 9, 0.95, 1, 2, 1).ok());
  EXPECT_FALSE(random_rectangles(9, 9, 0.2, 0, 2, 1).ok());
  EXPECT_FALSE(random_rectangles(9, 9, 0.2, 3, 2, 1).ok());
  EXPECT_EQ(maze(9, 9, 8, 1).error(), "corridors cannot be 8 cells wide here: give 1 to 7");
  EXPECT_FALSE(maze(9, 9, 0, 1).ok());
}

}  // namespace
}  // namespace replan
