#include "core/experiment/random_blocks.hpp"

#include <cmath>

#include "core/base/random.hpp"
#include "core/plan/navigator.hpp"

namespace replan {
namespace {

constexpr int kTries = 20;

/// A shortest way for the robot, as corners; empty if there is none.
std::vector<Point> shortest_way(const Scenario& world, const SharedBytes& cells) {
  const auto navigator = make_navigator({"astar", {}}, world.map.box(), cells, world.robot.radius);
  navigator->begin(centre_of(world.start), centre_of(world.goal));
  if (finish(*navigator) != PlanStatus::found) return {};
  const Path path = navigator->path();
  std::vector<Point> way;
  for (std::size_t i = 0; i < path.size(); ++i) way.push_back(path.point(i));
  return way;
}

double between(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// The place so far along the way.
Point place_on(std::span<const Point> way, double along) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double leg = between(way[i - 1], way[i]);
    if (along > leg || leg == 0) {
      along -= leg;
      continue;
    }
    const double part = along / leg;
    return {way[i - 1].x + part * (way[i].x - way[i - 1].x), way[i - 1].y + part * (way[i].y - way[i - 1].y),
            way[i - 1].z + part * (way[i].z - way[i - 1].z)};
  }
  return way.back();
}

/// The free cells of a block around a cell, but for start and goal, in the order of nodes.
std::vector<CellChange> block_around(const Scenario& world, const SharedBytes& cells, Cell middle, int side) {
  const Box box = world.map.box();
  const int low = side / 2;
  const int layers = box.solid() ? side : 1, below = box.solid() ? low : 0;
  std::vector<CellChange> changes;
  for (int z = middle.z - below; z < middle.z - below + layers; ++z)
    for (int y = middle.y - low; y < middle.y - low + side; ++y)
      for (int x = middle.x - low; x < middle.x - low + side; ++x) {
        const Cell cell{x, y, z};
        if (box.contains(cell) && cells[box.node(cell)] == kFree && cell != world.start && cell != world.goal)
          changes.push_back({cell, true});
      }
  return changes;
}

}  // namespace

Surprises dropped_blocks(const Scenario& world, const RandomBlocks& blocks) {
  Random random(world.seed);
  std::vector<Surprise> dropped;
  SharedBytes cells = world.map.blocked;
  const std::vector<Point> way = shortest_way(world, cells);
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += between(way[i - 1], way[i]);
  for (int i = 0; i < blocks.count && length > blocks.ahead; ++i)
    for (int tried = 0; tried < kTries; ++tried) {
      const Cell middle = cell_of(place_on(way, blocks.ahead + random.unit() * (length - blocks.ahead)));
      if (between(centre_of(middle), centre_of(world.start)) < blocks.ahead) continue;
      const auto changes = block_around(world, cells, middle, blocks.side);
      SharedBytes with = cells;
      for (const CellChange& change : changes) with[world.map.box().node(change.cell)] = kObstacle;
      if (changes.empty() || shortest_way(world, with).empty()) continue;
      cells = with;
      dropped.push_back(
          {.at = {.move = std::nullopt, .near = middle, .within = blocks.ahead}, .cells = changes});
      break;
    }
  return dropped;
}

}  // namespace replan
