// What one can choose to have a robot go by: the planners that search, and pilots. A pilot is put together of a planner,
// what its paths go through, and a robot of its own kind, so that it can stand beside planners in one world and leave
// the scenario's robot to them. Pilots are made from robots/pilots.def; code asks pilots().
//
// A scenario, a title, a file and a report have what was asked for; what runs is worked out here and nowhere else.
#pragma once

#include <span>
#include <string_view>

#include "core/base/result.hpp"
#include "core/plan/planner_choice.hpp"
#include "core/plan/registry.hpp"
#include "core/world/robot.hpp"

namespace replan {

/// What can be said of a pilot without running it.
struct Pilot {
  PlannerInfo info;        ///< its name and its parameters; what it searches for is its planner's to say
  std::string_view robot;  ///< the kind that it drives; that kind's parameters are among its own
  /// What plans where this was asked for.
  PlannerChoice (*planner)(const PlannerChoice& asked) = nullptr;
};

/// All pilots, in the order of pilots.def.
std::span<const Pilot> pilots();
/// The pilot of that id, or nullptr: planners are none.
const Pilot* find_pilot(std::string_view id);

/// All that can be chosen: planners, then pilots, then the exercises.
std::span<const PlannerInfo> choices();
/// The planner or pilot of that id, or nullptr.
const PlannerInfo* find_choice(std::string_view id);
/// As find_choice(), with an error that suggests the nearest id.
Result<const PlannerInfo*> require_choice(std::string_view id);

/// What plans where that was asked for: itself, but for a pilot.
PlannerChoice planner_of(const PlannerChoice& asked);

/// What runs where something was asked for. Of a planner that is itself, with the robot that there is.
struct Resolved {
  PlannerChoice planner;
  RobotSetup robot;
};
/// `robot` is the scenario's. A pilot's own has all that it has but kind and settings; the settings too if the kind is
/// the same, but for those that were asked for.
Resolved resolved(const PlannerChoice& asked, const RobotSetup& robot);

/// What its run goes by, of all the parameters of info_of(asked): what was asked for, and of a pilot the settings that its
/// robot takes over from the scenario's.
Settings settings_of(const PlannerChoice& asked, const RobotSetup& robot);

/// What a run of it is: values, laws and traits of what plans, under the id, the name and the words of what was asked
/// for, with the parameters of both. Lives as long as the program.
const PlannerInfo& info_of(const PlannerChoice& asked);

}  // namespace replan
