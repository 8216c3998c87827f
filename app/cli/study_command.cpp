#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "core/base/file.hpp"
#include "core/study/study.hpp"

namespace replan::cli {
namespace {

struct StudyArguments {
  std::string name;
  std::string folder;
  std::string seeds;
  bool quick = false;
  bool json = false;
};

Result<void> write_study(const StudyInfo& info, const StudyReport& report, const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{"cannot make the folder '" + folder + "': " + failed.message()};
  const std::string stem = (std::filesystem::path(folder) / info.id).string();
  for (const auto& [ending, text] : {std::pair{".md", study_markdown(info, report)},
                                     {".csv", study_csv(report)},
                                     {".json", study_json(info, report)}})
    if (const auto written = write_file_atomically(stem + ending, text); !written) return written;
  return {};
}

Result<int> study(const StudyArguments& arguments) {
  const auto info = require_study(arguments.name);
  if (!info) return Error{info.error()};
  StudyWatch watch{.seeds = arguments.quick ? (*info)->quick_seeds : (*info)->seeds};
  if (!arguments.seeds.empty()) {
    const auto seeds = parse_count("--seeds", arguments.seeds, 1);
    if (!seeds) return Error{seeds.error()};
    constexpr std::int64_t kMostSeeds = 1'000'000;
    if (*seeds > kMostSeeds) return Error{"--seeds can be at most " + std::to_string(kMostSeeds)};
    watch.seeds = static_cast<std::uint64_t>(*seeds);
  }
  std::unique_ptr<ProgressBar> bar;
  watch.progress = [&](std::size_t done, std::size_t all) {
    if (bar == nullptr) bar = std::make_unique<ProgressBar>(std::string((*info)->id), all);
    bar->show(done);
  };
  const auto report = (*info)->run(watch);
  bar.reset();
  if (!report) return Error{report.error()};
  if (!arguments.folder.empty())
    if (const auto written = write_study(**info, *report, arguments.folder); !written)
      return Error{written.error()};
  print(arguments.json ? study_json(**info, *report) : study_markdown(**info, *report));
  return kDone;
}

std::string study_footer() {
  std::string text = "Studies:\n";
  for (const StudyInfo& info : studies()) {
    std::string start = "  " + std::string(info.id);
    start.resize(18, ' ');
    text += start + wrapped(info.title, 18) + "\n";
  }
  return text +
         "\nExamples:\n"
         "  replan study informed-rrt\n"
         "      A table for each world, the paper's claims and a verdict for each.\n"
         "  replan study dld-random --quick --out results\n"
         "      With few seeds, and also written as results/dld-random.md, .csv and .json.\n";
}

}  // namespace

Command add_study(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "study", "Run an experiment of the papers, and hold it against what they report");
  const auto arguments = std::make_shared<StudyArguments>();
  app->add_option("NAME", arguments->name, "Which; 'replan list studies' shows them")->required();
  app->add_option("--out", arguments->folder, "Write the report there too, as Markdown, CSV and JSON")
      ->type_name("DIR");
  app->add_option("--seeds", arguments->seeds, "How many seeds, instead of the study's own number")
      ->type_name("N");
  app->add_flag("--quick", arguments->quick, "With few seeds: to see whether it runs");
  app->add_flag("--json", arguments->json, "Print everything as JSON, every run included");
  app->footer(study_footer);
  return {app, [arguments] { return study(*arguments); }};
}

}  // namespace replan::cli
