// Studies: statistics by hand, their texts, and that each runs.
#include "core/study/study.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/world/generators/generators.hpp"
#include "core/world/library.hpp"
#include "core/world/scenario.hpp"

namespace replan::test::study_test {
namespace {

TEST(Study, SpreadsAreThoseOfTheHand) {
  EXPECT_FALSE(spread_of({}));
  const auto one = spread_of({3});
  EXPECT_EQ(one->count, 1u);
  EXPECT_EQ(one->mean, 3);
  EXPECT_EQ(one->deviation, 0);
  EXPECT_EQ(one->median, 3);
  const auto five = spread_of({5, 1, 4, 2, 8});
  EXPECT_DOUBLE_EQ(five->mean, 4);
  EXPECT_DOUBLE_EQ(five->deviation, std::sqrt(30.0 / 4));
  EXPECT_DOUBLE_EQ(five->low, 2);
  EXPECT_DOUBLE_EQ(five->median, 4);
  EXPECT_DOUBLE_EQ(five->high, 5);
  EXPECT_DOUBLE_EQ(spread_of({1, 2})->median, 1.5);
}

/// Two worlds, two planners, of which the second finds no path in the second world.
StudyReport small_report() {
  StudyReport report;
  report.worlds = {"one", "two"};
  report.planners = {"A", "B"};
  report.figures = {{"length", "length", "m", 2}, {"ms", "time", "ms", 1, true}};
  report.paper = {{0, 0, {}, 12.5}};
  report.runs = {{0, 0, 1, true, {10.0, 1.0}},
                 {0, 1, 1, true, {14.0, 2.0}},
                 {1, 0, 1, true, {11.0, 3.0}},
                 {1, 1, 1, false, {std::nullopt, 4.0}}};
  report.claims = {{"A is shorter.", "It is.", Verdict::reproduced, ""}};
  return report;
}

StudyInfo small_info() {
  return {"small", "A small study", "a paper", "As it is.", 1, 1, nullptr};
}

TEST(Study, TakesWorldsTogetherOrApart) {
  StudyReport report = small_report();
  EXPECT_DOUBLE_EQ(spread_of(report, 0, 0)->mean, 10.5);
  EXPECT_DOUBLE_EQ(spread_of(report, 0, 0, 1)->mean, 11);
  EXPECT_FALSE(spread_of(report, 0, 1, 1));
  const std::string together = study_markdown(small_info(), report);
  EXPECT_NE(together.find("| planner | paths | length (m) | the paper's | time (ms) |"), std::string::npos)
      << together;
  EXPECT_NE(together.find("| A | 2 of 2 | 10.50 ± 0.71 | 12.50 | 2.0 (1.5 to 2.5) |"), std::string::npos)
      << together;
  EXPECT_NE(together.find("| B | 1 of 2 | 14.00 | – | 3.0 (2.5 to 3.5) |"), std::string::npos) << together;
  EXPECT_NE(together.find("| A is shorter. | It is. | reproduced |"), std::string::npos) << together;
  report.worlds_apart = true;
  const std::string apart = study_markdown(small_info(), report);
  EXPECT_NE(apart.find("## two\n"), std::string::npos) << apart;
  EXPECT_NE(apart.find("| B | 0 of 1 | – | – | 4.0 (4.0 to 4.0) |"), std::string::npos) << apart;
}

TEST(Study, HasEachRunInItsFiles) {
  EXPECT_EQ(study_csv(small_report()),
            "world,planner,seed,found,length [m],ms [ms]\n"
            "one,A,1,1,10,1\none,B,1,1,14,2\ntwo,A,1,1,11,3\ntwo,B,1,0,,4\n");
  const auto json = nlohmann::json::parse(study_json(small_info(), small_report()));
  ASSERT_EQ(json["runs"].size(), 4u);
  EXPECT_EQ(json["runs"][3]["found"], false);
  EXPECT_FALSE(json["runs"][3]["figures"].contains("length"));
  EXPECT_EQ(json["paper"][0]["value"], 12.5);
  EXPECT_EQ(json["claims"][0]["verdict"], "reproduced");
}

TEST(Study, OfAnUnknownNameSuggestsTheNearest) {
  EXPECT_EQ(require_study("informed-rt").error(),
            "unknown study 'informed-rt'; did you mean 'informed-rrt'?");
}

/// Each of them with one seed: what it measures makes sense, and it says something to each claim.
TEST(Study, EachRunsAndSpeaksToItsClaims) {
  for (const StudyInfo& info : studies()) {
    SCOPED_TRACE(info.id);
    std::size_t told = 0, all = 0;
    const auto report = info.run({.seeds = 1, .progress = [&](std::size_t done, std::size_t of) {
                                    told = done;
                                    all = of;
                                  }});
    ASSERT_TRUE(report.ok()) << report.error();
    EXPECT_EQ(report->runs.size(), report->worlds.size() * report->planners.size());
    EXPECT_EQ(told, all);
    EXPECT_EQ(told, report->runs.size());
    EXPECT_GE(report->claims.size(), 3u);
    for (const StudyRun& run : report->runs) EXPECT_EQ(run.values.size(), report->figures.size());
    for (const StudyClaim& claim : report->claims)
      EXPECT_TRUE(claim.verdict == Verdict::reproduced || !claim.why.empty()) << claim.paper;
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = info.run({.seeds = 1, .stop = stop.get_token()});
    ASSERT_TRUE(stopped.ok());
    EXPECT_TRUE(stopped->runs.empty());
    EXPECT_TRUE(stopped->claims.empty());
  }
}

/// What opens in the window is what the study runs on.
TEST(Study, TheWorldOfFigure5IsTheFirstOfItsMaps) {
  const auto scenario = read_scenario(library_folder() + "/dld-fig-5.json");
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  const std::array ends{scenario->start, scenario->goal};
  const auto map = random_rectangles(200, 200, 0.17, 5, 15, 1, ends);
  ASSERT_TRUE(map.ok());
  EXPECT_EQ(scenario->map.blocked, map->blocked);
}

}  // namespace
}  // namespace replan::test::study_test
