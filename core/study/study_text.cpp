// Studies as Markdown, CSV and JSON.
#include <algorithm>

#include "core/base/csv.hpp"
#include "core/study/study_tables.hpp"
#include "core/world/json_reader.hpp"

namespace replan {

namespace {

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string markdown_table(const StudyTable& table) {
  std::vector<std::string> rule(table.lines.front().size(), "---:");
  std::fill_n(rule.begin(), table.words, "---");
  std::string text = table.heading.empty() ? "" : "## " + table.heading + "\n\n";
  text += line_of(table.lines.front()) + line_of(rule);
  for (std::size_t i = 1; i < table.lines.size(); ++i) text += line_of(table.lines[i]);
  return text + "\n";
}

Json spread_json(const Spread& spread) {
  return {{"count", spread.count},
          {"mean", plain_number(spread.mean)},
          {"deviation", plain_number(spread.deviation)},
          {"quartiles", {plain_number(spread.low), plain_number(spread.median), plain_number(spread.high)}}};
}

Json summaries_json(const StudyReport& report) {
  Json summaries = Json::array();
  for (std::size_t w = 0; w < report.worlds.size(); ++w)
    for (std::size_t p = 0; p < report.planners.size(); ++p)
      for (std::size_t f = 0; f < report.figures.size(); ++f)
        if (const auto spread = spread_of(report, f, p, w)) {
          Json one = {{"world", report.worlds[w]},
                      {"planner", report.planners[p]},
                      {"figure", report.figures[f].key}};
          one.update(spread_json(*spread));
          summaries.push_back(std::move(one));
        }
  return summaries;
}

Json runs_json(const StudyReport& report) {
  Json runs = Json::array();
  for (const StudyRun& run : report.runs) {
    Json one = {{"world", report.worlds[run.world]},
                {"planner", report.planners[run.planner]},
                {"seed", run.seed},
                {"found", run.found}};
    for (std::size_t f = 0; f < report.figures.size(); ++f)
      if (run.values[f]) one["figures"][std::string(report.figures[f].key)] = plain_number(*run.values[f]);
    runs.push_back(std::move(one));
  }
  return runs;
}

}  // namespace

std::string study_markdown(const StudyInfo& info, const StudyReport& report) {
  std::string text = "# " + std::string(info.title) + "\n\nAfter " + std::string(info.source) + ".\n\n" +
                     std::string(info.setting) + "\n\n" + seeds_words(info, report) + "\n\n";
  for (const StudyTable& table : figure_tables(report)) text += markdown_table(table);
  text += table_words(report) + "\n";
  if (!report.supplement.empty()) text += "\n" + report.supplement;
  if (!report.claims.empty()) text += "\n## What the paper claims\n\n" + markdown_table(claim_table(report));
  return text;
}

std::string study_csv(const StudyReport& report) {
  std::string text = "world,planner,seed,found";
  for (const StudyFigure& figure : report.figures) {
    text += "," + std::string(figure.key);
    if (!figure.unit.empty()) text += " [" + std::string(figure.unit) + "]";
  }
  text += "\n";
  for (const StudyRun& run : report.runs) {
    text += csv_field(report.worlds[run.world]) + "," + csv_field(report.planners[run.planner]) + "," +
            std::to_string(run.seed) + (run.found ? ",1" : ",0");
    for (const auto& value : run.values) text += "," + (value ? plain_number(*value).dump() : "");
    text += "\n";
  }
  return text;
}

std::string study_json(const StudyInfo& info, const StudyReport& report) {
  Json document = {
      {"study", info.id}, {"title", info.title}, {"source", info.source}, {"setting", info.setting}};
  for (const StudyFigure& figure : report.figures)
    document["figures"].push_back({{"key", figure.key}, {"label", figure.label}, {"unit", figure.unit}});
  for (const PaperFigure& paper : report.paper) {
    Json one = {{"planner", report.planners[paper.planner]}, {"figure", report.figures[paper.figure].key}};
    if (paper.world) one["world"] = report.worlds[*paper.world];
    one["value"] = plain_number(paper.value);
    document["paper"].push_back(std::move(one));
  }
  if (!report.machine.empty()) document["machine"] = report.machine;
  document["summaries"] = summaries_json(report);
  document["claims"] = Json::array();
  for (const StudyClaim& claim : report.claims)
    document["claims"].push_back({{"paper", claim.paper},
                                  {"ours", claim.ours},
                                  {"verdict", verdict_name(claim.verdict)},
                                  {"why", claim.why}});
  document["runs"] = runs_json(report);
  return pretty_json(document);
}

}  // namespace replan
