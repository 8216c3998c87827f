#include <algorithm>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/lattice/box_words.hpp"
#include "core/study/run_report.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/formats/voxel_map.hpp"
#include "core/world/generators/list.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"

namespace replan::cli {
namespace {

/// The planner of a scenario for which none is named.
constexpr const char* kUsualPlanner = "dstar-lite";

struct ConvertArguments {
  std::string in;
  std::string out;
  std::string slice;
  WorldArguments world;
};

std::string described(const GridMap& map) {
  const auto obstacles =
      std::count_if(map.blocked.begin(), map.blocked.end(), [](auto cell) { return cell != 0; });
  return size_text(map.box()) + ", " + counted(obstacles, "obstacle");
}

int done(const ConvertArguments& arguments, const std::string& what, std::span<const std::string> notes) {
  print("wrote " + arguments.out + ": " + what + "\n");
  for (const std::string& note : notes) print("note: " + note + "\n");
  return kDone;
}

/// Writes the one problem that a start and a goal are, with the length of a shortest path.
Result<int> write_problem(const ConvertArguments& arguments, const MapFile& file,
                          std::span<const std::string> notes) {
  const std::string stem = file_stem(arguments.out);
  const bool from_file = !is_generator_spec(arguments.in) && find_map_format(arguments.in) != nullptr;
  const std::string map_name = stem.ends_with(".map") ? stem : file_name(arguments.in);
  if (!stem.ends_with(".map") && !from_file)
    return Error{"a .scen names the map that it is for: call it NAME.map.scen, and make NAME.map too"};
  if (!file.start || !file.goal)
    return Error{"a .scen is a list of problems with start and goal: give --start X,Y and --goal X,Y"};
  const RunReport plan = plan_once(file.map, *file.start, *file.goal, {"astar", {}});
  if (!plan.succeeded()) {
    complain("no path leads from start to goal, so there is no problem to write to " + arguments.out);
    return kFailed;
  }
  ScenProblem problem;
  problem.bucket = static_cast<int>(plan.figures.length / 4);
  problem.width = file.map.width;
  problem.height = file.map.height;
  problem.start = *file.start;
  problem.goal = *file.goal;
  problem.printed = decimals(plan.figures.length, 8);
  if (map_name.find_first_of("\t\r\n") != std::string::npos)
    return Error{"a .scen cannot name the map '" + map_name + "': its name holds a tab or a line's end"};
  const ScenFile scen{.path = arguments.out, .map_name = map_name, .problems = {problem}, .lengths = {}};
  if (const auto written = write_file_atomically(arguments.out, scen_text(scen)); !written)
    return Error{written.error()};
  return done(arguments, "1 problem of length " + problem.printed + " on " + map_name, notes);
}

Result<int> write_as_map(const ConvertArguments& arguments, const MapFile& file,
                         std::vector<std::string> notes) {
  const std::string extension = file_extension(arguments.out);
  if (file.map.depth > 1 && extension != ".3dmap")
    return Error{"'" + arguments.in + "' has three dimensions: give --slice Z with Z from 0 to " +
                 std::to_string(file.map.depth - 1)};
  if (extension == ".scen") return write_problem(arguments, file, notes);
  if (const auto written = write_map_file(file, arguments.out); !written) return Error{written.error()};
  return done(arguments, described(file.map), notes);
}

/// A map becomes a map, or a scenario on it.
Result<int> from_map(ConvertArguments& arguments) {
  arguments.world.map = arguments.in;
  const auto file = arguments.world.load_map();
  if (!file) return Error{file.error()};
  const std::string extension = file_extension(arguments.out);
  std::vector<std::string> notes = file->found.notes;
  const auto lost = lost_in(extension, *file);
  notes.insert(notes.end(), lost.begin(), lost.end());
  if (extension != ".json") {
    if (!arguments.world.planners.ids.empty() || !arguments.world.planners.settings.empty())
      return Error{"--planner and --set are for a scenario (.json), not for '" + arguments.out + "'"};
    return write_as_map(arguments, *file, notes);
  }
  if (arguments.world.planners.ids.empty()) arguments.world.planners.ids = {kUsualPlanner};
  const auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  if (const auto written = write_scenario(*world, arguments.out); !written) return Error{written.error()};
  return done(
      arguments,
      described(world->map) + ", " + counted(static_cast<std::int64_t>(world->planners.size()), "planner"),
      notes);
}

/// A scenario becomes a map, which is all that a map can hold of it, or a scenario with its map inside.
Result<int> from_scenario(ConvertArguments& arguments) {
  arguments.world.scenario = arguments.in;
  auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  world->map_file.clear();
  world->map_reading = {};
  const std::string extension = file_extension(arguments.out);
  std::vector<std::string> notes = world->map_found.notes;
  const auto lost = lost_in(extension, *world);
  notes.insert(notes.end(), lost.begin(), lost.end());
  if (extension != ".json")
    return write_as_map(arguments, {world->map, world->start, world->goal, world->map_found}, notes);
  if (const auto written = write_scenario(*world, arguments.out); !written) return Error{written.error()};
  return done(arguments, described(world->map) + ", the map inside", notes);
}

/// One plane of a box of voxels becomes a map.
Result<int> from_slice(ConvertArguments& arguments) {
  const bool in_scenario = !is_generator_spec(arguments.in) && file_extension(arguments.in) == ".json";
  if (in_scenario)
    if (const auto unused = arguments.world.reading.check_unused_by(arguments.in); !unused)
      return Error{unused.error()};
  auto scenario = in_scenario ? read_scenario(arguments.in) : Scenario{};
  if (!scenario) return Error{scenario.error()};
  arguments.world.map = arguments.in;
  auto file = in_scenario ? Result<MapFile>(MapFile{std::move(scenario->map)}) : arguments.world.load_map();
  if (!file) return Error{file.error()};
  const GridMap& voxels = file->map;
  if (voxels.depth <= 1 && file_extension(arguments.in) != ".3dmap")
    return Error{"--slice is for a world of several layers, and '" + arguments.in + "' has one"};
  const auto z = parse_count("--slice", arguments.slice, 0);
  if (!z) return Error{z.error()};
  auto slice = voxel_slice(voxels, static_cast<int>(std::min<std::int64_t>(*z, kMaxVoxels)));
  if (!slice) return Error{"--slice " + arguments.slice + ": " + slice.error()};
  const std::string extension = file_extension(arguments.out);
  if (extension == ".json" || extension == ".scen")
    return Error{"a slice becomes a map, not a scenario: convert it to .map first, then that one"};
  return write_as_map(arguments, {std::move(slice.value())}, file->found.notes);
}

Result<int> convert(ConvertArguments& arguments) {
  const bool generated = is_generator_spec(arguments.in);
  const std::string extension = generated ? "" : file_extension(arguments.in);
  if (!arguments.slice.empty()) return from_slice(arguments);
  if (is_link(arguments.in)) return from_scenario(arguments);
  if (extension == ".scen")
    return Error{"'" + arguments.in +
                 "' is a list of problems; convert the .map that it is for, or solve it with 'replan batch'"};
  return extension == ".json" ? from_scenario(arguments) : from_map(arguments);
}

std::string convert_footer() {
  return "Examples:\n"
         "  replan convert floor.png floor.map --threshold 100\n"
         "      Pixels darker than 100 become obstacles.\n"
         "  replan convert office.yaml office.json --unknown unmapped --start 12,40 --goal 200,60\n"
         "      A scenario on a ROS map, whose unknown cells the robot has to find out about.\n"
         "  replan convert 'generator:maze?width=61&height=41&corridor=2&seed=7' maze.map\n"
         "      A new map; 'replan list generators' shows what there is.\n"
         "  replan convert env1.cfg env1.json\n"
         "      SBPL's start and end cell become the scenario's.\n"
         "  replan convert costs.npy costs.map --occupied 254\n"
         "      Of numpy's array, the cells that are 254 become obstacles.\n"
         "  replan convert Complex.3dmap floor.map --slice 40\n"
         "      One plane of a box of voxels.\n"
         "  replan convert hawaii.asc sea.3dmap --layers 32 --reduce 2\n"
         "      A sea floor from its heights, in 32 layers, two columns each way as one.\n"
         "  replan convert Complex.3dmap complex.json --start 4,4,40 --goal 90,60,12\n"
         "      A scenario in the box, its layers inside.\n"
         "  replan convert maps/demo.json demo.txt\n"
         "      A scenario's map as text, to paste.\n\n"
         "Reads maps (" +
         map_extensions(MapUse::read) + "), generators and scenario .json.\nWrites maps (" +
         map_extensions(MapUse::write) +
         "),\nscenario .json, and a .scen with one problem and its optimal length. What the new "
         "format\n"
         "cannot hold is told, a line each that begins with 'note: '. A .yaml gets its .pgm beside it. A "
         "scenario\n"
         "made from a map has the planner dstar-lite unless others are named.";
}

}  // namespace

Command add_convert(CLI::App& program) {
  CLI::App* app = program.add_subcommand("convert", "Turn a map or a scenario into another format");
  const auto arguments = std::make_shared<ConvertArguments>();
  app->add_option("IN", arguments->in, "The file to read, or generator:ID?KEY=VALUE&...")->required();
  app->add_option("OUT", arguments->out, "The file to write; its name's end tells the format")->required();
  app->add_option("--start", arguments->world.start, "Where the robot starts, for formats that hold it")
      ->type_name("X,Y[,Z]");
  app->add_option("--goal", arguments->world.goal, "Where it is to go")->type_name("X,Y[,Z]");
  arguments->world.reading.declare(*app);
  app->add_option("--slice", arguments->slice, "Of a world of several layers: the layer with this z")
      ->type_name("Z");
  arguments->world.planners.declare(*app);
  app->footer(convert_footer);
  return {app, [arguments] { return convert(*arguments); }};
}

}  // namespace replan::cli
