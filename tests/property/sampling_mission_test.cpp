// Random missions by planners that sample, in the plane and in space: surprises and moving obstacles cut their trees, and the
// robot is put down elsewhere. None enters an obstacle; each arrives, or ends for a reason that it names; and a mission that
// is taken up in the middle goes on with the same samples.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/mission_drives.hpp"

namespace replan::test::sampling_mission_test {
namespace {

constexpr std::uint64_t kMissions = 5'000;  // in the plane and in space together
constexpr std::uint64_t kTakenUp = 8;       // every eighth

std::vector<const PlannerInfo*> sampling_planners() {
  std::vector<const PlannerInfo*> planners;
  for (const PlannerInfo& info : sound_planners())
    if (info.can_miss()) planners.push_back(&info);
  return planners;
}

Scenario drawn_for(std::uint64_t seed, bool solid, const PlannerInfo& info) {
  Random random(seed * 1000 + 23);
  Scenario scenario = solid ? random_voxel_scenario(random, info) : random_scenario(random, info, {16, 13});
  if (random.chance(0.3)) give_size(random, scenario);
  return scenario;
}

void drive_sampling(std::uint64_t count, bool solid) {
  const auto [all, taken, fault] = drive_missions(
      count, sampling_planners(), kTakenUp,
      [solid](std::uint64_t seed, const PlannerInfo& info) { return drawn_for(seed, solid, info); });
  ASSERT_EQ(fault, "");
  const auto number = [](std::int64_t n) { return static_cast<long long>(n); };
  std::printf("%lld missions, %lld arrived, %lld without a path; %lld moves, %lld replans, %lld taken up\n",
              number(all.missions), number(all.arrived), number(all.no_path), number(all.moves),
              number(all.replans), number(taken));
  EXPECT_EQ(all.missions, static_cast<std::int64_t>(count));
  for (const std::int64_t some : {all.arrived, all.no_path, all.replans, all.put_down, taken})
    EXPECT_GT(some, static_cast<std::int64_t>(count) / 100);
}

TEST(SamplingMissions, TouchNothingInThePlane) {
  drive_sampling(kMissions / 2, false);
}
TEST(SamplingMissions, TouchNothingInSpace) {
  drive_sampling(kMissions / 2, true);
}

}  // namespace
}  // namespace replan::test::sampling_mission_test
