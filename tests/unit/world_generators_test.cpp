#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/hash.hpp"
#include "core/world/generators/generators.hpp"
#include "core/world/generators/list.hpp"

namespace replan::world_generators_test {
namespace {

double covered(const GridMap& map) {
  return static_cast<double>(std::count(map.blocked.begin(), map.blocked.end(), 1)) /
         static_cast<double>(map.blocked.size());
}

std::uint64_t hash(const GridMap& map) {
  const std::vector<std::uint8_t> cells = map.blocked.plain();
  return hash_bytes({reinterpret_cast<const char*>(cells.data()), cells.size()});
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
  const auto map = random_cells({300, 300}, 0.3, 5, kept);
  ASSERT_TRUE(map.ok());
  EXPECT_NEAR(covered(*map), 0.3, 0.01);
  EXPECT_FALSE(map->at({0, 0}));
  EXPECT_EQ(covered(*random_cells({20, 20}, 0, 1)), 0);
  EXPECT_EQ(covered(*random_cells({20, 20}, 1, 1)), 1);
}

TEST(Generators, AMazeIsATree) {
  const auto map = maze(41, 31, {}, 3);
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
    const auto perfect = maze(100, 80, {.corridor = corridor}, 9);
    const auto looped = maze(100, 80, {.corridor = corridor, .loops = 0.2}, 9);
    ASSERT_TRUE(perfect.ok() && looped.ok());
    EXPECT_EQ(shape_of(*perfect).parts, 1);
    EXPECT_EQ(shape_of(*looped).parts, 1);
    EXPECT_LT(covered(*looped), covered(*perfect));
  }
  EXPECT_EQ(shape_of(*maze(3, 3, {}, 1)).cells, 1);
}

TEST(Generators, AreTheSameEverywhere) {
  EXPECT_EQ(hash(*random_rectangles(200, 200, 0.17, 5, 15, 1)), 8725219793958398866u);
  EXPECT_EQ(hash(*random_cells({64, 64}, 0.4, 1)), 2791358616555902477u);
  EXPECT_EQ(hash(*maze(65, 65, {.loops = 0.1}, 1)), 12693430590457760476u);
  EXPECT_EQ(hash(*rooms(65, 65, {}, 1)), 14710497476525175921u);
  EXPECT_EQ(hash(*caves(65, 65, {}, 1)), 15427999401942395202u);
  EXPECT_EQ(hash(*maze(65, 65, {.braid = 0.5}, 1)), 18054065780071126689u);
  EXPECT_NE(hash(*random_cells({64, 64}, 0.4, 1)), hash(*random_cells({64, 64}, 0.4, 2)));
}

TEST(Generators, RefuseWhatCannotBe) {
  EXPECT_FALSE(random_cells({0, 5}, 0.1, 1).ok());
  EXPECT_FALSE(random_cells({-3, 5}, 0.1, 1).ok());
  EXPECT_FALSE(random_cells({1'000'000'000, 1'000'000'000}, 0.1, 1).ok());
  EXPECT_FALSE(random_cells({5, 5}, 1.5, 1).ok());
  EXPECT_FALSE(random_cells({5, 5}, std::nan(""), 1).ok());
  EXPECT_FALSE(random_rectangles(9, 9, 0.95, 1, 2, 1).ok());
  EXPECT_FALSE(random_rectangles(9, 9, 0.2, 0, 2, 1).ok());
  EXPECT_FALSE(random_rectangles(9, 9, 0.2, 3, 2, 1).ok());
  EXPECT_EQ(maze(9, 9, {.corridor = 8}, 1).error(), "corridors cannot be 8 cells wide here: give 1 to 7");
  EXPECT_FALSE(maze(9, 9, {.corridor = 0}, 1).ok());
}

/// Places of a maze with corridors one wide that can be left on one side only.
int dead_ends(const GridMap& map) {
  int count = 0;
  for (int y = 1; y + 1 < map.height; y += 2)
    for (int x = 1; x + 1 < map.width; x += 2) {
      int ways = 0;
      for (const Cell n : {Cell{x + 1, y}, Cell{x - 1, y}, Cell{x, y + 1}, Cell{x, y - 1}})
        ways += map.at(n) ? 0 : 1;
      count += ways == 1 ? 1 : 0;
    }
  return count;
}

TEST(Generators, BraidingOpensDeadEnds) {
  const int perfect = dead_ends(*maze(61, 61, {}, 5)), half = dead_ends(*maze(61, 61, {.braid = 0.5}, 5));
  EXPECT_GT(perfect, 50);
  EXPECT_LT(half, perfect * 2 / 3);
  EXPECT_GT(half, perfect / 4);
  EXPECT_EQ(dead_ends(*maze(61, 61, {.braid = 1}, 5)), 0);
  EXPECT_EQ(shape_of(*maze(61, 61, {.braid = 1}, 5)).parts, 1);
  EXPECT_TRUE(maze(3, 41, {.braid = 1}, 5).ok());  // one column: its ends have no other side
}

TEST(Generators, RoomsAreAllWithinReach) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RoomsShape shape{.min_side = 3, .max_side = 9, .door = 2, .loops = 0};
    const auto map = rooms(70, 50, shape, seed);
    ASSERT_TRUE(map.ok()) << map.error();
    EXPECT_EQ(shape_of(*map).parts, 1);
    for (int x = 0; x < 70; ++x) EXPECT_TRUE(map->at({x, 0}) && map->at({x, 49}));
    for (int y = 0; y < 50; ++y) EXPECT_TRUE(map->at({0, y}) && map->at({69, y}));
    const double walls = covered(*map), open = covered(*rooms(70, 50, {3, 9, 2, 1}, seed));
    EXPECT_LT(open, walls);  // more doors
    EXPECT_GT(walls, 0.15);
  }
  const auto one = rooms(8, 8, {}, 1);  // a single room
  EXPECT_EQ(shape_of(*one).cells, 36);
}

TEST(Generators, CavesAreOneCave) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto map = caves(80, 60, {}, seed);
    ASSERT_TRUE(map.ok()) << map.error();
    EXPECT_EQ(shape_of(*map).parts, 1);
    EXPECT_GT(shape_of(*map).cells, 80 * 60 / 10);
    for (int x = 0; x < 80; ++x) EXPECT_TRUE(map->at({x, 0}) && map->at({x, 59}));
  }
  EXPECT_EQ(caves(2, 2, {}, 1).error(),
            "all of it is rock: give a smaller fraction, fewer rounds or a larger map");
}

TEST(Generators, KeptCellsAreFreeAndWithinReach) {
  const std::vector<Cell> kept = {{0, 0}, {99, 79}, {50, 40}, {51, 40}, {200, 200}};
  for (const GeneratorInfo& info : generators()) {
    const auto map = generate(info.id, {}, {100, 80, info.layers}, 7, kept);
    ASSERT_TRUE(map.ok()) << map.error();
    for (const Cell cell : kept) EXPECT_FALSE(map->contains(cell) && map->at(cell)) << info.id;
    const bool joined = info.id != "cells" && info.id != "rectangles";
    EXPECT_TRUE(!joined || info.layers > 1 || shape_of(*map).parts == 1) << info.id;
  }
}

TEST(GeneratorList, DeclaresEachParameterOnce) {
  for (const GeneratorInfo& info : generators()) {
    EXPECT_FALSE(info.name.empty() || info.summary.empty());
    for (const Parameter& parameter : info.parameters) {
      EXPECT_EQ(find_parameter(info.parameters, parameter.key), &parameter) << parameter.key;
      EXPECT_EQ(find_parameter(generator_size_parameters(), parameter.key), nullptr) << parameter.key;
      EXPECT_GE(parameter.initial, parameter.low) << parameter.key;
      EXPECT_LE(parameter.initial, parameter.high) << parameter.key;
      EXPECT_FALSE(parameter.label.empty() || parameter.help.empty()) << parameter.key;
    }
    // Each end of each range alone makes a map, or an error that says what to change.
    for (const Parameter& parameter : info.parameters)
      for (const double value : {parameter.low, parameter.high}) {
        Settings settings;
        settings.set(parameter.key, value);
        const auto map = generate(info.id, settings, {60, 60, info.layers}, 1);
        EXPECT_TRUE(map.ok() || map.error().find("give ") != std::string::npos) << map.error();
      }
  }
}

TEST(GeneratorList, SpecsSayWhatTheyWant) {
  EXPECT_EQ(*generate_from_spec("generator:maze?width=61&height=41&corridor=2&seed=7"),
            *maze(61, 41, {.corridor = 2}, 7));
  EXPECT_EQ(*generate_from_spec("generator:cells"), *random_cells({100, 100}, 0.3, 1));
  EXPECT_EQ(*generate_from_spec("generator:caves?"), *caves(100, 100, {}, 1));
  EXPECT_EQ(
      *generate_from_spec("generator:rooms?min_side=4&max_side=5&door=1&loops=0.5&seed=9007199254740992"),
      *rooms(100, 100, {4, 5, 1, 0.5}, 9007199254740992u));
  EXPECT_EQ(*generate_from_spec("generator:rectangles?fraction=0.2&min_side=3&max_side=4"),
            *random_rectangles(100, 100, 0.2, 3, 4, 1));
  EXPECT_EQ(open_map("generator:maze?seed=3")->map, *maze(100, 100, {}, 3));
}

TEST(GeneratorList, SizesAreCheckedAlikeEverywhere) {
  EXPECT_EQ(maze(0, 5, {}, 1).error(),
            "a world cannot have 0 x 5 cells: give sides from 1 and at most 67108864 cells in all");
  EXPECT_EQ(
      random_boxes({1000, 1000, 1000}, 0.1, 1, 1, 1).error(),
      "a world cannot have 1000 x 1000 x 1000 cells: give sides from 1 and at most 134217728 cells in all");
}

TEST(GeneratorList, BadSpecsAreNamed) {
  const auto error = [](const std::string& spec) {
    const auto map = generate_from_spec(spec);
    return map.ok() ? "" : map.error();
  };
  EXPECT_EQ(error("generator:mase"), "generator:mase: unknown generator 'mase'; did you mean 'maze'?");
  EXPECT_EQ(error("generator:"),
            "generator:: unknown generator ''; known: cells, rectangles, maze, rooms, caves, boxes, caverns, "
            "sea-floor, pillars");
  EXPECT_EQ(error("generator:maze?corridors=2"),
            "generator:maze?corridors=2: unknown setting 'corridors'; did you mean 'corridor'?");
  EXPECT_EQ(error("generator:maze?braid=2"),
            "generator:maze?braid=2: 'braid' cannot be '2': give a number from 0 to 1");
  EXPECT_EQ(error("generator:maze?width=0"),
            "generator:maze?width=0: 'width' cannot be '0': give a whole number from 1 to 67108864 cells");
  EXPECT_EQ(error("generator:maze?seed=1&seed=2"), "generator:maze?seed=1&seed=2: 'seed' is set twice");
  EXPECT_EQ(error("generator:maze?seed"),
            "generator:maze?seed: 'seed' is no setting: give key=value, parted by &");
  EXPECT_EQ(error("generator:maze?seed=-1").find("'seed' cannot be '-1'") == std::string::npos, false);
  EXPECT_NE(error("generator:cells?width=67108864&height=67108864").find("a world cannot have"),
            std::string::npos);
  EXPECT_NE(error("generator:rooms?door=9").find("doors cannot be 9 cells wide"), std::string::npos);
}

}  // namespace
}  // namespace replan::world_generators_test
