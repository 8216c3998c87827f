// Random missions in the plane and in space by sonar of every kind, of robots that hop from cell to cell and of vehicles
// with limits, along paths with and without stages: none enters an obstacle; each arrives, or ends where brute force says
// that its map has no path; it knows what its cone reaches and learns of nothing else; no vehicle turns, climbs or goes
// faster than it can; and a mission that is taken up in the middle goes on as if it had never stopped.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/mission_drives.hpp"

namespace replan::test::sonar_mission_test {
namespace {

constexpr std::uint64_t kMissions = 5'000;  // in the plane and in space together
constexpr std::uint64_t kTakenUp = 4;       // every fourth

void give_sonar(Random& random, RobotSetup& robot) {
  constexpr double kAngles[] = {1, 30, 60, 90, 120, 180, 250, 360};
  robot.sensor_angle = kAngles[random.below(8)];
}

void give_kind(Random& random, RobotSetup& robot) {
  constexpr double kRates[] = {5, 45, 90, 720}, kClimbs[] = {0.3, 1, 2, 50},
                   kCorners[] = {0, 20, 30, 60, 180};
  if (random.chance(0.4)) return;
  robot.kind = "vehicle";
  robot.settings.set("turn_rate", kRates[random.below(4)]);
  robot.settings.set("climb_rate", kClimbs[random.below(4)]);
  robot.settings.set("corner", kCorners[random.below(5)]);
}

void give_stage(Random& random, PlannerChoice& choice) {
  const std::uint32_t which = random.below(3);
  Settings settings;
  if (which == 1) settings.set("samples", random.between(1, 12));
  if (which == 1) settings.set("corners_only", random.below(2));
  if (which > 0) choice.stages = {{which == 1 ? "bspline" : "floyd", settings}};
}

Scenario drawn(std::uint64_t seed, bool solid, const PlannerInfo& info) {
  Random random(seed * 1000 + 17);
  Scenario scenario = solid ? random_voxel_scenario(random, info) : random_scenario(random, info, {16, 13});
  if (random.chance(0.3)) give_size(random, scenario);
  give_sonar(random, scenario.robot);
  give_kind(random, scenario.robot);
  give_stage(random, scenario.planners.front());
  return scenario;
}

std::vector<const PlannerInfo*> planners_of(bool solid) {
  std::vector<const PlannerInfo*> planners;
  for (const PlannerInfo& info : sound_planners())
    if (!solid || !info.planar) planners.push_back(&info);
  return planners;
}

void drive_all(std::uint64_t count, bool solid) {
  const auto [all, taken, fault] = drive_missions(
      count, planners_of(solid), kTakenUp,
      [solid](std::uint64_t seed, const PlannerInfo& info) { return drawn(seed, solid, info); });
  ASSERT_EQ(fault, "");
  const auto number = [](std::int64_t n) { return static_cast<long long>(n); };
  std::printf(
      "%lld missions, %lld arrived, %lld without a path, %lld at the nearest cell, %lld turned back for "
      "ever; %lld moves "
      "(%lld beside something moving), %lld turns on the spot, %lld replans, %lld waits; %lld taken up; of "
      "those without "
      "a path %lld would have one if they knew all\n",
      number(all.missions), number(all.arrived), number(all.no_path), number(all.nearest),
      number(all.endless), number(all.moves), number(all.beside_movers), number(all.turns),
      number(all.replans), number(all.waits), number(taken), number(all.better_known));
  EXPECT_EQ(all.missions, static_cast<std::int64_t>(count));
  // Each of them has to occur, or the test says nothing of it.
  for (const std::int64_t count_of : {all.arrived, all.no_path, all.nearest, all.beside_movers, all.waits,
                                      all.turns, all.put_down, all.new_goals, taken})
    EXPECT_GT(count_of, static_cast<std::int64_t>(count) / 100);
}

TEST(SonarMissions, TouchNothingInThePlane) {
  drive_all(kMissions / 2, false);
}
TEST(SonarMissions, TouchNothingInSpace) {
  drive_all(kMissions / 2, true);
}

}  // namespace
}  // namespace replan::test::sonar_mission_test
