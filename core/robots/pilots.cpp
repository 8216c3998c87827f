#include "core/robots/pilots.hpp"

#include <limits>
#include <string>
#include <vector>

#include "core/robots/dwa_robot.hpp"
#include "core/stages/floyd.hpp"

namespace replan {
namespace {

/// What improved A* is called here.
constexpr std::string_view kUsualGlobal = "adaptive-astar";

/// The stage's own parameter, by a key that tells what the distance is.
Parameter safety_parameter() {
  Parameter safety = parameters::kSafetyDistance;
  safety.key = "safety";
  return safety;
}

Parameter global_parameter() {
  Parameter global{.key = "global",
                   .label = "Global planner",
                   .type = ParameterType::choice,
                   .help =
                       "Who plans the path whose turns are the sub-goals, with its usual settings: any "
                       "planner that finds a path wherever there is one."};
  for (const PlannerInfo& info : complete_planners()) {
    if (info.id == kUsualGlobal) global.initial = static_cast<double>(global.choices.size());
    global.choices.push_back(info.id);
  }
  return global;
}

const PlannerInfo& global_of(const Settings& settings) {
  const double index = settings.get("global", global_parameter().initial);
  return complete_planners()[static_cast<std::size_t>(index)];
}

PlannerInfo driven(std::string_view name, std::string_view summary, std::string_view source) {
  PlannerInfo info;
  info.name = name;
  info.summary = summary;
  info.source = source;
  info.planar = true;
  info.any_angle = true;
  info.length_bound = [](const Settings&) { return std::numeric_limits<double>::infinity(); };
  return info;
}

void add(std::vector<Parameter>& all, std::span<const Parameter> more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

PlannerInfo DwaPilot::describe() {
  PlannerInfo info =
      driven("DWA",
             "No planner: a robot on two wheels that heads for the goal itself, along the arc that scores "
             "best each time.",
             "Fox, Burgard & Thrun 1997, doi 10.1109/100.580977");
  add(info.parameters, DwaRobot::describe().parameters);
  return info;
}

PlannerChoice DwaPilot::planner(const PlannerChoice& asked) {
  return {.id = "straight-line", .settings = {}, .stages = asked.stages};
}

PlannerInfo FusionPilot::describe() {
  PlannerInfo info =
      driven("Fusion",
             "A robot on two wheels that makes for the turns of a planner's smoothed path, one after the "
             "other, along the arc that scores best each time.",
             "Liu, Xue, Zhang & Liu, Henan University of Technology");
  info.parameters = {global_parameter(), safety_parameter()};
  add(info.parameters, lattice_parameters());
  add(info.parameters, DwaRobot::describe().parameters);
  return info;
}

PlannerChoice FusionPilot::planner(const PlannerChoice& asked) {
  const PlannerInfo& global = global_of(asked.settings);
  PlannerChoice choice{std::string(global.id), {}};
  for (const Parameter& rule : lattice_parameters())
    if (asked.settings.has(rule.key) && find_parameter(global.parameters, rule.key) != nullptr)
      choice.settings.set(rule.key, asked.settings.get(rule));
  StageChoice smoothing{"floyd", {}};
  if (const Parameter safety = safety_parameter(); asked.settings.has(safety.key))
    smoothing.settings.set(parameters::kSafetyDistance.key, asked.settings.get(safety));
  choice.stages.push_back(std::move(smoothing));
  choice.stages.insert(choice.stages.end(), asked.stages.begin(), asked.stages.end());
  return choice;
}

}  // namespace replan
