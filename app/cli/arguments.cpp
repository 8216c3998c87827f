#include "app/cli/arguments.hpp"

#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>

#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/plan/stage.hpp"
#include "core/world/choices.hpp"
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

/// One `--set [PLANNER.]KEY=VALUE`, taken apart.
struct Assignment {
  std::string_view typed, planner, key, value;
};

Result<Assignment> take_apart(std::string_view typed) {
  const std::size_t equals = typed.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return Error{"--set " + std::string(typed) + ": give KEY=VALUE, or PLANNER.KEY=VALUE for one planner"};
  Assignment result{typed, {}, typed.substr(0, equals), typed.substr(equals + 1)};
  if (const std::size_t dot = result.key.find('.'); dot != std::string_view::npos) {
    result.planner = result.key.substr(0, dot);
    result.key = result.key.substr(dot + 1);
  }
  return result;
}

std::string joined(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
  return list;
}

/// Why a setting fits none of the planners of a run.
Error unknown_setting(const Assignment& set, std::span<const PlannerChoice> choices) {
  std::vector<std::string_view> owners, keys;
  for (const PlannerInfo& info : replan::choices())
    if (find_parameter(info.parameters, set.key) != nullptr) owners.push_back(info.id);
  for (const PlannerChoice& choice : choices)
    for (const Parameter& parameter : find_choice(choice.id)->parameters)
      if (std::find(keys.begin(), keys.end(), parameter.key) == keys.end()) keys.push_back(parameter.key);
  const std::string start = "--set " + std::string(set.typed) + ": ";
  if (!owners.empty())
    return {start + "none of the planners here has the setting '" + std::string(set.key) +
            "'; these have: " + joined(owners)};
  return {start + "unknown setting '" + std::string(set.key) + "'" +
          suggestion(set.key, keys, "; known: " + joined(keys))};
}

Result<void> assign(const Assignment& set, std::span<PlannerChoice> choices) {
  bool known = false, present = set.planner.empty();
  for (PlannerChoice& choice : choices) {
    if (!set.planner.empty() && set.planner != choice.id) continue;
    present = true;
    const auto& declared = find_choice(choice.id)->parameters;
    if (find_parameter(declared, set.key) == nullptr) continue;
    known = true;
    if (const auto done = set_from_text(choice.settings, declared, set.key, set.value); !done)
      return Error{"--set " + std::string(set.typed) + ": for planner '" + choice.id + "' " + done.error()};
  }
  if (present && known) return {};
  if (present) return unknown_setting(set, choices);
  if (const auto info = require_choice(set.planner); !info)
    return Error{"--set " + std::string(set.typed) + ": " + info.error()};
  return Error{"--set " + std::string(set.typed) + ": planner '" + std::string(set.planner) +
               "' is not among the planners here; add it with --planner"};
}

/// "STAGE" for all planners, or "PLANNER.STAGE" for one.
Result<void> add_stage(std::string_view typed, std::vector<PlannerChoice>& choices) {
  const std::size_t dot = typed.find('.');
  const std::string_view planner = dot == std::string_view::npos ? "" : typed.substr(0, dot);
  const std::string_view id = dot == std::string_view::npos ? typed : typed.substr(dot + 1);
  const Result<const StageInfo*> stage = require_stage(id);
  if (!stage) return Error{"--stage: " + stage.error()};
  bool added = false;
  for (PlannerChoice& choice : choices) {
    if (!planner.empty() && planner != choice.id) continue;
    choice.stages.push_back({std::string(id), {}});
    added = true;
  }
  if (added) return {};
  if (const auto info = require_choice(planner); !info) return Error{"--stage: " + info.error()};
  return Error{"--stage " + std::string(typed) + ": planner '" + std::string(planner) +
               "' is not among the planners here; add it with --planner"};
}

/// "all" are all that search and can do so in that world; who is named and cannot is refused.
Result<std::vector<PlannerChoice>> chosen(std::span<const std::string> ids,
                                          std::span<const PlannerChoice> own, const GridMap* world) {
  const auto can_plan = [world](const PlannerInfo& info) {
    return world == nullptr ? Result<void>() : fits(info, world->box());
  };
  std::vector<PlannerChoice> result;
  for (const std::string& id : ids) {
    if (id == "all") {
      for (const PlannerInfo& info : sound_planners())
        if (can_plan(info)) result.push_back({std::string(info.id), {}});
      continue;
    }
    const auto info = require_choice(id);
    if (!info) return Error{"--planner: " + info.error()};
    if (const auto can = can_plan(**info); !can) return Error{"--planner: " + can.error()};
    const auto kept =
        std::find_if(own.begin(), own.end(), [&](const PlannerChoice& c) { return c.id == id; });
    result.push_back(kept != own.end() ? *kept : PlannerChoice{id, {}});
  }
  if (ids.empty()) result.assign(own.begin(), own.end());
  if (result.empty())
    return Error{"no planner is named: give --planner ID[,ID...]; 'replan list planners' shows them"};
  return result;
}

/// Of "2.5", in cells, or "0.3m" on a map that says how large its cells are.
Result<double> radius_in_cells(std::string_view typed, const GridMap& map) {
  const MapFrame frame(map);
  const bool in_metres = typed.ends_with('m');
  if (in_metres && !frame.metric())
    return Error{"--radius " + std::string(typed) +
                 " is in metres, but the map does not say how large its cells are: give a number of cells"};
  auto cells = number_from<double>(typed.substr(0, typed.size() - (in_metres ? 1 : 0)));
  if (cells && in_metres) *cells /= frame.metres_per_cell();
  if (cells && *cells >= 0 && *cells <= MoveRules::kMostRadius) return *cells;
  return Error{"--radius cannot be '" + std::string(typed) + "': give a number of cells from 0 to " +
               kMostRadius + (frame.metric() ? ", or metres as 0.3m" : "")};
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

bool same_choice(const Parameter& a, const Parameter& b) {
  return a.key == b.key && a.choices == b.choices && a.help == b.help;
}

std::string values_text(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::toggle:
      return "true|false";
    case ParameterType::choice: {
      std::string list;
      for (const std::string_view choice : parameter.choices)
        list += (list.empty() ? "" : "|") + std::string(choice);
      return list;
    }
    case ParameterType::real:
    case ParameterType::whole:
      break;
  }
  return format_value(parameter, parameter.low) + ".." + format_value(parameter, parameter.high) +
         (parameter.unit.empty() ? "" : " " + std::string(parameter.unit));
}

}  // namespace

void PlannerArguments::declare(CLI::App& command) {
  command
      .add_option("--planner", ids,
                  "Planners to run, or 'all' that search; 'replan list planners' shows them")
      ->type_name("ID[,ID...]")
      ->allow_extra_args(false);
  command
      .add_option("--set", settings,
                  "A setting, for each planner that has it or for the one named (repeatable)")
      ->type_name("[ID.]KEY=VALUE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--stage", stages,
          "What paths go through once they are found, for each planner or for the one named (repeatable); "
          "'replan list stages' shows them")
      ->type_name("[ID.]STAGE")
      ->allow_extra_args(false);
}

Result<std::vector<PlannerChoice>> PlannerArguments::choose(std::span<const PlannerChoice> own,
                                                            const GridMap* world) const {
  auto choices = chosen(split_list(ids), own, world);
  if (!choices) return choices;
  for (const std::string& typed : settings) {
    const auto set = take_apart(typed);
    if (!set) return Error{set.error()};
    if (const auto done = assign(*set, choices.value()); !done) return Error{done.error()};
  }
  for (const std::string& typed : stages)
    if (const auto done = add_stage(typed, choices.value()); !done) return Error{done.error()};
  return choices;
}

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
}

Result<std::optional<double>> ReadingArguments::occupied_number() const {
  if (occupied.empty()) return std::optional<double>();
  const auto number = cell_number(occupied);
  if (number && std::abs(*number) <= kMaxOccupied) return number;
  return Error{"--occupied cannot be '" + occupied +
               "': give the number that stands for an obstacle, for example 1"};
}

Result<MapReading> ReadingArguments::reading() const {
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
  if (unknown.empty()) return result;
  const auto found = std::find(std::begin(kUnknown), std::end(kUnknown), unknown);
  if (found == std::end(kUnknown))
    return Error{"--unknown cannot be '" + unknown + "'" +
                 suggestion(unknown, kUnknown, ": give blocked, free or unmapped")};
  result.unknown = static_cast<UnknownCells>(found - std::begin(kUnknown));
  return result;
}

void WorldArguments::declare(CLI::App& command) {
  command.add_option("SCENARIO", scenario, "A scenario file (.json)");
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
  const auto how = reading.reading();
  if (!how) return Error{how.error()};
  std::vector<Cell> ends;  // a generated map, which is a plane, leaves them free
  for (const auto& [option, text] : {std::pair{"--start", &start}, std::pair{"--goal", &goal}}) {
    if (text->empty() || !is_generator_spec(map)) continue;
    const auto cell = parse_cell(option, *text, false);
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
  if (map.empty() && file_extension(scenario) != ".json")
    return Error{"'" + scenario + "' is no scenario file (.json); give a map with --map FILE"};
  if (map.empty() && reading.given())
    return Error{
        "--threshold, --invert, --unknown and --occupied are for a map; "
        "a scenario says itself how its map is read"};
  Result<Scenario> world = map.empty() ? read_scenario(scenario) : plain_world(*this);
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
  auto choices = planners.choose(world->planners, &world->map);
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

std::string settings_help() {
  constexpr std::size_t kIndent = 6;
  std::string text = "Planner settings (--set):\n";
  std::vector<Parameter> shown;
  for (const PlannerInfo& info : choices())
    for (const Parameter& parameter : info.parameters) {
      const auto again = [&](const Parameter& other) { return same_choice(other, parameter); };
      if (std::any_of(shown.begin(), shown.end(), again)) continue;
      shown.push_back(parameter);
      std::vector<std::string_view> owners, others;
      for (const PlannerInfo& other : choices())
        (std::any_of(other.parameters.begin(), other.parameters.end(), again) ? owners : others)
            .push_back(other.id);
      text += "  " + std::string(parameter.key) + "=" + values_text(parameter) + "  (default " +
              format_value(parameter, parameter.initial) + ")\n" + std::string(kIndent, ' ') +
              wrapped(parameter.help, kIndent) + "\n" + std::string(kIndent, ' ') +
              wrapped(others.empty()       ? "For all planners."
                      : others.size() <= 2 ? "For all planners but " + joined(others) + "."
                                           : "For " + joined(owners) + ".",
                      kIndent) +
              "\n";
    }
  return text;
}

}  // namespace replan::cli
