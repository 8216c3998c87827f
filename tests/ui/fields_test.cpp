// Fields keep what was typed into them, however they are left, and nothing that is typed goes elsewhere.
#include <gtest/gtest.h>

#include "tests/ui/shell_fixture.hpp"
#include "ui/tabs/debug.hpp"

namespace replan::ui::fields_test {
namespace {

constexpr const char* kWorld = R"({"replan": 1, "name": "Room",
    "map": {"rows": ["..........", "..........", "..........", "..........", ".........."]}, "start": [0, 0], "goal": [9, 1],
    "planners": [{"id": "dld-star-lite"}]})";

class FieldsTest : public ShellTest {
 protected:
  void SetUp() override { open("room.json", kWorld, 1280, 900); }
  [[nodiscard]] bool typing() const { return offscreen_->stage().io().WantTextInput; }
  [[nodiscard]] bool is_dialog_open() {
    bool open = false;
    offscreen_->frame([&] {
      session_->update(0);
      shell_->draw(offscreen_->stage().look(), *session_, 0);
      open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    });
    return open;
  }
  /// Clicks down a column until a field has the keyboard; where that was.
  ImVec2 click_a_field(float x, float from, float to) {
    for (float y = from; y < to; y += 4) {
      click({x, y});
      if (typing()) return {x, y};
    }
    ADD_FAILURE() << "there is no field";
    return {};
  }
};

TEST_F(FieldsTest, TabGoesFromNumberToNumberAndEnterEndsOne) {
  press('G', true);
  ASSERT_TRUE(is_dialog_open());
  for (int i = 0; i < 12 && !typing(); ++i)
    press(key::kTab);  // over the choice of the generator to the width
  ASSERT_TRUE(typing());
  type("61");
  press(key::kTab);
  ASSERT_TRUE(typing()) << "Tab does not go on to the height";
  type("41");
  press(key::kEnter);
  ASSERT_TRUE(is_dialog_open()) << "Enter in a number pressed the button";
  EXPECT_FALSE(typing());
  press(key::kEnter);
  ASSERT_FALSE(is_dialog_open());
  session_->settle();
  EXPECT_EQ(session_->scenario().map.width, 61);
  EXPECT_EQ(session_->scenario().map.height, 41);
}

TEST_F(FieldsTest, AClickElsewhereKeepsANumber) {
  press('G', true);
  const ImVec2 middle(640, 450);
  const ImVec2 field = click_a_field(middle.x - 48, middle.y - 160, middle.y + 100);
  type("23");
  click({field.x + 200, field.y});  // the picture
  EXPECT_FALSE(typing());
  press(key::kEnter);
  session_->settle();
  EXPECT_EQ(session_->scenario().map.width, 23);
}

TEST_F(FieldsTest, EscapeTakesANumberBackAndLeavesTheDialog) {
  press('G', true);
  click_a_field(592, 290, 550);
  type("23");
  press(key::kEscape);
  ASSERT_TRUE(is_dialog_open());
  press(key::kEnter);
  session_->settle();
  EXPECT_EQ(session_->scenario().map.width, 10);
}

TEST_F(FieldsTest, ASettingThatIsTypedIsSetWhenItIsLeft) {
  press(key::kF1 + 1);  // the Planner tab
  const PixelArea canvas = shell_->panels().canvas;
  const std::size_t before = session_->history().size();
  click_a_field(1280 - 28, 200, 700);
  type("3");
  EXPECT_EQ(session_->history().size(), before) << "each key was an edit";
  click({(canvas.min.x + canvas.max.x) / 2, canvas.max.y - 4});
  EXPECT_EQ(session_->history().size(), before + 1);
}

TEST_F(FieldsTest, AListOfChoicesIsGoneThroughWithTheArrows) {
  std::vector<std::string> made;
  while (made.size() < 2) {
    press('G', true);
    press(key::kTab);
    press(key::kEnter);  // opens the list
    press(key::kUp);
    press(key::kEnter);
    ASSERT_TRUE(is_dialog_open()) << "Enter in the list pressed the dialog's button";
    click({640, 100});  // nowhere
    press(key::kEnter);
    ASSERT_FALSE(is_dialog_open());
    session_->settle();
    made.push_back(session_->undo_text());
  }
  EXPECT_NE(made[0], made[1]);
  EXPECT_EQ(made[0].find("maze"), std::string::npos) << made[0] << ": what is chosen at first";
}

TEST_F(FieldsTest, AMenuIsGoneThroughWithTheArrows) {
  const PixelArea canvas = shell_->panels().canvas;
  click({(canvas.min.x + canvas.max.x) / 2, (canvas.min.y + canvas.max.y) / 2}, 1);
  ASSERT_TRUE(shell_->view().menu);
  const Cell cell = *shell_->view().menu;
  EXPECT_NE(shell_->view().view.pinned, cell);
  press(key::kDown);
  press(key::kEnter);
  EXPECT_EQ(shell_->view().view.pinned, cell);
  EXPECT_FALSE(shell_->view().menu);
}

TEST_F(FieldsTest, WhatIsTypedIsNotScoldedBeforeItIsRefusedAndEscapeKeepsIt) {
  press(key::kF1 + 6);
  std::string& draft = shell_->panels().tabs.get<DebugTab>().breakpoint;
  for (float y = 120; y < 420 && !typing(); y += 6) click({1000, y});
  ASSERT_TRUE(typing());
  type("g(3,3) >");
  press(key::kEscape);
  EXPECT_FALSE(typing());
  EXPECT_NE(draft.find("g(3,3) >"), std::string::npos) << draft;
}

TEST_F(FieldsTest, AKeyThatCanDoNothingSaysWhy) {
  press('Z', true);
  EXPECT_EQ(shell_->told(), "Undo: no edit was made.");
}

TEST_F(FieldsTest, ARefusedBreakpointKeepsTheKeyboard) {
  press(key::kF1 + 6);
  std::string& draft = shell_->panels().tabs.get<DebugTab>().breakpoint;
  for (float y = 120; y < 420 && !typing(); y += 6) click({1000, y});
  ASSERT_TRUE(typing());
  type("g(3,3) > ");
  press(key::kEnter);
  EXPECT_TRUE(session_->breakpoints().list().empty());
  EXPECT_TRUE(typing()) << "the next keys go to the canvas";
  type("size(U) > 100");  // takes the place of what was refused
  EXPECT_EQ(draft, "size(U) > 100");
  EXPECT_EQ(shell_->view().tools.chosen_id(), "select");
  press(key::kEnter);
  ASSERT_EQ(session_->breakpoints().list().size(), 1u);
  EXPECT_EQ(session_->breakpoints().list()[0].condition, "size(U) > 100");
  EXPECT_TRUE(typing());
  type("E");
  EXPECT_EQ(draft, "E");
  EXPECT_EQ(shell_->view().tools.chosen_id(), "select");
}

}  // namespace
}  // namespace replan::ui::fields_test
