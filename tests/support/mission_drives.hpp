// Many random missions, each held to what must be true of any, and some of them taken up in the middle.
#pragma once

#include <string>
#include <vector>

#include "core/plan/registry.hpp"
#include "tests/support/mission_witness.hpp"
#include "tests/support/taking_up.hpp"

namespace replan::test {

/// What missions came to.
struct DriveTotals {
  MissionTotals of;
  std::int64_t taken_up = 0;
  std::string fault;  ///< of the first mission that did what it must not, with its scenario; empty: none did
};

/// Drives missions 0 to `count` by these planners in turn, and takes up every `taken_up_each`-th in its middle. How the one of
/// a seed looks says `draw(seed, info)`.
template <class Draw>
DriveTotals drive_missions(std::uint64_t count, const std::vector<const PlannerInfo*>& planners,
                           std::uint64_t taken_up_each, Draw&& draw) {
  DriveTotals totals;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const PlannerInfo& info = *planners[seed % planners.size()];
    const Scenario scenario = draw(seed, info);
    MissionWitness witness(scenario, info);
    std::string fault = witness.run(totals.of);
    Random random(seed);
    if (fault.empty() && seed % taken_up_each == 0) {
      fault = taken_up(random, scenario, witness.log());
      ++totals.taken_up;
    }
    if (fault.empty()) continue;
    totals.fault = fault + ", seed " + std::to_string(seed) + ", " + std::string(info.id) + "\n" +
                   scenario_text(scenario);
    break;
  }
  return totals;
}

}  // namespace replan::test
