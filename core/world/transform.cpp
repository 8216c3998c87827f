#include "core/world/transform.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace replan {
namespace {

/// Every place of a scenario but its map and what moves, as told by `move`, a function from Cell to Cell.
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
}

void sort_rows(std::vector<CellChange>& cells) {
  std::sort(cells.begin(), cells.end(),
            [](const CellChange& a, const CellChange& b) { return in_node_order(a.cell, b.cell); });
}

/// Whether the map came with a frame of its own (ROS).
bool has_frame(const GridMap& map) {
  return map.resolution != 1 || map.origin != std::array<double, 3>{};
}

/// What a turn does to the three coordinates: new coordinate i is old coordinate from[i], counted from the other end
/// if flip[i].
struct AxisSwap {
  std::array<Axis, 3> from;
  std::array<bool, 3> flip;
};

AxisSwap axis_swap(Turn turn) {
  using enum Axis;
  switch (turn) {
    case Turn::left:
      return {{y, x, z}, {false, true, false}};
    case Turn::right:
      return {{y, x, z}, {true, false, false}};
    case Turn::left_right:
      return {{x, y, z}, {true, false, false}};
    case Turn::top_bottom:
      return {{x, y, z}, {false, true, false}};
    case Turn::upside_down:
      return {{x, y, z}, {false, false, true}};
    case Turn::tip_back:
      return {{x, z, y}, {false, true, false}};
    case Turn::tip_forward:
      return {{x, z, y}, {false, false, true}};
    case Turn::tip_left:
      return {{z, y, x}, {true, false, false}};
    case Turn::tip_right:
      return {{z, y, x}, {false, false, true}};
  }
  return {{x, y, z}, {}};
}

/// The lengths along x, y and z of something that has these before the turn.
Cell turned_size(Cell size, Turn turn) {
  const auto& from = axis_swap(turn).from;
  return {coordinate(size, from[0]), coordinate(size, from[1]), coordinate(size, from[2])};
}

Cell size_of(const Box& box) {
  return {box.width(), box.height(), box.depth()};
}

bool about_z(Turn turn) {
  return turn == Turn::left || turn == Turn::right;
}

/// Whether layers are layers no more.
bool tips(Turn turn) {
  return axis_swap(turn).from[2] != Axis::z;
}

Cell clamped(Cell cell, const Box& world) {
  return {std::clamp(cell.x, 0, world.width() - 1), std::clamp(cell.y, 0, world.height() - 1),
          std::clamp(cell.z, 0, world.depth() - 1)};
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

/// How far the old world's first cell moves along one axis.
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

/// How many layers a moving obstacle has that had `layers`: no more than its world, or it would be another one when it is
/// read again, since files do not tell it of planes.
int fitting_depth(int layers, const GridMap& world) {
  return std::min(layers, world.depth);
}

/// The moving obstacles of a world that was `before`. The way of one is that of its lowest cell, which is another cell
/// of the box after the turn.
void turn_movers(Scenario& after, const Box& before, Turn turn) {
  for (MovingObstacle& mover : after.movers) {
    const Cell size{mover.width, mover.height, mover.depth}, now = turned_size(size, turn);
    for (Cell& corner : mover.way) {
      const Cell last{corner.x + size.x - 1, corner.y + size.y - 1, corner.z + size.z - 1};
      corner = clamped(box_of(turned(corner, before, turn), turned(last, before, turn)).low, after.map.box());
    }
    mover.width = now.x;
    mover.height = now.y;
    mover.depth = fitting_depth(now.z, after.map);
  }
}

/// The camera looks at the same place of a layer still; of a world that was tipped at all of it.
void turn_camera(ViewSetup& view, const GridMap& before, Turn turn) {
  if (!view.camera) return;
  const double x = view.camera->x, y = view.camera->y;
  const auto look_at = [&](double at_x, double at_y) { view.camera->x = at_x, view.camera->y = at_y; };
  if (turn == Turn::left) return look_at(y, before.width - x);
  if (turn == Turn::right) return look_at(before.height - y, x);
  if (turn == Turn::left_right) return look_at(before.width - x, y);
  if (turn == Turn::top_bottom) return look_at(x, before.height - y);
  if (turn != Turn::upside_down) view.camera.reset();
}

/// Gives the map its new size; a cell of the one before comes to lie where `shifted` says, if that is inside.
template <class Shifted>
void resize_map(Scenario& after, const Scenario& before, const NewSize& size, const Shifted& shifted) {
  const GridMap& map = before.map;
  after.map.width = size.width;
  after.map.height = size.height;
  after.map.depth = size.depth;
  after.map.blocked.assign(after.map.box().node_count(), size.blocked ? kObstacle : kFree);
  const auto unknown = emptied_unknown(after);
  for (NodeId from = 0; from < map.blocked.size(); ++from)
    if (const Cell to = shifted(map.box().position(from)); after.map.contains(to)) {
      after.map.blocked[after.map.index(to)] = map.blocked[from];
      if (unknown) (*unknown)[after.map.index(to)] = before.map_found.is_unknown(map, from);
    }
}

/// Moves the cells of surprises, and drops those that fall off, with the surprises of which nothing is left.
template <class Shifted>
void shift_surprises(Resized& done, const Shifted& shifted) {
  Scenario& after = done.scenario;
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
}

}  // namespace

Cell turned(Cell cell, const Box& world, Turn turn) {
  const AxisSwap swap = axis_swap(turn);
  const auto placed = [&](std::size_t i) {
    const int value = coordinate(cell, swap.from[i]);
    return swap.flip[i] ? coordinate(size_of(world), swap.from[i]) - 1 - value : value;
  };
  return {placed(0), placed(1), placed(2)};
}

Box turned_size(const Box& world, Turn turn) {
  const Cell size = turned_size(size_of(world), turn);
  return {size.x, size.y, size.z};
}

Scenario turned(const Scenario& scenario, Turn turn) {
  const GridMap& map = scenario.map;
  Scenario after = scenario;
  after.map_file.clear();
  const Box size = turned_size(map.box(), turn);
  after.map.width = size.width();
  after.map.height = size.height();
  after.map.depth = size.depth();
  if (about_z(turn) && has_frame(map)) after.map.origin = turned_origin(map, turn);
  if (tips(turn)) after.map.origin = {};  // what was up is none of the frame's directions
  const auto move = [&](Cell cell) { return turned(cell, map.box(), turn); };
  const auto unknown = emptied_unknown(after);
  for (NodeId from = 0; from < map.blocked.size(); ++from) {
    const std::size_t to = after.map.index(move(map.box().position(from)));
    after.map.blocked[to] = map.blocked[from];
    if (unknown) (*unknown)[to] = scenario.map_found.is_unknown(map, from);
  }
  turn_movers(after, map.box(), turn);
  move_places(after, move);
  for (std::size_t i = 0; i < after.surprises.size(); ++i) {
    Surprise& surprise = after.surprises.edit(i);
    for (CellChange& change : surprise.cells) change.cell = move(change.cell);
    sort_rows(surprise.cells);
  }
  turn_camera(after.view, map, turn);
  return after;
}

Cell shift_of(const Box& world, const NewSize& size) {
  return {shift(size.across, world.width(), size.width), shift(size.down, world.height(), size.height),
          shift(size.up, world.depth(), size.depth)};
}

Result<Resized> resized(const Scenario& scenario, const NewSize& size) {
  const GridMap& map = scenario.map;
  if (const auto checked = check_world_size({size.width, size.height, size.depth}); !checked)
    return Error{checked.error()};
  const Cell by = shift_of(map.box(), size);
  Resized done{scenario, 0, {}, false};
  Scenario& after = done.scenario;
  after.map_file.clear();
  const auto shifted = [by](Cell cell) { return Cell{cell.x + by.x, cell.y + by.y, cell.z + by.z}; };
  resize_map(after, scenario, size, shifted);
  if (has_frame(map)) after.map.origin = moved_origin(map, -by.x, map.height - size.height + by.y);
  const Box world = after.map.box();
  const auto falls_off = [&](Cell cell) { return !world.contains(shifted(cell)); };
  done.ends_moved = falls_off(scenario.start) || falls_off(scenario.goal);
  const auto move = [&](Cell cell) { return clamped(shifted(cell), world); };
  move_places(after, move);
  for (MovingObstacle& mover : after.movers) {
    for (Cell& corner : mover.way) corner = move(corner);
    mover.depth = fitting_depth(mover.depth, after.map);
  }
  shift_surprises(done, shifted);
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
