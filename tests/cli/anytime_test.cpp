// The contract of 'replan anytime', and of planners with seeds of their own.
#include <gtest/gtest.h>

#include "tests/cli/child.hpp"

namespace replan::test::anytime_test {
namespace {

constexpr const char* kScenario = R"({
  "replan": 1, "name": "Gap",
  "map": {"rows": ["............", ".....@......", ".....@......", ".....@......", "............", "............"]},
  "start": [0, 2], "goal": [11, 2],
  "planners": [{"id": "rrt-star", "settings": {"samples": 300}}, {"id": "rrt-connect"}]
})";

class AnytimeCommand : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string scenario_ = folder_.with("gap.json", kScenario);

  void expect_complaint(std::vector<std::string> arguments, const std::string& words) const {
    const Outcome outcome = run_program(std::move(arguments));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  }
};

TEST_F(AnytimeCommand, printsMediansAndWritesCurves) {
  const std::string csv = folder_.file("gap.csv"), svg = folder_.file("gap.svg");
  const Outcome outcome = run_program({"anytime", scenario_, "--seeds", "5", "--csv", csv, "--svg", svg});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("rrt-star"), std::string::npos);
  EXPECT_NE(outcome.out.find("The shortest of all ways is "), std::string::npos);
  const std::string lines = whole_file(csv);
  EXPECT_TRUE(lines.starts_with("planner,seed,samples,ms,length,end\nrrt-star,1,")) << lines;
  EXPECT_NE(lines.find("\nrrt-connect,5,"), std::string::npos);
  EXPECT_TRUE(whole_file(svg).ends_with("</svg>\n"));
}

TEST_F(AnytimeCommand, printsItsLinesInstead) {
  const Outcome outcome = run_program({"anytime", scenario_, "--planner", "rrt", "--csv", "-"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.out.starts_with("planner,seed,samples,ms,length,end\nrrt,1,"));
  EXPECT_TRUE(outcome.out.ends_with(",planner\n"));
}

TEST_F(AnytimeCommand, aPlanWithoutAPathIsExitCodeOne) {
  const Outcome outcome = run_program({"anytime", scenario_, "--planner", "rrt", "--set", "samples=1"});
  EXPECT_EQ(outcome.code, 1);
}

TEST_F(AnytimeCommand, theClockEndsAPlan) {
  const Outcome outcome = run_program({"anytime", scenario_, "--planner", "rrt-star", "--set",
                                       "samples=1000000", "--time", "0.05", "--csv", "-"});
  EXPECT_TRUE(outcome.out.ends_with(",time\n")) << outcome.out;
}

TEST_F(AnytimeCommand, refusesWhatWouldChangeNothing) {
  expect_complaint({"anytime", scenario_, "--stage", "bspline"}, "--stage changes nothing here");
  expect_complaint({"anytime", scenario_, "--unreachable-goal", "nearest"},
                   "--unreachable-goal changes nothing here");
  expect_complaint({"anytime", scenario_, "--robot", "vehicle"}, "--robot changes nothing here");
}

TEST_F(AnytimeCommand, saysWhatIsWrong) {
  expect_complaint({"anytime", scenario_, "--planner", "astar"}, "'astar' has no path before its end");
  expect_complaint({"anytime", scenario_, "--seeds", "0"}, "--seeds cannot be '0'");
  expect_complaint({"anytime", scenario_, "--time", "-1"}, "--time cannot be '-1'");
  expect_complaint({"anytime", scenario_, "--set", "seed=1000000000", "--seeds", "2"}, "fewer with --seeds");
}

/// Two obstacles meet at a corner in the middle of the way.
TEST_F(AnytimeCommand, holdsEachPlannerAgainstTheShortestWayOfItsOwnRule) {
  const std::string scenario = folder_.with("corner.json", R"({
    "replan": 1, "name": "Corner",
    "map": {"rows": ["..@...", "..@...", "..@...", "...@..", "......"]},
    "start": [0, 3], "goal": [5, 2],
    "planners": [{"id": "rrt-star", "settings": {"samples": 300}}]
  })");
  const std::vector<std::string> both = {"anytime", scenario, "--planner", "rrt-star,rrt-star"};
  EXPECT_NE(run_program(both).out.find("The shortest of all ways is "), std::string::npos);
  EXPECT_EQ(run_program(both).out.find("own corner rule"), std::string::npos);
  std::vector<std::string> apart = both;
  apart.insert(apart.end(), {"--set", "rrt-star#2.corners=any"});
  const Outcome outcome = run_program(apart);
  EXPECT_NE(outcome.out.find("The shortest of all ways is 5.099 to "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("by each planner's own corner rule."), std::string::npos) << outcome.out;
}

TEST_F(AnytimeCommand, planSideBySideWithSeedsOfTheirOwn) {
  const std::vector<std::string> both = {"run", scenario_, "--planner", "rrt,rrt", "--json"};
  const auto paths_with = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = both;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto runs = run_program(arguments).json()["runs"];
    return std::pair(runs[0]["path"], runs[1]["path"]);
  };
  const auto [a, b] = paths_with({});
  EXPECT_EQ(a, b);
  const auto [first, second] = paths_with({"--set", "rrt#2.seed=7"});
  EXPECT_EQ(first, a);
  EXPECT_NE(second, a);
  EXPECT_EQ(paths_with({"--set", "rrt.seed=7"}), std::pair(second, second));
  expect_complaint({"run", scenario_, "--planner", "rrt", "--set", "rrt#2.seed=7"}, "not so many of 'rrt'");
}

}  // namespace
}  // namespace replan::test::anytime_test
