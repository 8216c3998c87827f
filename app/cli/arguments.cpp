#include "app/cli/arguments.hpp"

#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>

#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/lattice/lattice.hpp"
#include "core/world/formats/number_cells.hpp"
#include "core/world/formats/text_lines.hpp"
#include "core/world/generators/list.hpp"
#include "core/world/map_file.hpp"
#include "core/world/map_frame.hpp"

namespace replan::cli {
namespace {

/// In the order of UnreachableGoal.
constexpr std::string_view kUnreachableGoals[] = {"wait", "nearest"};
const std::string kMostRadius = std::to_string(static_cast<int>(MoveRules::kMostRadius));

/// Of "2.5", in cells, or "0.3m".
Result<double> radius_in_cells(std::string_view typed, const GridMap& map) {
  auto cells = number_from<double>(typed);
  if (const auto metres = typed_metres(typed)) {
    const auto converted = metres_in_cells("--radius " + std::string(typed), *metres, map);
    if (!converted) return converted;
    cells = *converted;
  }
  if (cells && *cells >= 0 && *cells <= MoveRules::kMostRadius) return *cells;
  return Error{"--radius cannot be '" + std::string(typed) + "': give a number of cells from 0 to " +
               kMostRadius + (MapFrame(map).metric() ? ", or metres as 0.3m" : "")};
}

/// The world on a map, whose start and goal must be given or stand in its file.
Result<Scenario> plain_world(const WorldArguments& arguments) {
  Result<MapFile> file = arguments.load_map();
  if (!file) return Error{file.error()};
  for (const auto& [option, cell] : {std::pair{"--start", &file->start}, std::pair{"--goal", &file->goal}})
    if (!cell->has_value())
      return Error{std::string(option) + " is missing: give " + option + " " + cell_wanted(file->map.box())};
  Scenario world;
  world.map = std::move(file->map);
  world.start = *file->start;
  world.goal = *file->goal;
  world.map_found = std::move(file->found);
  world.name = is_generator_spec(arguments.map) ? arguments.map : file_stem(arguments.map);
  return world;
}

/// The world of a link; what is not known of the link is told.
Result<Scenario> linked_world(const std::string& text) {
  Result<Link> link = parse_link(text);
  if (!link) return Error{link.error()};
  tell_notes(link->notes);
  return std::move(link->scenario);
}

}  // namespace

void ReadingArguments::declare(CLI::App& command) {
  command
      .add_option("--threshold", threshold,
                  "Of a picture: pixels darker than this, 1 to 255, are obstacles (128)")
      ->type_name("N");
  command.add_flag("--invert", invert, "Of a picture: bright pixels are obstacles instead");
  command
      .add_option(
          "--unknown", unknown,
          "Of a ROS map: what unknown cells are: blocked (default), free, or unmapped, which are obstacles "
          "that the robot does not know of")
      ->type_name("WHAT");
  command
      .add_option("--occupied", occupied,
                  "Of a file of numbers: the one that is the obstacle (default: 1, or of 0 and another "
                  "number that one)")
      ->type_name("VALUE");
  command.add_flag(
      "--height-map", height_map,
      "Of a picture: it is a height map, white is high (with --invert black), and becomes a world of "
      "layers, as a grid of heights (.asc) always does");
  command
      .add_option("--layers", layers,
                  "Of heights: how many layers there are, " + std::to_string(kLeastHeightLayers) + " to " +
                      std::to_string(kMostHeightLayers) + " (64)")
      ->type_name("N");
  command
      .add_option("--heights", heights,
                  "Of heights: the lowest and the highest of the layers (default: the deepest place, and sea "
                  "level or, "
                  "with nothing below it, the highest place); of a picture 0, black, to 255, white")
      ->type_name("LOW,HIGH");
  command
      .add_option(
          "--reduce", reduce,
          "Of heights: so many columns each way are read as one (default: as few as there is room for)")
      ->type_name("N");
}

Result<HeightReading> ReadingArguments::height_reading() const {
  HeightReading reading;
  if (!layers.empty()) {
    const auto count = number_from<int>(layers).value_or(0);
    if (count < kLeastHeightLayers || count > kMostHeightLayers)
      return Error{"--layers cannot be '" + layers + "': give a whole number from " +
                   std::to_string(kLeastHeightLayers) + " to " + std::to_string(kMostHeightLayers)};
    reading.layers = count;
  }
  if (!heights.empty()) {
    const std::string_view typed = heights;
    const std::size_t comma = std::min(typed.find(','), typed.size());
    const auto low = number_from<double>(typed.substr(0, comma)),
               high = number_from<double>(typed.substr(std::min(comma + 1, typed.size())));
    if (!low || !high || !(*low < *high) || std::abs(*low) > kMaxHeight || std::abs(*high) > kMaxHeight)
      return Error{"--heights cannot be '" + heights +
                   "': give the lower and the higher one, such as -4000,0"};
    reading.low = *low;
    reading.high = *high;
  }
  if (reduce.empty()) return reading;
  reading.reduce = number_from<int>(reduce).value_or(0);
  if (reading.reduce >= 1 && reading.reduce <= kMostReduced) return reading;
  return Error{"--reduce cannot be '" + reduce + "': give a whole number from 1 to " +
               std::to_string(kMostReduced)};
}

Result<std::optional<double>> ReadingArguments::occupied_number() const {
  if (occupied.empty()) return std::optional<double>();
  const auto number = cell_number(occupied);
  if (number && std::abs(*number) <= kMaxOccupied) return number;
  return Error{"--occupied cannot be '" + occupied +
               "': give the number that stands for an obstacle, for example 1"};
}

Result<MapReading> ReadingArguments::reading(const std::string& file) const {
  constexpr std::string_view kUnknown[] = {"blocked", "free", "unmapped"};
  MapReading result;
  result.image.invert = invert;
  const auto number = threshold.empty() ? result.image.threshold : number_from<int>(threshold).value_or(0);
  if (number < 1 || number > 255)
    return Error{"--threshold cannot be '" + threshold + "': give a whole number from 1 to 255"};
  result.image.threshold = number;
  const auto obstacle = occupied_number();
  if (!obstacle) return Error{obstacle.error()};
  result.occupied = *obstacle;
  if (of_heights()) {
    const MapFormat* format = find_map_format(file);
    if (!height_map && format != nullptr && format->picture)
      return Error{"'" + file +
                   "' is a picture, which is a height map only with --height-map: give it too, or leave out "
                   "--layers, --heights and --reduce"};
    const auto heights_read = height_reading();
    if (!heights_read) return Error{heights_read.error()};
    result.heights = *heights_read;
  }
  if (unknown.empty()) return result;
  const auto found = std::find(std::begin(kUnknown), std::end(kUnknown), unknown);
  if (found == std::end(kUnknown))
    return Error{"--unknown cannot be '" + unknown + "'" +
                 suggestion(unknown, kUnknown, ": give blocked, free or unmapped")};
  result.unknown = static_cast<UnknownCells>(found - std::begin(kUnknown));
  return result;
}

Result<void> ReadingArguments::check_unused_by(const std::string& source) const {
  if (!given()) return {};
  const std::string options =
      "options that say how a map is read (--threshold, --invert, --unknown, --occupied, --height-map, "
      "--layers, --heights, --reduce) are for a map";
  if (!is_generator_spec(source)) return Error{options + "; a scenario says itself how its map is read"};
  const bool told = source.find("layers=") != std::string::npos;
  const std::string before = told ? "" : source.find('?') == std::string::npos ? "?" : "&";
  return Error{
      options + " file, and a generator has settings of its own: " +
      (layers.empty() ? "leave them out" : "say " + before + "layers=" + layers + " in the generator")};
}

void WorldArguments::declare(CLI::App& command) {
  command.add_option("SCENARIO", scenario,
                     "A scenario file (.json), or a link to a moment of one, in quotes");
  command
      .add_option("--map", map,
                  "A map instead: " + map_extensions(MapUse::read) +
                      ", or generator:ID?KEY=VALUE&... ('replan list generators')")
      ->type_name("FILE");
  command
      .add_option("--start", start, "Where the robot starts: a cell, or metres in the map's frame (1.5m,2m)")
      ->type_name("X,Y[,Z]");
  command.add_option("--goal", goal, "Where it is to go, likewise")->type_name("X,Y[,Z]");
  command
      .add_option("--unreachable-goal", unreachable_goal,
                  "What it does where the goal cannot be reached: wait, or nearest: go to the reachable cell "
                  "nearest to it")
      ->type_name("WHAT");
  command.add_option("--robot", robot, "The kind of robot; 'replan list robots' shows them")
      ->type_name("KIND");
  command
      .add_option("--radius", radius,
                  "The radius of its body in cells, 0 to " + kMostRadius +
                      ", or in metres of the map's (0.3m)" +
                      ": its centre keeps so far away from obstacles (0: a point)")
      ->type_name("CELLS");
  reading.declare(command);
  planners.declare(command);
}

Result<MapFile> WorldArguments::load_map() const {
  if (is_generator_spec(map))
    if (const auto unused = reading.check_unused_by(map); !unused) return Error{unused.error()};
  const auto how = reading.reading(map);
  if (!how) return Error{how.error()};
  std::vector<Cell> ends;  // a generated map leaves them free
  for (const auto& [option, text] : {std::pair{"--start", &start}, std::pair{"--goal", &goal}}) {
    if (text->empty() || !is_generator_spec(map)) continue;
    const auto cell = parse_cell(option, *text, std::count(text->begin(), text->end(), ',') > 1);
    if (!cell) return Error{cell.error()};
    ends.push_back(*cell);
  }
  Result<MapFile> file = open_map(map, *how, ends);
  if (!file) return file;
  for (const auto& [option, text, cell] :
       {std::tuple{"--start", &start, &file->start}, std::tuple{"--goal", &goal, &file->goal}}) {
    if (text->empty()) continue;
    const auto given = parse_cell_in(file->map, option, *text, "the map " + map);
    if (!given) return Error{given.error()};
    *cell = *given;
  }
  return file;
}

Result<Scenario> WorldArguments::load() const {
  if (scenario.empty() == map.empty())
    return Error{scenario.empty()
                     ? "no world is named: give a scenario file, or --map FILE with --start and --goal"
                     : "give either a scenario file or --map, not both"};
  if (map.empty() && !is_link() && file_extension(scenario) != ".json")
    return Error{"'" + scenario + "' is no scenario file (.json); give a map with --map FILE"};
  if (map.empty())
    if (const auto unused = reading.check_unused_by(scenario); !unused) return Error{unused.error()};
  Result<Scenario> world = !map.empty() ? plain_world(*this)
                           : is_link()  ? linked_world(scenario)
                                        : read_scenario(scenario);
  if (!world) return world;
  for (const auto& [option, text, cell] :
       {std::tuple{"--start", &start, &world->start}, std::tuple{"--goal", &goal, &world->goal}}) {
    if (!map.empty() || text->empty()) continue;
    const auto given = parse_cell_in(world->map, option, *text, "the map " + source());
    if (!given) return Error{given.error()};
    *cell = *given;
  }
  if (!unreachable_goal.empty()) {
    const auto found =
        std::find(std::begin(kUnreachableGoals), std::end(kUnreachableGoals), unreachable_goal);
    if (found == std::end(kUnreachableGoals))
      return Error{"--unreachable-goal cannot be '" + unreachable_goal + "'" +
                   suggestion(unreachable_goal, kUnreachableGoals, ": give wait or nearest")};
    world->robot.unreachable_goal = static_cast<UnreachableGoal>(found - std::begin(kUnreachableGoals));
  }
  if (!robot.empty()) {
    if (const auto known = require_robot(robot, world->map.box()); !known)
      return Error{"--robot: " + known.error()};
    world->robot.kind = robot;
  }
  if (!radius.empty()) {
    const auto cells = radius_in_cells(radius, world->map);
    if (!cells) return Error{cells.error()};
    world->robot.radius = *cells;
  }
  auto choices = planners.choose(world->planners, &world->map, world->robot.radius);
  if (!choices) return Error{choices.error()};
  world->planners = std::move(choices.value());
  return world;
}

Result<std::int64_t> parse_count(std::string_view option, std::string_view text, std::int64_t low) {
  const auto value = number_from<std::int64_t>(text);
  if (value && *value >= low) return *value;
  return Error{std::string(option) + " cannot be '" + std::string(text) + "': give a whole number from " +
               std::to_string(low)};
}

std::optional<double> typed_metres(std::string_view typed) {
  return typed.ends_with('m') ? number_from<double>(typed.substr(0, typed.size() - 1)) : std::nullopt;
}

Result<double> metres_in_cells(std::string_view what, double metres, const GridMap& map) {
  const MapFrame frame(map);
  if (frame.metric()) return metres / frame.metres_per_cell();
  return Error{std::string(what) +
               " is in metres, but the map does not say how large its cells are: give a number of cells"};
}

std::vector<std::string> split_list(std::span<const std::string> texts) {
  std::vector<std::string> parts;
  for (std::string_view text : texts)
    while (!text.empty()) {
      const std::size_t comma = std::min(text.find(','), text.size());
      if (comma > 0) parts.emplace_back(text.substr(0, comma));
      text.remove_prefix(std::min(comma + 1, text.size()));
    }
  return parts;
}

std::string suggestion(std::string_view name, std::span<const std::string_view> names,
                       std::string_view otherwise) {
  const std::string_view nearest = nearest_name(name, names);
  return nearest.empty() ? std::string(otherwise) : "; did you mean '" + std::string(nearest) + "'?";
}

}  // namespace replan::cli
