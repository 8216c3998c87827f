// Studies as Markdown, CSV and JSON.
#include "core/study/study.hpp"
#include "core/study/study_words.hpp"
#include "core/world/json_reader.hpp"

namespace replan {

namespace {

std::string heading(const StudyFigure& figure) {
  std::string text(figure.label);
  if (!figure.unit.empty()) text += " (" + std::string(figure.unit) + ")";
  return text;
}

/// Medians of wall times, which a few slow runs do not move; means of all else, as papers have them.
std::string value_text(const StudyFigure& figure, const std::optional<Spread>& spread) {
  if (!spread) return "–";
  const auto text = [&](double value) { return told(value, figure.decimals); };
  if (figure.wall_time)
    return text(spread->median) + " (" + text(spread->low) + " to " + text(spread->high) + ")";
  return spread->count == 1 ? text(spread->mean) : text(spread->mean) + " ± " + text(spread->deviation);
}

std::optional<double> paper_value(const StudyReport& report, std::size_t figure, std::size_t planner,
                                  std::optional<std::size_t> world) {
  for (const PaperFigure& paper : report.paper)
    if (paper.figure == figure && paper.planner == planner && paper.world == world) return paper.value;
  return std::nullopt;
}

bool in_paper(const StudyReport& report, std::size_t figure) {
  for (const PaperFigure& paper : report.paper)
    if (paper.figure == figure) return true;
  return false;
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string found_text(const StudyReport& report, std::size_t planner, std::optional<std::size_t> world) {
  std::size_t runs = 0, found = 0;
  for (const StudyRun& run : report.runs) {
    if (run.planner != planner || (world && run.world != *world)) continue;
    ++runs;
    found += run.found ? 1 : 0;
  }
  return std::to_string(found) + " of " + std::to_string(runs);
}

std::string table_of(const StudyReport& report, std::optional<std::size_t> world) {
  std::vector<std::string> names{"planner", "paths"}, rule{"---", "---:"};
  for (std::size_t f = 0; f < report.figures.size(); ++f) {
    names.push_back(heading(report.figures[f]));
    if (in_paper(report, f)) names.push_back("the paper's");
  }
  rule.resize(names.size(), "---:");
  std::string text = line_of(names) + line_of(rule);
  for (std::size_t p = 0; p < report.planners.size(); ++p) {
    std::vector<std::string> cells{report.planners[p], found_text(report, p, world)};
    for (std::size_t f = 0; f < report.figures.size(); ++f) {
      cells.push_back(value_text(report.figures[f], spread_of(report, f, p, world)));
      if (!in_paper(report, f)) continue;
      const auto paper = paper_value(report, f, p, world);
      cells.push_back(paper ? told(*paper, report.figures[f].decimals) : "–");
    }
    text += line_of(cells);
  }
  return text;
}

std::string claims_of(const StudyReport& report) {
  std::string text = "| the paper says | here | verdict |\n| --- | --- | --- |\n";
  for (const StudyClaim& claim : report.claims)
    text += line_of({claim.paper, claim.why.empty() ? claim.ours : claim.ours + " " + claim.why,
                     verdict_name(claim.verdict)});
  return text;
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
                     std::string(info.setting) + "\n\n";
  if (report.worlds_apart) {
    for (std::size_t w = 0; w < report.worlds.size(); ++w)
      text += "## " + report.worlds[w] + "\n\n" + table_of(report, w) + "\n";
  } else {
    text += table_of(report, std::nullopt) + "\n";
  }
  text += "Means with their standard deviation; times are medians with their quartiles.\n";
  if (!report.claims.empty()) text += "\n## What the paper claims\n\n" + claims_of(report);
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
    text += report.worlds[run.world] + "," + report.planners[run.planner] + "," + std::to_string(run.seed) +
            (run.found ? ",1" : ",0");
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
