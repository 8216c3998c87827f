// Studies: statistics by hand, their texts, and that each runs.
#include "core/study/study.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/base64.hpp"
#include "core/scene/view.hpp"
#include "core/study/study_charts.hpp"
#include "core/study/study_html.hpp"
#include "core/study/study_runs.hpp"
#include "core/study/study_words.hpp"
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
  EXPECT_NE(together.find("| planner | paths | length (m) | the paper's | time, A = 1 | time (ms) |"),
            std::string::npos)
      << together;
  EXPECT_NE(together.find("| A | 2 of 2 | 10.50 ± 0.71 | 12.50 | 1.00 (1.00 to 1.00) | 2.0 (1.5 to 2.5) |"),
            std::string::npos)
      << together;
  EXPECT_NE(together.find("| B | 1 of 2 | 14.00 | – | 2.00 (2.00 to 2.00) | 3.0 (2.5 to 3.5) |"),
            std::string::npos)
      << together;
  EXPECT_NE(together.find("| A is shorter. | It is. | reproduced |"), std::string::npos) << together;
  report.worlds_apart = true;
  const std::string apart = study_markdown(small_info(), report);
  EXPECT_NE(apart.find("## two\n"), std::string::npos) << apart;
  EXPECT_NE(apart.find("| B | 0 of 1 | – | – | – | 4.0 (4.0 to 4.0) |"), std::string::npos) << apart;
}

TEST(Study, ComparesRunByRunWhereBothHaveFound) {
  const StudyReport report = small_report();
  const auto ratio = ratio_of(report, 0, 1, 0);
  ASSERT_TRUE(ratio);
  EXPECT_EQ(ratio->count, 1u);  // in the second world only one of them has a path
  EXPECT_DOUBLE_EQ(ratio->mean, 1.4);
  EXPECT_FALSE(ratio_of(report, 0, 1, 0, 1));
  EXPECT_EQ(typical_values(report, 0), (std::vector<double>{10, 14}));
  EXPECT_TRUE(typical_values(report, 0, 1).empty());
}

TEST(Study, FillsInSentences) {
  EXPECT_EQ(filled("{2} and {1}, {2}", {"a", "{1}"}), "{1} and a, {1}");
  EXPECT_EQ(filled("none", {}), "none");
}

/// What is drawn is in the script, so that nothing else is needed to draw it again.
TEST(StudyChart, HasItsDataInsideItsScript) {
  StudyReport report = small_report();
  const std::string bars = chart_script(report, {"length", "Length", 0}, "small-length");
  EXPECT_NE(bars.find("$planner0 << EOD\n0.000000 10.500000 9.792893 11.207107\nEOD"), std::string::npos)
      << bars;
  EXPECT_NE(bars.find("$planner1 << EOD\n1.000000 14.000000 14.000000 14.000000\nEOD"), std::string::npos)
      << bars;
  EXPECT_NE(bars.find("$paper << EOD\n0.000000 12.500000\nEOD"), std::string::npos) << bars;
  EXPECT_NE(bars.find("set output \"small-length.svg\""), std::string::npos) << bars;
  EXPECT_NE(bars.find("set output \"small-length.png\""), std::string::npos) << bars;
  EXPECT_NE(bars.find("length (m)"), std::string::npos) << bars;
}

TEST(StudyChart, DrawsTimesAsRatiosToTheFirstPlanner) {
  StudyReport report = small_report();
  report.paper = {{1, 0, {}, 500}, {1, 1, {}, 750}};
  const std::string bars = chart_script(report, {"time", "Time", 1}, "t");
  EXPECT_NE(bars.find("$planner1 << EOD\n1.000000 2.000000 2.000000 2.000000\nEOD"), std::string::npos)
      << bars;
  EXPECT_NE(bars.find("$paper << EOD\n0.000000 1.000000\n1.000000 1.500000\nEOD"), std::string::npos) << bars;
  EXPECT_NE(bars.find("time, A = 1"), std::string::npos) << bars;
}

TEST(StudyChart, OfLinesGoesFromWorldToWorld) {
  const std::string lines =
      chart_script(small_report(), {"length", "Length", 0, StudyChart::Form::lines, true}, "l");
  EXPECT_NE(lines.find("$planner0 << EOD\n-0.030000 10.000000 10.000000 10.000000\n0.970000 11.000000"),
            std::string::npos)
      << lines;
  EXPECT_NE(lines.find("set logscale y"), std::string::npos) << lines;
}

TEST(StudyChart, NeedsARunWithItsFigure) {
  StudyReport report = small_report();
  EXPECT_TRUE(can_be_drawn(report, {"length", "Length", 0}));
  for (StudyRun& run : report.runs) run.values[0] = std::nullopt;
  EXPECT_FALSE(can_be_drawn(report, {"length", "Length", 0}));
  EXPECT_TRUE(can_be_drawn(report, {"time", "Time", 1}));
}

/// The page needs nothing from the network, and says what became of every claim.
TEST(StudyPage, HoldsAllOfIt) {
  const StudyInfo info = small_info();
  StudyReport report = small_report();
  report.claims.push_back({"B < A & more.", "It is <not>.", Verdict::not_reproduced, "Because."});
  report.supplement = "## Others\n\n| name | share |\n| --- | ---: |\n| X | 12 % |\n\nA word.\n";
  std::vector<StudySection> sections(1);
  sections[0] = {
      &info, report, {{"Two worlds", {{"A", "<svg>a</svg>"}, {"B", "<svg>b</svg>"}}}}, {"A note."}};
  const std::string page = study_html(sections);
  for (const char* part :
       {"B &lt; A &amp; more.", "It is &lt;not&gt;.", "Because.", "class=\"verdict not-reproduced\"",
        "A small study", "src=\"data:image/svg+xml;base64,PHN2Zz5hPC9zdmc+\"", "<h3>Others</h3>", "12 %",
        "A note.", "A word."})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  for (const char* foreign : {"http:", "https:", "<script", "url("})
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
}

TEST(Base64, IsThatOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\0\xff", 2)), "AP8=");
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
    for (const StudyChart& chart : report->charts)
      EXPECT_NE(chart_script(*report, chart, "x").find("plot "), std::string::npos) << chart.id;
    EXPECT_EQ(told, all);
    EXPECT_EQ(told, report->runs.size());
    EXPECT_GE(report->claims.size(), 3u);
    for (const StudyRun& run : report->runs) EXPECT_EQ(run.values.size(), report->figures.size());
    for (const StudyClaim& claim : report->claims)
      EXPECT_TRUE(claim.verdict == Verdict::reproduced || !claim.why.empty()) << claim.paper;
    StopSource stop;
    stop.request_stop();
    const auto stopped = info.run({.seeds = 1, .stop = stop.get_token()});
    ASSERT_TRUE(stopped.ok());
    EXPECT_TRUE(stopped->runs.empty());
    EXPECT_TRUE(stopped->claims.empty());
  }
}

/// A picture can be drawn: its planners and overlays are there, and its scenario reads back.
TEST(Study, PicturesOpenInTheWindow) {
  for (const StudyInfo& info : studies()) {
    SCOPED_TRACE(info.id);
    if (info.pictures == nullptr) continue;
    const auto pictures = info.pictures();
    ASSERT_TRUE(pictures.ok()) << pictures.error();
    for (const StudyPicture& picture : *pictures) {
      EXPECT_GE(picture.scenario.planners.size(), 1u);
      EXPECT_LE(picture.scenario.planners.size(), 4u);
      EXPECT_TRUE(parse_overlays(picture.overlays).ok());
      Scenario alone = picture.scenario;
      alone.map_file.clear();
      const auto again = parse_scenario(scenario_text(alone), "picture", ".");
      ASSERT_TRUE(again.ok()) << again.error();
      EXPECT_EQ(again->map.blocked, picture.scenario.map.blocked);
    }
  }
}

/// What a plan is told as comes out of the report of that plan.
TEST(Study, MeasuresPlansAsRunsDo) {
  const auto scenario = read_scenario(library_folder() + "/demo.json");
  ASSERT_TRUE(scenario.ok());
  PlannerChoice choice;
  choice.id = "dld-star-lite";
  const RunReport report = plan_once(scenario->map, scenario->start, scenario->goal, choice);
  const StudyRun run = plan_run(scenario->map, scenario->start, scenario->goal, choice, 1);
  ASSERT_TRUE(run.found);
  EXPECT_EQ(run.values[kLength], report.figures.length);
  EXPECT_EQ(run.values[kTurns], static_cast<double>(report.figures.turns));
  EXPECT_EQ(run.values[kSightChecks], static_cast<double>(report.counters.sight_checks));
  EXPECT_EQ(run.values.size(), plan_figures().size());
}

TEST(Study, PointsAlongAPathAreByItsLength) {
  const Path path(std::vector<Point>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}});
  EXPECT_EQ(point_along(path, 0), (Point{0, 0, 0}));
  EXPECT_EQ(point_along(path, 0.25), (Point{2, 0, 0}));
  EXPECT_EQ(point_along(path, 0.75), (Point{4, 2, 0}));
  EXPECT_EQ(point_along(path, 1), (Point{4, 4, 0}));
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
