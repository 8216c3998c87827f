#include "app/cli/batch_output.hpp"

#include "app/cli/output.hpp"
#include "core/world/choices.hpp"

namespace replan::cli {
namespace {

const char* noun_of(BatchKind kind) {
  return kind == BatchKind::problems ? "problem" : "run";
}

/// What the table cannot say: what was skipped, and which planners the listed lengths do not judge.
std::string remarks(std::span<const BatchReport> reports, BatchKind kind) {
  std::string text;
  const char* noun = noun_of(kind);
  if (const std::int64_t skipped = reports.empty() ? 0 : reports.front().skipped; skipped > 0)
    text += counted(skipped, noun) + " skipped: the start or the goal lies in an obstacle of the map.\n";
  for (const BatchReport& report : reports) {
    if (kind == BatchKind::problems && !report.comparable)
      text +=
          report.label + ": not held to the listed lengths; with these settings it looks for other paths.\n";
    if (report.unsolved() > 0)
      text += report.label + ": " + counted(report.unsolved(), noun) +
              (find_pilot(report.planner) != nullptr ? " in which the robot did not arrive.\n"
               : kind == BatchKind::problems         ? " without a path.\n"
                                                     : " that did not succeed.\n");
  }
  return text.empty() ? text : "\n" + text;
}

}  // namespace

std::string batch_table(std::span<const BatchReport> reports, BatchKind kind) {
  using enum Table::Align;
  Table table({{"planner", left},
               {std::string(noun_of(kind)) + "s"},
               {"skipped"},
               {"found"},
               {"mismatches"},
               {"max rel. error"},
               {"mean ratio"},
               {"total ms"},
               {"ms a " + std::string(noun_of(kind))},
               {"expansions"}});
  for (const BatchReport& report : reports) {
    const auto solved = static_cast<double>(std::max<std::int64_t>(1, report.problems - report.skipped));
    const bool listed = report.mean_ratio > 0;
    char error[32];
    std::snprintf(error, sizeof error, "%.2e", report.max_relative_error);
    table.add({report.label, std::to_string(report.problems), std::to_string(report.skipped),
               std::to_string(report.found), report.comparable ? std::to_string(report.mismatches) : "-",
               listed ? error : "-", listed ? decimals(report.mean_ratio, 6) : "-",
               decimals(report.total_ms, 1), decimals(report.total_ms / solved, 3),
               std::to_string(report.expansions)});
  }
  return table.text() + remarks(reports, kind);
}

std::string batch_title(const RunList& list, const std::string& source) {
  const bool named = !list.experiment().name.empty();
  const bool one_file = list.worlds().size() == 1 && list.worlds().front().lengths_are_listed();
  if (!named && one_file)
    return list.worlds().front().file + " on " + list.worlds().front().map_file + ", " +
           counted(list.count(), "run") + "\n\n";
  return (named ? list.experiment().name : source) + ": " + counted(list.worlds().size(), "world") + ", " +
         counted(list.experiment().planners.size(), "planner") + ", " + counted(list.count(), "run") + "\n\n";
}

void complain_of_mismatches(std::span<const BatchReport> reports) {
  for (const BatchReport& report : reports) {
    for (const BatchMismatch& mismatch : report.first_mismatches)
      complain(mismatch.world + ":" + std::to_string(mismatch.line) + ": " + report.label + " found " +
               (mismatch.found > 0 ? decimals(mismatch.found, 8) : "no path") + ", listed is " +
               decimals(mismatch.listed, 8));
    const auto told = static_cast<std::int64_t>(report.first_mismatches.size());
    if (report.mismatches > told)
      complain(report.label + ": and " + counted(report.mismatches - told, "more mismatch") +
               (report.mismatches - told == 1 ? "" : "es"));
  }
}

}  // namespace replan::cli
