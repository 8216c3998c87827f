// An experiment as text, and what results call its parts.
#include "core/base/words.hpp"
#include "core/experiment/experiment.hpp"
#include "core/plan/stage.hpp"
#include "core/world/choice_json.hpp"
#include "core/world/choices.hpp"
#include "core/world/json_reader.hpp"
#include "core/world/scenario_map.hpp"

namespace replan {
namespace {

Json world_json(const ExperimentWorld& world) {
  Json json = {{"file", world.file}};
  if (!world.map.empty()) json["map"] = world.map;
  if (world.limit > 0) json["limit"] = world.limit;
  if (world.start) json["start"] = *world.start;
  if (world.goal) json["goal"] = *world.goal;
  add_map_reading(json, world.reading);
  return json;
}

Json surprises_json(const ExperimentSurprises& surprises) {
  using Kind = ExperimentSurprises::Kind;
  if (surprises.kind == Kind::none) return "none";
  if (surprises.kind == Kind::own) return "own";
  const RandomBlocks& blocks = surprises.blocks;
  return {{"blocks", blocks.count}, {"side", blocks.side}, {"ahead", plain_number(blocks.ahead)}};
}

/// "a=1 b=x", of the keys whose values are not those of `usual`; of an object in an object "a.b=1".
std::string pairs_label(const Json& object, const Json& usual, const std::string& prefix = "") {
  std::string label;
  for (auto item = object.begin(); item != object.end(); ++item) {
    const auto same = usual.find(item.key());
    if (same != usual.end() && *same == *item) continue;
    if (!label.empty()) label += ' ';
    label += item->is_object()   ? pairs_label(*item, Json::object(), prefix + item.key() + ".")
             : item->is_string() ? prefix + item.key() + "=" + item->get<std::string>()
                                 : prefix + item.key() + "=" + item->dump();
  }
  return label;
}

std::string values_label(const Settings& settings, std::span<const Parameter> parameters) {
  std::string label;
  for (const auto& [key, value] : settings.values())
    if (const Parameter* parameter = find_parameter(parameters, key))
      label += (label.empty() ? "" : " ") + key + "=" + format_value(*parameter, value);
  return label;
}

}  // namespace

std::string experiment_text(const Experiment& experiment) {
  Json document = {{"format", "replan experiment"}, {"version", 1}};
  if (!experiment.name.empty()) document["name"] = experiment.name;
  document["drive"] = experiment.drive;
  document["repeat"] = experiment.repeat;
  if (experiment.seconds) document["limit"] = {{"seconds", plain_number(*experiment.seconds)}};
  for (const PlannerChoice& choice : experiment.planners)
    document["planners"].push_back(planner_json(choice));
  for (const auto& robot : experiment.robots)
    document["robots"].push_back(robot ? robot_json(*robot) : Json("own"));
  for (const ExperimentWorld& world : experiment.worlds) document["worlds"].push_back(world_json(world));
  if (experiment.drive)
    for (const ExperimentSurprises& one : experiment.surprises)
      document["surprises"].push_back(surprises_json(one));
  document["seeds"] = experiment.seeds;
  return pretty_json(document);
}

std::string settings_label(const PlannerChoice& choice) {
  return values_label(choice.settings, find_choice(choice.id)->parameters);
}

std::string stages_label(const PlannerChoice& choice) {
  std::string label;
  for (const StageChoice& stage : choice.stages) {
    const std::string values = values_label(stage.settings, find_stage(stage.id)->parameters);
    label += (label.empty() ? "" : ", ") + stage.id + (values.empty() ? "" : " " + values);
  }
  return label;
}

std::string robot_label(const std::optional<RobotSetup>& robot) {
  if (!robot) return {};
  const std::string label = pairs_label(robot_json(*robot), robot_json({}));
  return label.empty() ? "usual" : label;
}

std::string surprises_label(const ExperimentSurprises& surprises) {
  using Kind = ExperimentSurprises::Kind;
  if (surprises.kind != Kind::blocks) return surprises.kind == Kind::none ? "none" : "own";
  const RandomBlocks& blocks = surprises.blocks;
  return counted(blocks.count, "block") + " of " + std::to_string(blocks.side) + ", " +
         plain_number(blocks.ahead).dump() + " ahead";
}

}  // namespace replan
