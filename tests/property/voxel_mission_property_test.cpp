// Random missions in boxes of voxels, with surprises, moving obstacles and sensors of every kind: the robot never enters
// an obstacle; every plan, repaired or fresh, costs what brute force says that a fresh plan on the robot's map costs;
// the planner's laws hold from event to event; the same scenario gives the same log; and a mission that is taken up in
// the middle goes on as if it had never stopped.
#include <cstdio>

#include <gtest/gtest.h>

#include "core/debug/law_checker.hpp"
#include "core/debug/plan_oracle.hpp"
#include "tests/support/mission_witness.hpp"
#include "tests/support/taking_up.hpp"

namespace replan::test::voxel_mission_property_test {
namespace {

constexpr int kMissions = 480;  // of all planners together

struct Tally {
  MissionTotals missions;
  int plans = 0, repairs = 0, without_path = 0, laws = 0, taken_up = 0, scripts = 0;
};

/// Every plan of the log against brute force.
void ask_all(const LogView& view, Tally& tally) {
  std::size_t plan = 0;
  for (std::size_t i = 0; i < view.log.size(); ++i) {
    if (view.log.event(i).kind != EventKind::plan_end) continue;
    const PlanQuestion question = ask_about(view, plan++, i + 1);
    oracle::World world;
    world.dimensions = 3;
    world.size = {view.lattice.width(), view.lattice.height(), view.lattice.depth()};
    world.blocked = question.known.plain();
    MoveRules rules = question.rules;
    if (rules.radius > 0) {
      world.blocked = oracle::grown(world, rules.radius);
      rules.corners = CornerRule::none;
    }
    const bool buried = world.blocked[question.start] != 0;
    const oracle::Raw fresh =
        buried ? oracle::kNever
               : oracle::costs_to(world, rules, expected_penalties(view.info, view.settings, world),
                                  question.goal)[question.start];
    ASSERT_EQ(right_cost(question).raw, fresh) << "plan " << plan - 1;
    if (claims_cheapest(view.info, view.settings))
      ASSERT_EQ(question.claimed.raw, fresh) << "plan " << plan - 1;
    else
      ASSERT_FALSE(judge(question, {fresh})) << "plan " << plan - 1;
    ++tally.plans;
    tally.repairs += plan > 1 && view.info.incremental ? 1 : 0;
    tally.without_path += fresh == oracle::kNever ? 1 : 0;
  }
}

void check_laws(const LogView& view, Tally& tally) {
  LawChecker checker(view);
  while (checker.advance(100'000)) {
  }
  ASSERT_EQ(checker.checked(), view.log.size());
  ASSERT_EQ(checker.breach_count(), 0u)
      << checker.breaches().front().law << ": " << checker.breaches().front().words;
  ++tally.laws;
}

void drive(Random& random, const Scenario& scenario, const PlannerInfo& info, Tally& tally) {
  MissionWitness witness(scenario, info);
  const std::string fault = witness.run(tally.missions);
  ASSERT_EQ(fault, "");
  Recorder recorder;
  ASSERT_TRUE(driven_on(*make_mission(scenario, scenario.planners.front(), &recorder), recorder) ==
              witness.log())
      << "the second time it is another log";
  Timeline log(initial_state(scenario, scenario.planners.front()));
  log.append(witness.log());
  const Box world = scenario.map.box();
  const LogView view{log, world, info, scenario.planners.front().settings, scenario.robot.radius};
  ask_all(view, tally);
  if (!::testing::Test::HasFatalFailure()) check_laws(view, tally);
  if (::testing::Test::HasFatalFailure()) return;
  ASSERT_EQ(taken_up(random, scenario, witness.log()), "");
  ++tally.taken_up;
  const auto back = parse_scenario(scenario_text(scenario), "s.json", ".");
  ASSERT_TRUE(back.ok()) << back.error();
  ASSERT_EQ(*back, scenario);
  ++tally.scripts;
}

TEST(VoxelMissions, AreDrivenAsThoseInThePlane) {
  Tally tally;
  std::vector<const PlannerInfo*> planners;
  for (const PlannerInfo& info : sound_planners())
    if (!info.planar) planners.push_back(&info);
  for (int mission = 0; mission < kMissions; ++mission) {
    const PlannerInfo& info = *planners[static_cast<std::size_t>(mission) % planners.size()];
    Random random(static_cast<std::uint64_t>(mission) * 1000 + 3);
    Scenario scenario = random_voxel_scenario(random, info);
    if (mission % 3 == 0) give_size(random, scenario);
    drive(random, scenario, info, tally);
    ASSERT_FALSE(HasFatalFailure()) << "mission " << mission << ", "
                                    << describe_settings(info, scenario.planners[0].settings) << "\n"
                                    << scenario_text(scenario);
  }
  const MissionTotals& all = tally.missions;
  std::printf(
      "%lld missions, %lld arrived, %lld without a path, %lld at the nearest cell; %lld moves (%lld beside "
      "something moving), %d plans, %d of them repairs and %d without a path; %d laws checked, %d taken up\n",
      static_cast<long long>(all.missions), static_cast<long long>(all.arrived),
      static_cast<long long>(all.no_path), static_cast<long long>(all.nearest),
      static_cast<long long>(all.moves), static_cast<long long>(all.beside_movers), tally.plans,
      tally.repairs, tally.without_path, tally.laws, tally.taken_up);
  EXPECT_EQ(all.missions, kMissions);
  EXPECT_EQ(tally.laws, kMissions);
  EXPECT_EQ(tally.taken_up, kMissions);
  // Each of them has to occur, or the test says nothing of it.
  EXPECT_GT(tally.repairs, 500);
  for (const std::int64_t count_of : {all.arrived, all.no_path, all.nearest, all.beside_movers, all.waits,
                                      all.put_down, all.new_goals, std::int64_t{tally.without_path}})
    EXPECT_GT(count_of, 5);
}

}  // namespace
}  // namespace replan::test::voxel_mission_property_test
