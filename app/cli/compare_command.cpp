#include <cmath>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/experiment/compare_results.hpp"
#include "core/experiment/results_folder.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan::cli {
namespace {

struct CompareArguments {
  std::string before, after;
  std::string alpha, tolerate;
  bool times = false;
  bool any_settings = false;
  bool all = false;
  bool json = false;
  bool fail_on_loss = false;
};

/// Of a folder of results, or of a file results.json.
Result<std::vector<RunResult>> results_in(const std::string& path, bool times) {
  std::error_code failed;
  if (std::filesystem::is_directory(path, failed)) {
    auto kept = read_results_folder(path);
    if (!kept) return Error{kept.error()};
    return std::move(kept->results);
  }
  if (times) return Error{"--times needs folders of results: '" + path + "' has no times"};
  const auto text = read_file(path);
  if (!text) return Error{text.error()};
  auto read = parse_results(*text, path);
  if (!read) return Error{read.error()};
  return std::move(read->results);
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, std::abs(value) >= 1e6 ? "%.4e" : "%.6g", value);
  return text;
}

/// A number in a range, as typed; `usual` where nothing was.
Result<double> number_of(const char* option, const std::string& typed, double usual, double low,
                         double high) {
  if (typed.empty()) return usual;
  const auto value = number_from<double>(typed);
  if (value && *value >= low && *value <= high) return *value;
  return Error{std::string(option) + " cannot be '" + typed + "': give a number from " + short_number(low) +
               " to " + short_number(high)};
}

std::string p_text(double p) {
  char text[32];
  std::snprintf(text, sizeof text, p < 0.001 ? "%.1e" : "%.3f", p);
  return text;
}

std::string comparison_table(const Comparison& comparison, bool all) {
  using enum Table::Align;
  constexpr const char* kTrends[] = {"unchanged", "better", "WORSE"};
  Table table({{"planner", left},
               {"figure", left},
               {"pairs"},
               {"better"},
               {"worse"},
               {"before"},
               {"after"},
               {"ratio"},
               {"95 % interval"},
               {"effect"},
               {"p"},
               {"verdict", left}});
  std::size_t equal = 0;
  for (const ComparedFigure& row : comparison.rows) {
    if (!all && row.improved + row.worsened == 0) {
      ++equal;
      continue;
    }
    table.add({row.planner, row.figure, std::to_string(row.pairs), std::to_string(row.improved),
               std::to_string(row.worsened), short_number(row.before), short_number(row.after),
               row.ratio ? decimals(*row.ratio, 4) : "-",
               row.interval ? decimals(row.interval->low, 4) + " .. " + decimals(row.interval->high, 4) : "-",
               decimals(row.effect, 2), p_text(row.corrected),
               kTrends[static_cast<std::size_t>(row.verdict)]});
  }
  std::string text = equal < comparison.rows.size() ? table.text() : "";
  if (equal > 0)
    text += (text.empty() ? "" : "\n") + std::to_string(equal) +
            " rows are left out: every pair is equal in them (--all).\n";
  return text;
}

Result<int> compare(const CompareArguments& arguments) {
  CompareSettings settings{.times = arguments.times};
  const auto alpha = number_of("--alpha", arguments.alpha, settings.alpha, 0, 1),
             tolerated = number_of("--tolerate", arguments.tolerate, 0, 0, 1000);
  for (const auto* number : {&alpha, &tolerated})
    if (!*number) return Error{number->error()};
  settings.alpha = *alpha;
  auto before = results_in(arguments.before, arguments.times),
       after = results_in(arguments.after, arguments.times);
  for (auto* results : {&before, &after}) {
    if (!*results) return Error{results->error()};
    if (!arguments.any_settings) continue;
    if (const auto named = forget_settings(**results); !named) return Error{named.error()};
  }
  const Comparison comparison = compare_results(*before, *after, settings);
  if (comparison.pairs == 0)
    return Error{
        "no run of '" + arguments.before + "' is in '" + arguments.after +
        "': give results of the same worlds, planners, robots, surprises and seeds; of planners with other "
        "settings with --any-settings"};
  if (arguments.json)
    print(comparison_json(comparison));
  else
    print(counted(comparison.pairs, "run") + " in both; " + std::to_string(comparison.only_before) +
          " only in " + arguments.before + ", " + std::to_string(comparison.only_after) + " only in " +
          arguments.after + "\n\n" + comparison_table(comparison, arguments.all));
  bool lost = false;
  for (const ComparedFigure& row : comparison.rows) {
    if (row.verdict != Trend::worse) continue;
    lost |= *tolerated == 0 || !row.ratio || 100 * row.loss().value_or(0) > *tolerated;
  }
  return arguments.fail_on_loss && lost ? kFailed : kDone;
}

std::string compare_footer() {
  return "Examples:\n"
         "  replan compare results-before results-after\n"
         "      What has become better or worse, planner by planner and figure by figure.\n"
         "  replan compare main/results.json results --fail-on-loss --tolerate 2\n"
         "      For a check of changes: exit code 1 if something is worse by more than 2 %.\n\n"
         "Runs are paired by world, problem, start, goal, planner with settings, robot, surprises and seed. "
         "A "
         "figure counts\n"
         "where both runs succeeded. p is that of Wilcoxon's signed-rank test (exact up to 50 pairs that "
         "differ), of \"succeeded\"\n"
         "that of McNemar's exact test, corrected by Holm's method for all rows in which any pair differs. "
         "effect is the\n"
         "rank-biserial correlation of after - before, from -1 to 1; ratio the median of after / before with "
         "its bootstrap\n"
         "interval. A row is better or worse if p is less than --alpha.\n\n"
         "Exit code 0, 1 with --fail-on-loss if a row is worse, 2 for bad input.\n";
}

}  // namespace

Command add_compare(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "compare", "Tell what is better and what is worse in a second run of an experiment");
  const auto arguments = std::make_shared<CompareArguments>();
  app->add_option("BEFORE", arguments->before, "A folder of results, or its results.json")->required();
  app->add_option("AFTER", arguments->after, "The results to hold against them")->required();
  app->add_flag("--times", arguments->times, "Compare the times of planning too; needs folders");
  app->add_flag(
      "--any-settings", arguments->any_settings,
      "Pair runs of a planner whatever its settings and stages: to hold two settings against each other");
  app->add_option("--alpha", arguments->alpha, "How likely one false alarm may be, all rows together (0.05)")
      ->type_name("P");
  app->add_flag("--fail-on-loss", arguments->fail_on_loss, "Exit code 1 if a row is worse");
  app->add_option("--tolerate", arguments->tolerate,
                  "With --fail-on-loss: a median that is worse by no more than this is no loss (0)")
      ->type_name("PERCENT");
  app->add_flag("--all", arguments->all, "Rows without any difference too");
  app->add_flag("--json", arguments->json, "Print the comparison as JSON");
  app->footer(compare_footer);
  return {app, [arguments] { return compare(*arguments); }};
}

}  // namespace replan::cli
