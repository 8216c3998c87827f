#include "core/world/transform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace replan {
namespace {

/// Every place of a scenario but its map, as told by `move`, a function from Cell to Cell.
template <class Move>
void move_places(Scenario& scenario, const Move& move) {
  scenario.start = move(scenario.start);
  scenario.goal = move(scenario.goal);
  for (std::size_t i = 0; i < scenario.surprises.size(); ++i) {
    Surprise& surprise = scenario.surprises.edit(i);
    if (surprise.at.near) surprise.at.near = move(*surprise.at.near);
    if (surprise.goal) surprise.goal = move(*surprise.goal);
    if (surprise.robot) surprise.robot = move(*surprise.robot);
  }
  for (MovingObstacle& mover : scenario.movers)
    for (Cell& corner : mover.way) corner = move(corner);
}

void sort_rows(std::vector<CellChange>& cells) {
  std::sort(cells.begin(), cells.end(),
            [](const CellChange& a, const CellChange& b) { return in_node_order(a.cell, b.cell); });
}

/// Whether the map came with a frame of its own (ROS).
bool has_frame(const GridMap& map) {
  return map.resolution != 1 || map.origin != std::array<double, 3>{};
}

bool quarter(Turn turn) {
  return turn == Turn::left || turn == Turn::right;
}

/// The pose of the lower left corner if that lies so many cells to the right of the old one, and above it.
std::array<double, 3> moved_origin(const GridMap& map, int right, int up) {
  const auto [x, y, yaw] = map.origin;
  const double dx = right * map.resolution, dy = up * map.resolution;
  return {x + dx * std::cos(yaw) - dy * std::sin(yaw), y + dx * std::sin(yaw) + dy * std::cos(yaw), yaw};
}

/// The lower left corner's pose after a quarter turn, so that every cell stays where it is in the map's
/// frame.
std::array<double, 3> turned_origin(const GridMap& map, Turn turn) {
  // The new lower left corner is the old upper left one (left) or the lower right one (right).
  const bool left = turn == Turn::left;
  std::array<double, 3> origin = left ? moved_origin(map, 0, map.height) : moved_origin(map, map.width, 0);
  const double by = left ? -std::numbers::pi / 2 : std::numbers::pi / 2;
  origin[2] = std::remainder(origin[2] + by, 2 * std::numbers::pi);
  return origin;
}

/// How far the old world's upper left corner moves along one axis.
int shift(Side side, int before, int after) {
  switch (side) {
    case Side::low:
      return 0;
    case Side::middle:
      return (after - before) / 2;
    case Side::high:
      return after - before;
  }
  return 0;
}

/// In the place of what was unknown, room for the new map's cells; nothing if nothing was.
std::shared_ptr<std::vector<bool>> emptied_unknown(Scenario& after) {
  if (after.map_found.unknown == nullptr) return nullptr;
  auto unknown = std::make_shared<std::vector<bool>>(after.map.blocked.size());
  after.map_found.unknown = unknown;
  return unknown;
}

}  // namespace

Cell turned(Cell cell, int width, int height, Turn turn) {
  switch (turn) {
    case Turn::left:
      return {cell.y, width - 1 - cell.x, cell.z};
    case Turn::right:
      return {height - 1 - cell.y, cell.x, cell.z};
    case Turn::left_right:
      return {width - 1 - cell.x, cell.y, cell.z};
    case Turn::top_bottom:
      return {cell.x, height - 1 - cell.y, cell.z};
  }
  return cell;
}

Scenario turned(const Scenario& scenario, Turn turn) {
  const GridMap& map = scenario.map;
  Scenario after = scenario;
  after.map_file.clear();
  if (quarter(turn)) {
    std::swap(after.map.width, after.map.height);
    if (has_frame(map)) after.map.origin = turned_origin(map, turn);
  }
  const auto move = [&](Cell cell) { return turned(cell, map.width, map.height, turn); };
  const auto unknown = emptied_unknown(after);
  for (NodeId from = 0; from < map.blocked.size(); ++from) {
    const std::size_t to = after.map.index(move(map.box().position(from)));
    after.map.blocked[to] = map.blocked[from];
    if (unknown) (*unknown)[to] = scenario.map_found.is_unknown(map, from);
  }
  move_places(after, move);
  for (std::size_t i = 0; i < after.surprises.size(); ++i) {
    Surprise& surprise = after.surprises.edit(i);
    for (CellChange& change : surprise.cells) change.cell = move(change.cell);
    sort_rows(surprise.cells);
  }
  for (MovingObstacle& mover : after.movers) {
    // The way is that of the upper left cell: another corner of the box after the turn.
    if (quarter(turn)) std::swap(mover.width, mover.height);
    const int left = turn == Turn::right || turn == Turn::left_right ? mover.width - 1 : 0;
    const int up = turn == Turn::left || turn == Turn::top_bottom ? mover.height - 1 : 0;
    for (Cell& corner : mover.way)
      corner = {std::clamp(corner.x - left, 0, after.map.width - 1),
                std::clamp(corner.y - up, 0, after.map.height - 1), corner.z};
  }
  if (auto& camera = after.view.camera) {
    const double x = camera->x, y = camera->y;
    camera->x = turn == Turn::left         ? y
                : turn == Turn::right      ? map.height - y
                : turn == Turn::left_right ? map.width - x
                                           : x;
    camera->y = turn == Turn::left         ? map.width - x
                : turn == Turn::right      ? x
                : turn == Turn::top_bottom ? map.height - y
                                           : y;
  }
  return after;
}

Result<Resized> resized(const Scenario& scenario, const NewSize& size) {
  const GridMap& map = scenario.map;
  const std::int64_t most = map.depth == 1 ? kMaxCells : kMaxVoxels / map.depth;
  if (size.width < 1 || size.height < 1 || std::int64_t{size.width} * size.height > most)
    return Error{"a world cannot have " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                 " cells: give sides from 1 and at most " + std::to_string(most) + " cells in all"};
  const Cell by{shift(size.across, map.width, size.width), shift(size.down, map.height, size.height)};
  Resized done{scenario, 0, {}, false};
  Scenario& after = done.scenario;
  after.map_file.clear();
  after.map.width = size.width;
  after.map.height = size.height;
  after.map.blocked.assign(after.map.box().node_count(), size.blocked ? kObstacle : kFree);
  const auto unknown = emptied_unknown(after);
  const auto shifted = [by](Cell cell) { return Cell{cell.x + by.x, cell.y + by.y, cell.z}; };
  for (NodeId from = 0; from < map.blocked.size(); ++from)
    if (const Cell to = shifted(map.box().position(from)); after.map.contains(to)) {
      after.map.blocked[after.map.index(to)] = map.blocked[from];
      if (unknown) (*unknown)[after.map.index(to)] = scenario.map_found.is_unknown(map, from);
    }
  if (has_frame(map)) after.map.origin = moved_origin(map, -by.x, map.height - size.height + by.y);
  const auto move = [&](Cell cell) {
    return Cell{std::clamp(cell.x + by.x, 0, size.width - 1), std::clamp(cell.y + by.y, 0, size.height - 1),
                cell.z};
  };
  const auto falls_off = [&](Cell cell) { return !after.map.contains(shifted(cell)); };
  done.ends_moved = falls_off(scenario.start) || falls_off(scenario.goal);
  move_places(after, move);
  for (std::size_t i = 0; i < after.surprises.size(); ++i) {
    Surprise& surprise = after.surprises.edit(i);
    const std::size_t before = surprise.cells.size();
    for (CellChange& change : surprise.cells) change.cell = shifted(change.cell);
    std::erase_if(surprise.cells, [&](const CellChange& each) { return !after.map.contains(each.cell); });
    done.cells_lost += before - surprise.cells.size();
  }
  for (std::size_t i = after.surprises.size(); i-- > 0;) {
    const Surprise& surprise = std::as_const(after.surprises)[i];
    if (!surprise.cells.empty() || surprise.goal || surprise.robot) continue;
    done.surprises_lost.insert(done.surprises_lost.begin(), i);
    after.surprises.erase(i);
  }
  if (auto& camera = after.view.camera) {
    camera->x += by.x;
    camera->y += by.y;
  }
  return done;
}

std::vector<CellChange> inversion(const GridMap& map, std::span<const Cell> keep_free) {
  std::vector<CellChange> changes;
  for (NodeId node = 0; node < map.blocked.size(); ++node) {
    const Cell cell = map.box().position(node);
    const bool block = map.blocked[node] == kFree;
    if (block && std::find(keep_free.begin(), keep_free.end(), cell) != keep_free.end()) continue;
    changes.push_back({cell, block});
  }
  return changes;
}

}  // namespace replan
