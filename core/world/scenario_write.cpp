#include "core/base/file.hpp"
#include "core/world/choice_json.hpp"
#include "core/world/json_reader.hpp"
#include "core/world/place_writer.hpp"
#include "core/world/scenario.hpp"
#include "core/world/scenario_map.hpp"

namespace replan {
namespace {

Json surprise_json(const PlaceWriter& places, const Surprise& surprise) {
  Json at = Json::object();
  if (surprise.at.move) at["move"] = *surprise.at.move;
  if (surprise.at.near) {
    at["near"] = places.cell(*surprise.at.near);
    at["within"] = plain_number(surprise.at.within);
  }
  std::vector<Cell> added, removed;
  for (const CellChange& change : surprise.cells) (change.blocked ? added : removed).push_back(change.cell);
  Json result = {{"at", std::move(at)}};
  const bool nothing_else = removed.empty() && !surprise.goal && !surprise.robot;
  if (!added.empty() || nothing_else) result["add"] = places.cells(std::move(added));
  if (!removed.empty()) result["remove"] = places.cells(std::move(removed));
  if (surprise.announced) result["announced"] = true;
  if (surprise.goal) result["goal"] = places.cell(*surprise.goal);
  if (surprise.robot) result["robot"] = places.cell(*surprise.robot);
  return result;
}

Json mover_json(const PlaceWriter& places, const MovingObstacle& mover) {
  constexpr const char* kAtEnd[] = {"back", "loop", "stop"};
  Json result = Json::object();
  for (const Cell corner : mover.way) result["way"].push_back(places.cell(corner));
  if (mover.width != 1 || mover.height != 1 || mover.depth != 1) {
    result["size"] = {mover.width, mover.height};
    if (places.solid()) result["size"].push_back(mover.depth);
  }
  result["speed"] = plain_number(mover.speed);
  result["at_end"] = kAtEnd[static_cast<std::size_t>(mover.at_end)];
  if (mover.from != 0) result["from"] = mover.from;
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
  const PlaceWriter places(scenario.map.box());
  document["map"] = map_json(scenario);
  document["start"] = places.cell(scenario.start);
  document["goal"] = places.cell(scenario.goal);
  Json& planners = document["planners"] = Json::array();
  for (const PlannerChoice& choice : scenario.planners) planners.push_back(planner_json(choice));
  document["robot"] = robot_json(scenario.robot);
  for (const Surprise& surprise : scenario.surprises)
    document["surprises"].push_back(surprise_json(places, surprise));
  for (const MovingObstacle& mover : scenario.movers) document["movers"].push_back(mover_json(places, mover));
  if (scenario.view != ViewSetup{}) document["view"] = view_json(scenario.view);
  if (scenario.debug != DebugSetup{}) document["debug"] = debug_json(scenario.debug);
  document["seed"] = scenario.seed;
  return pretty_json(document);
}

Result<void> write_scenario(const Scenario& scenario, const std::string& path) {
  return write_file_atomically(path, scenario_text(scenario));
}

}  // namespace replan
