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
Result<GridMap> random_cells(int width, int height, double fraction, std::uint64_t seed,
                             std::span<const Cell> keep_free = {});

/// A maze of corridors `corridor` cells wide between walls one cell thick, with a wall around: exactly one
/// way between any two places, and `knock_out` (0 to 1) of the inner walls taken out afterwards, so that
/// there are more. What is left over at the right and at the bottom is wall. The map must hold at least one
/// place: corridor + 2 cells each way.
Result<GridMap> maze(int width, int height, int corridor, std::uint64_t seed, double knock_out = 0);

}  // namespace replan
