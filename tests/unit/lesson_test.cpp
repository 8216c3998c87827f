// Lessons: how they are read, how a step comes to be done, and that each that is shipped can be played to its end.
#include "core/lesson/lesson.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/base/markdown.hpp"
#include "core/debug/touched.hpp"
#include "core/lesson/lesson_player.hpp"
#include "core/session/command_name.hpp"
#include "core/session/fresh_plan.hpp"

namespace replan::lesson_test {
namespace {

const std::string kHead = R"(# Small

About *nothing* much.

```scenario
{"replan": 1, "map": {"rows": ["....", "....", "...."]}, "start": [0, 1], "goal": [3, 1],
 "planners": [{"id": "dstar-lite"}]}
```
)";
const std::string kStep =
    "\n## Begin\n\nPress **Home**\nnow.\n\n- given: `Seek`\n- until: `expansions == 0`\n"
    "- do: `seek 0`\n- cell: `3, 1`\n- touches: `3 of 12`\n";

Lesson read(const std::string& text) {
  Result<Lesson> lesson = parse_lesson(text, "l.md", ".");
  EXPECT_TRUE(lesson.ok()) << (lesson ? "" : lesson.error());
  return lesson ? std::move(lesson.value()) : Lesson{.steps = {LessonStep{}}};
}

std::string error_of(const std::string& text) {
  const Result<Lesson> lesson = parse_lesson(text, "l.md", ".");
  return lesson ? "no error" : lesson.error();
}

TEST(LessonReader, TakesAllParts) {
  const Lesson lesson = read(kHead + kStep);
  EXPECT_EQ(lesson.title, "Small");
  EXPECT_EQ(lesson.summary, "About *nothing* much.");
  EXPECT_EQ(lesson.scenario.map.width, 4);
  ASSERT_EQ(lesson.steps.size(), 1u);
  const LessonStep& step = lesson.steps.front();
  EXPECT_EQ(step.title, "Begin");
  EXPECT_EQ(step.paragraphs, std::vector<std::string>{"Press **Home** now."});
  EXPECT_EQ(step.given, std::vector<std::string>{"Seek"});
  ASSERT_TRUE(step.until);
  EXPECT_EQ(expression_text(*step.until), "expansions == 0");
  EXPECT_EQ(step.deeds.size(), 1u);
  EXPECT_EQ(step.cell, (Cell{3, 1}));
  EXPECT_EQ(step.touches, (TouchClaim{3, 12}));
}

TEST(LessonReader, TakesAScenarioFromItsFile) {
  const Lesson lesson = read("# A\n\nB.\n\n<!-- scenario: " REPLAN_SOURCE_DIR "/maps/demo.json -->\n" +
                             std::string("\n## C\n\nD.\n\n- until: `km > 0`\n"));
  EXPECT_EQ(lesson.scenario.map.width, 34);
}

TEST(LessonReader, ErrorsNameTheLineAndTheMend) {
  EXPECT_EQ(error_of(kHead), "l.md: the lesson has no steps; each begins with '## What it is about'");
  EXPECT_EQ(error_of(kHead + "## A\n"), "l.md:9: the step says nothing; write a sentence below it");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n"),
            "l.md:9: the step asks for nothing; add '- until: `CONDITION`' or '- given: `COMMAND`'");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- given: `Seek`\n"),
            "l.md:9: the step cannot be done for the learner; add '- do: `DEED`'");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- given: `Seak`\n"),
            "l.md:11: there is no command 'Seak'; did you mean 'Seek'?");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- untl: `km > 0`\n"),
            "l.md:11: a step has no 'untl'; did you mean 'until'?");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- until: `g > 0`\n"),
            "l.md:11: character 1: 'g' needs a cell: g(x, y)");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- do: `stepp line`\n"),
            "l.md:11: there is no deed 'stepp'; did you mean 'step'?");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- do: `paint 9,9`\n"),
            "l.md:11: the cell (9, 9) is outside the world: x goes from 0 to 3, y from 0 to 2");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- do: `step far`\n"),
            "l.md:11: a step is 'step UNIT [COUNT]', and a unit is line, expansion, move, replan or mission");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- cell: `1`\n"), "l.md:11: '1' is no cell; write 3,1");
  EXPECT_EQ(error_of(kHead + "## A\nB.\n- touches: `few of 12`\n"),
            "l.md:11: 'few of 12' does not say how many cells are touched; write 3 of 36");
  EXPECT_EQ(
      error_of("# A\nB.\n## C\n"),
      "l.md:3: the scenario is missing: put a block that begins with ```scenario before the first step");
  EXPECT_EQ(error_of("# A\nB.\n```scenario\n{\"replan\": 1, \"mapp\": 2}\n```\n").substr(0, 8), "l.md:4: ")
      << "errors in the scenario name the lesson's lines";
  EXPECT_EQ(error_of("# A\nB.\n```scenario\n{}\n"),
            "l.md:4: the scenario's block is not closed; end it with ```");
  EXPECT_EQ(error_of("text"), "l.md: the lesson has no heading; begin it with '# Name'");
}

TEST(LessonReader, SuggestsTheNearestLesson) {
  EXPECT_EQ(read_lesson("first-step").error(),
            "there is no lesson 'first-step'; did you mean 'first-steps'?");
}

TEST(LessonPlayer, AStepIsDoneOnceItsConditionHoldsAndItsCommandWasGiven) {
  LessonPlayer player(
      read(kHead + kStep + "\n## End\n\nGo.\n\n- until: `consistent(0, 1) && g(0, 1) < inf`\n"));
  Session session(player.lesson().scenario);
  session.settle();
  player.note("Seek");
  EXPECT_FALSE(player.look(session)) << "the cursor is at the end of the search";
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  EXPECT_TRUE(player.look(session));
  EXPECT_FALSE(player.look(session)) << "it is told once";
  ASSERT_TRUE(session.apply(Seek{session.run().timeline().size()}).ok());
  EXPECT_TRUE(player.done()) << "and stays done";
  player.go_back();
  EXPECT_EQ(player.number(), 0u) << "there is none before the first";
  player.go_on();
  EXPECT_EQ(player.number(), 1u);
  EXPECT_FALSE(player.done());
  player.go_on();
  EXPECT_EQ(player.number(), 1u) << "there is none after the last";
  // The way to where the condition comes true is found in the run.
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  const auto deeds = player.deeds(session);
  ASSERT_TRUE(deeds.ok()) << deeds.error();
  ASSERT_TRUE(session.apply(std::get<Command>(deeds->front())).ok());
  EXPECT_TRUE(player.look(session));
}

TEST(LessonPlayer, AWorldOfAnotherSizeIsNotTheLessons) {
  LessonPlayer player(read(kHead + "\n## End\n\nGo.\n\n- until: `g(3, 1) == 0`\n"));
  Session session(player.lesson().scenario);
  ASSERT_TRUE(session.apply(ResizeWorld{{.width = 2, .height = 3}}).ok());
  session.settle();
  EXPECT_FALSE(player.look(session));
  EXPECT_FALSE(player.deeds(session).ok());
}

/// Does the step as the learner would have it done; false if it is not done then.
bool do_step(LessonPlayer& player, Session& session) {
  const auto deeds = player.deeds(session);
  if (!deeds) return false;
  for (const Deed& deed : *deeds) {
    if (const auto* command = std::get_if<Command>(&deed)) {
      EXPECT_TRUE(session.apply(*command).ok());
      player.note(command_name(*command));
    } else {
      player.note(std::get<ActionDeed>(deed).action);
    }
  }
  session.settle();
  return player.look(session);
}

/// What the latest repair of the leading run touched at the cursor, and what a plan from scratch would have.
TouchClaim touched_by_last_repair(const Session& session) {
  const Run& run = session.run();
  const std::size_t cursor = run.timeline().cursor();
  std::size_t begin = 0;
  for (const Milestone& each : run.milestones())
    if (each.kind == EventKind::plan_begin && each.event < cursor) begin = each.event;
  TouchedList touched;
  touched.follow(run.log_view(), run.log_id(), begin, cursor);
  return {static_cast<std::int64_t>(touched.list().size()),
          plan_from_scratch(FreshPlanTask(run), {}).touched};
}

std::string words_of(const LessonStep& step) {
  std::string words;
  for (const std::string& each : step.paragraphs) words += without_markdown(each) + " ";
  return words;
}

/// Holds the step's claim, if it makes one, to the run; the repair has to be worth it.
void expect_claim(const LessonPlayer& player, const Session& session) {
  if (!player.step().touches) return;
  const TouchClaim claim = *player.step().touches;
  const TouchClaim really = touched_by_last_repair(session);
  EXPECT_EQ(claim, really) << player.lesson().id << ": '" << player.step().title << "': " << really.repair
                           << " of " << really.scratch;
  EXPECT_LE(claim.repair * 3, claim.scratch) << "a lesson shows a repair that pays";
}

TEST(ShippedLessons, ArePlayedToTheirEndByTheirDeeds) {
  const std::vector<LessonFile> files = lesson_files();
  ASSERT_GE(files.size(), 5u);
  EXPECT_EQ(files.front().id, "first-steps");
  std::set<std::string> ids;
  for (const LessonFile& file : files) {
    EXPECT_TRUE(ids.insert(file.id).second) << file.id << " is there twice";
    Result<Lesson> lesson = read_lesson(file);
    ASSERT_TRUE(lesson.ok()) << lesson.error();
    LessonPlayer player(std::move(lesson.value()));
    Session session(player.lesson().scenario);
    session.settle();
    for (std::size_t i = 0; i < player.lesson().steps.size(); ++i) {
      EXPECT_FALSE(player.look(session))
          << file.path << ": '" << player.step().title << "' is done before it begins";
      EXPECT_TRUE(do_step(player, session)) << file.path << ": '" << player.step().title << "' is never done";
      expect_claim(player, session);
      player.go_on();
    }
    EXPECT_TRUE(player.at_last());
  }
}

TEST(ShippedLessons, AWallThatIsInNobodysWayIsNoRepair) {
  Result<Lesson> lesson = read_lesson("first-steps");
  ASSERT_TRUE(lesson.ok()) << lesson.error();
  LessonPlayer player(std::move(lesson.value()));
  Session session(player.lesson().scenario);
  session.settle();
  while (player.step().given != std::vector<std::string>{"PaintCells"}) {
    ASSERT_TRUE(do_step(player, session)) << player.step().title;
    ASSERT_FALSE(player.at_last());
    player.go_on();
  }
  ASSERT_TRUE(session.apply(PaintCells{{{{7, 0}, true}}}).ok());
  player.note("PaintCells");
  session.settle();
  EXPECT_FALSE(player.look(session)) << "a corner was painted";
  EXPECT_TRUE(do_step(player, session));
}

/// Where a lesson says how often a key is pressed, that is how often it has to be.
TEST(ShippedLessons, TakeThePressesThatTheyAskFor) {
  const std::pair<std::string_view, int> kCounts[] = {{"Press → once", 1},
                                                      {"Press → again", 1},
                                                      {"Press → twice", 2},
                                                      {"Press → three times", 3},
                                                      {"Press → some five times", 5}};
  for (const LessonFile& file : lesson_files()) {
    Result<Lesson> lesson = read_lesson(file);
    ASSERT_TRUE(lesson.ok()) << lesson.error();
    LessonPlayer player(std::move(lesson.value()));
    Session session(player.lesson().scenario);
    session.settle();
    for (std::size_t i = 0; i < player.lesson().steps.size(); ++i, player.go_on()) {
      const std::string words = words_of(player.step());
      const auto asked = std::find_if(std::begin(kCounts), std::end(kCounts), [&](const auto& each) {
        return words.find(each.first) != std::string::npos;
      });
      if (asked == std::end(kCounts)) {
        EXPECT_TRUE(do_step(player, session)) << file.path << ": " << player.step().title;
        continue;
      }
      for (int press = 1; press <= asked->second; ++press) {
        ASSERT_TRUE(session.apply(Step{StepUnit::expansion, 1}).ok());
        player.note("Step");
        session.settle();
        const bool done = player.look(session);
        EXPECT_EQ(done, press == asked->second)
            << file.path << ": '" << player.step().title << "' after " << press << " presses";
      }
    }
  }
}

TEST(ShippedLessons, CountTheExpansionsOfTwoPlanners) {
  const Result<Lesson> lesson = read_lesson("two-planners");
  ASSERT_TRUE(lesson.ok()) << lesson.error();
  Session session(lesson->scenario);
  session.settle();
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  session.settle();
  std::string words;
  for (const LessonStep& step : lesson->steps) words += words_of(step);
  std::vector<std::int64_t> all;
  for (const auto& run : session.runs()) {
    const MissionFigures& end = run->decisions().back().figures;
    EXPECT_EQ(end.replans, 1);
    for (const std::int64_t count : {end.counters.expansions, end.last_plan.expansions})
      EXPECT_NE(words.find(std::to_string(count)), std::string::npos) << count;
    all.push_back(end.counters.expansions);
  }
  EXPECT_GE(all[1], 2 * all[0]) << "A* has twice the work";
  EXPECT_EQ(session.runs()[0]->decisions().back().figures.moves,
            session.runs()[1]->decisions().back().figures.moves);
}

TEST(ShippedLessons, AreMadeOfShortSentences) {
  for (const LessonFile& file : lesson_files()) {
    const Result<Lesson> lesson = read_lesson(file);
    ASSERT_TRUE(lesson.ok()) << lesson.error();
    EXPECT_TRUE(lesson->summary.ends_with('.')) << file.path;
    for (const LessonStep& step : lesson->steps) {
      std::size_t letters = 0;
      for (const std::string& paragraph : step.paragraphs) {
        EXPECT_TRUE(paragraph.ends_with('.')) << file.path << ": " << paragraph;
        letters += without_markdown(paragraph).size();
      }
      EXPECT_LE(letters, 330u) << file.path << ": '" << step.title << "' is too long for a step";
    }
  }
}

using Spans = std::vector<MarkdownSpan>;

TEST(Markdown, TellsFacesApart) {
  using enum MarkdownFace;
  EXPECT_EQ(markdown_spans("a *b* **c d** `e*f*`."), (Spans{{plain, "a "},
                                                            {emphasis, "b"},
                                                            {plain, " "},
                                                            {strong, "c d"},
                                                            {plain, " "},
                                                            {code, "e*f*"},
                                                            {plain, "."}}));
  EXPECT_EQ(markdown_spans("*Laws* and D* Lite"), (Spans{{emphasis, "Laws"}, {plain, " and D* Lite"}}));
  EXPECT_EQ(markdown_spans(""), Spans{});
}

TEST(Markdown, LeavesStarsOfNamesAndOfSums) {
  for (const char* text :
       {"D* Lite and A*", "D* Lite, DLD* Lite: *", "a * b * c", "2*3*4", "one `open", "**", "*"})
    EXPECT_EQ(without_markdown(text), text);
  EXPECT_EQ(without_markdown("D\\* Lite with \\`g\\`"), "D* Lite with `g`");
  EXPECT_EQ(without_markdown("the *D* Lite* planner"), "the D* Lite planner");
}

}  // namespace
}  // namespace replan::lesson_test
