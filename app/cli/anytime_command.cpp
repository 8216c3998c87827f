#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/plan/common_parameters.hpp"
#include "core/plan/nth_name.hpp"
#include "core/plan/registry.hpp"
#include "core/planners/rrt_parameters.hpp"
#include "core/study/anytime.hpp"
#include "core/world/formats/text_lines.hpp"

namespace replan::cli {
namespace {

struct AnytimeArguments {
  WorldArguments world;
  std::string seeds = "1";
  std::string seconds;
  std::string csv, svg;  // files; "-" prints the CSV
};

Result<double> most_milliseconds(const AnytimeArguments& arguments) {
  if (arguments.seconds.empty()) return std::numeric_limits<double>::infinity();
  const auto seconds = number_from<double>(arguments.seconds);
  if (seconds && std::isfinite(*seconds) && *seconds > 0) return *seconds * 1000;
  return Error{"--time cannot be '" + arguments.seconds + "': give seconds, more than 0"};
}

/// What would change nothing is refused rather than ignored.
Result<void> check_options(const WorldArguments& world) {
  if (!world.planners.stages.empty())
    return Error{
        "--stage changes nothing here, where paths are measured as the planner finds them: leave it out"};
  for (const auto& [option, given] : {std::pair{"--unreachable-goal", !world.unreachable_goal.empty()},
                                      std::pair{"--robot", !world.robot.empty()}})
    if (given)
      return Error{std::string(option) + " changes nothing here, where no robot drives: leave it out"};
  return {};
}

/// What has nothing to better has no curve.
Result<void> check_planners(std::span<const PlannerChoice> planners) {
  for (const PlannerChoice& choice : planners) {
    const PlannerInfo* info = find_planner(choice.id);
    if (info == nullptr || !info->can_miss())
      return Error{
          "'" + choice.id +
          "' has no path before its end: give planners that draw samples or breed paths, with --planner"};
  }
  return {};
}

/// Each planner with its seed and those that follow it.
Result<std::vector<AnytimeRun>> plan_all(const Scenario& world, std::int64_t seeds, double most_ms) {
  std::vector<AnytimeRun> runs;
  ProgressBar bar("plans", world.planners.size() * static_cast<std::size_t>(seeds));
  std::map<std::string, std::size_t> met;
  for (const PlannerChoice& choice : world.planners) {
    const std::size_t nth = ++met[choice.id];
    const double first = choice.settings.get(parameters::kSeed);
    if (first + static_cast<double>(seeds - 1) > parameters::kSeed.high)
      return Error{"there are not so many seeds from that of '" + choice.id +
                   "' on: give fewer with --seeds"};
    for (std::int64_t i = 0; i < seeds; ++i) {
      PlannerChoice seeded = choice;
      seeded.settings.set(parameters::kSeed.key, first + static_cast<double>(i));
      runs.push_back(plan_anytime(world.map, world.start, world.goal, seeded, world.robot.radius, most_ms));
      runs.back().planner = nth_name(choice.id, nth);
      bar.show(runs.size());
    }
  }
  return runs;
}

/// How long the shortest of all ways is by each planner's corner rule, in their order.
std::vector<std::optional<double>> optima_of(const Scenario& world, double most_ms) {
  std::map<double, std::optional<double>> by_rule;
  std::vector<std::optional<double>> optima;
  for (const PlannerChoice& choice : world.planners) {
    const auto [found, is_new] = by_rule.try_emplace(choice.settings.get(parameters::kCorners));
    if (is_new)
      found->second = shortest_of_all(world.map.box(), world.map.blocked, world.start, world.goal, choice,
                                      world.robot.radius, most_ms);
    optima.push_back(found->second);
  }
  return optima;
}

/// Those that are known, ascending, each once.
std::vector<double> known_of(std::span<const std::optional<double>> optima) {
  std::set<double> known;
  for (const auto& optimum : optima)
    if (optimum) known.insert(*optimum);
  return {known.begin(), known.end()};
}

std::string optimum_words(std::span<const double> known) {
  if (known.empty()) return "How long the shortest of all ways is, is not known here.";
  if (known.size() == 1) return "The shortest of all ways is " + decimals(known.front(), 3) + " cells long.";
  return "The shortest of all ways is " + decimals(known.front(), 3) + " to " + decimals(known.back(), 3) +
         " cells long, by each planner's own corner rule.";
}

std::string or_dash(double value, int decimals_shown) {
  return std::isfinite(value) ? decimals(value, decimals_shown) : "-";
}

/// The median over the plans of a planner of what each has; one without a path has none.
template <class Of>
double median_of(std::span<const AnytimeRun> runs, const Of& of) {
  std::vector<double> values;
  for (const AnytimeRun& run : runs)
    values.push_back(run.found() ? of(run) : std::numeric_limits<double>::infinity());
  return lower_median(std::move(values));
}

std::string table_of(std::span<const AnytimeRun> runs, std::span<const std::optional<double>> optima) {
  using enum Table::Align;
  Table table({{"planner", left},
               {"plans"},
               {"found"},
               {"first samples"},
               {"first ms"},
               {"first length"},
               {"last length"},
               {"over optimum"},
               {"samples"},
               {"ms"}});
  const auto groups = by_planner(runs);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto plans = groups[i];
    const std::optional<double> optimum = optima[i];
    const auto found = std::count_if(plans.begin(), plans.end(), [](const auto& run) { return run.found(); });
    const double last = median_of(plans, [](const AnytimeRun& run) { return run.gains.back().length; });
    std::vector<double> samples, times;
    for (const AnytimeRun& run : plans) samples.push_back(static_cast<double>(run.samples));
    for (const AnytimeRun& run : plans) times.push_back(run.ms);
    table.add(
        {plans.front().planner, std::to_string(plans.size()), std::to_string(found),
         or_dash(median_of(plans, [](const auto& run) { return double(run.gains.front().samples); }), 0),
         or_dash(median_of(plans, [](const auto& run) { return run.gains.front().ms; }), 3),
         or_dash(median_of(plans, [](const auto& run) { return run.gains.front().length; }), 3),
         or_dash(last, 3),
         optimum && std::isfinite(last) ? decimals((last / *optimum - 1) * 100, 2) + " %" : "-",
         decimals(lower_median(samples), 0), decimals(lower_median(times), 3)});
  }
  return table.text();
}

Result<int> anytime(const AnytimeArguments& arguments) {
  if (const auto good = check_options(arguments.world); !good) return Error{good.error()};
  const auto world = arguments.world.load();
  if (!world) return Error{world.error()};
  if (const auto good = check_planners(world->planners); !good) return Error{good.error()};
  const auto seeds = parse_count("--seeds", arguments.seeds, 1);
  if (!seeds) return Error{seeds.error()};
  const auto most_ms = most_milliseconds(arguments);
  if (!most_ms) return Error{most_ms.error()};
  if (world->start == world->goal)
    return Error{"start and goal are the same cell: there is no path to become shorter"};
  if (arguments.svg == "-") return Error{"--svg needs the name of a file"};
  const auto runs = plan_all(*world, *seeds, *most_ms);
  if (!runs) return Error{runs.error()};
  const auto optima = optima_of(*world, *most_ms);
  const std::vector<double> known = known_of(optima);
  for (const auto& [file, text] : {std::pair{&arguments.csv, anytime_csv(*runs)},
                                   std::pair{&arguments.svg, anytime_svg(*runs, known)}}) {
    if (file->empty() || *file == "-") continue;
    if (const auto written = write_file_atomically(*file, text); !written) return Error{written.error()};
  }
  if (arguments.csv == "-")
    print(anytime_csv(*runs));
  else
    print(table_of(*runs, optima) + "\nMedians over the plans. " + optimum_words(known) + "\n");
  const bool all = std::all_of(runs->begin(), runs->end(), [](const auto& run) { return run.found(); });
  return all ? kDone : kFailed;
}

std::string anytime_footer() {
  return "Examples:\n"
         "  replan anytime maps/gap-for-samples.json --planner rrt-star,informed-rrt-star --seeds 20 --svg "
         "gap.svg\n"
         "      How soon each has a path, and how it becomes shorter, over samples and over time.\n"
         "  replan anytime maps/gap-for-samples.json --planner rrt-star --set samples=1000000 --time 0.5 "
         "--csv -\n"
         "      Half a second each: every gain as a line.\n"
         "  replan anytime maps/gap-for-samples.json --planner rrt-star --set samples=20000 --set "
         "no_gain=2000\n"
         "      Until 2000 samples have gained nothing.\n\n"
         "Plans are made on the whole map, and nobody drives. With the same seed a plan is the same each "
         "time, but\n"
         "for its times; one that --time ends is not. Exit code 0 if every plan found a path, 1 if not, 2 "
         "for bad input.\n\n" +
         settings_help();
}

}  // namespace

Command add_anytime(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "anytime", "Plan by samples, with many seeds, and tell how the path becomes shorter");
  const auto arguments = std::make_shared<AnytimeArguments>();
  arguments->world.declare(*app);
  app->add_option("--seeds", arguments->seeds, "So many plans of each planner: its seed and those behind it")
      ->type_name("N");
  app->add_option(
         "--time", arguments->seconds,
         "End each plan after so many seconds, with its path by then; and the search for the shortest of all "
         "ways likewise")
      ->type_name("SECONDS");
  app->add_option("--csv", arguments->csv, "Write a line for each gain; '-' prints them instead")
      ->type_name("FILE");
  app->add_option("--svg", arguments->svg, "Draw the curves")->type_name("FILE");
  app->footer(anytime_footer);
  return {app, [arguments] { return anytime(*arguments); }};
}

}  // namespace replan::cli
