// Runs as JSON and as CSV.
#include <algorithm>

#include "core/study/run_report.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

/// By cells, as their indices count: the middle of cell (x, y) is [x, y].
Json point_json(const Point& point, bool solid) {
  Json result = {plain_number(point.x - 0.5), plain_number(point.y - 0.5)};
  if (solid) result.push_back(plain_number(point.z - 0.5));
  return result;
}

std::string csv_number(const NamedFigure& figure) {
  return plain_number(figure.value.value_or(0)).dump();
}

Json figures_json(std::span<const NamedFigure> figures) {
  Json result = Json::object();
  for (const NamedFigure& figure : figures) {
    Json& value = result[std::string(figure.key)];
    if (figure.whole)
      value = static_cast<std::int64_t>(figure.value.value_or(0));
    else
      value = figure.value.value_or(0);
  }
  return result;
}

/// The path and the lengths of its figures in metres.
void add_metres(Json& run, const RunReport& report) {
  Json& path = run["path_m"] = Json::array();
  for (std::size_t i = 0; i < report.path.size(); ++i) {
    const Point place = report.frame->to_metres(report.path.point(i));
    path.push_back({place.x, place.y});
    if (report.solid) path.back().push_back(place.z);
  }
  run["metres_per_cell"] = report.frame->metres_per_cell();
  run["figures"].update(figures_json(in_metres(named_figures(report), *report.frame)));
}

/// The last columns of a metric map, by their names.
std::vector<std::pair<std::string, NamedFigure>> metric_columns(const RunReport& report) {
  std::vector<std::pair<std::string, NamedFigure>> columns;
  for (const NamedFigure& figure : in_metres(named_figures(report), *report.frame))
    columns.emplace_back(figure.key, figure);
  if (report.robot)
    for (const NamedFigure& figure : in_metres(named_figures(*report.robot), *report.frame))
      columns.emplace_back("robot_" + std::string(figure.key), figure);
  return columns;
}

}  // namespace

std::string runs_json(std::span<const RunReport> reports) {
  Json document = {{"runs", Json::array()}};
  for (const RunReport& report : reports) {
    Json run = {{"planner", report.planner}, {"status", report.status}};
    Json& path = run["path"] = Json::array();
    for (std::size_t i = 0; i < report.path.size(); ++i)
      path.push_back(point_json(report.path.point(i), report.solid));
    run["figures"] = figures_json(named_figures(report));
    if (report.frame) add_metres(run, report);
    for (const auto& [number, value] : report.plan_numbers)
      run["plan_numbers"][std::string(number.key)] = value;
    if (report.robot) {
      run["robot"] = {{"reached", report.robot->reached()},
                      {"ending", mission_state_name(report.robot->ending)},
                      {"last_status", status_name(report.robot->last_plan)}};
      if (report.robot->short_of_goal) run["robot"]["short_of_goal"] = *report.robot->short_of_goal;
      run["robot"].update(figures_json(named_figures(*report.robot)));
      run["robot"].update(figures_json(surprise_figures(*report.robot)));
      if (report.robot->drive) run["robot"].update(figures_json(drive_figures(*report.robot)));
      if (report.robot->kept) run["robot"].update(figures_json(kept_figures(*report.robot)));
      if (report.frame)
        run["robot"].update(figures_json(in_metres(named_figures(*report.robot), *report.frame)));
    }
    document["runs"].push_back(std::move(run));
  }
  return pretty_json(document);
}

std::string runs_csv(std::span<const RunReport> reports) {
  const bool robots = !reports.empty() && reports.front().robot.has_value();
  const bool metric = !reports.empty() && reports.front().frame.has_value();
  const bool drives = std::any_of(reports.begin(), reports.end(),
                                  [](const RunReport& each) { return each.robot && each.robot->drive; });
  const bool keeps = std::any_of(reports.begin(), reports.end(),
                                 [](const RunReport& each) { return each.robot && each.robot->kept; });
  std::string names = "planner,status", lines;
  RunReport some;
  if (!reports.empty()) some.radius = reports.front().radius;  // one robot has one size, whoever plans for it
  for (const NamedFigure& figure : named_figures(some)) names += "," + std::string(figure.key);
  if (robots) {
    names += ",robot_reached,robot_ending";
    for (const NamedFigure& figure : named_figures(RobotReport{}))
      names += ",robot_" + std::string(figure.key);
  }
  if (drives)
    for (const NamedFigure& figure : drive_figures(RobotReport{}))
      names += ",robot_" + std::string(figure.key);
  if (keeps)
    for (const NamedFigure& figure : kept_figures(RobotReport{}))
      names += ",robot_" + std::string(figure.key);
  if (metric)
    for (const auto& [name, figure] : metric_columns(reports.front())) names += "," + name;
  for (const RunReport& report : reports) {
    lines += report.planner + "," + std::string(report.status);
    for (const NamedFigure& figure : named_figures(report)) lines += "," + csv_number(figure);
    if (report.robot) {
      lines += std::string(report.robot->reached() ? ",true," : ",false,") +
               mission_state_name(report.robot->ending);
      for (const NamedFigure& figure : named_figures(*report.robot)) lines += "," + csv_number(figure);
      if (drives)
        for (const NamedFigure& figure : drive_figures(*report.robot)) lines += "," + csv_number(figure);
      if (keeps)
        for (const NamedFigure& figure : kept_figures(*report.robot)) lines += "," + csv_number(figure);
    }
    if (metric)
      for (const auto& [name, figure] : metric_columns(report)) lines += "," + csv_number(figure);
    lines += "\n";
  }
  return names + "\n" + lines;
}

}  // namespace replan
