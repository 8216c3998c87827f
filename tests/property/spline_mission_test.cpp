// Robots along paths that were rounded to curves, in worlds that change: none enters an obstacle, and all come where those
// along plain paths come.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/mission_witness.hpp"

namespace replan::test::spline_mission_test {
namespace {

template <class Make>
void drive_missions(const char* id, std::uint64_t count, const Make& make) {
  const PlannerInfo& info = *find_planner(id);
  MissionTotals totals;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    Random random(seed);
    Scenario scenario = make(random, info);
    Settings settings;
    settings.set("samples", random.between(1, 12));
    settings.set("corners_only", random.below(2));
    scenario.planners[0].stages = {{"bspline", settings}};
    MissionWitness witness(scenario, info);
    const std::string fault = witness.run(totals);
    ASSERT_EQ(fault, "") << id << ", seed " << seed << "\n" << scenario_text(scenario);
  }
  std::printf("%s: %lld missions, %lld arrived, %lld without a path, %lld moves, %lld replans\n", id,
              static_cast<long long>(totals.missions), static_cast<long long>(totals.arrived),
              static_cast<long long>(totals.no_path), static_cast<long long>(totals.moves),
              static_cast<long long>(totals.replans));
  EXPECT_GT(totals.arrived, static_cast<std::int64_t>(count) / 10);
}

class SplineMissions : public ::testing::TestWithParam<const char*> {};

TEST_P(SplineMissions, EndWithoutACollisionInThePlane) {
  drive_missions(GetParam(), 500,
                 [](Random& random, const PlannerInfo& info) { return random_scenario(random, info); });
}
TEST_P(SplineMissions, EndWithoutACollisionInSpace) {
  drive_missions(GetParam(), 200,
                 [](Random& random, const PlannerInfo& info) { return random_voxel_scenario(random, info); });
}

INSTANTIATE_TEST_SUITE_P(Planners, SplineMissions,
                         ::testing::Values("astar", "theta-star", "dstar-lite", "dld-star-lite",
                                           "threat-astar"));

}  // namespace
}  // namespace replan::test::spline_mission_test
