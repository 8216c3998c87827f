// Worlds out of a seed: the same size, parameters and seed give the same cells on every machine.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// Axis-parallel rectangles, thrown until they cover `fraction` (0 to 0.9) of all cells or no more fits; they
/// may overlap. Sides are drawn from `min_side` to `max_side` cells, no longer than the map's. None covers a
/// cell of `keep_free`. The world of the DLD* Lite paper is 200 x 200 with fraction 0.17 and sides from 5
/// to 15.
Result<GridMap> random_rectangles(int width, int height, double fraction, int min_side, int max_side,
                                  std::uint64_t seed, std::span<const Cell> keep_free = {});

/// Each cell is an obstacle with probability `fraction` (0 to 1), but for the cells of `keep_free`.
Result<GridMap> random_cells(const Box& size, double fraction, std::uint64_t seed,
                             std::span<const Cell> keep_free = {});

/// How a maze is to look.
struct MazeShape {
  int corridor = 1;  ///< width of its corridors in cells
  double braid = 0;  ///< fraction of the dead ends that are opened: 0 a perfect maze, 1 none is left
  double loops = 0;  ///< fraction of the inner walls that are taken out after all
};
/// A maze of corridors between walls one cell thick, with a wall around: exactly one way between any two
/// places unless `braid` or `loops` add some. What is left over at the right and at the bottom is wall. The
/// map must hold at least one place: corridor + 2 cells each way. To cells of `keep_free` that lie in a wall
/// a way is dug.
Result<GridMap> maze(int width, int height, const MazeShape& shape, std::uint64_t seed,
                     std::span<const Cell> keep_free = {});

/// How a floor of rooms is to look.
struct RoomsShape {
  int min_side = 6;    ///< of a room, in cells
  int max_side = 14;   ///< the last room of a row or column may be longer
  int door = 2;        ///< width of the doors, at most min_side
  double loops = 0.3;  ///< fraction of the walls that have a door beyond those needed to reach every room
};
/// Rooms in rows and columns between walls one cell thick, with a wall around and doors at random places of
/// the walls: from every room there is a way to every other. To cells of `keep_free` in a wall a way is dug.
Result<GridMap> rooms(int width, int height, const RoomsShape& shape, std::uint64_t seed,
                      std::span<const Cell> keep_free = {});

/// How caves are to look.
struct CavesShape {
  double fraction = 0.45;  ///< of the cells that are rock at first, 0.3 to 0.6
  int rounds = 5;          ///< of smoothing, 0 to 20: a cell becomes what most of the nine around it are
};
/// Caves by a cellular automaton, rock all around. Of all caves the largest is kept, so that all free cells
/// are joined by straight steps; to cells of `keep_free` in rock a way is dug. That no cave is left is an
/// error.
Result<GridMap> caves(int width, int height, const CavesShape& shape, std::uint64_t seed,
                      std::span<const Cell> keep_free = {});

// Worlds of layers. In each the free cells of `keep_free` are joined by straight steps: where they are not, a way is
// dug to the largest region of free cells.

/// Boxes along the axes, thrown until they cover `fraction` (0 to 0.9) of all cells or no more fits; they may overlap.
/// Sides are drawn from `min_side` to `max_side` cells, no longer than the world's. None covers a cell of `keep_free`.
Result<GridMap> random_boxes(const Box& size, double fraction, int min_side, int max_side, std::uint64_t seed,
                             std::span<const Cell> keep_free = {});

/// How caverns are to look.
struct CavernsShape {
  double fraction = 0.5;  ///< of the cells that are rock at first, 0.4 to 0.6
  int rounds = 5;         ///< of smoothing, 0 to 20: a cell becomes what most of the 27 around it are
};
/// As caves(), in space: the largest cave of a cellular automaton, all of whose cells are joined by straight steps, with
/// rock all around. That no cave is left is an error.
Result<GridMap> caverns(const Box& size, const CavernsShape& shape, std::uint64_t seed,
                        std::span<const Cell> keep_free = {});

/// How a sea floor is to look.
struct SeaFloorShape {
  double relief = 0.8;     ///< fraction of the layers between the deepest valley and the highest peak
  double roughness = 0.5;  ///< how high hills of half the size are beside those of the whole, 0 to 1
  int feature = 32;        ///< how far the largest hills are apart, in cells, from 2
};
/// A floor of fractal value noise (hills, on them hills of half the size, and so on) reckoned in whole numbers. Below it
/// all is rock, above it all is free, as is the highest layer: from every free cell there is a way to every other.
/// Two layers at least.
Result<GridMap> sea_floor(const Box& size, const SeaFloorShape& shape, std::uint64_t seed,
                          std::span<const Cell> keep_free = {});

/// How pillars are to look.
struct PillarsShape {
  double fraction = 0.15;  ///< of the ground that they cover, 0 to 0.9
  int min_side = 3;        ///< the thinnest one's diameter, in cells
  int max_side = 9;        ///< the thickest one's
  double whole = 0.5;      ///< fraction of them that reach the highest layer; the others end somewhere below
};
/// Round pillars that stand on layer 0, until they cover as much of it as wanted or no more fits; they may overlap. None
/// covers a cell of `keep_free`.
Result<GridMap> pillars(const Box& size, const PillarsShape& shape, std::uint64_t seed,
                        std::span<const Cell> keep_free = {});

}  // namespace replan
