#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/run_break.hpp"
#include "app/cli/run_check.hpp"
#include "app/cli/run_trace.hpp"
#include "core/base/file.hpp"
#include "core/lattice/box_words.hpp"
#include "core/study/figures_table.hpp"
#include "core/world/choices.hpp"
#include "core/world/ends.hpp"

namespace replan::cli {
namespace {

struct RunArguments {
  WorldArguments world;
  bool json = false;
  bool check = false;
  bool cells = false;
  std::string csv, markdown, latex;  // files; "-" prints
  TraceArguments trace;
  BreakArguments stops;
};

/// A length in the unit of its run's map; "none" for the distance to an obstacle where there is none.
std::string length_text(const RunReport& report, double cells, int decimals_shown) {
  if (std::isinf(cells)) return "none";
  return decimals(report.frame ? report.frame->metres(cells) : cells, decimals_shown);
}

std::string plans_table(std::span<const RunReport> reports) {
  using enum Table::Align;
  const bool metric = reports.front().frame.has_value();
  Table table({{"planner", left},
               {"status", left},
               {"nodes"},
               {metric ? "length m" : "length"},
               {"turns"},
               {"turning deg"},
               {metric ? "clearance min m" : "clearance min"},
               {"mean"},
               {"plan ms"},
               {"expansions"},
               {"queue ops"},
               {"sight checks"},
               {"memory kB"}});
  for (const RunReport& report : reports) {
    const PathFigures& figures = report.figures;
    table.add({report.planner, std::string(report.status), std::to_string(figures.nodes),
               length_text(report, figures.length, 3), std::to_string(figures.turns),
               decimals(figures.turning_angle_deg, 1),
               length_text(report, figures.min_clearance, metric ? 3 : 2),
               length_text(report, figures.mean_clearance, metric ? 3 : 2), decimals(report.plan_ms, 3),
               std::to_string(report.counters.expansions), std::to_string(report.counters.queue_operations),
               std::to_string(report.counters.sight_checks),
               decimals(static_cast<double>(report.memory_bytes) / 1000, 0)});
  }
  return table.text();
}

/// What a planner works out for its first plan, one line for each planner that does.
std::string plan_numbers(std::span<const RunReport> reports) {
  std::string text;
  for (const RunReport& report : reports) {
    std::string line;
    for (const auto& [number, value] : report.plan_numbers)
      line += (line.empty() ? ": " : ", ") + std::string(number.label) + " = " + decimals(value, 4);
    if (!line.empty()) text += report.planner + line + "\n";
  }
  return text;
}

/// Of a robot with a size, one line for each planner that has a path, and obstacles to be clear of.
std::string edge_clearances(std::span<const RunReport> reports, double radius) {
  std::string text;
  for (const RunReport& report : reports)
    if (report.figures.nodes > 0 && !std::isinf(report.figures.min_clearance))
      text += report.planner + ": clearance of the edge of a robot of radius " + decimals(radius, 2) +
              ": min " + decimals(report.figures.min_clearance - radius, 2) + ", mean " +
              decimals(report.figures.mean_clearance - radius, 2) + "\n";
  return text;
}

std::string robots_table(std::span<const RunReport> reports) {
  using enum Table::Align;
  Table table({{"planner", left},
               {"robot", left},
               {"moves"},
               {reports.front().frame ? "travelled m" : "travelled"},
               {"collisions"},
               {"replans"},
               {"replan ms"}});
  for (const RunReport& report : reports)
    if (const auto& robot = report.robot)
      table.add({report.planner, mission_state_name(robot->ending), std::to_string(robot->moves),
                 length_text(report, robot->travelled, 3), std::to_string(robot->collisions),
                 std::to_string(robot->replans), decimals(report.replan_ms, 3)});
  return table.text();
}

/// Why a run did not succeed; empty if it did. That an end is unknown on the map only the world can tell.
std::string why_not(const Scenario& world, const RunReport& report) {
  const bool start = report.status == status_name(PlanStatus::start_blocked);
  if (start || report.status == status_name(PlanStatus::goal_blocked))
    if (std::string unknown = unknown_end_sentence(world, start); !unknown.empty()) return unknown;
  return explanation(report);
}

std::string summary(const WorldArguments& arguments, const Scenario& world,
                    std::span<const RunReport> reports) {
  const Box box = world.map.box();
  std::string text = arguments.source() + ": " + size_text(box) + ", from " +
                     cell_text(world.start, box.solid()) + " to " + cell_text(world.goal, box.solid()) +
                     "\n\n" + plans_table(reports);
  if (const std::string numbers = plan_numbers(reports); !numbers.empty()) text += "\n" + numbers;
  if (const double radius = reports.front().radius; radius > 0)
    text += "\n" + edge_clearances(reports, radius);
  if (reports.front().robot) text += "\n" + robots_table(reports);
  std::string failures;
  for (const RunReport& report : reports)
    if (const std::string why = why_not(world, report); !why.empty())
      failures += report.planner + ": " + why + "\n";
  return text + (failures.empty() ? "" : "\n" + failures);
}

struct TableFile {
  FiguresFormat format;
  const char* option;
  const std::string& file;
};
std::array<TableFile, 3> table_files(const RunArguments& arguments) {
  return {{{FiguresFormat::csv, "--csv", arguments.csv},
           {FiguresFormat::markdown, "--markdown", arguments.markdown},
           {FiguresFormat::latex, "--latex", arguments.latex}}};
}

/// What is printed instead of the summary, if anything.
std::optional<FiguresFormat> printed(const RunArguments& arguments) {
  if (arguments.json) return FiguresFormat::json;
  for (const TableFile& table : table_files(arguments))
    if (table.file == "-") return table.format;
  return std::nullopt;
}

Result<void> check_tables(const RunArguments& arguments) {
  std::string first = arguments.json ? "--json" : "";
  for (const TableFile& table : table_files(arguments)) {
    if (table.file != "-") continue;
    const std::string option = "'" + std::string(table.option) + " -'";
    if (!first.empty()) return Error{first + " and " + option + " both print: give the latter a file name"};
    first = option;
  }
  return {};
}

/// A stop is no table of figures: it is told in the terminal, or as JSON for a program.
Result<void> check_stops(const RunArguments& arguments) {
  std::string_view other = arguments.trace.given() ? "--trace" : "";
  for (const TableFile& table : table_files(arguments))
    if (!table.file.empty()) other = table.option;
  if (other.empty()) return {};
  return Error{"--break tells only where the runs stop, as a table or with --json: leave out " +
               std::string(other)};
}

Result<void> write_tables(const RunArguments& arguments, std::span<const RunReport> reports) {
  for (const TableFile& table : table_files(arguments)) {
    if (table.file.empty() || table.file == "-") continue;
    if (auto written = write_file_atomically(table.file, figures_text(table.format, reports)); !written)
      return written;
  }
  return {};
}

/// On a bare map planners plan, and nobody drives; but there is nothing to a pilot but its drive, and beside one all do.
bool only_plans(const RunArguments& arguments, const Scenario& world) {
  return !arguments.world.map.empty() &&
         std::none_of(world.planners.begin(), world.planners.end(),
                      [](const PlannerChoice& choice) { return find_pilot(choice.id) != nullptr; });
}

Result<int> run(const RunArguments& arguments) {
  const auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  tell_notes(world->map_found.notes_for_planning());
  const bool plan_alone = only_plans(arguments, *world);
  if (arguments.check) return check_runs(*world, arguments.json);
  if (arguments.stops.given()) {
    if (const auto good = check_stops(arguments); !good) return Error{good.error()};
    return arguments.stops.run(*world, plan_alone, arguments.json);
  }
  if (const auto good = check_tables(arguments); !good) return Error{good.error()};
  if (const auto good = arguments.trace.check(world->map.box()); !good) return Error{good.error()};
  std::vector<RunReport> reports;
  bool succeeded = true;
  for (const PlannerChoice& choice : world->planners) {
    reports.push_back(plan_alone ? plan_once(world->map, world->start, world->goal, choice, world->robot)
                                 : drive(*world, choice));
    if (arguments.cells) reports.back().frame.reset();
    succeeded &= reports.back().succeeded();
  }
  if (const auto written = write_tables(arguments, reports); !written) return Error{written.error()};
  if (const auto traced = arguments.trace.write(*world, plan_alone); !traced) return Error{traced.error()};
  const auto format = printed(arguments);
  print(format ? figures_text(*format, reports) : summary(arguments.world, *world, reports));
  return succeeded ? kDone : kFailed;
}

std::string run_footer() {
  return "Examples:\n"
         "  replan run maps/demo.json\n"
         "      Drives the demo's robot with each of the scenario's planners.\n"
         "  replan run --map arena.map --start 1,11 --goal 40,30 --planner astar,dld-star-lite --set "
         "range=3\n"
         "      Compares two plans on a map.\n"
         "  replan run maps/fusion-boxes.json --planner fusion,dwa --set fusion.global=dstar-lite\n"
         "      Drives by the turns of a plan, and beside it with none.\n"
         "  replan run maps/demo.json --planner all --set astar.heuristic=euclidean --json\n"
         "      The figures of all planners, for a program.\n"
         "  replan run maps/broken-planner.json --check\n"
         "      Where does a broken planner go wrong first?\n"
         "  replan run maps/demo.json --trace demo.trace.yaml --trace-map demo.map\n"
         "      The search for the Posthoc visualiser, and the map to lay under it.\n"
         "  replan run maps/demo.json --break 'changed(rhs(12, 40))' --break 'km > 5 && size(U) >= 100'\n"
         "      Where each run comes to each of them first: event, line of the pseudo-code, values.\n"
         "  replan run maps/fusion-boxes.json --break 'score(winner) < 0.5 || admissible == 0'\n"
         "      Where a robot that drives finds no good arc.\n\n"
         "Status, path and the figures of its shape are those of the first plan; times and counters are of "
         "the whole\n"
         "run. Exit code 0 if every planner found a path (and its robot arrived), 1 if not, 2 for bad "
         "input. With --break: 0 if every run stopped at one condition at least, 1 if not.\n\n" +
         settings_help() + "\n" + conditions_help();
}

}  // namespace

Command add_run(CLI::App& program) {
  CLI::App* app = program.add_subcommand("run", "Plan, and drive a scenario's robot, without drawing");
  const auto arguments = std::make_shared<RunArguments>();
  arguments->world.declare(*app);
  app->add_flag("--json", arguments->json, "Print the runs as JSON, paths included");
  app->add_option("--csv", arguments->csv, "Write the figures as CSV too; '-' prints them instead")
      ->type_name("FILE");
  app->add_option("--markdown", arguments->markdown,
                  "Write the figures as a Markdown table, with ratios to the first planner; '-' prints it")
      ->type_name("FILE");
  app->add_option("--latex", arguments->latex, "Write the figures as a LaTeX table (booktabs); '-' prints it")
      ->type_name("FILE");
  app->add_flag("--cells", arguments->cells,
                "Lengths in cells alone, also on a map that says how large its cells are");
  arguments->trace.declare(*app);
  arguments->stops.declare(*app);
  app->add_flag("--check", arguments->check,
                "Hold the planners to their laws and each plan to an oracle, and print the verdicts instead")
      ->excludes("--csv")
      ->excludes("--markdown")
      ->excludes("--latex")
      ->excludes("--trace")
      ->excludes("--break");
  app->footer(run_footer);
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace replan::cli
