// Random missions in worlds that change: with surprises, moving obstacles and sensors of every kind the robot
// never enters an obstacle, and where it gives up there is no path on its map. Where it makes for the cell
// nearest to its goal, that is the cell which brute force names, and none is nearer that it could reach.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/each_planner.hpp"
#include "tests/support/mission_witness.hpp"

namespace replan::test::mission_property_test {
namespace {

constexpr int kMissions = 20'004;  // a multiple of the number of planners, below

class RandomMissions : public ::testing::TestWithParam<const PlannerInfo*> {};

TEST_P(RandomMissions, endWithoutACollision) {
  const PlannerInfo& info = *GetParam();
  MissionTotals totals;
  const auto count = static_cast<std::uint64_t>(kMissions) / sound_planners().size();
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    Random random(seed * 1000 + static_cast<std::uint64_t>(&info - planners().data()));
    const Scenario scenario = random_scenario(random, info);
    MissionWitness witness(scenario, info);
    const std::string fault = witness.run(totals);
    ASSERT_EQ(fault, "") << "seed " << seed << ", " << describe_settings(info, scenario.planners[0].settings)
                         << "\n"
                         << scenario_text(scenario);
  }
  std::printf(
      "%s: %lld missions, %lld arrived, %lld without a path; %lld moves (%lld beside something moving), %lld "
      "replans, %lld turned back for ever, %lld waits, %lld sightings forgotten, %lld times put down, %lld "
      "new goals; %lld plans to the nearest cell, %lld ends there, %lld times on to the goal again, %lld "
      "moves "
      "out of an obstacle\n",
      std::string(info.id).c_str(), static_cast<long long>(totals.missions),
      static_cast<long long>(totals.arrived), static_cast<long long>(totals.no_path),
      static_cast<long long>(totals.moves), static_cast<long long>(totals.beside_movers),
      static_cast<long long>(totals.replans), static_cast<long long>(totals.endless),
      static_cast<long long>(totals.waits), static_cast<long long>(totals.forgotten),
      static_cast<long long>(totals.put_down), static_cast<long long>(totals.new_goals),
      static_cast<long long>(totals.nearest_plans), static_cast<long long>(totals.nearest),
      static_cast<long long>(totals.goal_again), static_cast<long long>(totals.drove_out));
  EXPECT_LT(totals.endless, 10);
  // Each of them has to occur, or the test says nothing of it.
  for (const std::int64_t count_of :
       {totals.arrived, totals.no_path, totals.beside_movers, totals.waits, totals.forgotten, totals.put_down,
        totals.new_goals, totals.nearest_plans, totals.nearest, totals.goal_again, totals.drove_out})
    EXPECT_GT(count_of, 20);
}

INSTANTIATE_TEST_SUITE_P(Planners, RandomMissions, ::testing::ValuesIn(each_of(sound_planners())),
                         planner_test_name);

}  // namespace
}  // namespace replan::test::mission_property_test
