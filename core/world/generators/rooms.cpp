#include <algorithm>
#include <string>

#include "core/world/generators/generators.hpp"
#include "core/world/generators/parts.hpp"

namespace replan {
namespace {

/// Where the walls of one axis stand, the outer ones included, with rooms of low to high cells between them.
std::vector<int> wall_lines(int size, int low, int high, Random& random) {
  std::vector<int> walls{0};
  for (;;) {
    const int left = size - walls.back() - 2, side = random.between(low, high);
    if (left < side + 1 + low) break;  // no second room would fit behind this one
    walls.push_back(walls.back() + side + 1);
  }
  walls.push_back(size - 1);
  return walls;
}

/// The rooms and the walls between them.
class RoomsBuilder {
 public:
  RoomsBuilder(int width, int height, const RoomsShape& shape, std::uint64_t seed)
      : map_(width, height),
        shape_(shape),
        random_(seed),
        across_(wall_lines(width, shape.min_side, shape.max_side, random_)),
        down_(wall_lines(height, shape.min_side, shape.max_side, random_)) {}

  GridMap build() {
    for (const int x : across_)
      for (int y = 0; y < map_.height; ++y) map_.set({x, y}, true);
    for (const int y : down_)
      for (int x = 0; x < map_.width; ++x) map_.set({x, y}, true);
    const int columns = static_cast<int>(across_.size()) - 1, rows = static_cast<int>(down_.size()) - 1;
    for (const Passage& passage : random_tree(columns, rows, random_)) add_door(passage.place, passage.step);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        for (const Cell step : {Cell{1, 0}, Cell{0, 1}})
          if (column + step.x < columns && row + step.y < rows && random_.chance(shape_.loops))
            add_door({column, row}, step);
    return std::move(map_);
  }

 private:
  /// Opens the wall between a room and the one next to it, somewhere; a second door may lie over the first.
  void add_door(Cell room, Cell step) {
    const Cell first{std::min(room.x, room.x + step.x), std::min(room.y, room.y + step.y)};
    const auto& along = step.x != 0 ? down_ : across_;
    const auto& through = step.x != 0 ? across_ : down_;
    const auto place = static_cast<std::size_t>(step.x != 0 ? first.y : first.x);
    const int wall = through[static_cast<std::size_t>(step.x != 0 ? first.x : first.y) + 1];
    const int from = random_.between(along[place] + 1, along[place + 1] - shape_.door);
    for (int i = from; i < from + shape_.door; ++i)
      map_.set(step.x != 0 ? Cell{wall, i} : Cell{i, wall}, false);
  }

  GridMap map_;
  RoomsShape shape_;
  Random random_;
  std::vector<int> across_, down_;
};

}  // namespace

Result<GridMap> rooms(int width, int height, const RoomsShape& shape, std::uint64_t seed,
                      std::span<const Cell> keep_free) {
  if (auto checked = check_world_size({width, height}); !checked) return Error{checked.error()};
  if (auto checked = check_fraction("the fraction of further doors", shape.loops, 0, 1); !checked)
    return Error{checked.error()};
  const int longest = std::min(width, height) - 2;
  if (shape.min_side < 1 || shape.max_side < shape.min_side || shape.min_side > longest)
    return Error{"rooms cannot have sides from " + std::to_string(shape.min_side) + " to " +
                 std::to_string(shape.max_side) + " here: give a smallest side from 1 to " +
                 std::to_string(std::max(1, longest)) + " and a longest one that is no shorter"};
  if (shape.door < 1 || shape.door > shape.min_side)
    return Error{"doors cannot be " + std::to_string(shape.door) + " cells wide: give 1 to " +
                 std::to_string(shape.min_side) + ", the smallest side of a room"};
  GridMap map = RoomsBuilder(width, height, shape, seed).build();
  dig_to_open(map, keep_free);
  return map;
}

}  // namespace replan
