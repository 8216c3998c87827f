#include <algorithm>
#include <string>

#include "core/world/generators/generators.hpp"
#include "core/world/generators/parts.hpp"

namespace replan {
namespace {

constexpr double kLeastRock = 0.3, kMostRock = 0.6;
constexpr int kMostRounds = 20;

/// One round: a cell is rock if most of the nine cells around it are; beyond the map is rock.
GridMap smoothed(const GridMap& map) {
  GridMap result(map.width, map.height);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      int rock = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          rock += !map.contains({x + dx, y + dy}) || map.at({x + dx, y + dy}) ? 1 : 0;
      result.set({x, y}, rock >= 5);
    }
  return result;
}

/// The free cells that can be reached from `first` by straight steps; they are marked in `seen`.
std::vector<Cell> cave_at(const GridMap& map, Cell first, std::vector<std::uint8_t>& seen) {
  std::vector<Cell> cave{first};
  seen[map.index(first)] = 1;
  for (std::size_t next = 0; next < cave.size(); ++next) {
    const Cell c = cave[next];
    for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x, c.y + 1}, Cell{c.x - 1, c.y}, Cell{c.x, c.y - 1}})
      if (map.contains(n) && !map.at(n) && seen[map.index(n)] == 0) {
        seen[map.index(n)] = 1;
        cave.push_back(n);
      }
  }
  return cave;
}

/// The largest cave, the first of several; empty if there is none.
std::vector<Cell> largest_cave(const GridMap& map) {
  std::vector<std::uint8_t> seen(map.blocked.size());
  std::vector<Cell> largest;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      if (map.at({x, y}) || seen[map.index({x, y})] != 0) continue;
      std::vector<Cell> cave = cave_at(map, {x, y}, seen);
      if (cave.size() > largest.size()) largest = std::move(cave);
    }
  return largest;
}

}  // namespace

Result<GridMap> caves(int width, int height, const CavesShape& shape, std::uint64_t seed,
                      std::span<const Cell> keep_free) {
  if (auto checked = check_world_size({width, height}); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the fraction of rock", shape.fraction, kLeastRock, kMostRock); !checked)
    return Error{checked.error()};
  if (shape.rounds < 0 || shape.rounds > kMostRounds)
    return Error{"the caves cannot be smoothed " + std::to_string(shape.rounds) + " times: give 0 to " +
                 std::to_string(kMostRounds)};
  GridMap map(width, height);
  Random random(seed);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool border = x == 0 || y == 0 || x == width - 1 || y == height - 1;
      map.set({x, y}, random.chance(shape.fraction) || border);
    }
  for (int i = 0; i < shape.rounds; ++i) map = smoothed(map);
  const std::vector<Cell> cave = largest_cave(map);
  if (cave.empty()) return Error{"all of it is rock: give a smaller fraction, fewer rounds or a larger map"};
  map.blocked.assign(map.blocked.size(), kObstacle);
  for (const Cell cell : cave) map.set(cell, false);
  dig_to_open(map, keep_free);
  return map;
}

}  // namespace replan
