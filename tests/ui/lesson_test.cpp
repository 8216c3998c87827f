// Lessons in the window: the strip over the canvas, with keyboard and mouse.
#include "core/lesson/lesson.hpp"

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "tests/ui/shell_fixture.hpp"
#include "ui/shell/actions.hpp"
#include "ui/tabs/words.hpp"

namespace replan::ui::lesson_test {
namespace {

constexpr const char* kWorld = R"({"replan": 1, "name": "Room", "map": {"rows": ["..........", ".........."]},
    "start": [0, 0], "goal": [9, 1], "planners": [{"id": "dstar-lite"}]})";

class LessonTest : public ShellTest {
 protected:
  void SetUp() override { open("room.json", kWorld); }

  void click(ImVec2 at) {
    InputQueue& input = offscreen_->stage().input();
    input.mouse_move(at.x, at.y);
    frames(3);
    input.mouse_button(0, true);
    frames(3);
    input.mouse_button(0, false);
    frames(3);
  }
  void begin() {
    shell_->perform_next(ActionId::first_steps);
    frames(2);
    session_->settle();
    frames(4);
    ASSERT_TRUE(shell_->lesson().open());
  }
  /// In the row of the strip's buttons, behind Back and those that are named.
  void click_behind(std::initializer_list<const char*> buttons) {
    float x = left() + width_of("Back");
    for (const char* each : buttons) x += width_of(each);
    click_at(x);
  }
  void click_back() { click_at(left()); }
  [[nodiscard]] const Look& look() const { return offscreen_->stage().look(); }
  [[nodiscard]] float left() const { return look().px.tools + look().px.m + look().px(12); }
  [[nodiscard]] float width_of(const char* button) const {
    return text_width(look().fonts.ui, button) + look().px(24) + look().px.s;
  }
  void click_at(float x) { click({x, shell_->panels().canvas.min.y - look().px(20)}); }
  [[nodiscard]] const LessonPlayer& player() const { return shell_->lesson().player(); }
};

TEST_F(LessonTest, GoesOnAsTheLearnerDoesWhatItAsksFor) {
  begin();
  EXPECT_EQ(session_->scenario().name, "First steps");
  EXPECT_FALSE(player().done());
  press(key::kHome);
  EXPECT_TRUE(player().done());
  click_behind({});
  EXPECT_EQ(player().number(), 1u);
  EXPECT_EQ(shell_->view().view.pinned, player().step().cell) << "the step's cell is pinned";
  press(key::kRight);
  EXPECT_TRUE(player().done());
  click_back();
  EXPECT_EQ(player().number(), 0u);
}

TEST_F(LessonTest, IsDoneForTheLearner) {
  begin();
  click_behind({"Skip"});
  EXPECT_TRUE(player().done()) << "it was done";
  EXPECT_EQ(session_->run().timeline().cursor(), 0u);
  click_behind({});
  EXPECT_EQ(player().number(), 1u);
}

TEST_F(LessonTest, WhatIsSkippedIsDoneSoThatLaterStepsCanBe) {
  begin();
  const std::size_t steps = player().lesson().steps.size();
  click_behind({});
  EXPECT_EQ(player().number(), 1u);
  EXPECT_EQ(session_->run().timeline().cursor(), 0u) << "it was done";
  for (std::size_t step = 1; step + 1 < steps; ++step) {
    click_behind({});
    session_->settle();
    frames(4);
    ASSERT_EQ(player().number(), step + 1) << player().step().title;
  }
  EXPECT_EQ(session_->run().decisions().back().figures.replans, 1) << "the wall was painted";
}

TEST_F(LessonTest, EachStepBeginsWithTheSelectTool) {
  shell_->perform_next(ActionId::tool_fill);
  frames(2);
  begin();
  EXPECT_EQ(shell_->view().tools.chosen_id(), "select");
  shell_->perform_next(ActionId::tool_fill);
  frames(2);
  click_behind({});
  EXPECT_EQ(player().number(), 1u);
  EXPECT_EQ(shell_->view().tools.chosen_id(), "select");
}

TEST_F(LessonTest, TheFirstStepPinsItsCellInAWorldOfAnotherSize) {
  press('P', true);
  type("lesson km");
  press(key::kEnter);
  session_->settle();
  frames(4);
  ASSERT_EQ(player().lesson().id, "km");
  ASSERT_TRUE(player().step().cell);
  EXPECT_EQ(shell_->view().view.pinned, player().step().cell);
}

TEST_F(LessonTest, TheWorldStaysWhereItIsFromStepToStep) {
  begin();
  const float top = shell_->panels().canvas.min.y;
  for (std::size_t step = 0; step + 1 < player().lesson().steps.size(); ++step) {
    EXPECT_EQ(shell_->panels().canvas.min.y, top) << player().step().title;
    click_behind({"Skip"});
    session_->settle();
    frames(4);
    EXPECT_TRUE(player().done()) << player().step().title;
    EXPECT_EQ(shell_->panels().canvas.min.y, top) << "done: " << player().step().title;
    click_behind({});
  }
}

TEST_F(LessonTest, BackLeadsToTheMomentAtWhichTheStepBegan) {
  begin();
  click_back();  // nowhere
  EXPECT_EQ(player().number(), 0u);
  std::vector<std::size_t> began;
  for (std::size_t step = 0; step < 3; ++step) {
    began.push_back(session_->run().timeline().cursor());
    click_behind({});  // Skip: does it and goes on
    session_->settle();
    frames(4);
    ASSERT_EQ(player().number(), step + 1);
  }
  ASSERT_NE(began[1], began[2]);
  for (std::size_t step = 3; step-- > 1;) {
    click_back();
    frames(2);
    EXPECT_EQ(player().number(), step);
    EXPECT_EQ(session_->run().timeline().cursor(), began[step]);
  }
}

TEST_F(LessonTest, NobodyIsAskedAboutTheWorldOfALesson) {
  begin();
  ASSERT_TRUE(session_->apply(PaintCells{{{{0, 0}, true}}}).ok());
  frames(2);
  EXPECT_TRUE(session_->modified());
  shell_->perform_next(ActionId::first_steps);
  frames(2);
  session_->settle();
  frames(3);
  EXPECT_FALSE(session_->modified()) << "it begins again";
  ASSERT_TRUE(session_->apply(PaintCells{{{{0, 0}, true}}}).ok());
  frames(2);
  EXPECT_TRUE(shell_->documents().may_close(*session_));
}

TEST_F(LessonTest, WhatIsEditedAfterALessonIsAskedAbout) {
  begin();
  ASSERT_TRUE(session_->apply(PaintCells{{{{0, 0}, true}}}).ok());
  frames(2);
  const Look& look = offscreen_->stage().look();
  click({shell_->panels().canvas.max.x - look.px(24), look.px.menu + look.px(18)});
  ASSERT_FALSE(shell_->lesson().open());
  EXPECT_TRUE(shell_->documents().may_close(*session_)) << "nothing was done since";
  ASSERT_TRUE(session_->apply(PaintCells{{{{1, 0}, true}}}).ok());
  frames(2);
  EXPECT_FALSE(shell_->documents().may_close(*session_));
}

TEST_F(LessonTest, ClosesWithItsWorld) {
  begin();
  ASSERT_TRUE(session_->apply(PaintCells{{{{0, 0}, true}}}).ok());
  frames(2);
  EXPECT_TRUE(shell_->lesson().open()) << "an edit of its world is its own matter";
  shell_->documents().replace(*session_, {*read_scenario(path_), path_});
  frames(2);
  EXPECT_FALSE(shell_->lesson().open()) << "another world is none of its own";
}

TEST_F(LessonTest, UnsavedWorkIsAskedAboutFirst) {
  ASSERT_TRUE(session_->apply(PaintCells{{{{5, 0}, true}}}).ok());
  frames(2);
  shell_->perform_next(ActionId::first_steps);
  frames(3);
  EXPECT_FALSE(shell_->lesson().open());
  press(key::kEscape);
  EXPECT_FALSE(shell_->lesson().open());
  EXPECT_EQ(session_->scenario().name, "Room");
}

TEST_F(LessonTest, ActionsThatLessonsNameAreThere) {
  for (const LessonFile& file : lesson_files()) {
    const Result<Lesson> lesson = read_lesson(file);
    ASSERT_TRUE(lesson.ok()) << lesson.error();
    for (const LessonStep& step : lesson->steps) {
      for (const Deed& deed : step.deeds)
        if (const auto* act = std::get_if<ActionDeed>(&deed)) {
          EXPECT_NE(find_action(act->action), nullptr) << file.path << ": " << act->action;
        }
      for (const std::string& name : step.given)
        if (std::islower(static_cast<unsigned char>(name.front())) != 0) {
          EXPECT_NE(find_action(name), nullptr) << file.path << ": " << name;
        }
    }
  }
}

TEST_F(LessonTest, APaletteEntryOpensALesson) {
  press('P', true);
  type("lesson first");
  press(key::kEnter);
  session_->settle();
  frames(3);
  EXPECT_TRUE(shell_->lesson().open());
}

TEST_F(LessonTest, AWordOpensTheGlossaryThere) {
  press('P', true);
  type("meaning of rhs");
  press(key::kEnter);
  EXPECT_EQ(shell_->view().tab, "words");
  EXPECT_EQ(shell_->panels().tabs.get<WordsTab>().lit(), "rhs");
  frames(600);
  EXPECT_EQ(shell_->view().tab, "words") << "it stays open";
}

}  // namespace
}  // namespace replan::ui::lesson_test
