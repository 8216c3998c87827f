// Which planner is to be used, and how.
#pragma once

#include <string>
#include <vector>

#include "core/plan/parameters.hpp"

namespace replan {

/// A stage that a path goes through, by its registry id, with the settings that differ from its defaults.
struct StageChoice {
  std::string id;
  Settings settings;
  friend bool operator==(const StageChoice&, const StageChoice&) = default;
};

/// A planner by its registry id, with the settings that differ from its defaults, and what its paths go
/// through before anybody follows them, in that order.
struct PlannerChoice {
  std::string id;
  Settings settings;
  std::vector<StageChoice> stages = {};
  friend bool operator==(const PlannerChoice&, const PlannerChoice&) = default;
};

}  // namespace replan
