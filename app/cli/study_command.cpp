#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/output.hpp"
#include "app/cli/window.hpp"
#include "app/study_files.hpp"
#include "core/base/file.hpp"
#include "core/base/folders.hpp"
#include "core/base/machine.hpp"
#include "core/study/study.hpp"

namespace replan::cli {
namespace {

constexpr std::string_view kAllStudies = "all";

struct StudyArguments {
  std::string name;
  std::string folder;
  std::string seeds;
  std::string barn;
  bool quick = false;
  bool json = false;
};

Result<std::vector<const StudyInfo*>> studies_named(const std::string& name) {
  std::vector<const StudyInfo*> found;
  if (name == kAllStudies) {
    for (const StudyInfo& info : studies()) found.push_back(&info);
    return found;
  }
  const auto info = require_study(name);
  if (!info) return Error{info.error()};
  found.push_back(*info);
  return found;
}

/// Nothing where none is asked for: each study has its own.
Result<std::optional<std::uint64_t>> asked_seeds(const StudyArguments& arguments) {
  if (arguments.seeds.empty()) return std::optional<std::uint64_t>();
  const auto seeds = parse_count("--seeds", arguments.seeds, 1);
  if (!seeds) return Error{seeds.error()};
  constexpr std::int64_t kMostSeeds = 1'000'000;
  if (*seeds > kMostSeeds) return Error{"--seeds can be at most " + std::to_string(kMostSeeds)};
  return std::optional(static_cast<std::uint64_t>(*seeds));
}

Result<StudyReport> run_study(const StudyInfo& info, const StudyArguments& arguments,
                              std::optional<std::uint64_t> seeds) {
  StudyWatch watch{.seeds = seeds.value_or(arguments.quick ? info.quick_seeds : info.seeds),
                   .barn = arguments.barn};
  std::optional<ProgressBar> bar;
  watch.progress = [&](std::size_t done, std::size_t all) {
    if (!bar) bar.emplace(std::string(info.id), all);
    bar->show(done);
  };
  const std::string machine = machine_sentence();
  auto report = info.run(watch);
  if (report) report->machine = machine;
  return report;
}

/// Written anew after each study, so that an interrupted run leaves a page of those that are done.
Result<void> write_page(const std::string& folder, const std::vector<StudySection>& sections) {
  return write_file_atomically((std::filesystem::path(folder) / "report.html").string(),
                               study_html(sections));
}

/// What became of the claims, a line for each study.
std::string summary_of_studies(const std::vector<StudySection>& sections) {
  Table table({{"study", Table::Align::left},
               {"claims"},
               {"reproduced"},
               {"partly"},
               {"not reproduced"},
               {"answered"}});
  for (const StudySection& section : sections) {
    std::array<std::size_t, 4> counts{};
    for (const StudyClaim& claim : section.report.claims) ++counts[static_cast<std::size_t>(claim.verdict)];
    table.add({std::string(section.info->id), std::to_string(section.report.claims.size()),
               std::to_string(counts[0]), std::to_string(counts[1]), std::to_string(counts[2]),
               std::to_string(counts[3])});
  }
  return table.text();
}

Result<int> study(const StudyArguments& arguments) {
  const auto chosen = studies_named(arguments.name);
  if (!chosen) return Error{chosen.error()};
  const auto seeds = asked_seeds(arguments);
  if (!seeds) return Error{seeds.error()};
  const bool kept = !arguments.folder.empty();
  if (kept)
    if (const auto made = make_folder(arguments.folder); !made) return Error{made.error()};
  std::vector<StudySection> sections;
  std::string json;
  for (const StudyInfo* info : *chosen) {
    auto report = run_study(*info, arguments, *seeds);
    if (!report) return Error{report.error()};
    if (arguments.json)
      json += (json.empty() ? "" : ",\n") + study_json(*info, *report);
    else if (chosen->size() == 1 || !kept)
      print(study_markdown(*info, *report) + (chosen->size() > 1 ? "\n" : ""));
    if (!kept) continue;
    auto section = app::write_study(*info, std::move(*report), arguments.folder, study_pen());
    if (!section) return Error{section.error()};
    for (const std::string& note : section->notes) tell_notes(std::span(&note, 1));
    sections.push_back(std::move(*section));
    if (const auto written = write_page(arguments.folder, sections); !written) return Error{written.error()};
  }
  if (arguments.json)
    print(chosen->size() == 1 ? json : "[" + json + "]\n");
  else if (kept && chosen->size() > 1)
    print(summary_of_studies(sections));
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
         "      With few seeds, and also written as results/dld-random.md, .csv and .json, with diagrams, "
         "pictures and\n"
         "      results/report.html, a page for a browser.\n"
         "  replan study all --out results\n"
         "      All of them on one page.\n";
}

}  // namespace

Command add_study(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "study", "Run an experiment of the papers, and hold it against what they report");
  const auto arguments = std::make_shared<StudyArguments>();
  app->add_option("NAME", arguments->name, "Which, or all; 'replan list studies' shows them")->required();
  app->add_option(
         "--out", arguments->folder,
         "Write the report there too: Markdown, CSV, JSON, diagrams, pictures, and a page for a browser")
      ->type_name("DIR");
  app->add_option("--seeds", arguments->seeds, "How many seeds, instead of the study's own number")
      ->type_name("N");
  app->add_option("--barn", arguments->barn, "The folder of the BARN benchmark, for the study named fusion")
      ->type_name("FOLDER");
  app->add_flag("--quick", arguments->quick, "With few seeds: to see whether it runs");
  app->add_flag("--json", arguments->json, "Print everything as JSON, every run included");
  app->footer(study_footer);
  return {app, [arguments] { return study(*arguments); }};
}

}  // namespace replan::cli
