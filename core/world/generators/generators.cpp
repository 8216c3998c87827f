#include "core/world/generators/generators.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/world/generators/parts.hpp"

namespace replan {
namespace {

/// Of rectangles thrown in a row without covering a new cell: after that many nothing more is to be hoped
/// for.
constexpr int kMaxVainThrows = 10'000;

struct Rectangle {
  int x, y, width, height;
  [[nodiscard]] bool contains(Cell c) const {
    return c.x >= x && c.y >= y && c.x < x + width && c.y < y + height;
  }
};

/// Fills the rectangle and returns how many cells were free before.
std::int64_t fill(GridMap& map, const Rectangle& rectangle) {
  std::int64_t count = 0;
  for (int y = rectangle.y; y < rectangle.y + rectangle.height; ++y)
    for (int x = rectangle.x; x < rectangle.x + rectangle.width; ++x) {
      count += map.at({x, y}) ? 0 : 1;
      map.set({x, y}, true);
    }
  return count;
}

/// The places of a maze and the walls between them.
class MazeBuilder {
 public:
  MazeBuilder(int width, int height, int corridor, std::uint64_t seed)
      : map_(width, height),
        corridor_(corridor),
        columns_((width - 1) / (corridor + 1)),
        rows_((height - 1) / (corridor + 1)),
        random_(seed) {
    map_.blocked.assign(map_.blocked.size(), kObstacle);
  }

  GridMap build(const MazeShape& shape) {
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const Cell at = corner({column, row});
        clear({at.x, at.y, corridor_, corridor_});
      }
    for (const Passage& passage : random_tree(columns_, rows_, random_)) open(passage.place, passage.step);
    for_each_place([&](Cell place) {
      for (const Cell step : {Cell{1, 0}, Cell{0, 1}})
        if (wall_stands(place, step) && random_.chance(shape.loops)) open(place, step);
    });
    if (shape.braid > 0) for_each_place([&](Cell place) { braid(place, shape.braid); });
    return std::move(map_);
  }

 private:
  template <class Visit>
  void for_each_place(const Visit& visit) {
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) visit(Cell{column, row});
  }
  [[nodiscard]] Cell corner(Cell place) const {
    return {1 + place.x * (corridor_ + 1), 1 + place.y * (corridor_ + 1)};
  }
  /// Whether there is a neighbour on that side, and a wall in between.
  [[nodiscard]] bool wall_stands(Cell place, Cell step) const {
    const Cell there{place.x + step.x, place.y + step.y};
    if (there.x < 0 || there.y < 0 || there.x >= columns_ || there.y >= rows_) return false;
    const Cell at = corner({std::max(place.x, there.x), std::max(place.y, there.y)});
    return map_.at({at.x - std::abs(step.x), at.y - std::abs(step.y)});
  }
  void clear(const Rectangle& rectangle) {
    for (int y = rectangle.y; y < rectangle.y + rectangle.height; ++y)
      for (int x = rectangle.x; x < rectangle.x + rectangle.width; ++x) map_.set({x, y}, false);
  }
  /// Takes out the wall between a place and its neighbour.
  void open(Cell place, Cell step) {
    const Cell at = corner({std::min(place.x, place.x + step.x), std::min(place.y, place.y + step.y)});
    if (step.x != 0)
      clear({at.x + corridor_, at.y, 1, corridor_});
    else
      clear({at.x, at.y + corridor_, corridor_, 1});
  }
  /// Opens a place that can be left on one side only, with the given probability, on one of its other sides.
  void braid(Cell place, double probability) {
    Cell walls[4];
    std::uint32_t standing = 0;
    int neighbours = 0;
    for (const Cell step : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}}) {
      const Cell there{place.x + step.x, place.y + step.y};
      neighbours += there.x >= 0 && there.y >= 0 && there.x < columns_ && there.y < rows_ ? 1 : 0;
      if (wall_stands(place, step)) walls[standing++] = step;
    }
    const bool dead_end = neighbours - static_cast<int>(standing) == 1;
    if (dead_end && standing > 0 && random_.chance(probability)) open(place, walls[random_.below(standing)]);
  }

  GridMap map_;
  int corridor_, columns_, rows_;
  Random random_;
};

}  // namespace

Result<GridMap> random_rectangles(int width, int height, double fraction, int min_side, int max_side,
                                  std::uint64_t seed, std::span<const Cell> keep_free) {
  if (auto checked = check_world_size({width, height}); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the covered fraction", fraction, 0, 0.9); !checked)
    return Error{checked.error()};
  if (min_side < 1 || max_side < min_side)
    return Error{"sides cannot go from " + std::to_string(min_side) + " to " + std::to_string(max_side) +
                 ": give a smallest side from 1 and a longest one that is no shorter"};
  GridMap map(width, height);
  Random random(seed);
  const double wanted = fraction * width * height;
  std::int64_t covered = 0;
  for (int vain = 0; static_cast<double>(covered) < wanted && vain < kMaxVainThrows;) {
    Rectangle rectangle{0, 0, std::min(random.between(min_side, max_side), width),
                        std::min(random.between(min_side, max_side), height)};
    rectangle.x = random.between(0, width - rectangle.width);
    rectangle.y = random.between(0, height - rectangle.height);
    const bool kept =
        std::any_of(keep_free.begin(), keep_free.end(), [&](Cell c) { return rectangle.contains(c); });
    const std::int64_t gained = kept ? 0 : fill(map, rectangle);
    covered += gained;
    vain = gained == 0 ? vain + 1 : 0;
  }
  return map;
}

Result<GridMap> random_cells(const Box& size, double fraction, std::uint64_t seed,
                             std::span<const Cell> keep_free) {
  if (auto checked = check_world_size(size); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the obstacles' fraction", fraction, 0, 1); !checked)
    return Error{checked.error()};
  GridMap map(size.width(), size.height(), size.depth());
  Random random(seed);
  for (std::size_t cell = 0; cell < map.blocked.size(); ++cell)
    if (random.chance(fraction)) map.blocked[cell] = kObstacle;
  for (const Cell cell : keep_free)
    if (map.contains(cell)) map.set(cell, false);
  return map;
}

Result<GridMap> maze(int width, int height, const MazeShape& shape, std::uint64_t seed,
                     std::span<const Cell> keep_free) {
  if (auto checked = check_world_size({width, height}); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the fraction of walls taken out", shape.loops, 0, 1); !checked)
    return Error{checked.error()};
  if (auto checked = check_fraction("the fraction of dead ends opened", shape.braid, 0, 1); !checked)
    return Error{checked.error()};
  const int widest = std::min(width, height) - 2;
  if (widest < 1) return Error{"a maze needs 3 cells each way"};
  if (shape.corridor < 1 || shape.corridor > widest)
    return Error{"corridors cannot be " + std::to_string(shape.corridor) + " cells wide here: give 1 to " +
                 std::to_string(widest)};
  GridMap map = MazeBuilder(width, height, shape.corridor, seed).build(shape);
  dig_to_open(map, keep_free);
  return map;
}

}  // namespace replan
