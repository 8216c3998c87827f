#include "core/world/generators/list.hpp"

#include <algorithm>

#include "core/world/generators/generators.hpp"
#include "core/world/map_file.hpp"

namespace replan {
namespace {

using enum ParameterType;

constexpr std::string_view kPrefix = "generator:";
// As wide as a map one cell high may be at most. Seeds are whole numbers that a double holds exactly.
constexpr double kLongestSide = static_cast<double>(kMaxCells), kMaxSeed = 0x1p53;
constexpr double kLongestRoom = 8190;
constexpr int kUsualLayers = 32;
constexpr double kMostLayers = 8192;

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

Result<GridMap> make_cells(const GeneratorRequest& r) {
  return random_cells(r.size, r.real("fraction"), r.seed, r.keep_free);
}
Result<GridMap> make_boxes(const GeneratorRequest& r) {
  return random_boxes(r.size, r.real("fraction"), r.whole("min_side"), r.whole("max_side"), r.seed,
                      r.keep_free);
}
Result<GridMap> make_caverns(const GeneratorRequest& r) {
  return caverns(r.size, {r.real("fraction"), r.whole("rounds")}, r.seed, r.keep_free);
}
Result<GridMap> make_sea_floor(const GeneratorRequest& r) {
  return sea_floor(r.size, {r.real("relief"), r.real("roughness"), r.whole("feature")}, r.seed, r.keep_free);
}
Result<GridMap> make_pillars(const GeneratorRequest& r) {
  return pillars(r.size, {r.real("fraction"), r.whole("min_side"), r.whole("max_side"), r.real("whole")},
                 r.seed, r.keep_free);
}
Result<GridMap> make_rectangles(const GeneratorRequest& r) {
  return random_rectangles(r.size.width(), r.size.height(), r.real("fraction"), r.whole("min_side"),
                           r.whole("max_side"), r.seed, r.keep_free);
}
Result<GridMap> make_maze(const GeneratorRequest& r) {
  return maze(r.size.width(), r.size.height(), {r.whole("corridor"), r.real("braid"), r.real("loops")},
              r.seed, r.keep_free);
}
Result<GridMap> make_rooms(const GeneratorRequest& r) {
  return rooms(r.size.width(), r.size.height(),
               {r.whole("min_side"), r.whole("max_side"), r.whole("door"), r.real("loops")}, r.seed,
               r.keep_free);
}
Result<GridMap> make_caves(const GeneratorRequest& r) {
  return caves(r.size.width(), r.size.height(), {r.real("fraction"), r.whole("rounds")}, r.seed, r.keep_free);
}

std::vector<GeneratorInfo> plane_generators() {
  return {
      {"cells",
       "Random cells",
       "Every cell is an obstacle with the same probability.",
       {{.key = "fraction", .label = "Obstacles", .initial = 0.3, .help = "The probability of an obstacle."}},
       make_cells,
       1,
       true},
      {"rectangles",
       "Random rectangles",
       "Rectangles thrown at random until they cover enough; the world of the DLD* Lite paper.",
       {{.key = "fraction",
         .label = "Covered",
         .initial = 0.17,
         .high = 0.9,
         .help = "The fraction of all cells that the rectangles cover."},
        side("min_side", "Shortest side", 5, "The shortest side of a rectangle."),
        side("max_side", "Longest side", 15, "The longest side of a rectangle.")},
       make_rectangles},
      {"maze",
       "Maze",
       "Winding corridors. There is exactly one way between any two places, unless dead ends are opened or "
       "walls removed.",
       {side("corridor", "Corridor", 1, "How wide the corridors are."),
        {.key = "braid",
         .label = "Dead ends opened",
         .help = "The fraction of the dead ends that are opened: 0 for a perfect maze, 1 for none left."},
        loops("Walls removed", 0, "The fraction of the inner walls that are removed.")},
       make_maze},
      {"rooms",
       "Rooms",
       "Rooms in rows and columns with doors, every room within reach.",
       {side("min_side", "Shortest side", 6, "The shortest side of a room."),
        side("max_side", "Longest side", 14, "The longest side of a room; the last of a row may be longer."),
        side("door", "Door", 2, "How wide the doors are, at most the shortest side of a room."),
        loops("Doors beyond those needed", 0.3,
              "The fraction of the walls with a door beyond those needed to reach every room.")},
       make_rooms},
      {"caves",
       "Caves",
       "One winding cave, grown by a cellular automaton.",
       {{.key = "fraction",
         .label = "Rock",
         .initial = 0.45,
         .low = 0.3,
         .high = 0.6,
         .help = "The fraction of the cells that are rock at first."},
        {.key = "rounds",
         .label = "Smoothing",
         .type = whole,
         .initial = 5,
         .high = 20,
         .unit = "rounds",
         .help = "How often a cell becomes what most cells around it are."}},
       make_caves},
  };
}

std::vector<GeneratorInfo> layer_generators() {
  return {
      {"boxes",
       "Boxes",
       "Boxes thrown at random into a world of layers until they cover enough.",
       {{.key = "fraction",
         .label = "Covered",
         .initial = 0.17,
         .high = 0.9,
         .help = "The fraction of all cells that the boxes cover."},
        side("min_side", "Shortest side", 3, "The shortest side of a box."),
        side("max_side", "Longest side", 9, "The longest side of a box.")},
       make_boxes,
       kUsualLayers,
       true},
      {"caverns",
       "Caverns",
       "One cave that winds through all layers, grown by a cellular automaton in space.",
       {{.key = "fraction",
         .label = "Rock",
         .initial = 0.5,
         .low = 0.4,
         .high = 0.6,
         .help = "The fraction of the cells that are rock at first."},
        {.key = "rounds",
         .label = "Smoothing",
         .type = whole,
         .initial = 5,
         .high = 20,
         .unit = "rounds",
         .help = "How often a cell becomes what most of the 27 cells around it are."}},
       make_caverns,
       kUsualLayers,
       true},
      {"sea-floor",
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
       true},
      {"pillars",
       "Pillars",
       "Round pillars on the ground, some up to the highest layer.",
       {{.key = "fraction",
         .label = "Covered",
         .initial = 0.15,
         .high = 0.9,
         .help = "The fraction of the ground that the pillars cover."},
        side("min_side", "Thinnest", 3, "The diameter of the thinnest pillar."),
        side("max_side", "Thickest", 9, "The diameter of the thickest pillar."),
        {.key = "whole",
         .label = "Up to the top",
         .initial = 0.5,
         .help =
             "The fraction of the pillars that reach the highest layer; the others end somewhere below."}},
       make_pillars,
       kUsualLayers,
       true},
  };
}

std::vector<GeneratorInfo> make_list() {
  std::vector<GeneratorInfo> list = plane_generators();
  for (GeneratorInfo& info : layer_generators()) list.push_back(std::move(info));
  return list;
}

std::vector<Parameter> size_parameters(const GeneratorInfo& info) {
  std::vector<Parameter> list(generator_size_parameters().begin(), generator_size_parameters().end());
  if (info.solid) list.push_back(generator_layers_parameter(info));
  return list;
}

/// Takes "key=value&key=value" apart into the generator's own settings and size and seed.
Result<void> read_pairs(std::string_view pairs, const GeneratorInfo& info, Settings& own, Settings& size) {
  std::vector<Parameter> all(info.parameters.begin(), info.parameters.end());
  const std::vector<Parameter> of_sizes = size_parameters(info);
  all.insert(all.end(), of_sizes.begin(), of_sizes.end());
  while (!pairs.empty()) {
    const std::string_view pair = pairs.substr(0, pairs.find('&'));
    pairs.remove_prefix(std::min(pair.size() + 1, pairs.size()));
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos)
      return Error{"'" + std::string(pair) + "' is no setting: give key=value, parted by &"};
    const std::string_view key = pair.substr(0, equals);
    if (own.has(key) || size.has(key)) return Error{"'" + std::string(key) + "' is set twice"};
    const bool of_size = find_parameter(of_sizes, key) != nullptr;
    if (auto set = set_from_text(of_size ? size : own, all, key, pair.substr(equals + 1)); !set) return set;
  }
  return {};
}

}  // namespace

std::span<const GeneratorInfo> generators() {
  static const std::vector<GeneratorInfo> list = make_list();
  return list;
}

std::span<const Parameter> generator_size_parameters() {
  static const std::vector<Parameter> list = {
      {.key = "width",
       .label = "Width",
       .type = whole,
       .initial = 100,
       .low = 1,
       .high = kLongestSide,
       .unit = "cells",
       .help = "Columns of the map; a map has at most 67108864 cells."},
      {.key = "height",
       .label = "Height",
       .type = whole,
       .initial = 100,
       .low = 1,
       .high = kLongestSide,
       .unit = "cells",
       .help = "Rows of the map."},
      {.key = "seed",
       .label = "Seed",
       .type = whole,
       .initial = 1,
       .high = kMaxSeed,
       .help = "The same seed gives the same map on every machine."}};
  return list;
}

Parameter generator_layers_parameter(const GeneratorInfo& info) {
  return {.key = "layers",
          .label = "Layers",
          .type = whole,
          .initial = static_cast<double>(info.layers),
          .low = 1,
          .high = kMostLayers,
          .unit = "cells",
          .help = "Layers of the world; with more than one it has at most 134217728 cells."};
}

Result<const GeneratorInfo*> require_generator(std::string_view id) {
  std::vector<std::string_view> ids;
  std::string list;
  for (const GeneratorInfo& info : generators()) {
    if (info.id == id) return &info;
    ids.push_back(info.id);
    list += (list.empty() ? "" : ", ") + std::string(info.id);
  }
  const std::string_view nearest = nearest_name(id, ids);
  return Error{"unknown generator '" + std::string(id) + "'" +
               (nearest.empty() ? "; known: " + list : "; did you mean '" + std::string(nearest) + "'?")};
}

double GeneratorRequest::real(std::string_view key) const {
  return settings.get(*find_parameter(generator.parameters, key));
}

Result<GridMap> generate(std::string_view id, const Settings& settings, const Box& size, std::uint64_t seed,
                         std::span<const Cell> keep_free) {
  const Result<const GeneratorInfo*> info = require_generator(id);
  if (!info) return Error{info.error()};
  if (size.depth() != 1 && !(*info)->solid)
    return Error{"the generator '" + std::string(id) + "' makes one layer, not " +
                 std::to_string(size.depth())};
  return (*info)->make({**info, settings, size, seed, keep_free});
}

bool is_generator_spec(std::string_view text) {
  return text.starts_with(kPrefix);
}

Result<GridMap> generate_from_spec(std::string_view spec, std::span<const Cell> keep_free) {
  const std::string place = std::string(spec) + ": ";
  if (!is_generator_spec(spec)) return Error{place + "not a generator: it must begin with 'generator:'"};
  const std::string_view rest = spec.substr(kPrefix.size()), id = rest.substr(0, rest.find('?'));
  const Result<const GeneratorInfo*> info = require_generator(id);
  if (!info) return Error{place + info.error()};
  Settings own, size;
  const std::string_view pairs = rest.substr(std::min(id.size() + 1, rest.size()));
  if (const auto read = read_pairs(pairs, **info, own, size); !read) return Error{place + read.error()};
  const auto sized = [&](std::string_view key) {
    return size.get(*find_parameter(generator_size_parameters(), key));
  };
  const double layers = (*info)->solid ? size.get(generator_layers_parameter(**info)) : 1;
  const Box box(static_cast<int>(sized("width")), static_cast<int>(sized("height")),
                static_cast<int>(layers));
  Result<GridMap> map = generate(id, own, box, static_cast<std::uint64_t>(sized("seed")), keep_free);
  if (!map) return Error{place + map.error()};
  return map;
}

Result<MapFile> open_map(const std::string& source, const MapReading& reading,
                         std::span<const Cell> keep_free) {
  if (!is_generator_spec(source)) return read_map_file(source, reading);
  Result<GridMap> map = generate_from_spec(source, keep_free);
  if (!map) return Error{map.error()};
  return MapFile{std::move(map.value())};
}

}  // namespace replan
