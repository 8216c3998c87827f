// Each generator with all its parameters.
#include "core/world/generators/kinds.hpp"

#include "core/world/generators/generators.hpp"

namespace replan {
namespace {

using enum ParameterType;

constexpr double kLongestRoom = 8190;
constexpr int kUsualLayers = 32;

Parameter loops(std::string_view label, double initial, std::string_view help) {
  return {.key = "loops", .label = label, .initial = initial, .help = help};
}
Parameter side(std::string_view key, std::string_view label, double initial, std::string_view help) {
  return {.key = key,
          .label = label,
          .type = whole,
          .initial = initial,
          .low = 1,
          .high = kLongestRoom,
          .unit = "cells",
          .help = help};
}
/// How much of a world things that are thrown into it cover.
Parameter covered(double initial, std::string_view help) {
  return {.key = "fraction", .label = "Covered", .initial = initial, .high = 0.9, .help = help};
}
/// What caves are grown from, and how often.
Parameter rock(double initial, double low) {
  return {.key = "fraction",
          .label = "Rock",
          .initial = initial,
          .low = low,
          .high = 0.6,
          .help = "The fraction of the cells that are rock at first."};
}
Parameter smoothing(std::string_view help) {
  return {.key = "rounds",
          .label = "Smoothing",
          .type = whole,
          .initial = 5,
          .high = 20,
          .unit = "rounds",
          .help = help};
}

Result<GridMap> make_cells(const GeneratorRequest& r) {
  return random_cells(r.size, r.real("fraction"), r.seed, r.keep_free);
}
GeneratorInfo cells_kind() {
  return {
      "cells",
      "Random cells",
      "Every cell is an obstacle with the same probability.",
      {{.key = "fraction", .label = "Obstacles", .initial = 0.3, .help = "The probability of an obstacle."}},
      make_cells,
      1,
      true};
}

Result<GridMap> make_rectangles(const GeneratorRequest& r) {
  return random_rectangles(r.size.width(), r.size.height(), r.real("fraction"), r.whole("min_side"),
                           r.whole("max_side"), r.seed, r.keep_free);
}
GeneratorInfo rectangles_kind() {
  return {"rectangles",
          "Random rectangles",
          "Rectangles thrown at random until they cover enough; the world of the DLD* Lite paper.",
          {covered(0.17, "The fraction of all cells that the rectangles cover."),
           side("min_side", "Shortest side", 5, "The shortest side of a rectangle."),
           side("max_side", "Longest side", 15, "The longest side of a rectangle.")},
          make_rectangles};
}

Result<GridMap> make_maze(const GeneratorRequest& r) {
  return maze(r.size.width(), r.size.height(), {r.whole("corridor"), r.real("braid"), r.real("loops")},
              r.seed, r.keep_free);
}
GeneratorInfo maze_kind() {
  return {
      "maze",
      "Maze",
      "Winding corridors. There is exactly one way between any two places, unless dead ends are opened or "
      "walls removed.",
      {side("corridor", "Corridor", 1, "How wide the corridors are."),
       {.key = "braid",
        .label = "Dead ends opened",
        .help = "The fraction of the dead ends that are opened: 0 for a perfect maze, 1 for none left."},
       loops("Walls removed", 0, "The fraction of the inner walls that are removed.")},
      make_maze};
}

Result<GridMap> make_rooms(const GeneratorRequest& r) {
  return rooms(r.size.width(), r.size.height(),
               {r.whole("min_side"), r.whole("max_side"), r.whole("door"), r.real("loops")}, r.seed,
               r.keep_free);
}
GeneratorInfo rooms_kind() {
  return {
      "rooms",
      "Rooms",
      "Rooms in rows and columns with doors, every room within reach.",
      {side("min_side", "Shortest side", 6, "The shortest side of a room."),
       side("max_side", "Longest side", 14, "The longest side of a room; the last of a row may be longer."),
       side("door", "Door", 2, "How wide the doors are, at most the shortest side of a room."),
       loops("Doors beyond those needed", 0.3,
             "The fraction of the walls with a door beyond those needed to reach every room.")},
      make_rooms};
}

Result<GridMap> make_caves(const GeneratorRequest& r) {
  return caves(r.size.width(), r.size.height(), {r.real("fraction"), r.whole("rounds")}, r.seed, r.keep_free);
}
GeneratorInfo caves_kind() {
  return {"caves",
          "Caves",
          "One winding cave, grown by a cellular automaton.",
          {rock(0.45, 0.3), smoothing("How often a cell becomes what most cells around it are.")},
          make_caves};
}

Result<GridMap> make_boxes(const GeneratorRequest& r) {
  return random_boxes(r.size, r.real("fraction"), r.whole("min_side"), r.whole("max_side"), r.seed,
                      r.keep_free);
}
GeneratorInfo boxes_kind() {
  return {"boxes",
          "Boxes",
          "Boxes thrown at random into a world of layers until they cover enough.",
          {covered(0.17, "The fraction of all cells that the boxes cover."),
           side("min_side", "Shortest side", 3, "The shortest side of a box."),
           side("max_side", "Longest side", 9, "The longest side of a box.")},
          make_boxes,
          kUsualLayers,
          true};
}

Result<GridMap> make_caverns(const GeneratorRequest& r) {
  return caverns(r.size, {r.real("fraction"), r.whole("rounds")}, r.seed, r.keep_free);
}
GeneratorInfo caverns_kind() {
  return {"caverns",
          "Caverns",
          "One cave that winds through all layers, grown by a cellular automaton in space.",
          {rock(0.5, 0.4), smoothing("How often a cell becomes what most of the 27 cells around it are.")},
          make_caverns,
          kUsualLayers,
          true};
}

Result<GridMap> make_sea_floor(const GeneratorRequest& r) {
  return sea_floor(r.size, {r.real("relief"), r.real("roughness"), r.whole("feature")}, r.seed, r.keep_free);
}
GeneratorInfo sea_floor_kind() {
  return {
      "sea-floor",
      "Sea floor",
      "Hills and valleys below open water, as rough as one likes; the highest layer is free.",
      {{.key = "relief",
        .label = "Relief",
        .initial = 0.8,
        .help = "The fraction of the layers between the deepest valley and the highest peak."},
       {.key = "roughness",
        .label = "Roughness",
        .initial = 0.5,
        .help =
            "How high hills of half the size are beside those of the whole: 0 gives soft hills, 1 rubble."},
       {.key = "feature",
        .label = "Largest hills",
        .type = whole,
        .initial = 32,
        .low = 2,
        .high = kLongestRoom,
        .unit = "cells",
        .help = "How far the largest hills are apart."}},
      make_sea_floor,
      kUsualLayers,
      true};
}

Result<GridMap> make_pillars(const GeneratorRequest& r) {
  return pillars(r.size, {r.real("fraction"), r.whole("min_side"), r.whole("max_side"), r.real("whole")},
                 r.seed, r.keep_free);
}
GeneratorInfo pillars_kind() {
  return {
      "pillars",
      "Pillars",
      "Round pillars on the ground, some up to the highest layer.",
      {covered(0.15, "The fraction of the ground that the pillars cover."),
       side("min_side", "Thinnest", 3, "The diameter of the thinnest pillar."),
       side("max_side", "Thickest", 9, "The diameter of the thickest pillar."),
       {.key = "whole",
        .label = "Up to the top",
        .initial = 0.5,
        .help = "The fraction of the pillars that reach the highest layer; the others end somewhere below."}},
      make_pillars,
      kUsualLayers,
      true};
}

}  // namespace

std::vector<GeneratorInfo> generator_kinds() {
  return {cells_kind(), rectangles_kind(), maze_kind(),      rooms_kind(),  caves_kind(),
          boxes_kind(), caverns_kind(),    sea_floor_kind(), pillars_kind()};
}

}  // namespace replan
