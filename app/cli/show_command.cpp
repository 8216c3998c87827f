// `replan show`: a moment of a run as text.
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/export/case_text.hpp"
#include "core/session/film_plan.hpp"

namespace replan::cli {
namespace {

struct ShowArguments {
  WorldArguments world;
  std::string at = "plan";
  std::string cell;
};

Result<std::optional<Cell>> pinned_cell(const ShowArguments& arguments, const GridMap& map) {
  if (arguments.cell.empty()) return std::optional<Cell>();
  const auto cell = parse_cell_in(map, "--cell", arguments.cell, "the world");
  if (!cell) return Error{cell.error()};
  return std::optional<Cell>(*cell);
}

Result<int> show(const ShowArguments& arguments) {
  auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  tell_notes(world->map_found.notes_for_planning());
  const auto pin = pinned_cell(arguments, world->map);
  if (!pin) return Error{pin.error()};
  const auto scenario = std::make_shared<const Scenario>(std::move(world.value()));
  Run run(scenario, 0);
  run.finish(Target::end());
  if (const std::string failure = run.failure(); !failure.empty()) return Error{failure};
  const auto position = moment_position(run, arguments.at);
  if (!position) return Error{"--at: " + position.error()};
  run.timeline().seek(*position);
  print(case_text(*scenario, run.log_view(), {.pane = 0, .pin = *pin}));
  return kDone;
}

std::string show_footer() {
  return "Examples:\n"
         "  replan show maps/demo.json --at replan:1\n"
         "      World, values and open list once the first replan stands.\n"
         "  replan show maps/demo.json --planner dstar-lite --at 3000 --cell 12,40\n"
         "      After 3000 events, with the cells around one of them.\n\n"
         "The text goes into a bug report as it is; pasted into the window it opens the same world at the "
         "same "
         "event.\n"
         "Of several planners the first one is shown: choose it with --planner.\n\n" +
         settings_help();
}

}  // namespace

Command add_show(CLI::App& program) {
  CLI::App* app = program.add_subcommand("show", "Print a moment of a run as text: world, values, open list");
  const auto arguments = std::make_shared<ShowArguments>();
  arguments->world.declare(*app);
  app->add_option(
         "--at", arguments->at,
         "The moment: after that many events of the log, or start, plan (the default), replan:N, move:N, end")
      ->type_name("MOMENT");
  app->add_option("--cell", arguments->cell, "List the values around this cell instead of the robot's")
      ->type_name("X,Y[,Z]");
  app->footer(show_footer);
  return {app, [arguments] { return show(*arguments); }};
}

}  // namespace replan::cli
