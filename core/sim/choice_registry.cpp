// What can be chosen, made from planners.def and robots/pilots.def.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/plan/named.hpp"
#include "core/world/choices.hpp"

#define REPLAN_PILOT_HEADERS
#include "core/robots/pilots.def"
#undef REPLAN_PILOT_HEADERS

namespace replan {
namespace {

template <class Of>
Pilot pilot_of(std::string_view id) {
  Pilot pilot{Of::describe(), Of::kRobot, Of::planner};
  pilot.info.id = id;
  return pilot;
}

/// PlannerInfo of a pilot for which that planner plans.
PlannerInfo flown(const PlannerInfo& pilot, const PlannerInfo& planner) {
  PlannerInfo info = planner;
  info.id = pilot.id;
  info.name = pilot.name;
  info.summary = pilot.summary;
  info.source = pilot.source;
  info.planar |= pilot.planar;
  info.parameters = pilot.parameters;
  for (const Parameter& parameter : planner.parameters)
    if (find_parameter(info.parameters, parameter.key) == nullptr) info.parameters.push_back(parameter);
  return info;
}

using PilotAndPlanner = std::pair<std::string_view, std::string_view>;

std::map<PilotAndPlanner, PlannerInfo> all_flown() {
  std::map<PilotAndPlanner, PlannerInfo> all;
  for (const Pilot& pilot : pilots())
    for (const PlannerInfo& planner : listed_planners())
      all.emplace(PilotAndPlanner{pilot.info.id, planner.id}, flown(pilot.info, planner));
  return all;
}

}  // namespace

std::span<const Pilot> pilots() {
  static const std::vector<Pilot> all = {
#define REPLAN_PILOT(ID, CLASS) pilot_of<CLASS>(ID),
#include "core/robots/pilots.def"
#undef REPLAN_PILOT
  };
  return all;
}

const Pilot* find_pilot(std::string_view id) {
  for (const Pilot& pilot : pilots())
    if (pilot.info.id == id) return &pilot;
  return nullptr;
}

std::span<const PlannerInfo> choices() {
  static const std::vector<PlannerInfo> all = [] {
    const auto sound = sound_planners();
    std::vector<PlannerInfo> infos(sound.begin(), sound.end());
    for (const Pilot& pilot : pilots()) infos.push_back(pilot.info);
    infos.insert(infos.end(), planners().begin() + static_cast<std::ptrdiff_t>(sound.size()),
                 planners().end());
    return infos;
  }();
  return all;
}

const PlannerInfo* find_choice(std::string_view id) {
  return find_by_id(choices(), id);
}

Result<const PlannerInfo*> require_choice(std::string_view id) {
  return require_by_id(choices(), id, "planner");
}

PlannerChoice planner_of(const PlannerChoice& asked) {
  const Pilot* pilot = find_pilot(asked.id);
  return pilot == nullptr ? asked : pilot->planner(asked);
}

Resolved resolved(const PlannerChoice& asked, const RobotSetup& robot) {
  const Pilot* pilot = find_pilot(asked.id);
  if (pilot == nullptr) return {asked, robot};
  Resolved run{pilot->planner(asked), robot};
  run.robot.kind = pilot->robot;
  if (robot.kind != pilot->robot) run.robot.settings = {};
  for (const Parameter& own : find_robot(pilot->robot)->parameters)
    if (asked.settings.has(own.key)) run.robot.settings.set(own.key, asked.settings.get(own));
  return run;
}

Settings settings_of(const PlannerChoice& asked, const RobotSetup& robot) {
  Settings all = asked.settings;
  if (find_pilot(asked.id) == nullptr) return all;
  const Resolved run = resolved(asked, robot);
  for (const Parameter& rule : lattice_parameters())
    if (!run.planner.settings.has(rule.key)) all.reset(rule.key);  // of a planner that has no choice
  for (const auto& [key, value] : run.robot.settings.values()) all.set(key, value);
  return all;
}

const PlannerInfo& info_of(const PlannerChoice& asked) {
  const Pilot* pilot = find_pilot(asked.id);
  if (pilot == nullptr) return *find_planner(asked.id);
  static const std::map<PilotAndPlanner, PlannerInfo> all = all_flown();
  return all.at({pilot->info.id, find_planner(pilot->planner(asked).id)->id});
}

}  // namespace replan
