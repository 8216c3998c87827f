// The worlds that planners are measured on.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/base/cell.hpp"
#include "core/world/generators/generators.hpp"
#include "core/world/scenario.hpp"

namespace replan {

namespace bench {
// Called by main(): planners and their parameters are not there yet while the program's constants are made.
void register_plans();
void register_checks();
void register_sight();
void register_voxels();
}  // namespace bench

/// Some worlds of one kind, and where to go in them.
struct Worlds {
  std::string name;
  Cell start, goal;
  std::vector<GridMap> maps;
};

/// A first plan across random rectangles, as large as wished.
inline Scenario big_scenario(const char* planner, int size) {
  Scenario scenario;
  const Cell ends[] = {{20, 20}, {size - 20, size - 20}};
  scenario.map = *random_rectangles(size, size, 0.17, 5, 60, 1, ends);
  scenario.start = ends[0];
  scenario.goal = ends[1];
  scenario.planners = {{planner, {}}};
  return scenario;
}

/// The DLD* Lite paper's kind (ten maps of random rectangles, Fig. 5), its narrow mazes (Fig. 7), where it
/// names the sight checks an open problem, and open ground, where they are long.
inline const std::vector<Worlds>& all_worlds() {
  static const auto worlds = [] {
    Worlds rectangles{"rectangles", {15, 15}, {175, 175}, {}};
    const std::array<Cell, 2> free = {rectangles.start, rectangles.goal};
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
      rectangles.maps.push_back(*random_rectangles(200, 200, 0.17, 5, 15, seed, free));
    Worlds narrow{
        "maze_1", {1, 1}, {499, 499}, {*maze(501, 501, {.corridor = 1, .braid = 0, .loops = 0.1}, 1)}};
    Worlds wide{
        "maze_7", {4, 4}, {493, 493}, {*maze(497, 497, {.corridor = 7, .braid = 0, .loops = 0.1}, 1)}};
    // Open ground, where rays are long.
    Worlds empty{"empty_2048", {1, 1}, {2046, 2000}, {GridMap(2048, 2048)}};
    Worlds field{"field_60000x40", {1, 20}, {59998, 25}, {GridMap(60000, 40)}};
    return std::vector<Worlds>{rectangles, narrow, wide, empty, field};
  }();
  return worlds;
}

/// Those of the paper's kinds alone.
inline std::span<const Worlds> paper_worlds() {
  return std::span(all_worlds()).first(3);
}

}  // namespace replan
