// The whole world turned, mirrored or given another size, with everything that stands in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// A way to turn or mirror a world. Seen from above, with y down the page and z towards the eye: the back of a world
/// is where y is 0, its top where z is highest. The last five need more than one layer to do anything useful.
enum class Turn : std::uint8_t {
  left,         ///< a quarter turn about z, against the clock
  right,        ///< a quarter turn about z, with the clock
  left_right,   ///< mirrored along x: what was left is right
  top_bottom,   ///< mirrored along y: what was at the top of a layer is at its bottom
  upside_down,  ///< mirrored along z: the lowest layer is the highest
  tip_back,     ///< a quarter turn about x: what was on top is at the back
  tip_forward,  ///< a quarter turn about x: what was on top is at the front
  tip_left,     ///< a quarter turn about y: what was on top is at the left
  tip_right,    ///< a quarter turn about y: what was on top is at the right
};

/// Where the old world lies in the new one, along one axis.
enum class Side : std::uint8_t { low, middle, high };

/// Another size of the world.
struct NewSize {
  int width = 1, height = 1;                  ///< cells
  Side across = Side::low, down = Side::low;  ///< low: what is at the left (top) stays there
  bool blocked = false;                       ///< new cells are obstacles
  int depth = 1;                              ///< layers
  Side up = Side::low;                        ///< low: what is in the lowest layer stays there
  friend bool operator==(const NewSize&, const NewSize&) = default;
};

/// A scenario after a change of size, and what did not fit.
struct Resized {
  Scenario scenario;
  std::size_t cells_lost = 0;               ///< of surprises
  std::vector<std::size_t> surprises_lost;  ///< by their number before: nothing of them was left
  bool ends_moved = false;  ///< the start or a goal was outside and moved to the nearest cell inside
};

/// Where a cell of such a world comes to lie.
Cell turned(Cell cell, const Box& world, Turn turn);
/// The size of such a world then. Tipping may give a plane that is too large for one: see check_world_size().
Box turned_size(const Box& world, Turn turn);
/// Turns the map with start, goal, surprises, the ways of moving obstacles and the camera. In the
/// map's own frame (GridMap::origin) each cell keeps its place when the map is turned about z, and mirrored the map covers
/// the same ground; tipped it has a place no more, only the length of its cells.
Scenario turned(const Scenario& scenario, Turn turn);

/// How far the old world's cells move along each axis.
Cell shift_of(const Box& world, const NewSize& size);
/// Gives the map another size. Start, goal, triggers and ways that would fall off move to the nearest cell;
/// cells of surprises that fall off are dropped. The error names the limits.
Result<Resized> resized(const Scenario& scenario, const NewSize& size);

/// Every cell the other way round, but for `keep_free`, as changes in the order of rows.
std::vector<CellChange> inversion(const GridMap& map, std::span<const Cell> keep_free);

}  // namespace replan
