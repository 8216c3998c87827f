// The oracle says what brute force says of every plan of random missions, agrees with every sound planner,
// and finds fault with the broken one.
#include <cstdio>

#include <gtest/gtest.h>

#include "core/debug/plan_oracle.hpp"
#include "tests/support/each_planner.hpp"
#include "tests/support/missions.hpp"
#include "tests/support/trials.hpp"

namespace replan::test::plan_oracle_property_test {
namespace {

const int kMissions = trials(600);  // of each planner

struct Tally {
  int plans = 0, without_path = 0, disagreements = 0;
};

/// All plans of a mission, asked about.
void ask_all(const Scenario& scenario, const PlannerInfo& info, Tally& tally) {
  const PlannerChoice& choice = scenario.planners[0];
  const Box lattice(scenario.map.width, scenario.map.height);
  Recorder recorder;
  const auto mission = make_mission(scenario, choice, &recorder);
  for (int slices = 0; mission->advance(64) && slices < 2000; ++slices) {
  }
  Timeline log(initial_state(scenario, choice));
  log.append(recorder.take());
  const LogView view{log, lattice, info, choice.settings, scenario.robot.radius};
  std::size_t plan = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log.event(i).kind != EventKind::plan_end) continue;
    const PlanQuestion question = ask_about(view, plan++, i + 1);
    oracle::World world;
    world.size = {lattice.width(), lattice.height(), 1};
    world.blocked = question.known.plain();
    MoveRules rules = move_rules(choice.settings);
    if (scenario.robot.radius > 0) {
      world.blocked = oracle::grown(world, scenario.robot.radius);
      rules.corners = CornerRule::none;
    }
    const bool buried = world.blocked[question.start] != 0;
    const oracle::Raw right =
        buried ? oracle::kNever
               : oracle::costs_to(world, rules, expected_penalties(info, choice.settings, world),
                                  question.goal)[question.start];
    ASSERT_EQ(right_cost(question).raw, right) << "plan " << plan - 1;
    const auto wrong = judge(question, {right});
    ++tally.plans;
    tally.without_path += right == oracle::kNever ? 1 : 0;
    tally.disagreements += wrong ? 1 : 0;
    const bool same_ends = (question.claimed.raw < oracle::kNever) == (right < oracle::kNever);
    const bool claim_holds = question.exact      ? question.claimed.raw == right
                             : question.sampling ? question.claimed.is_infinite() || right < oracle::kNever
                             : question.straight ? same_ends && question.claimed.raw <= right
                                                 : same_ends && question.claimed.raw >= right;
    ASSERT_EQ(claim_holds, !wrong.has_value());
    if (wrong) {
      EXPECT_EQ(wrong->plan, plan - 1);
      EXPECT_FALSE(disagreement_text(*wrong).empty());
    }
  }
}

class PlanOracle : public ::testing::TestWithParam<const PlannerInfo*> {};

TEST_P(PlanOracle, saysWhatBruteForceSays) {
  const PlannerInfo& info = *GetParam();
  Tally tally;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(kMissions); ++seed) {
    Random random(seed * 100 + 7);
    Scenario scenario = random_scenario(random, info, {12, 10});
    if (seed % 3 == 0) give_size(random, scenario);
    ask_all(scenario, info, tally);
    ASSERT_FALSE(HasFatalFailure()) << describe_settings(info, scenario.planners[0].settings) << ", seed "
                                    << seed;
  }
  std::printf("%s: %d plans, %d without a path, %d disagreements\n", std::string(info.id).c_str(),
              tally.plans, tally.without_path, tally.disagreements);
  EXPECT_GT(tally.plans, kMissions);
  EXPECT_GT(tally.without_path, 20);
  if (info.exercise)
    EXPECT_GT(tally.disagreements, 0);
  else
    EXPECT_EQ(tally.disagreements, 0);
}

INSTANTIATE_TEST_SUITE_P(Planners, PlanOracle, ::testing::ValuesIn(each_of(planners())), planner_test_name);

}  // namespace
}  // namespace replan::test::plan_oracle_property_test
