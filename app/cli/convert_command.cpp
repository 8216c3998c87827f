#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"

namespace replan::cli {
namespace {

struct ConvertArguments {
  std::string in;
  std::string out;
  WorldArguments world;
};

std::string described(const GridMap& map) {
  const auto obstacles =
      std::count_if(map.blocked.begin(), map.blocked.end(), [](auto cell) { return cell != 0; });
  return std::to_string(map.width) + " x " + std::to_string(map.height) + " cells, " +
         counted(obstacles, "obstacle");
}

/// A map becomes a map, or a scenario on it.
Result<int> from_map(ConvertArguments& arguments) {
  if (file_extension(arguments.out) != ".json") {
    const auto map = read_map(arguments.in);
    if (!map) return Error{map.error()};
    if (const auto written = write_map(*map, arguments.out); !written) return Error{written.error()};
    print("wrote " + arguments.out + ": " + described(*map) + "\n");
    return kDone;
  }
  arguments.world.map = arguments.in;
  const auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  if (const auto written = write_scenario(*world, arguments.out); !written) return Error{written.error()};
  print("wrote " + arguments.out + ": " + described(world->map) + ", " +
        counted(static_cast<std::int64_t>(world->planners.size()), "planner") + "\n");
  return kDone;
}

/// A scenario becomes a map, which is all that a map can hold of it, or a scenario with its map inside.
Result<int> from_scenario(ConvertArguments& arguments) {
  arguments.world.scenario = arguments.in;
  auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  const bool to_scenario = file_extension(arguments.out) == ".json";
  world->map_file.clear();
  const auto written =
      to_scenario ? write_scenario(*world, arguments.out) : write_map(world->map, arguments.out);
  if (!written) return Error{written.error()};
  print(
      "wrote " + arguments.out + ": " + described(world->map) +
      (to_scenario ? ", the map inside\n" : "; start, goal, planners and surprises stay in the scenario\n"));
  return kDone;
}

Result<int> convert(ConvertArguments& arguments) {
  return file_extension(arguments.in) == ".json" ? from_scenario(arguments) : from_map(arguments);
}

constexpr const char* kFooter =
    "Examples:\n"
    "  replan convert floor.png floor.map\n"
    "      Dark pixels become obstacles.\n"
    "  replan convert arena.map arena.json --start 1,11 --goal 40,30 --planner dstar-lite\n"
    "      A scenario on a map, with the map inside.\n"
    "  replan convert maps/demo.json demo.png\n"
    "      A scenario's map as a picture, one pixel a cell.\n\n"
    "Reads .map, .png, .bmp, .jpg, .pgm, .ppm and scenario .json; writes .map, .png and scenario .json.";

}  // namespace

Command add_convert(CLI::App& program) {
  CLI::App* app = program.add_subcommand("convert", "Turn a map or a scenario into another format");
  const auto arguments = std::make_shared<ConvertArguments>();
  app->add_option("IN", arguments->in, "The file to read")->required();
  app->add_option("OUT", arguments->out, "The file to write; its name's end tells the format")->required();
  app->add_option("--start", arguments->world.start, "For a scenario: where the robot starts")
      ->type_name("X,Y");
  app->add_option("--goal", arguments->world.goal, "For a scenario: where it is to go")->type_name("X,Y");
  arguments->world.planners.declare(*app);
  app->footer(kFooter);
  return {app, [arguments] { return convert(*arguments); }};
}

}  // namespace replan::cli
