#include <algorithm>
#include <memory>
#include <numeric>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/batch_input.hpp"
#include "app/cli/batch_output.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/output.hpp"
#include "app/cli/window.hpp"
#include "core/experiment/run_experiment.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan::cli {
namespace {

constexpr int kInterrupted = 130;  // as a shell tells it

/// Makes runs and gives each to `keep`. Returns whether all were made: else it was interrupted.
Result<bool> make(const RunList& list, std::span<const std::int64_t> runs, std::size_t threads,
                  const std::function<Result<void>(RunResult)>& keep) {
  const StopOnInterrupt interrupt;
  ProgressBar bar("batch", runs.size());
  std::size_t done = 0;
  Result<void> kept;
  const auto take = [&](RunResult result) {
    kept = keep(std::move(result));
    bar.show(++done);
    return kept.ok();
  };
  if (make_runs(list, runs, threads, {.take = take, .stop = interrupt.token()})) return true;
  if (!kept) return Error{kept.error()};
  return false;
}

/// How a batch that was interrupted stands.
std::string stopped_text(const ResultsFolder* folder, const std::string& path) {
  if (folder == nullptr) return "stopped: nothing is kept; with --out DIR the same command would go on";
  return "stopped: " + counted(folder->done(), "run") + " done and kept in '" + path + "', " +
         std::to_string(folder->missing().size()) + " to go; the same command goes on";
}

/// Makes all runs and reports on them. Nothing if it was interrupted, which is told.
Result<std::optional<std::vector<BatchReport>>> reports_without_folder(const RunList& list,
                                                                       std::size_t threads) {
  std::vector<std::int64_t> runs(static_cast<std::size_t>(list.count()));
  std::iota(runs.begin(), runs.end(), std::int64_t{0});
  std::vector<RunResult> results;
  const auto made = make(list, runs, threads, [&](RunResult result) -> Result<void> {
    results.push_back(std::move(result));
    return {};
  });
  if (!made) return Error{made.error()};
  if (!*made) {
    complain(stopped_text(nullptr, ""));
    return std::optional<std::vector<BatchReport>>();
  }
  std::sort(results.begin(), results.end(),
            [](const RunResult& a, const RunResult& b) { return a.run < b.run; });
  return std::optional(batch_reports(results));
}

/// The same with the results kept in a folder, and what is there already not made again.
Result<std::optional<std::vector<BatchReport>>> reports_in_folder(const RunList& list,
                                                                  const std::string& path, const Shard& part,
                                                                  std::size_t threads) {
  auto folder = ResultsFolder::open(path, list, part);
  if (!folder) return Error{folder.error()};
  const auto made =
      make(list, folder->missing(), threads, [&](const RunResult& result) { return folder->add(result); });
  if (!made) return Error{made.error()};
  if (!*made) {
    complain(stopped_text(&folder.value(), path));
    return std::optional<std::vector<BatchReport>>();
  }
  BatchSums sums;
  const auto written = folder->write_results([&](const RunResult& result) { sums.add(result); });
  if (!written) return Error{written.error()};
  return std::optional(sums.reports());
}

/// The scenario that a run is, whose number was typed.
Result<Scenario> scenario_of(const RunList& list, const std::string& option, const std::string& number) {
  const auto run = number_from<std::int64_t>(number);
  if (run && *run >= 0 && *run < list.count()) return list.scenario(list.parts(*run));
  if (list.count() == 0) return Error{option + " has nothing to show: the experiment has no runs"};
  return Error{option + " cannot be '" + number + "': give a run's number, from 0 to " +
               std::to_string(list.count() - 1)};
}

Result<int> write_run(const RunList& list, const BatchArguments& arguments) {
  const auto scenario = scenario_of(list, "--scenario", arguments.scenario);
  if (!scenario) return Error{scenario.error()};
  if (arguments.output.empty()) return Error{"--scenario needs -o FILE.json, the scenario's file"};
  if (const auto written = write_scenario(*scenario, arguments.output); !written)
    return Error{written.error()};
  return kDone;
}

Result<int> show_run(const RunList& list, const BatchArguments& arguments) {
  auto scenario = scenario_of(list, "--open", arguments.open);
  if (!scenario) return Error{scenario.error()};
  if (const auto closed = open_window(std::move(scenario.value())); !closed) return Error{closed.error()};
  return kDone;
}

Result<int> batch(const BatchArguments& arguments) {
  if (!arguments.open.empty() && !has_window())
    return Error{
        "--open needs the window, which this replan was built without: write the run by '--scenario " +
        arguments.open + " -o run.json', and open that where there is one"};
  const auto list = arguments.runs();
  if (!list) return Error{list.error()};
  for (const LoadedWorld& world : list->worlds()) tell_notes(world.notes);
  if (!arguments.scenario.empty()) return write_run(*list, arguments);
  if (!arguments.open.empty()) return show_run(*list, arguments);
  if (!arguments.output.empty()) return Error{"-o goes with --scenario; results are kept by --out DIR"};
  const auto threads = arguments.threads();
  if (!threads) return Error{threads.error()};
  const auto part = arguments.part();
  if (!part) return Error{part.error()};
  const auto made = arguments.folder.empty() ? reports_without_folder(*list, *threads)
                                             : reports_in_folder(*list, arguments.folder, *part, *threads);
  if (!made) return Error{made.error()};
  if (!*made) return kInterrupted;
  const std::vector<BatchReport>& reports = **made;
  print(arguments.json ? batch_json(reports)
                       : batch_title(*list, arguments.files.front()) +
                             batch_table(reports, arguments.of_problems() ? BatchKind::problems
                                                                          : BatchKind::experiment));
  complain_of_mismatches(reports);
  const bool passed = std::all_of(reports.begin(), reports.end(), [&](const BatchReport& report) {
    return arguments.of_problems() ? report.passed() : report.mismatches == 0;
  });
  return passed ? kDone : kFailed;
}

std::string batch_footer() {
  return "Examples:\n"
         "  replan batch arena.map.scen --planner astar,dstar-lite\n"
         "      Solves every problem and holds the lengths against those in the file.\n"
         "  replan batch big.map.scen --map maps/big.map --planner all --limit 60 --json\n"
         "      An even sample of 60 problems, for a program.\n"
         "  replan batch Simple.3dmap.3dscen --planner astar --limit 100\n"
         "      Problems in a box of voxels.\n"
         "  replan batch experiment.json --out results --jobs 4\n"
         "      An experiment of your own: planners x robots x worlds x surprises x seeds. After an end of "
         "any\n"
         "      kind the same command goes on where it was.\n"
         "  replan batch experiment.json --out part3 --shard 3/8\n"
         "      The third of eight parts, for a cluster; 'replan merge part*' puts them together.\n"
         "  replan batch experiment.json --scenario 1284 -o run.json\n"
         "      Run 1284 as a scenario, for another program or another machine.\n"
         "  replan batch experiment.json --open 1284\n"
         "      Run 1284 in the window, with the debugger.\n\n"
         "A mismatch is a length that is not the listed one to the precision printed in the file. The listed "
         "lengths\n"
         "judge planners that find shortest paths on the grid; for the others the ratio to them is told. "
         "dwa and fusion\n"
         "drive each problem, and what is told is the length of their way. A problem whose start or goal "
         "lies in an\n"
         "obstacle is skipped and counted as that. --limit N takes N problems spread "
         "evenly over the file, the first and the\n"
         "last among them. --out keeps a line for each run as soon as it is done, and in the end "
         "results.csv, "
         "results.json\n"
         "and times.csv. docs/batches.md has the format of experiments and of results.\n\n"
         "Exit code 0 if all is done, 1 if a length mismatches or, of problems, there is no path, 2 for bad "
         "input, 130 if\n"
         "it was stopped by Ctrl-C.\n\n" +
         settings_help();
}

}  // namespace

Command add_batch(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "batch", "Run an experiment, or all problems of MovingAI files and check the lengths");
  const auto arguments = std::make_shared<BatchArguments>();
  app->add_option("FILE", arguments->files, "An experiment (.json), or files of problems (.scen, .3dscen)")
      ->required()
      ->type_name("...");
  app->add_option("--map", arguments->map, "Of problems: the map, if it is not beside the file")
      ->type_name("FILE");
  arguments->reading.declare(*app);
  arguments->planners.declare(*app);
  app->add_option("--limit", arguments->limit, "Of problems: only an even sample of N of each file")
      ->type_name("N");
  app->add_option("--out", arguments->folder, "Keep the results there, or go on with what is there")
      ->type_name("DIR");
  app->add_option("--jobs", arguments->jobs, "Threads; more than one disturb each other's times (1)")
      ->type_name("N");
  app->add_option("--shard", arguments->shard, "Only part I of N: the runs I-1, I-1+N, I-1+2N, ...")
      ->type_name("I/N");
  app->add_option("--scenario", arguments->scenario, "Make no runs, but write run K as a scenario (-o)")
      ->type_name("K");
  app->add_option("-o,--output", arguments->output, "The scenario's file")->type_name("FILE");
  app->add_option("--open", arguments->open, "Make no runs, but open run K in the window")
      ->type_name("K")
      ->excludes("--scenario")
      ->excludes("--output");
  app->add_flag("--json", arguments->json, "Print the results of each planner as JSON");
  app->footer(batch_footer);
  return {app, [arguments] { return batch(*arguments); }};
}

}  // namespace replan::cli
