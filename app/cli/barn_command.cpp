#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/plan/registry.hpp"
#include "core/study/barn.hpp"

namespace replan::cli {
namespace {

constexpr std::string_view kNoPlan = "none";

struct BarnArguments {
  std::string folder;
  std::vector<std::string> globals{"none", "adaptive-astar", "astar", "dstar-lite"};
  std::vector<std::string> settings;
  std::vector<std::string> worlds;
  std::string csv;
};

Result<Settings> drive_values(const std::vector<std::string>& texts) {
  Settings settings;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return Error{"--set " + text + " is not KEY=VALUE."};
    const auto set = set_from_text(settings, drive_parameters(), std::string_view(text).substr(0, equals),
                                   std::string_view(text).substr(equals + 1));
    if (!set) return Error{set.error()};
  }
  return settings;
}

Result<std::vector<BarnWorld>> worlds_of(const BarnArguments& arguments) {
  auto all = read_barn(arguments.folder);
  if (!all || arguments.worlds.empty()) return all;
  std::vector<BarnWorld> chosen;
  for (const std::string& text : split_list(arguments.worlds)) {
    const auto number = parse_count("--world", text, 0);
    if (!number) return Error{number.error()};
    const auto found = std::find_if(all->begin(), all->end(),
                                    [&](const BarnWorld& world) { return world.number == *number; });
    if (found == all->end()) return Error{"There is no world " + text + " in " + arguments.folder + "."};
    chosen.push_back(*found);
  }
  return chosen;
}

Result<int> barn(const BarnArguments& arguments) {
  const auto drive = drive_values(arguments.settings);
  if (!drive) return Error{drive.error()};
  const std::vector<std::string> globals = split_list(arguments.globals);
  for (const std::string& id : globals)
    if (const auto known = require_planner(id); id != kNoPlan && !known) return Error{known.error()};
  const auto worlds = worlds_of(arguments);
  if (!worlds) return Error{worlds.error()};
  std::vector<BarnSummary> summaries;
  std::string csv = barn_csv({}, {}), failures;
  for (const std::string& id : globals) {
    const bool alone = id == kNoPlan;
    const std::string name = alone ? "dwa" : "fusion with " + id;
    const BarnSettings settings = barn_settings(*drive, alone ? "" : id);
    const auto drives = drive_barn(*worlds, settings);
    failures += barn_failures(name, *worlds, drives, settings);
    summaries.push_back(summary_of(name, drives));
    csv += barn_csv(name, drives);
  }
  print(barn_table(summaries) + (failures.empty() ? "" : "\n" + failures));
  if (!arguments.csv.empty())
    if (const auto written = write_file_atomically(arguments.csv, csv); !written)
      return Error{written.error()};
  return kDone;
}

/// The drive's settings with this benchmark's defaults.
std::string drive_settings_help() {
  const Settings defaults = barn_drive();
  std::string text = "\nSettings of the drive:\n";
  for (const Parameter& parameter : drive_parameters()) {
    const std::string key =
        std::string(parameter.key) + "=" + format_value(parameter, defaults.get(parameter));
    const std::string unit = parameter.unit.empty() ? "" : " " + std::string(parameter.unit);
    std::string start = "  " + key + unit;
    start.resize(std::max(start.size() + 1, std::size_t{32}), ' ');
    text += start + wrapped(parameter.help, 32) + "\n";
  }
  return text;
}

std::string barn_footer() {
  return "Examples:\n"
         "  replan barn data/barn --csv worlds.csv\n"
         "      All worlds, with no plan and with three planners; a table, and a line for each drive in a "
         "file.\n"
         "  replan barn data/barn --global dstar-lite --world 0,295 --set horizon=2\n"
         "      Two worlds with another setting of the drive.\n\n"
         "The robot knows nothing but what its laser has seen. The worlds are those of Perille, Truong, Xiao "
         "& "
         "Stone,\n"
         "\"Benchmarking metric ground navigation\", 2020, as a folder with index.json and a .map for "
         "each.\n" +
         drive_settings_help();
}

}  // namespace

Command add_barn(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("barn", "Drive a robot through the BARN benchmark's worlds with DWA");
  const auto arguments = std::make_shared<BarnArguments>();
  app->add_option("FOLDER", arguments->folder, "The folder of the worlds")->required();
  app->add_option("--global", arguments->globals, "Planners of the global plan; none: plain DWA")
      ->type_name("ID,...");
  app->add_option("--set", arguments->settings, "A setting of the drive")->type_name("KEY=VALUE");
  app->add_option("--world", arguments->worlds, "Only these worlds")->type_name("N,...");
  app->add_option("--csv", arguments->csv, "Write a line for each drive")->type_name("FILE");
  app->footer(barn_footer);
  return {app, [arguments] { return barn(*arguments); }};
}

}  // namespace replan::cli
