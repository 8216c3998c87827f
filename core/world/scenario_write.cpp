#include <algorithm>

#include "core/base/file.hpp"
#include "core/plan/registry.hpp"
#include "core/plan/stage.hpp"
#include "core/world/json_reader.hpp"
#include "core/world/scenario.hpp"

namespace replan {
namespace {

Json cell_json(Cell cell) {
  return Json::array({cell.x, cell.y});
}

Json map_json(const Scenario& scenario) {
  Json map = Json::object();
  if (!scenario.map_file.empty()) {
    const MapReading& reading = scenario.map_reading;
    constexpr const char* kUnknown[] = {"blocked", "free", "unmapped"};
    map["file"] = scenario.map_file;
    if (reading.image.threshold != ImageMapOptions{}.threshold) map["threshold"] = reading.image.threshold;
    if (reading.image.invert) map["invert"] = true;
    if (reading.unknown != UnknownCells::blocked)
      map["unknown"] = kUnknown[static_cast<std::size_t>(reading.unknown)];
    if (reading.occupied) map["occupied"] = plain_number(*reading.occupied);
    return map;
  }
  Json& rows = map["rows"] = Json::array();
  for (int y = 0; y < scenario.map.height; ++y) {
    std::string row;
    for (int x = 0; x < scenario.map.width; ++x)
      row += ".@?"[scenario.map.blocked[scenario.map.index({x, y})]];
    rows.push_back(std::move(row));
  }
  if (scenario.map.resolution != 1) map["resolution"] = plain_number(scenario.map.resolution);
  if (scenario.map.origin != std::array<double, 3>{})
    for (const double part : scenario.map.origin) map["origin"].push_back(plain_number(part));
  return map;
}

/// Puts the settings that are set under "settings"; none, and there is no such key.
void add_settings(Json& owner, const Settings& settings, std::span<const Parameter> parameters) {
  for (const auto& [key, value] : settings.values()) {
    const Parameter* parameter = find_parameter(parameters, key);
    const ParameterType type = parameter == nullptr ? ParameterType::real : parameter->type;
    Json& setting = owner["settings"][key];
    if (type == ParameterType::choice)
      setting = format_value(*parameter, value);
    else if (type == ParameterType::toggle)
      setting = value != 0;
    else
      setting = plain_number(value);
  }
}

/// What a registry has declared for an id; nothing for one that it does not know.
template <class Info>
std::span<const Parameter> parameters_of(const Info* info) {
  return info == nullptr ? std::span<const Parameter>() : info->parameters;
}

Json planner_json(const PlannerChoice& choice) {
  Json planner = {{"id", choice.id}};
  add_settings(planner, choice.settings, parameters_of(find_planner(choice.id)));
  for (const StageChoice& stage : choice.stages) {
    Json one = {{"id", stage.id}};
    add_settings(one, stage.settings, parameters_of(find_stage(stage.id)));
    planner["stages"].push_back(std::move(one));
  }
  return planner;
}

/// Cells as few rectangles: each grows from its first cell to the right, then down. Single cells are kept
/// apart.
Json cells_json(std::vector<Cell> cells) {
  const auto before = [](Cell a, Cell b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
  std::sort(cells.begin(), cells.end(), before);
  std::vector<bool> taken(cells.size());
  const auto find = [&](Cell cell) {  // the index of an untaken cell, or the end
    const auto at =
        static_cast<std::size_t>(std::lower_bound(cells.begin(), cells.end(), cell, before) - cells.begin());
    return at < cells.size() && cells[at] == cell && !taken[at] ? at : cells.size();
  };
  Json singles = Json::array(), rectangles = Json::array();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (taken[i]) continue;
    const Cell first = cells[i];
    int width = 0, height = 0;
    while (find({first.x + width, first.y}) != cells.size()) ++width;
    for (bool whole = true; whole; height += whole ? 1 : 0)
      for (int x = 0; x < width && whole; ++x) whole = find({first.x + x, first.y + height}) != cells.size();
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) taken[find({first.x + x, first.y + y})] = true;
    if (width * height == 1)
      singles.push_back(cell_json(first));
    else
      rectangles.push_back({first.x, first.y, width, height});
  }
  Json result = Json::object();
  if (!singles.empty()) result["cells"] = std::move(singles);
  if (!rectangles.empty()) result["rectangles"] = std::move(rectangles);
  return result;
}

Json surprise_json(const Surprise& surprise) {
  Json at = Json::object();
  if (surprise.at.move) at["move"] = *surprise.at.move;
  if (surprise.at.near) {
    at["near"] = cell_json(*surprise.at.near);
    at["within"] = plain_number(surprise.at.within);
  }
  std::vector<Cell> added, removed;
  for (const CellChange& change : surprise.cells) (change.blocked ? added : removed).push_back(change.cell);
  Json result = {{"at", std::move(at)}};
  const bool nothing_else = removed.empty() && !surprise.goal && !surprise.robot;
  if (!added.empty() || nothing_else) result["add"] = cells_json(std::move(added));
  if (!removed.empty()) result["remove"] = cells_json(std::move(removed));
  if (surprise.announced) result["announced"] = true;
  if (surprise.goal) result["goal"] = cell_json(*surprise.goal);
  if (surprise.robot) result["robot"] = cell_json(*surprise.robot);
  return result;
}

Json mover_json(const MovingObstacle& mover) {
  constexpr const char* kAtEnd[] = {"back", "loop", "stop"};
  Json result = Json::object();
  for (const Cell corner : mover.way) result["way"].push_back(cell_json(corner));
  if (mover.width != 1 || mover.height != 1) result["size"] = {mover.width, mover.height};
  result["speed"] = plain_number(mover.speed);
  result["at_end"] = kAtEnd[static_cast<std::size_t>(mover.at_end)];
  if (mover.from != 0) result["from"] = mover.from;
  return result;
}

Json robot_json(const RobotSetup& robot) {
  constexpr const char* kKnowledge[] = {"all", "map", "nothing"};
  Json result = {{"knowledge", kKnowledge[static_cast<std::size_t>(robot.knowledge)]},
                 {"sensor_radius", plain_number(robot.sensor_radius)},
                 {"sensor_blocked", robot.sensor_blocked}};
  const RobotSetup usual;
  if (robot.motion != usual.motion) result["motion"] = robot.motion == Motion::smooth ? "smooth" : "steps";
  if (robot.speed != usual.speed) result["speed"] = plain_number(robot.speed);
  if (robot.patience != usual.patience) result["patience"] = plain_number(robot.patience);
  if (robot.unreachable_goal != usual.unreachable_goal) result["unreachable_goal"] = "nearest";
  if (robot.robot_cell_blocks) result["robot_cell_blocks"] = true;
  if (robot.kind != usual.kind) result["kind"] = robot.kind;
  add_settings(result, robot.settings, parameters_of(find_robot(robot.kind)));
  return result;
}

Json view_json(const ViewSetup& view) {
  Json result = Json::object();
  if (!view.overlays.empty()) result["overlays"] = view.overlays;
  if (view.theme) result["theme"] = *view.theme;
  if (view.camera)
    result["camera"] = {{"x", plain_number(view.camera->x)},
                        {"y", plain_number(view.camera->y)},
                        {"zoom", plain_number(view.camera->zoom)}};
  return result;
}

Json debug_json(const DebugSetup& debug) {
  Json result = Json::object();
  for (const Breakpoint& breakpoint : debug.breakpoints) {
    Json one = {{"condition", breakpoint.condition}};
    if (!breakpoint.enabled) one["enabled"] = false;
    result["breakpoints"].push_back(std::move(one));
  }
  if (!debug.watches.empty()) result["watches"] = debug.watches;
  return result;
}

}  // namespace

std::string scenario_text(const Scenario& scenario) {
  Json document = {{"replan", 1}};
  if (!scenario.name.empty()) document["name"] = scenario.name;
  if (!scenario.caption.empty()) document["caption"] = scenario.caption;
  document["map"] = map_json(scenario);
  document["start"] = cell_json(scenario.start);
  document["goal"] = cell_json(scenario.goal);
  Json& planners = document["planners"] = Json::array();
  for (const PlannerChoice& choice : scenario.planners) planners.push_back(planner_json(choice));
  document["robot"] = robot_json(scenario.robot);
  for (const Surprise& surprise : scenario.surprises)
    document["surprises"].push_back(surprise_json(surprise));
  for (const MovingObstacle& mover : scenario.movers) document["movers"].push_back(mover_json(mover));
  if (scenario.view != ViewSetup{}) document["view"] = view_json(scenario.view);
  if (scenario.debug != DebugSetup{}) document["debug"] = debug_json(scenario.debug);
  document["seed"] = scenario.seed;
  return pretty_json(document);
}

Result<void> write_scenario(const Scenario& scenario, const std::string& path) {
  return write_file_atomically(path, scenario_text(scenario));
}

}  // namespace replan
