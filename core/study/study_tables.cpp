#include "core/study/study_tables.hpp"

#include <algorithm>

#include "core/study/study_words.hpp"

namespace replan {
namespace {

constexpr const char* kNothing = "–";

std::string heading_of(const StudyFigure& figure) {
  std::string text(figure.label);
  if (!figure.unit.empty()) text += " (" + std::string(figure.unit) + ")";
  return text;
}

std::string quartiles_text(const Spread& spread, int decimals) {
  return filled("{1} ({2} to {3})",
                {told(spread.median, decimals), told(spread.low, decimals), told(spread.high, decimals)});
}

/// Medians of wall times with their quartiles; means of all else, with their deviation where there is one.
std::string value_text(const StudyFigure& figure, const std::optional<Spread>& spread) {
  if (!spread) return kNothing;
  if (figure.wall_time) return quartiles_text(*spread, figure.decimals);
  const std::string mean = told(spread->mean, figure.decimals),
                    deviation = told(spread->deviation, figure.decimals);
  return deviation == told(0, figure.decimals) ? mean : mean + " ± " + deviation;
}

std::optional<double> paper_value(const StudyReport& report, std::size_t figure, std::size_t planner,
                                  std::optional<std::size_t> world) {
  for (const PaperFigure& paper : report.paper)
    if (paper.figure == figure && paper.planner == planner && paper.world == world) return paper.value;
  return std::nullopt;
}

bool in_paper(const StudyReport& report, std::size_t figure) {
  return std::any_of(report.paper.begin(), report.paper.end(),
                     [&](const PaperFigure& paper) { return paper.figure == figure; });
}

std::string found_text(const StudyReport& report, std::size_t planner, std::optional<std::size_t> world) {
  std::size_t runs = 0, found = 0;
  for (const StudyRun& run : report.runs) {
    if (run.planner != planner || (world && run.world != *world)) continue;
    ++runs;
    found += run.found ? 1 : 0;
  }
  return filled("{1} of {2}", {std::to_string(found), std::to_string(runs)});
}

std::vector<std::string> names_of_columns(const StudyReport& report) {
  std::vector<std::string> names{"planner", "paths"};
  for (std::size_t f = 0; f < report.figures.size(); ++f) {
    if (report.figures[f].wall_time)
      names.push_back(
          filled("{1}, {2} = 1", {std::string(report.figures[f].label), report.planners.front()}));
    names.push_back(heading_of(report.figures[f]));
    if (in_paper(report, f)) names.emplace_back("the paper's");
  }
  return names;
}

std::vector<std::string> line_of_planner(const StudyReport& report, std::size_t planner,
                                         std::optional<std::size_t> world) {
  std::vector<std::string> cells{report.planners[planner], found_text(report, planner, world)};
  for (std::size_t f = 0; f < report.figures.size(); ++f) {
    if (report.figures[f].wall_time) {
      const auto ratio = ratio_of(report, f, planner, 0, world);
      cells.push_back(ratio ? quartiles_text(*ratio, 2) : kNothing);
    }
    cells.push_back(value_text(report.figures[f], spread_of(report, f, planner, world)));
    if (!in_paper(report, f)) continue;
    const auto paper = paper_value(report, f, planner, world);
    cells.push_back(paper ? told(*paper, report.figures[f].decimals) : kNothing);
  }
  return cells;
}

StudyTable figure_table(const StudyReport& report, std::optional<std::size_t> world) {
  StudyTable table{world ? report.worlds[*world] : "", {names_of_columns(report)}};
  for (std::size_t p = 0; p < report.planners.size(); ++p)
    table.lines.push_back(line_of_planner(report, p, world));
  return table;
}

}  // namespace

std::vector<StudyTable> figure_tables(const StudyReport& report) {
  if (!report.worlds_apart) return {figure_table(report, std::nullopt)};
  std::vector<StudyTable> tables;
  for (std::size_t w = 0; w < report.worlds.size(); ++w) tables.push_back(figure_table(report, w));
  return tables;
}

StudyTable claim_table(const StudyReport& report) {
  StudyTable table{"", {{"the paper says", "here", "verdict"}}, 3};
  for (const StudyClaim& claim : report.claims)
    table.lines.push_back({claim.paper, claim.why.empty() ? claim.ours : claim.ours + " " + claim.why,
                           verdict_name(claim.verdict)});
  return table;
}

std::string seeds_words(const StudyInfo& info, const StudyReport& report) {
  const std::string id(info.id), seeds = std::to_string(report.seeds);
  if (report.seeds == info.seeds) return filled("Seeds: {1}. Command: replan study {2}", {seeds, id});
  return filled(
      "Seeds: {1}, in place of the {3} that it is meant to have. Command: replan study {2} --seeds {1}",
      {seeds, id, std::to_string(info.seeds)});
}

std::string table_words(const StudyReport& report) {
  std::string words =
      "Means with their standard deviation, over the runs that have the figure; times are medians with their "
      "quartiles, "
      "first as ratios run by run. Times are those that the processor worked.";
  if (!report.machine.empty()) words += " " + report.machine;
  return words;
}

}  // namespace replan
