// How a path becomes shorter while a planner searches: told while it plans, read out of its log, and written down.
#include "core/study/anytime.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/debug/path_gains.hpp"
#include "core/planners/rrt_parameters.hpp"
#include "core/session/run.hpp"
#include "core/world/choices.hpp"

namespace replan::anytime_test {
namespace {

/// A wall with a narrow gap between start and goal.
Scenario gap(std::string planner) {
  Scenario scenario;
  scenario.map = GridMap(40, 30);
  for (int y = 6; y < 30; ++y)
    for (int x = 18; x < 22; ++x) scenario.map.set({x, y}, y != 20 && y != 21);
  scenario.start = {4, 20};
  scenario.goal = {35, 20};
  scenario.planners = {{std::move(planner), {}}};
  return scenario;
}

std::vector<const PlannerInfo*> sampling_planners() {
  std::vector<const PlannerInfo*> all;
  for (const PlannerInfo& info : sound_planners())
    if (info.sampling) all.push_back(&info);
  return all;
}

AnytimeRun plan(const Scenario& world, double most_ms = std::numeric_limits<double>::infinity()) {
  return plan_anytime(world.map, world.start, world.goal, world.planners.front(), world.robot.radius,
                      most_ms);
}

AnytimeRun made(std::int64_t seed, std::vector<Gain> gains) {
  AnytimeRun run{.planner = "rrt-star", .seed = seed, .gains = std::move(gains)};
  run.samples = 100;
  run.ms = 10;
  return run;
}

TEST(Anytime, GainsFallAndRepeat) {
  for (const PlannerInfo* info : sampling_planners()) {
    const Scenario world = gap(std::string(info->id));
    const AnytimeRun run = plan(world), again = plan(world);
    ASSERT_TRUE(run.found()) << info->id;
    EXPECT_EQ(run.status, PlanStatus::found);
    EXPECT_EQ(run.end, AnytimeEnd::planner);
    ASSERT_EQ(run.gains.size(), again.gains.size()) << info->id;
    for (std::size_t i = 0; i < run.gains.size(); ++i) {
      EXPECT_EQ(run.gains[i].samples, again.gains[i].samples);
      EXPECT_EQ(run.gains[i].length, again.gains[i].length);
      if (i == 0) continue;
      EXPECT_LT(run.gains[i].length, run.gains[i - 1].length) << info->id;
      EXPECT_GE(run.gains[i].samples, run.gains[i - 1].samples);
      EXPECT_GE(run.gains[i].ms, run.gains[i - 1].ms);
    }
    EXPECT_GE(run.samples, run.gains.back().samples);
  }
}

/// What the window draws is what was told while it planned.
TEST(Anytime, TheLogTellsTheSameGains) {
  for (const PlannerInfo* info : sampling_planners()) {
    const auto world = std::make_shared<const Scenario>(gap(std::string(info->id)));
    replan::Run recorded(world, 0);
    recorded.finish(Target::end());
    std::size_t end = 0;
    while (recorded.timeline().event(end).kind != EventKind::plan_end) ++end;
    PathGains read;
    read.follow(recorded.log_view(), recorded.log_id(), 0, end, SIZE_MAX);
    const auto gains = read.gains();
    const AnytimeRun run = plan(*world);
    ASSERT_EQ(gains.size(), run.gains.size()) << info->id;
    for (std::size_t i = 0; i < gains.size(); ++i) {
      EXPECT_EQ(gains[i].sample, run.gains[i].samples) << info->id;
      EXPECT_EQ(gains[i].cost.to_double(), run.gains[i].length) << info->id;
      EXPECT_EQ(recorded.timeline().state_at(gains[i].event + 1).scalar(Scalar::best),
                static_cast<std::uint64_t>(gains[i].cost.raw));
    }
  }
}

TEST(Anytime, APlannerThatDrawsNoSamplesHasNoGains) {
  replan::Run run(std::make_shared<const Scenario>(gap("astar")), 0);
  run.finish(Target::end());
  PathGains read;
  read.follow(run.log_view(), run.log_id(), 0, run.timeline().size(), SIZE_MAX);
  EXPECT_TRUE(read.gains().empty());
  EXPECT_TRUE(read.complete());
}

TEST(Anytime, TheClockEndsAPlanWithThePathByThen) {
  Scenario world = gap("rrt-star");
  world.planners.front().settings.set("samples", 1'000'000);
  const AnytimeRun none = plan(world, 1e-6);
  EXPECT_EQ(none.end, AnytimeEnd::time);
  EXPECT_EQ(none.status, PlanStatus::none_found);
  EXPECT_FALSE(none.found());
  const AnytimeRun some = plan(world, 60);
  EXPECT_EQ(some.end, AnytimeEnd::time);
  EXPECT_LT(some.samples, 1'000'000);
  if (some.found()) {
    EXPECT_EQ(some.status, PlanStatus::found);
  }
}

TEST(Anytime, SamplesWithoutAGainEndAPlan) {
  Scenario world = gap("rrt-star");
  world.planners.front().settings.set("no_gain", 150);
  const AnytimeRun run = plan(world);
  ASSERT_TRUE(run.found());
  EXPECT_EQ(run.samples, run.gains.back().samples + 150);
  for (std::size_t i = 1; i < run.gains.size(); ++i)
    EXPECT_LE(run.gains[i].samples, run.gains[i - 1].samples + 150);
}

TEST(Anytime, NoPathIsShorterThanTheShortestOfAll) {
  const Scenario world = gap("informed-rrt-star");
  const auto optimum =
      shortest_of_all(world.map.box(), world.map.blocked, world.start, world.goal, world.planners.front(), 0);
  ASSERT_TRUE(optimum.has_value());
  EXPECT_DOUBLE_EQ(*optimum, 31);  // straight through the gap
  const AnytimeRun run = plan(world);
  EXPECT_GE(run.gains.back().length, *optimum - 1e-9);
  EXPECT_LT(run.gains.back().length, *optimum * 1.02);
  EXPECT_FALSE(shortest_of_all(world.map.box(), world.map.blocked, world.start, world.goal,
                               world.planners.front(), 0.4)
                   .has_value())
      << "not known for a robot with a size";
  EXPECT_FALSE(
      shortest_of_all(Box(4, 4, 4), std::vector<std::uint8_t>(64), {0, 0, 0}, {3, 3, 3}, {"rrt", {}}, 0)
          .has_value())
      << "nor in space";
}

/// Two obstacles meet at a corner in the middle of the way.
TEST(Anytime, TheShortestOfAllGoesByTheCornerRuleOfThePlanner) {
  GridMap map(6, 5);
  for (const Cell cell : {Cell{2, 0}, Cell{2, 1}, Cell{2, 2}, Cell{3, 3}}) map.set(cell, true);
  const auto shortest = [&](double rule) {
    PlannerChoice choice{"rrt-star", {}};
    choice.settings.set("corners", rule);
    return shortest_of_all(map.box(), map.blocked, {0, 3}, {5, 2}, choice, 0).value_or(0);
  };
  EXPECT_DOUBLE_EQ(shortest(2), std::hypot(2.5, 0.5) * 2) << "through the corner";
  EXPECT_GT(shortest(0), shortest(2) + 0.1);
}

TEST(Anytime, TheShortestOfAllIsNotLookedForForEver) {
  GridMap map(60, 60);
  for (int y = 1; y < 59; y += 2)
    for (int x = 1 + y % 4; x < 59; x += 4) map.set({x, y}, true);
  const auto within = [&](double most_ms) {
    return shortest_of_all(map.box(), map.blocked, {0, 0}, {59, 58}, {"rrt-star", {}}, 0, most_ms);
  };
  EXPECT_TRUE(within(std::numeric_limits<double>::infinity()).has_value());
  EXPECT_FALSE(within(0).has_value());
}

TEST(Anytime, TheMedianBeginsWhereHalfOfThePlansHaveAPath) {
  const std::vector<AnytimeRun> runs = {made(1, {{10, 1, 50}, {20, 2, 40}}), made(2, {{30, 3, 45}}),
                                        made(3, {})};
  const auto curve = median_curve(runs, AnytimeAxis::samples);
  ASSERT_EQ(curve.size(), 1u);
  EXPECT_EQ(curve[0].at, 30);
  EXPECT_EQ(curve[0].length, 45);
  const auto of_two = median_curve(std::span(runs).first(2), AnytimeAxis::time);
  ASSERT_EQ(of_two.size(), 2u) << "the lower one of two";
  EXPECT_EQ(of_two[0].at, 1);
  EXPECT_EQ(of_two[0].length, 50);
  EXPECT_EQ(of_two[1].at, 2);
  EXPECT_EQ(of_two[1].length, 40);
  EXPECT_TRUE(std::isinf(lower_median({})));
}

TEST(Anytime, IsWrittenAsLinesAndAsAPicture) {
  const std::vector<AnytimeRun> runs = {made(1, {{10, 1, 50}, {20, 2, 40}}), made(2, {})};
  EXPECT_EQ(anytime_csv(runs),
            "planner,seed,samples,ms,length,end\n"
            "rrt-star,1,10,1.0000,50.000000,\n"
            "rrt-star,1,20,2.0000,40.000000,\n"
            "rrt-star,1,100,10.0000,40.000000,planner\n"
            "rrt-star,2,100,10.0000,,planner\n");
  const std::string svg = anytime_svg(runs, std::vector<double>{39.5, 38.25});
  EXPECT_NE(svg.find("optimum 39.500"), std::string::npos);
  EXPECT_NE(svg.find("optimum 38.250"), std::string::npos);
  EXPECT_NE(svg.find(">RRT*<"), std::string::npos);
  EXPECT_NE(svg.find("samples"), std::string::npos);
  EXPECT_NE(svg.find("milliseconds"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_TRUE(anytime_svg(std::vector<AnytimeRun>{made(1, {})}, {}).ends_with("</svg>\n"));
}

}  // namespace
}  // namespace replan::anytime_test
