// 'replan run --trace' and 'replan list terms'.
#include <sstream>

#include "core/export/case_text.hpp"
#include "core/plan/glossary.hpp"
#include "tests/cli/child.hpp"
#include "tests/support/posthoc_check.hpp"
#include "tests/support/schema_check.hpp"

namespace replan::test::trace_test {
namespace {

using nlohmann::json;

constexpr const char* kScenario = R"({
  "replan": 1, "name": "Gap",
  "map": {"rows": ["........", "...@....", "...@....", "...@....", "........"]},
  "start": [0, 2], "goal": [7, 2],
  "planners": [{"id": "dstar-lite"}, {"id": "astar", "settings": {"heuristic": "zero"}}, {"id": "astar"}],
  "robot": {"knowledge": "map", "sensor_radius": 2},
  "surprises": [{"at": {"move": 1}, "add": {"cells": [[3, 0]]}}]
})";

class TraceCommand : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string scenario_ = folder_.with("gap.json", kScenario);

  void expect_complaint(const std::vector<std::string>& arguments, const std::string& part) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
};

TEST_F(TraceCommand, writesAFileForEachPlanner) {
  const Outcome outcome = run_program({"run", scenario_, "--trace", folder_.file("t.jsonl"), "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.json()["runs"].size(), 3u) << "the figures are printed as ever";
  const json rules = json::parse(whole_file(REPLAN_SOURCE_DIR "/assets/trace.schema.json"));
  const SchemaCheck check(rules);
  const std::pair<const char*, const char*> files[] = {
      {"t.dstar-lite.jsonl", "dstar-lite"}, {"t.astar.jsonl", "astar"}, {"t.astar#2.jsonl", "astar"}};
  for (const auto& [file, planner] : files) {
    std::istringstream lines(whole_file(folder_.file(file)));
    std::string line;
    ASSERT_TRUE(std::getline(lines, line)) << file;
    const json head = json::parse(line);
    EXPECT_EQ(check.check(head), "");
    EXPECT_EQ(head["planner"], planner);
    std::size_t count = 0;
    for (; std::getline(lines, line); ++count) EXPECT_EQ(check.check(json::parse(line)), "") << line;
    EXPECT_EQ(count, head["events"]);
  }
  EXPECT_EQ(whole_file(folder_.file("t.jsonl")), "");
}

TEST_F(TraceCommand, aRunToTheNearestCellKeepsToTheSchemaToo) {
  const auto world = folder_.with("shut.json", R"({"replan": 1, "map": {"rows": ["....@..", "....@.."]},
 "start": [0, 0], "goal": [6, 0], "planners": [{"id": "astar"}], "robot": {"unreachable_goal": "nearest"},
 "surprises": [{"at": {"move": 9}, "remove": {"cells": [[4, 0]]}}]})");
  const std::string file = folder_.file("shut.jsonl");
  EXPECT_EQ(run_program({"run", world, "--trace", file}).code, 0) << "the way opens";
  const json rules = json::parse(whole_file(REPLAN_SOURCE_DIR "/assets/trace.schema.json"));
  std::istringstream lines(whole_file(file));
  std::vector<bool> aims;
  for (std::string line; std::getline(lines, line);) {
    const json event = json::parse(line);
    ASSERT_EQ(SchemaCheck(rules).check(event), "") << line;
    if (event.contains("kind") && event["kind"] == "aim") aims.push_back(event["goal"]);
  }
  EXPECT_EQ(aims, (std::vector<bool>{false, true}));
}

TEST_F(TraceCommand, writesPosthocTracesAndTheMapUnderThem) {
  for (const std::string name : {"t.trace.yaml", "t.trace.json"}) {
    const Outcome outcome = run_program({"run", scenario_, "--planner", "dstar-lite", "--trace",
                                         folder_.file(name), "--trace-map", folder_.file("t.map")});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::string text = whole_file(folder_.file(name));
    EXPECT_EQ(PosthocCheck::check(name, text), "");
    EXPECT_NE(text.find("block"), std::string::npos);
    EXPECT_EQ(whole_file(folder_.file("t.map")),
              "type octile\nheight 5\nwidth 8\nmap\n........\n...@....\n...@....\n...@....\n........\n");
  }
  const std::string map = folder_.file("t.map");
  const Outcome plan = run_program({"run", "--map", map, "--start", "0,2", "--goal", "7,2", "--planner",
                                    "astar", "--trace", folder_.file("plan.trace.yaml")});
  EXPECT_EQ(plan.code, 0) << plan.err;
  EXPECT_EQ(PosthocCheck::check("plan.trace.yaml", whole_file(folder_.file("plan.trace.yaml"))), "");
}

TEST_F(TraceCommand, saysWhatIsWrongBeforeItRuns) {
  expect_complaint({"run", scenario_, "--trace", folder_.file("t.json")}, "'t.trace.json'");
  expect_complaint({"run", scenario_, "--trace", folder_.file("t.csv")}, ".jsonl");
  expect_complaint({"run", scenario_, "--trace-map", folder_.file("t.map")}, "give --trace FILE");
  expect_complaint(
      {"run", scenario_, "--trace", folder_.file("t.jsonl"), "--trace-map", folder_.file("t.png")},
      "end the name");
  expect_complaint({"run", scenario_, "--trace", "/nonexistent/t.jsonl"}, "/nonexistent/t.dstar-lite.jsonl");
}

TEST_F(TraceCommand, showPrintsAMomentThatLeadsBack) {
  const Outcome outcome = run_program({"show", scenario_, "--at", "40", "--cell", "5,2"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto moment = parse_case_text(outcome.out, "stdout");
  ASSERT_TRUE(moment.ok()) << moment.error();
  EXPECT_EQ(moment->event, 40u);
  EXPECT_NE(outcome.out.find("around (5, 2)"), std::string::npos);
  expect_complaint({"show", scenario_, "--at", "replan:99"}, "--at");
  expect_complaint({"show", scenario_, "--cell", "8,2"}, "outside the world");
}

TEST(ListTerms, explainsTheWordsOfTheField) {
  const Outcome text = run_program({"list", "terms"});
  EXPECT_EQ(text.code, 0);
  const json list = run_program({"list", "terms", "--json"}).json()["terms"];
  ASSERT_EQ(list.size(), glossary().size());
  for (const GlossaryTerm& term : glossary())
    EXPECT_NE(text.out.find(std::string(term.title) + "\n    "), std::string::npos);
  EXPECT_EQ(list[0]["id"], glossary()[0].id);
}

}  // namespace
}  // namespace replan::test::trace_test
