#include "core/world/choice_json.hpp"

#include "core/base/words.hpp"
#include "core/lattice/box_lattice.hpp"
#include "core/plan/stage.hpp"
#include "core/world/choices.hpp"
#include "core/world/scenario.hpp"

namespace replan {
namespace {

constexpr std::size_t kMaxStages = 8;
constexpr double kMostSensed = 10'000;   // cells
constexpr double kMaxPatience = 86'400;  // seconds

std::string choices_of(const Parameter& parameter) {
  return "one of \"" + joined(parameter.choices, "\", \"") + "\"";
}

void read_stage(const JsonNode& node, std::vector<StageChoice>& stages) {
  if (!node.expect_object({"id", "settings"})) return;
  const auto id = node.require("id");
  if (!id) return;
  StageChoice choice{id->text(), {}};
  const Result<const StageInfo*> info = require_stage(choice.id);
  if (!info) return id->fail(info.error());
  if (const auto settings = node.find("settings"))
    read_settings(*settings, (*info)->parameters, choice.settings);
  stages.push_back(std::move(choice));
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

}  // namespace

void read_setting(const JsonNode& value, std::span<const Parameter> parameters, std::string_view key,
                  Settings& settings) {
  const Parameter* parameter = find_parameter(parameters, key);
  const bool text = parameter != nullptr && parameter->type == ParameterType::choice;
  const bool toggle = parameter != nullptr && parameter->type == ParameterType::toggle;
  if (parameter != nullptr && (text != value.value().is_string() || toggle != value.value().is_boolean()))
    return value.fail(text ? "must be a text in quotes, " + choices_of(*parameter) + ", not " + value.shown()
                      : toggle ? "must be true or false, not " + value.shown()
                               : "must be a number from " + plain_number(parameter->low).dump() + " to " +
                                     plain_number(parameter->high).dump() + ", not " + value.shown());
  const std::string typed = value.value().is_string() ? value.text() : value.value().dump();
  if (const auto set = set_from_text(settings, parameters, key, typed); !set) value.fail(set.error());
}

void read_settings(const JsonNode& node, std::span<const Parameter> parameters, Settings& settings) {
  if (!node.value().is_object()) return node.fail("must be an object {...}, not " + node.shown());
  for (auto item = node.value().begin(); item != node.value().end(); ++item)
    read_setting(*node.find(item.key()), parameters, item.key(), settings);
}

void read_stages(const JsonNode& node, std::vector<StageChoice>& stages) {
  for (const JsonNode& item : node.items(0, kMaxStages, "a list of at most 8 stages"))
    read_stage(item, stages);
}

void read_robot_setup(const JsonNode& node, const Box& world, RobotSetup& robot) {
  if (!node.expect_object({"knowledge", "sensor_radius", "sensor_angle", "sensor_blocked", "radius", "motion",
                           "speed", "patience", "unreachable_goal", "robot_cell_blocks", "kind", "settings"}))
    return;
  if (const auto kind = node.find("kind")) {
    robot.kind = kind->text();
    if (const auto known = require_robot(robot.kind, world); !known) return kind->fail(known.error());
  }
  if (const auto settings = node.find("settings"))
    read_settings(*settings, find_robot(robot.kind)->parameters, robot.settings);
  if (const auto item = node.find("knowledge"))
    robot.knowledge = static_cast<Knowledge>(item->one_of({"all", "map", "nothing"}));
  if (const auto item = node.find("sensor_radius")) robot.sensor_radius = item->number(0, kMostSensed);
  if (const auto item = node.find("sensor_angle")) robot.sensor_angle = item->number(1, 360);
  if (const auto item = node.find("sensor_blocked")) robot.sensor_blocked = item->toggle();
  if (const auto item = node.find("radius")) robot.radius = item->number(0, MoveRules::kMostRadius);
  if (const auto item = node.find("motion"))
    robot.motion = static_cast<Motion>(item->one_of({"steps", "smooth"}));
  if (const auto item = node.find("speed")) robot.speed = item->number(kMinSpeed, kMaxSpeed);
  if (const auto item = node.find("patience")) robot.patience = item->number(0, kMaxPatience);
  if (const auto item = node.find("unreachable_goal"))
    robot.unreachable_goal = static_cast<UnreachableGoal>(item->one_of({"wait", "nearest"}));
  if (const auto item = node.find("robot_cell_blocks")) robot.robot_cell_blocks = item->toggle();
}

Json planner_json(const PlannerChoice& choice) {
  Json planner = {{"id", choice.id}};
  add_settings(planner, choice.settings, parameters_of(find_choice(choice.id)));
  for (const StageChoice& stage : choice.stages) {
    Json one = {{"id", stage.id}};
    add_settings(one, stage.settings, parameters_of(find_stage(stage.id)));
    planner["stages"].push_back(std::move(one));
  }
  return planner;
}

Json robot_json(const RobotSetup& robot) {
  constexpr const char* kKnowledge[] = {"all", "map", "nothing"};
  Json result = {{"knowledge", kKnowledge[static_cast<std::size_t>(robot.knowledge)]},
                 {"sensor_radius", plain_number(robot.sensor_radius)},
                 {"sensor_blocked", robot.sensor_blocked}};
  const RobotSetup usual;
  if (robot.sensor_angle != usual.sensor_angle) result["sensor_angle"] = plain_number(robot.sensor_angle);
  if (robot.radius != usual.radius) result["radius"] = plain_number(robot.radius);
  if (robot.motion != usual.motion) result["motion"] = robot.motion == Motion::smooth ? "smooth" : "steps";
  if (robot.speed != usual.speed) result["speed"] = plain_number(robot.speed);
  if (robot.patience != usual.patience) result["patience"] = plain_number(robot.patience);
  if (robot.unreachable_goal != usual.unreachable_goal) result["unreachable_goal"] = "nearest";
  if (robot.robot_cell_blocks) result["robot_cell_blocks"] = true;
  if (robot.kind != usual.kind) result["kind"] = robot.kind;
  add_settings(result, robot.settings, parameters_of(find_robot(robot.kind)));
  return result;
}

}  // namespace replan
