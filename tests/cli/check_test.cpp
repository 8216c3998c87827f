// `replan run --check`.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/plan/registry.hpp"
#include "tests/cli/child.hpp"

namespace replan::test::check_test {
namespace {

using nlohmann::json;

std::string map_file(const std::string& name) {
  return REPLAN_SOURCE_DIR "/maps/" + name;
}

TEST(RunCheck, HoldsEverySoundPlannerToItsLaws) {
  const Outcome outcome = run_program({"run", map_file("closing-door.json"), "--planner", "all", "--check"});
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_EQ(outcome.out.find("broken"), std::string::npos) << outcome.out;
  const json all =
      run_program({"run", map_file("closing-door.json"), "--planner", "all", "--check", "--json"})
          .json()["checks"];
  ASSERT_EQ(all.size(), sound_planners().size());
  for (const json& each : all) {
    EXPECT_TRUE(each["laws"]["hold"]) << each;
    EXPECT_GT(each["laws"]["events"], 100) << each;
    EXPECT_TRUE(each["laws"]["first"].is_null());
    EXPECT_TRUE(each["oracle"]["agrees"]) << each;
    EXPECT_GE(each["oracle"]["plans"], 3) << each;
  }
}

TEST(RunCheck, SaysWhereABrokenPlannerGoesWrongFirst) {
  const Outcome text = run_program({"run", map_file("broken-planner.json"), "--check"});
  EXPECT_EQ(text.code, 1);
  EXPECT_NE(text.out.find("laws are broken"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("oracle disagrees with"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("laws hold over"), std::string::npos)
      << "of the sound planner beside it: " << text.out;
  const json broken =
      run_program({"run", map_file("broken-planner.json"), "--check", "--json"}).json()["checks"][0];
  EXPECT_EQ(broken["planner"], "broken-dstar-lite");
  EXPECT_FALSE(broken["laws"]["hold"]);
  EXPECT_GT(broken["laws"]["first"]["position"], 0);
  EXPECT_GT(broken["laws"]["first"]["line"], 0);
  EXPECT_EQ(broken["laws"]["first"]["cell"].size(), 2u);
  EXPECT_GT(broken["oracle"]["first"]["plan"], 0) << "the first plan is right";
}

TEST(RunCheck, SaysSoWhereNoPlanIsMeantToBeTheCheapest) {
  const Outcome outcome = run_program(
      {"run", map_file("office.json"), "--planner", "astar", "--set", "heuristic=manhattan", "--check"});
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  EXPECT_NE(outcome.out.find("none is meant to be the cheapest"), std::string::npos) << outcome.out;
}

TEST(RunCheck, PrintsNoFigures) {
  EXPECT_EQ(run_program({"run", map_file("closing-door.json"), "--check", "--csv", "-"}).code, 2);
}

/// Every shipped world, with its own planners: the laws hold but where a fault is what the world is about.
TEST(RunCheck, HoldsInEveryShippedWorldButThoseThatShowAFault) {
  int worlds = 0;
  for (const auto& entry : std::filesystem::directory_iterator(map_file(""))) {
    if (entry.path().extension() != ".json") continue;
    const std::string name = entry.path().filename().string();
    const bool faulty = name.starts_with("fault-") || name.starts_with("broken-");
    const Outcome outcome = run_program({"run", entry.path().string(), "--check"});
    EXPECT_EQ(outcome.code, faulty ? 1 : 0) << name << "\n" << outcome.out;
    ++worlds;
  }
  EXPECT_GE(worlds, 15);
}

}  // namespace
}  // namespace replan::test::check_test
