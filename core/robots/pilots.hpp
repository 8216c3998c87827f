// The dynamic window by itself, and fused with a planner.
//
//  Fox D., Burgard W. & Thrun S., "The dynamic window approach to collision avoidance", IEEE Robotics & Automation
//  Magazine 4(1), 1997, doi 10.1109/100.580977
//  Liu J., Xue L., Zhang H. & Liu Z., "Robot dynamic path planning based on improved A* and DWA algorithm" (Henan
//  University of Technology)
#pragma once

#include <string_view>

#include "core/plan/planner_choice.hpp"
#include "core/plan/registry.hpp"

namespace replan {

/// Heads for the goal itself.
struct DwaPilot {
  static constexpr std::string_view kRobot = "dwa";
  static PlannerInfo describe();
  static PlannerChoice planner(const PlannerChoice& asked);
};

/// Takes the turns of a planner's smoothed path for sub-goals.
struct FusionPilot {
  static constexpr std::string_view kRobot = "dwa";
  static PlannerInfo describe();
  static PlannerChoice planner(const PlannerChoice& asked);
};

}  // namespace replan
