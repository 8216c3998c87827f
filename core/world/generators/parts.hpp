// What several generators share.
#pragma once

#include <span>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/random.hpp"
#include "core/base/result.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// Whether `fraction` lies between `low` and `high`; `name` begins the error.
Result<void> check_fraction(const char* name, double fraction, double low, double high);

/// A way from a place of a grid of places to the next one, a step to one of the four sides.
struct Passage {
  Cell place, step;
};
/// Passages that join all columns x rows places by exactly one way between any two: a random walk that turns
/// back where it is stuck, so the ways are long and winding.
std::vector<Passage> random_tree(int columns, int rows, Random& random);

/// Fills what of the free cells cannot be reached from the largest region of them, by straight steps. False if there
/// are none.
bool keep_largest_region(GridMap& map);
/// Sets `cells` free and digs from each, straight steps only, to the largest region of free cells, which stays one; in an
/// all but empty world those that are dug are it.
void dig_to_largest_region(GridMap& map, std::span<const Cell> cells);

/// Sets `cells` free and digs from each to the nearest free cell, straight steps only.
void dig_to_open(GridMap& map, std::span<const Cell> cells);

}  // namespace replan
