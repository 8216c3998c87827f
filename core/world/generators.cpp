#include "core/world/generators.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/random.hpp"

namespace replan {
namespace {

/// Of rectangles thrown in a row without covering a new cell: after that many nothing more is to be hoped
/// for.
constexpr int kMaxVainThrows = 10'000;

Result<void> check_size(int width, int height) {
  if (width >= 1 && height >= 1 && std::int64_t{width} * height <= kMaxCells) return {};
  return Error{"a map cannot have " + std::to_string(width) + " x " + std::to_string(height) +
               " cells: give sides from 1 and at most " + std::to_string(kMaxCells) + " cells in all"};
}

Result<void> check_fraction(const char* name, double fraction, double high) {
  if (fraction >= 0 && fraction <= high) return {};
  return Error{std::string(name) + " cannot be " + std::to_string(fraction) + ": give a number from 0 to " +
               std::to_string(high).substr(0, 3)};
}

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
    std::fill(map_.blocked.begin(), map_.blocked.end(), std::uint8_t{1});
  }

  GridMap build(double knock_out) {
    carve();
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        for (const Cell step : {Cell{1, 0}, Cell{0, 1}})
          if (inside({column + step.x, row + step.y}) && wall_stands({column, row}, step) &&
              random_.chance(knock_out))
            open({column, row}, step);
    return std::move(map_);
  }

 private:
  [[nodiscard]] bool inside(Cell place) const {
    return place.x >= 0 && place.y >= 0 && place.x < columns_ && place.y < rows_;
  }
  [[nodiscard]] Cell corner(Cell place) const {
    return {1 + place.x * (corridor_ + 1), 1 + place.y * (corridor_ + 1)};
  }
  [[nodiscard]] bool carved(Cell place) const { return !map_.at(corner(place)); }
  /// Whether the wall from a place to the right or down stands.
  [[nodiscard]] bool wall_stands(Cell place, Cell step) const {
    const Cell at = corner(place);
    return map_.at({at.x + step.x * corridor_, at.y + step.y * corridor_});
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
  void carve_place(Cell place) {
    const Cell at = corner(place);
    clear({at.x, at.y, corridor_, corridor_});
  }

  /// A random walk over all places that turns back where it is stuck: long winding corridors, one way
  /// everywhere.
  void carve() {
    std::vector<Cell> way{{0, 0}};
    carve_place(way.back());
    while (!way.empty()) {
      const Cell here = way.back();
      Cell choices[4];
      std::uint32_t count = 0;
      for (const Cell step : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}}) {
        const Cell there{here.x + step.x, here.y + step.y};
        if (inside(there) && !carved(there)) choices[count++] = step;
      }
      if (count == 0) {
        way.pop_back();
        continue;
      }
      const Cell step = choices[random_.below(count)];
      open(here, step);
      way.push_back({here.x + step.x, here.y + step.y});
      carve_place(way.back());
    }
  }

  GridMap map_;
  int corridor_, columns_, rows_;
  Random random_;
};

}  // namespace

Result<GridMap> random_rectangles(int width, int height, double fraction, int min_side, int max_side,
                                  std::uint64_t seed, std::span<const Cell> keep_free) {
  if (auto checked = check_size(width, height); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the covered fraction", fraction, 0.9); !checked)
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

Result<GridMap> random_cells(int width, int height, double fraction, std::uint64_t seed,
                             std::span<const Cell> keep_free) {
  if (auto checked = check_size(width, height); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the obstacles' fraction", fraction, 1); !checked)
    return Error{checked.error()};
  GridMap map(width, height);
  Random random(seed);
  for (std::uint8_t& cell : map.blocked) cell = random.chance(fraction) ? 1 : 0;
  for (const Cell cell : keep_free)
    if (map.contains(cell)) map.set(cell, false);
  return map;
}

Result<GridMap> maze(int width, int height, int corridor, std::uint64_t seed, double knock_out) {
  if (auto checked = check_size(width, height); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the fraction of walls taken out", knock_out, 1); !checked)
    return Error{checked.error()};
  if (corridor < 1 || corridor > std::min(width, height) - 2)
    return Error{"corridors cannot be " + std::to_string(corridor) + " cells wide here: give 1 to " +
                 std::to_string(std::min(width, height) - 2)};
  return MazeBuilder(width, height, corridor, seed).build(knock_out);
}

}  // namespace replan
