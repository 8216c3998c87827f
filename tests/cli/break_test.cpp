// replan run --break: where the runs stop.
#include "tests/cli/child.hpp"

namespace replan::test::break_test {
namespace {

const std::string kDemo = std::string(REPLAN_SOURCE_DIR) + "/maps/demo.json";

TEST(RunBreak, tellsWhereEachRunStopsFirst) {
  const Outcome outcome =
      run_program({"run", kDemo, "--planner", "astar,dld-star-lite", "--break", "event(replan)", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto stops = outcome.json()["stops"];
  ASSERT_EQ(stops.size(), 2u);
  EXPECT_EQ(stops[0]["planner"], "astar");
  EXPECT_EQ(stops[1]["planner"], "dld-star-lite");
  for (const auto& stop : stops) {
    EXPECT_EQ(keys(stop), (std::set<std::string>{"planner", "stopped", "condition", "event", "clock",
                                                 "expansions", "line", "what", "values"}));
    EXPECT_EQ(stop["stopped"], true);
    EXPECT_EQ(stop["condition"], "event(replan)");
    EXPECT_EQ(stop["what"], "replan 1 begins");
    EXPECT_EQ(stop["line"]["number"], 109);
    EXPECT_GT(stop["event"], 0);
    EXPECT_GT(stop["expansions"], 0);
    EXPECT_TRUE(stop["values"].empty());
  }
  EXPECT_EQ(stops[1]["line"]["name"], "line 109 of Algorithm 1: main");
  EXPECT_EQ(stops[1]["line"]["text"], "if any edge costs changed");
}

TEST(RunBreak, tellsTheFirstStopOfEachCondition) {
  const std::vector<std::string> all = {"run",     kDemo,           "--planner", "astar",
                                        "--break", "event(replan)", "--break",   "moves >= 100000",
                                        "--break", "moves == 2"};
  std::vector<std::string> as_json = all;
  as_json.emplace_back("--json");
  const Outcome outcome = run_program(as_json);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto stops = outcome.json()["stops"];
  ASSERT_EQ(stops.size(), 3u);
  EXPECT_EQ(stops[2]["stopped"], false);
  EXPECT_EQ(stops[2]["condition"], "moves >= 100000");
  EXPECT_LT(stops[0]["event"], stops[1]["event"]) << "in the order in which they come true";
  for (const std::size_t i : {0u, 1u}) {
    const std::string condition = stops[i]["condition"];
    const auto alone =
        run_program({"run", kDemo, "--planner", "astar", "--break", condition, "--json"}).json();
    EXPECT_EQ(stops[i], alone["stops"][0]) << condition;
  }
  EXPECT_NE(stops[0]["condition"], stops[1]["condition"]);
  const Outcome table = run_program(all);
  for (const char* row :
       {"astar    event(replan)", "astar    moves == 2", "astar    not reached: moves >= 100000"})
    EXPECT_NE(table.out.find(row), std::string::npos) << row << "\n" << table.out;
}

TEST(RunBreak, stopsAtTwoConditionsOfOneEvent) {
  const Outcome outcome = run_program({"run", kDemo, "--planner", "astar", "--break", "event(replan)",
                                       "--break", "replans == 1 && event(replan)", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto stops = outcome.json()["stops"];
  ASSERT_EQ(stops.size(), 2u);
  EXPECT_EQ(stops[0]["event"], stops[1]["event"]);
}

TEST(RunBreak, countsSamplesByTheirName) {
  const std::string gap = std::string(REPLAN_SOURCE_DIR) + "/maps/gap-for-samples.json";
  const auto stop = [&](const char* planner, const char* condition) {
    return run_program({"run", gap, "--planner", planner, "--break", condition, "--json"}).json()["stops"][0];
  };
  const auto named = stop("rrt-star", "samples == 100");
  EXPECT_EQ(named["values"]["samples"], 100);
  EXPECT_EQ(named["event"], stop("rrt-star", "expansions == 100")["event"]);
  EXPECT_EQ(stop("astar", "samples > 0")["stopped"], false) << "it draws none";
}

TEST(RunBreak, tellsPlannersOfOneKindApart) {
  const auto stops = run_program({"run", kDemo, "--planner", "astar,astar", "--set",
                                  "astar#2.heuristic=euclidean", "--break", "event(replan)", "--json"})
                         .json()["stops"];
  EXPECT_EQ(stops[0]["planner"], "astar");
  EXPECT_EQ(stops[1]["planner"], "astar#2");
}

TEST(RunBreak, tellsTheValuesThatTheConditionReads) {
  const Outcome outcome = run_program({"run", kDemo, "--planner", "dstar-lite", "--break",
                                       "size(U) >= 10 && robot != none && !queued(0, 0)", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto values = outcome.json()["stops"][0]["values"];
  EXPECT_EQ(keys(values), (std::set<std::string>{"size(U)", "robot", "queued(0, 0)"}));
  EXPECT_EQ(values["size(U)"], 10);
  EXPECT_EQ(values["robot"].size(), 2u);
  EXPECT_EQ(values["queued(0, 0)"], false);
}

TEST(RunBreak, knowsWhatARobotThatDrivesDecides) {
  const std::string boxes = std::string(REPLAN_SOURCE_DIR) + "/maps/fusion-boxes.json";
  const auto stop = [&](const std::string& condition) {
    const Outcome outcome =
        run_program({"run", boxes, "--planner", "adaptive-astar", "--break", condition, "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.json()["stops"][0];
  };
  const auto turn = stop("changed(sub_goal) && moves > 0");
  EXPECT_EQ(turn["values"]["sub_goal"].size(), 2u);
  const auto poor = stop("score(winner) < 0.5");
  EXPECT_LT(poor["values"]["score(winner)"], 0.5);
  EXPECT_GT(poor["clock"], 0);
  EXPECT_GE(stop("admissible < 100")["clock"], 1);
}

TEST(RunBreak, saysWhatIsNotReached) {
  const Outcome outcome =
      run_program({"run", kDemo, "--planner", "astar,dstar-lite", "--break", "km > 0 && replans == 1"});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("astar       not reached: km > 0 && replans == 1"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("dstar-lite  km > 0 && replans == 1"), std::string::npos) << outcome.out;
}

TEST(RunBreak, pointsAtMistakes) {
  expect_complaint({"render", kDemo, "-o", "never.png", "--arc", "0.4,0"}, {"--arc", "from cell to cell"});
  const std::string boxes = std::string(REPLAN_SOURCE_DIR) + "/maps/fusion-boxes.json";
  expect_complaint({"render", boxes, "-o", "never.png", "--arc", "9,0"},
                   {"--arc 9,0", "more than the robot can do", "0.50 m/s"});
  expect_complaint({"render", boxes, "-o", "never.png", "--arc=-1,0"}, {"more than the robot can do"});
  expect_complaint({"run", kDemo, "--break", "rsh(3, 4) > 1"},
                   {"--break 'rsh(3, 4) > 1': character 1: unknown name 'rsh'; did you mean 'rhs'?"});
  expect_complaint({"run", kDemo, "--break", "km"}, {"compare it, as in km > 5"});
  expect_complaint({"run", kDemo, "--break", "km > 5", "--csv", "-"}, {"--break", "--json"});
  expect_complaint({"run", kDemo, "--break", "km > 5", "--trace", "-"}, {"--break", "--trace"});
}

TEST(RunBreak, saysWhatHoldsFromTheBeginning) {
  const Outcome outcome =
      run_program({"run", kDemo, "--planner", "dstar-lite", "--break", "g(12, 40) > 30 || event(replan)"});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("holds from the beginning"), std::string::npos) << outcome.out;
}

TEST(RunBreak, aMapIsPlannedOnAndNotDriven) {
  const Outcome outcome = run_program({"run", "--map", "generator:cells?width=30&height=20", "--start", "1,1",
                                       "--goal", "28,18", "--planner", "astar", "--break", "moves > 0"});
  EXPECT_EQ(outcome.code, 1) << outcome.out << outcome.err;
}

TEST(RunBreak, itsHelpNamesTheLanguage) {
  const std::string help = run_program({"run", "--help"}).out;
  for (const char* name : {"g(x, y)", "changed(value)", "size(U)", "underconsistent", "sight_failed"})
    EXPECT_NE(help.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace replan::test::break_test
