// The planners' pages: each is there, and holds every line that its planner's log speaks of.
#include "core/plan/pages.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/sim/mission.hpp"
#include "core/world/choices.hpp"

namespace replan::pages_test {
namespace {

PlannerPage page_or_fail(const std::string& text) {
  Result<PlannerPage> page = parse_page(text, "test.md", ".");
  EXPECT_TRUE(page.ok()) << (page ? "" : page.error());
  return page ? *std::move(page) : PlannerPage{};
}

/// A run with everything in it: a plan, moves, a surprise that blocks the way, one that opens it again.
Scenario eventful_scenario(const std::string& planner) {
  Scenario scenario;
  scenario.map = GridMap(24, 12);
  for (int y = 3; y < 12; ++y) scenario.map.set({11, y}, true);
  scenario.start = {2, 9};
  scenario.goal = {21, 9};
  scenario.planners = {{planner, {}}};
  scenario.robot.sensor_radius = 4;
  Surprise wall{.at = {.move = 3, .near = {}, .within = 0}, .cells = {}, .announced = false};
  for (int y = 1; y < 3; ++y) wall.cells.push_back({{11, y}, true});
  Surprise gap{.at = {.move = 9, .near = {}, .within = 0},
               .cells = {{{11, 7}, false}, {{11, 8}, false}, {{11, 9}, false}},
               .announced = true};
  scenario.surprises = {wall, gap};
  return scenario;
}

/// The pseudo-code lines of all events of a whole mission->
std::set<int> recorded_lines(const std::string& planner, const Settings& settings = {}) {
  Scenario scenario = eventful_scenario(planner);
  scenario.planners.front().settings = settings;
  Recorder recorder;
  const auto mission = make_mission(scenario, scenario.planners.front(), &recorder);
  while (mission->advance(1000)) {
  }
  if (const Pilot* pilot = find_pilot(planner); pilot == nullptr && !find_planner(planner)->exercise) {
    EXPECT_EQ(mission->state(), MissionState::arrived) << planner;
  }
  EXPECT_GT(mission->now().figures.replans, 0) << planner;
  std::set<int> lines;
  for (const Event& event : recorder.buffer()) lines.insert(event.line);
  return lines;
}

TEST(Pages, EveryPlannerHasOneWithIdeaLimitsAndSource) {
  for (const PlannerInfo& info : choices()) {
    const Result<PlannerPage> page = read_page(info.id);
    ASSERT_TRUE(page.ok()) << page.error();
    EXPECT_EQ(page->title, info.name) << info.id;
    for (const char* section : {"Idea", "Settings", "Limits", "Source"}) {
      ASSERT_NE(page->section(section), nullptr) << info.id << ": " << section;
      EXPECT_FALSE(page->section(section)->paragraphs.empty()) << info.id << ": " << section;
    }
  }
}

TEST(Pages, HoldEveryLineThatIsRecorded) {
  for (const PlannerInfo& info : planners()) {
    const Result<PlannerPage> page = read_page(info.id);
    ASSERT_TRUE(page.ok()) << page.error();
    for (const int number : recorded_lines(std::string(info.id))) {
      const PseudoLine* line = page->line(number);
      ASSERT_NE(line, nullptr) << info.id << " records line " << number << ", which its page does not have";
    }
  }
}

/// A pilot's page stands before the code of what plans for it, whichever that is, and no line has two numbers.
TEST(Pages, OfPilotsHoldEveryLineThatIsRecordedByThemOrTheirPlanner) {
  std::vector<PlannerChoice> asked = {{"dwa", {}}};
  for (std::size_t i = 0; i < complete_planners().size(); ++i) {
    asked.push_back({"fusion", {}});
    asked.back().settings.set("global", static_cast<double>(i));
  }
  for (const PlannerChoice& choice : asked) {
    const std::string planner = planner_of(choice).id;
    const Result<PlannerPage> page =
        find_planner(planner)->blind ? read_page(choice.id) : read_page(choice.id, planner);
    ASSERT_TRUE(page.ok()) << page.error();
    std::set<int> numbers;
    for (const PseudoBlock& block : page->code)
      for (const PseudoLine& line : block.lines)
        EXPECT_TRUE(line.number == 0 || numbers.insert(line.number).second)
            << planner << ": line " << line.number;
    for (const int number : recorded_lines(choice.id, choice.settings))
      EXPECT_TRUE(numbers.contains(number)) << choice.id << ", " << planner << ": line " << number;
  }
}

TEST(Pages, HoldEveryLineOfSightCheckedAlongThePath) {
  Settings settings;
  settings.set("sight_checks", 1);
  for (const char* planner : {"los-dstar-lite", "dld-star-lite"}) {
    const std::set<int> lines = recorded_lines(planner, settings);
    for (const int number : {205, 210, 214, 219})
      EXPECT_TRUE(lines.contains(number)) << planner << ' ' << number;
    for (const int number : {36, 37, 54}) EXPECT_FALSE(lines.contains(number)) << planner << ' ' << number;
    const Result<PlannerPage> page = read_page(planner);
    ASSERT_TRUE(page.ok()) << page.error();
    for (const int number : lines) EXPECT_NE(page->line(number), nullptr) << planner << ' ' << number;
  }
}

TEST(Pages, NumberTheirLinesOnce) {
  for (const PlannerInfo& info : planners()) {
    const Result<PlannerPage> page = read_page(info.id);
    ASSERT_TRUE(page.ok()) << page.error();
    std::set<int> seen;
    for (const PseudoBlock& block : page->code)
      for (const PseudoLine& line : block.lines) {
        if (line.number == 0) continue;
        EXPECT_TRUE(seen.insert(line.number).second) << info.id << ": line " << line.number;
      }
  }
}

/// A page is its planner's own: it has no line that only others come to.
TEST(Pages, HaveNoLinesOfOtherPlanners) {
  for (const PlannerInfo& info : planners()) {
    const Result<PlannerPage> page = read_page(info.id);
    ASSERT_TRUE(page.ok()) << page.error();
    for (const PseudoBlock& block : page->code)
      for (const PseudoLine& line : block.lines) {
        const auto has = [&](const char* words) { return line.text.find(words) != std::string::npos; };
        EXPECT_FALSE(!info.sight && has("LineOfSight")) << info.id << ": " << line.text;
        EXPECT_FALSE(!info.sight && has("s_start ← rp")) << info.id << ": " << line.text;
        EXPECT_FALSE(!info.clearance && (has("dist(s") || has("DistanceTransform")))
            << info.id << ": " << line.text;
      }
  }
}

TEST(Pages, NameEverySettingOfTheirPlanner) {
  for (const PlannerInfo& info : choices()) {
    const Result<PlannerPage> page = read_page(info.id);
    ASSERT_TRUE(page.ok()) << page.error();
    std::string words;
    for (const std::string& paragraph : page->section("Settings")->paragraphs) words += paragraph + "\n";
    for (const Parameter& parameter : info.parameters)
      EXPECT_NE(words.find(parameter.label), std::string::npos)
          << info.id << " says nothing of '" << parameter.label << "'";
  }
}

TEST(Pages, ParseBlocksNumbersAndContinuations) {
  const PlannerPage page = page_or_fail(
      "# Name\r\n\n## Idea\n\nOne `word`\nand more.\n\n- item\n  goes on\n\n"
      "```pseudo 100 Main\n 1: first\n 2:   second\n      and its rest\n```\n");
  EXPECT_EQ(page.title, "Name");
  ASSERT_EQ(page.sections.size(), 1u);
  EXPECT_EQ(page.sections[0].paragraphs,
            (std::vector<std::string>{"One `word` and more.", "• item goes on"}));
  ASSERT_EQ(page.code.size(), 1u);
  EXPECT_EQ(page.code[0].title, "Main");
  ASSERT_EQ(page.code[0].lines.size(), 3u);
  EXPECT_EQ(page.line(102)->text, "  second");
  EXPECT_EQ(page.code[0].lines[2].number, 0);
  EXPECT_EQ(page.code[0].lines[2].text, "  and its rest");
  EXPECT_EQ(page.line(3), nullptr);
  EXPECT_EQ(page.block_of(101), &page.code[0]);
}

TEST(Pages, ErrorsNamePlaceAndMend) {
  const auto error = [](const std::string& text) { return parse_page(text, "test.md", ".").error(); };
  EXPECT_EQ(error("# Name\n```pseudo 0 T\nno number\n```\n"),
            "test.md:3: a block's first line needs a number: '1: text'");
  EXPECT_EQ(error("# Name\n```pseudo T\n```\n").substr(0, 10), "test.md:2:");
  EXPECT_EQ(error("# Name\n```pseudo 100 T\n200: x\n```\n"), "test.md:3: line numbers go from 1 to 255");
  EXPECT_NE(error("words").find("no heading"), std::string::npos);
  EXPECT_NE(error("# Name\n").find("no pseudo-code"), std::string::npos);
  EXPECT_NE(error("# Name\n<!-- pseudo: nobody -->\n").find("nobody.md"), std::string::npos);
}

}  // namespace
}  // namespace replan::pages_test
