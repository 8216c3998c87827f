// The dialogs for the world as a whole: what they ask for, and that the session takes it.
#include "ui/shell/dialogs/world_dialogs.hpp"

#include <gtest/gtest.h>

#include "app/platform/offscreen.hpp"
#include "ui/keys.hpp"

namespace replan::ui::world_dialogs_test {
namespace {

class WorldDialogsTest : public testing::Test {
 protected:
  void SetUp() override {
    Scenario scenario;
    scenario.map = GridMap(31, 21);
    scenario.start = {2, 5};
    scenario.goal = {17, 5};
    scenario.planners = {{"dstar-lite", {}}};
    session_ = std::make_unique<Session>(scenario);
    session_->settle();
    auto offscreen = app::Offscreen::create({1000, 700, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    offscreen_ = std::move(*offscreen);
    frame();
  }
  void frame() {
    offscreen_->frame([this] { dialogs_.draw(offscreen_->stage().look(), *session_, commands_); });
  }
  void press(int key) {
    for (const bool down : {true, false}) {
      offscreen_->stage().input().key(key, down);
      frame();
    }
  }

  std::unique_ptr<Session> session_;
  std::unique_ptr<app::Offscreen> offscreen_;
  WorldDialogs dialogs_;
  std::vector<Command> commands_;
};

TEST_F(WorldDialogsTest, EnterCreatesTheWorldThatIsShown) {
  dialogs_.show_generate(*session_, {});
  frame();
  frame();
  ASSERT_TRUE(dialogs_.open());
  press(key::kEnter);
  EXPECT_FALSE(dialogs_.open());
  ASSERT_EQ(commands_.size(), 1u);
  const auto* wanted = std::get_if<GenerateWorld>(&commands_.front());
  ASSERT_NE(wanted, nullptr);
  EXPECT_EQ(wanted->width, 31);
  EXPECT_EQ(wanted->height, 21);
  ASSERT_TRUE(session_->apply(commands_.front()).ok());
  EXPECT_EQ(session_->undo_text(), "generate maze of 31 x 21, seed 1");
}

TEST_F(WorldDialogsTest, EscapeChangesNothing) {
  dialogs_.show_generate(*session_, {});
  frame();
  frame();
  press(key::kEscape);
  EXPECT_FALSE(dialogs_.open());
  dialogs_.show_resize(*session_, {});
  frame();
  frame();
  press(key::kEscape);
  EXPECT_FALSE(dialogs_.open());
  EXPECT_TRUE(commands_.empty());
}

TEST_F(WorldDialogsTest, ASizeLeftAsItIsIsNoEdit) {
  dialogs_.show_resize(*session_, {});
  frame();
  frame();
  press(key::kEnter);
  ASSERT_EQ(commands_.size(), 1u);
  ASSERT_NE(std::get_if<ResizeWorld>(&commands_.front()), nullptr);
  ASSERT_TRUE(session_->apply(commands_.front()).ok());
  EXPECT_TRUE(session_->history().empty());
}

TEST_F(WorldDialogsTest, AWorldOfLayersKeepsThemAndIsGeneratedInSpace) {
  Scenario scenario;
  scenario.map = GridMap(20, 16, 8);
  scenario.goal = {19, 15, 7};
  scenario.planners = {{"dstar-lite", {}, {}}};
  session_ = std::make_unique<Session>(scenario);
  session_->settle();
  dialogs_.show_resize(*session_, {});
  frame();
  frame();
  press(key::kEnter);
  ASSERT_EQ(commands_.size(), 1u);
  EXPECT_EQ(std::get<ResizeWorld>(commands_.front()).size.depth, 8);
  ASSERT_TRUE(session_->apply(commands_.front()).ok());
  EXPECT_TRUE(session_->history().empty());
  commands_.clear();
  dialogs_.show_generate(*session_, {});
  frame();
  frame();
  press(key::kEnter);
  ASSERT_EQ(commands_.size(), 1u);
  EXPECT_EQ(std::get<GenerateWorld>(commands_.front()).layers, 8);
  ASSERT_TRUE(session_->apply(commands_.front()).ok());
  EXPECT_EQ(session_->undo_text(), "generate boxes of 20 x 16 x 8, seed 1");
}

}  // namespace
}  // namespace replan::ui::world_dialogs_test
