// Generators of worlds of layers: what each promises, held against plain ways of finding out.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/hash.hpp"
#include "core/world/generators/generators.hpp"
#include "core/world/generators/list.hpp"

namespace replan::generators_in_space_test {
namespace {

double covered(const GridMap& map) {
  return static_cast<double>(std::count(map.blocked.begin(), map.blocked.end(), 1)) /
         static_cast<double>(map.blocked.size());
}

std::uint64_t hash(const GridMap& map) {
  const std::vector<std::uint8_t> cells = map.blocked.plain();
  return hash_bytes({reinterpret_cast<const char*>(cells.data()), cells.size()});
}

/// How many regions of free cells there are, joined by straight steps in space: by relaxing labels until nothing
/// changes, which is slow and plain.
std::size_t free_regions(const GridMap& map) {
  const Box box = map.box();
  std::vector<NodeId> label(box.node_count());
  for (NodeId node = 0; node < label.size(); ++node) label[node] = node;
  for (bool changed = true; changed;) {
    changed = false;
    for (NodeId node = 0; node < label.size(); ++node) {
      if (map.blocked[node] != kFree) continue;
      const Cell c = box.position(node);
      for (const Cell n : {Cell{c.x + 1, c.y, c.z}, Cell{c.x - 1, c.y, c.z}, Cell{c.x, c.y + 1, c.z},
                           Cell{c.x, c.y - 1, c.z}, Cell{c.x, c.y, c.z + 1}, Cell{c.x, c.y, c.z - 1}}) {
        if (!map.contains(n) || map.at(n)) continue;
        const NodeId least = std::min(label[node], label[map.index(n)]);
        changed = changed || label[node] != least || label[map.index(n)] != least;
        label[node] = label[map.index(n)] = least;
      }
    }
  }
  std::size_t count = 0;
  for (NodeId node = 0; node < label.size(); ++node)
    count += map.blocked[node] == kFree && label[node] == node ? 1 : 0;
  return count;
}

TEST(GeneratorsInSpace, BoxesAndPillarsCoverTheirShare) {
  const Cell kept[] = {{1, 1, 1}, {38, 28, 18}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto boxes = random_boxes({40, 30, 20}, 0.25, 3, 6, seed, kept);
    ASSERT_TRUE(boxes.ok()) << boxes.error();
    EXPECT_EQ(boxes->box(), Box(40, 30, 20));
    EXPECT_GE(covered(*boxes), 0.24);  // a way that was dug is no more than that
    EXPECT_LT(covered(*boxes), 0.25 + 216.0 / 24000);
    const auto map = pillars({40, 30, 20}, {.fraction = 0.2, .whole = 0.5}, seed);
    ASSERT_TRUE(map.ok()) << map.error();
    std::int64_t ground = 0, top = 0;
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x) {
        ground += map->at({x, y, 0}) ? 1 : 0;
        top += map->at({x, y, 19}) ? 1 : 0;
        for (int z = 1; z < 20; ++z) ASSERT_TRUE(!map->at({x, y, z}) || map->at({x, y, z - 1}));
      }
    EXPECT_GE(ground, 240);
    EXPECT_LT(ground, 240 + 81);
    EXPECT_GT(top, 0);
    EXPECT_LT(top, ground);
  }
}

TEST(GeneratorsInSpace, CavernsAreOneCaveThroughAllLayers) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto map = caverns({40, 36, 24}, {}, seed);
    ASSERT_TRUE(map.ok()) << map.error();
    EXPECT_EQ(free_regions(*map), 1u);
    EXPECT_GT(covered(*map), 0.4) << seed;
    EXPECT_LT(covered(*map), 0.9) << seed;
    for (int z = 0; z < 24; ++z)
      for (int y = 0; y < 36; ++y) EXPECT_TRUE(map->at({0, y, z}) && map->at({39, y, z}));
    for (int z = 2; z < 22; ++z) {
      int open = 0;
      for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 40; ++x) open += map->at({x, y, z}) ? 0 : 1;
      EXPECT_GT(open, 0) << seed << ", layer " << z;
    }
  }
  EXPECT_EQ(caverns({4, 4, 4}, {.fraction = 0.6}, 1).error(),
            "all of it is rock: give a smaller fraction, fewer rounds or a larger world");
}

/// Fewer rounds or less rock would not help there.
TEST(GeneratorsInSpace, CavernsNeedRoomBetweenTheirWalls) {
  for (const Box& flat : {Box(30, 30, 1), Box(30, 30, 2), Box(30, 30, 3), Box(3, 30, 30), Box(30, 3, 30)})
    EXPECT_EQ(caverns(flat, {.fraction = 0.4, .rounds = 1}, 1).error(),
              "all of it would be rock, which caverns have all round: give 4 layers or more, and sides of 4 "
              "cells or more");
  EXPECT_EQ(caverns({30, 30, 2}, {.fraction = 0.4, .rounds = 0}, 1).error(),
            "all of it would be rock, which caverns have all round: give 3 layers or more, and sides of 3 "
            "cells or more");
  EXPECT_TRUE(caverns({30, 30, 3}, {.fraction = 0.4, .rounds = 0}, 1).ok());
}

/// What the sums along the axes come to is what the rule says.
TEST(GeneratorsInSpace, CavernsAreSmoothedByTheMajorityOf27) {
  const Box box(9, 7, 6);
  const GridMap before = *caverns(box, {.fraction = 0.4, .rounds = 0}, 3),
                after = *caverns(box, {.fraction = 0.4, .rounds = 1}, 3);
  // Without rounds the largest cave is nearly all of the free cells, so that what differs is told by the rule where it
  // is fulfilled clearly; the cells of small caves make the rest unsure.
  for (int z = 0; z < 6; ++z)
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 9; ++x) {
        int free = 0;
        for (int dz = -1; dz <= 1; ++dz)
          for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
              const Cell n{x + dx, y + dy, z + dz};
              free += before.contains(n) && !before.at(n) ? 1 : 0;
            }
        EXPECT_TRUE(after.at({x, y, z}) || free >= 10);
        EXPECT_TRUE(!after.at({x, y, z}) || free < 14) << x << ", " << y << ", " << z;
      }
}

TEST(GeneratorsInSpace, ASeaFloorLiesBelowOpenWater) {
  for (const double roughness : {0.0, 0.5, 1.0}) {
    const auto map = sea_floor({50, 40, 16}, {.relief = 1, .roughness = roughness, .feature = 20}, 4);
    ASSERT_TRUE(map.ok()) << map.error();
    int lowest = 16, highest = 0, steps = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 50; ++x) {
        int floor = 0;
        while (floor < 16 && map->at({x, y, floor})) ++floor;
        for (int z = floor; z < 16; ++z) ASSERT_FALSE(map->at({x, y, z}));
        lowest = std::min(lowest, floor);
        highest = std::max(highest, floor);
        if (x > 0)
          steps += map->at({x - 1, y, floor}) || (floor > 0 && !map->at({x - 1, y, floor - 1})) ? 1 : 0;
      }
    EXPECT_EQ(lowest, 0);
    EXPECT_EQ(highest, 15);
    EXPECT_EQ(free_regions(*map), 1u);
    EXPECT_TRUE(roughness > 0 || steps < 50 * 40 / 2) << steps;
    EXPECT_TRUE(roughness < 1 || steps > 50 * 40 / 2) << steps;
  }
  EXPECT_EQ(sea_floor({5, 5, 1}, {}, 1).error(), "a sea floor needs water above it: give 2 layers or more");
}

TEST(GeneratorsInSpace, KeptCellsAreFreeAndJoined) {
  const std::vector<Cell> kept = {{0, 0, 0}, {29, 24, 9}, {15, 12, 0}, {15, 13, 5}, {200, 200, 200}};
  for (const GeneratorInfo& info : generators()) {
    if (info.layers == 1) continue;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const auto map = generate(info.id, {}, {30, 25, 10}, seed, kept);
      ASSERT_TRUE(map.ok()) << map.error();
      GridMap with_others_filled = *map;
      for (const Cell cell : kept) EXPECT_FALSE(map->contains(cell) && map->at(cell)) << info.id;
      // All of them in one region: a flood from the first reaches the others.
      std::vector<Cell> open{kept.front()};
      with_others_filled.set(kept.front(), true);
      while (!open.empty()) {
        const Cell c = open.back();
        open.pop_back();
        for (const Cell n : {Cell{c.x + 1, c.y, c.z}, Cell{c.x - 1, c.y, c.z}, Cell{c.x, c.y + 1, c.z},
                             Cell{c.x, c.y - 1, c.z}, Cell{c.x, c.y, c.z + 1}, Cell{c.x, c.y, c.z - 1}})
          if (with_others_filled.contains(n) && !with_others_filled.at(n)) {
            with_others_filled.set(n, true);
            open.push_back(n);
          }
      }
      for (const Cell cell : kept)
        EXPECT_TRUE(!map->contains(cell) || with_others_filled.at(cell)) << info.id << ", seed " << seed;
    }
  }
}

TEST(GeneratorsInSpace, AreTheSameEverywhere) {
  const Box box(40, 30, 20);
  EXPECT_EQ(hash(*random_cells(box, 0.2, 1)), 1770033189606790229u);
  EXPECT_EQ(hash(*random_boxes(box, 0.2, 3, 7, 1)), 4179400824426695604u);
  EXPECT_EQ(hash(*caverns(box, {}, 1)), 2280281846220951386u);
  EXPECT_EQ(hash(*sea_floor(box, {}, 1)), 6773148118204370197u);
  EXPECT_EQ(hash(*pillars(box, {}, 1)), 18070431693709956445u);
}

TEST(GeneratorsInSpace, SpecsSayHowManyLayers) {
  EXPECT_EQ(*generate_from_spec("generator:boxes?width=20&height=10&layers=5&seed=3"),
            *random_boxes({20, 10, 5}, 0.17, 3, 9, 3));
  EXPECT_EQ(generate_from_spec("generator:sea-floor?width=20&height=10")->box(), Box(20, 10, 32));
  EXPECT_EQ(generate_from_spec("generator:cells?width=20&height=10&layers=4")->box(), Box(20, 10, 4));
  EXPECT_EQ(
      generate_from_spec("generator:maze?layers=4").error().find("generator:maze?layers=4: unknown setting"),
      0u);
  EXPECT_EQ(generate("maze", {}, {9, 9, 2}, 1).error(), "the generator 'maze' makes one layer, not 2");
  EXPECT_FALSE(generate_from_spec("generator:boxes?width=1000&height=1000&layers=1000").ok());
  EXPECT_FALSE(random_boxes({5, 0, 5}, 0.1, 1, 2, 1).ok());
  EXPECT_FALSE(random_boxes({5, 5, 5}, 0.1, 3, 2, 1).ok());
  EXPECT_FALSE(pillars({5, 5, 5}, {.fraction = 0.95}, 1).ok());
}

}  // namespace
}  // namespace replan::generators_in_space_test
