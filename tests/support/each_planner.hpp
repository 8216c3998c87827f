// Tests that hold for every planner, named after it.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/plan/registry.hpp"

namespace replan::test {

/// As parameters of a suite: planners(), or sound_planners().
inline std::vector<const PlannerInfo*> each_of(std::span<const PlannerInfo> infos) {
  std::vector<const PlannerInfo*> all;
  for (const PlannerInfo& info : infos) all.push_back(&info);
  return all;
}

/// The id as a test's name may spell it: "dstar_lite".
inline std::string planner_test_name(const testing::TestParamInfo<const PlannerInfo*>& info) {
  std::string name(info.param->id);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace replan::test
