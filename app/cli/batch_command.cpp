#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/study/batch.hpp"
#include "core/world/choices.hpp"
#include "core/world/map_file.hpp"

namespace replan::cli {
namespace {

struct BatchArguments {
  std::string scen;
  std::string map;
  std::string limit;
  ReadingArguments reading;
  PlannerArguments planners;
  bool json = false;
};

std::string table(std::span<const BatchReport> reports) {
  using enum Table::Align;
  Table table({{"planner", left},
               {"problems"},
               {"skipped"},
               {"found"},
               {"mismatches"},
               {"max rel. error"},
               {"mean ratio"},
               {"total ms"},
               {"ms a problem"},
               {"expansions"}});
  for (const BatchReport& report : reports) {
    const auto solved = static_cast<double>(std::max<std::int64_t>(1, report.problems - report.skipped));
    char error[32];
    std::snprintf(error, sizeof error, "%.2e", report.max_relative_error);
    table.add({report.planner, std::to_string(report.problems), std::to_string(report.skipped),
               std::to_string(report.found), report.comparable ? std::to_string(report.mismatches) : "-",
               error, decimals(report.mean_ratio, 6), decimals(report.total_ms, 1),
               decimals(report.total_ms / solved, 3), std::to_string(report.expansions)});
  }
  return table.text();
}

/// What the table cannot say: what was skipped, and which planners the listed lengths do not judge.
std::string remarks(std::span<const BatchReport> reports) {
  std::string text;
  if (const std::int64_t skipped = reports.front().skipped; skipped > 0)
    text += counted(skipped, "problem") + " skipped: the start or the goal lies in an obstacle of the map.\n";
  for (const BatchReport& report : reports) {
    if (!report.comparable)
      text += report.planner +
              ": not held to the listed lengths; with these settings it looks for other paths.\n";
    if (report.unsolved() > 0)
      text += report.planner + ": " + counted(report.unsolved(), "problem") +
              (find_pilot(report.planner) != nullptr ? " in which the robot did not arrive.\n"
                                                     : " without a path.\n");
  }
  return text.empty() ? text : "\n" + text;
}

void complain_of_mismatches(const std::string& scen, const BatchReport& report) {
  for (const BatchMismatch& mismatch : report.first_mismatches)
    complain(scen + ":" + std::to_string(mismatch.line) + ": " + report.planner + " found " +
             (mismatch.found > 0 ? decimals(mismatch.found, 8) : "no path") + ", listed is " +
             decimals(mismatch.listed, 8));
  const auto told = static_cast<std::int64_t>(report.first_mismatches.size());
  if (report.mismatches > told)
    complain(scen + ": " + report.planner + ": and " + counted(report.mismatches - told, "more mismatch") +
             (report.mismatches - told == 1 ? "" : "es"));
}

/// The problems, the map that they are for, and the planners.
struct BatchInput {
  ScenFile scen;
  std::string map_path;
  GridMap map;
  std::vector<PlannerChoice> planners;
  std::vector<ScenProblem> problems;
};

Result<GridMap> read_map_for(const std::string& path, const BatchArguments& arguments) {
  const auto how = arguments.reading.reading(path);
  if (!how) return Error{how.error()};
  auto file = read_map_file(path, *how);
  if (!file) return Error{file.error()};
  tell_notes(file->found.notes_for_planning());
  return std::move(file->map);
}

Result<BatchInput> load(const BatchArguments& arguments) {
  BatchInput input;
  auto choices = arguments.planners.choose();
  if (!choices) return Error{choices.error()};
  input.planners = std::move(choices.value());
  const auto limit = arguments.limit.empty() ? 0 : parse_count("--limit", arguments.limit, 1);
  if (!limit) return Error{limit.error()};
  auto scen = read_scen(arguments.scen);
  if (!scen) return Error{scen.error()};
  input.scen = std::move(scen.value());
  const auto path = arguments.map.empty() ? map_beside(arguments.scen, input.scen.map_name) : arguments.map;
  if (!path) return Error{path.error()};
  auto map = read_map_for(input.map_path = *path, arguments);
  if (!map) return Error{map.error()};
  input.map = std::move(map.value());
  if (const auto fits = check_scen_fits(input.scen, input.map, *path); !fits) return Error{fits.error()};
  auto fitting = arguments.planners.choose({}, &input.map);
  if (!fitting) return Error{fitting.error()};
  input.planners = std::move(fitting.value());
  input.problems = even_sample(input.scen.problems, static_cast<std::size_t>(*limit));
  return input;
}

Result<int> batch(const BatchArguments& arguments) {
  const auto input = load(arguments);
  if (!input) return Error{input.error()};
  std::vector<BatchReport> reports;
  bool passed = true;
  for (const PlannerChoice& choice : input->planners) {
    ProgressBar bar(choice.id, input->problems.size());
    const BatchWatch watch{.progress = [&](std::size_t done) { bar.show(done); }, .stop = {}};
    reports.push_back(run_batch(input->map, input->scen.lengths, input->problems, choice, watch));
    passed &= reports.back().passed();
  }
  if (arguments.json)
    print(batch_json(reports));
  else
    print(arguments.scen + " on " + input->map_path + ", " +
          counted(static_cast<std::int64_t>(input->scen.problems.size()), "problem") + " in the file\n\n" +
          table(reports) + remarks(reports));
  for (const BatchReport& report : reports) complain_of_mismatches(arguments.scen, report);
  return passed ? kDone : kFailed;
}

std::string batch_footer() {
  return "Examples:\n"
         "  replan batch arena.map.scen --planner astar,dstar-lite\n"
         "      Solves every problem and holds the lengths against those in the file.\n"
         "  replan batch big.map.scen --map maps/big.map --planner all --limit 60 --json\n"
         "      An even sample of 60 problems, for a program.\n"
         "  replan batch Simple.3dmap.3dscen --planner astar --limit 100\n"
         "      Problems in a box of voxels.\n\n"
         "A mismatch is a length that is not the listed one to the precision printed in the file. The listed "
         "lengths\n"
         "judge planners that find shortest paths on the grid; for the others the ratio to them is told. "
         "dwa and fusion\n"
         "drive each problem, and what is told is the length of their way. A problem whose start or goal "
         "lies in "
         "an\n"
         "obstacle is skipped and counted as that. --limit N takes N problems spread "
         "evenly over the file, the first and the last among them. Exit code 0 if all agree, 1 if any "
         "mismatches or\n"
         "has no path, 2 for bad input.\n\n" +
         settings_help();
}

}  // namespace

Command add_batch(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "batch", "Solve every problem of a MovingAI .scen or .3dscen file and check the lengths");
  const auto arguments = std::make_shared<BatchArguments>();
  app->add_option("FILE", arguments->scen, "A problem file (.scen or .3dscen)")->required();
  app->add_option("--map", arguments->map, "The map, if it is not beside the file")->type_name("FILE");
  arguments->reading.declare(*app);
  arguments->planners.declare(*app);
  app->add_option("--limit", arguments->limit, "Only an even sample of N problems")->type_name("N");
  app->add_flag("--json", arguments->json, "Print the results as JSON");
  app->footer(batch_footer);
  return {app, [arguments] { return batch(*arguments); }};
}

}  // namespace replan::cli
