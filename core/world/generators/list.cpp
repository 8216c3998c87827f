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
  return random_cells(r.width, r.height, r.real("fraction"), r.seed, r.keep_free);
}
Result<GridMap> make_rectangles(const GeneratorRequest& r) {
  return random_rectangles(r.width, r.height, r.real("fraction"), r.whole("min_side"), r.whole("max_side"),
                           r.seed, r.keep_free);
}
Result<GridMap> make_maze(const GeneratorRequest& r) {
  return maze(r.width, r.height, {r.whole("corridor"), r.real("braid"), r.real("loops")}, r.seed,
              r.keep_free);
}
Result<GridMap> make_rooms(const GeneratorRequest& r) {
  return rooms(r.width, r.height,
               {r.whole("min_side"), r.whole("max_side"), r.whole("door"), r.real("loops")}, r.seed,
               r.keep_free);
}
Result<GridMap> make_caves(const GeneratorRequest& r) {
  return caves(r.width, r.height, {r.real("fraction"), r.whole("rounds")}, r.seed, r.keep_free);
}

std::vector<GeneratorInfo> make_list() {
  return {
      {"cells",
       "Random cells",
       "Every cell is an obstacle with the same probability.",
       {{.key = "fraction", .label = "Obstacles", .initial = 0.3, .help = "The probability of an obstacle."}},
       make_cells},
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

/// Takes "key=value&key=value" apart into the generator's own settings and size and seed.
Result<void> read_pairs(std::string_view pairs, const GeneratorInfo& info, Settings& own, Settings& size) {
  std::vector<Parameter> all(info.parameters.begin(), info.parameters.end());
  all.insert(all.end(), generator_size_parameters().begin(), generator_size_parameters().end());
  while (!pairs.empty()) {
    const std::string_view pair = pairs.substr(0, pairs.find('&'));
    pairs.remove_prefix(std::min(pair.size() + 1, pairs.size()));
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos)
      return Error{"'" + std::string(pair) + "' is no setting: give key=value, parted by &"};
    const std::string_view key = pair.substr(0, equals);
    if (own.has(key) || size.has(key)) return Error{"'" + std::string(key) + "' is set twice"};
    const bool of_size = find_parameter(generator_size_parameters(), key) != nullptr;
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

Result<GridMap> generate(std::string_view id, const Settings& settings, int width, int height,
                         std::uint64_t seed, std::span<const Cell> keep_free) {
  const Result<const GeneratorInfo*> info = require_generator(id);
  if (!info) return Error{info.error()};
  return (*info)->make({**info, settings, width, height, seed, keep_free});
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
  Result<GridMap> map = generate(id, own, static_cast<int>(sized("width")), static_cast<int>(sized("height")),
                                 static_cast<std::uint64_t>(sized("seed")), keep_free);
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
