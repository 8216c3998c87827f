// The panes of the window: how they share its area, and what a click on one does.
#include <gtest/gtest.h>

#include "app/platform/offscreen.hpp"
#include "ui/pane_grid.hpp"
#include "ui/shell/shell.hpp"

namespace replan::ui {
namespace {

class PanesTest : public testing::Test {
 protected:
  void open(int width, int height) {
    Scenario scenario;
    scenario.map = GridMap(20, 10);
    scenario.start = {2, 5};
    scenario.goal = {17, 5};
    scenario.planners = {{"dstar-lite", {}}, {"dld-star-lite", {}}, {"astar", {}}, {"dijkstra", {}}};
    session_ = std::make_unique<Session>(scenario);
    session_->settle();
    auto offscreen = app::Offscreen::create({width, height, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    offscreen_ = std::move(*offscreen);
    offscreen_->frame([this] { shell_ = std::make_unique<Shell>(offscreen_->stage().renderer()); });
    frames(2);
  }
  void TearDown() override {
    if (offscreen_) offscreen_->frame([this] { shell_.reset(); });
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i)
      offscreen_->frame([this] {
        session_->update(0);
        shell_->draw(offscreen_->stage().look(), *session_, 0);
      });
  }
  void click(ImVec2 at) {
    InputQueue& input = offscreen_->stage().input();
    input.mouse_move(at.x, at.y);
    frames(2);
    input.mouse_button(0, true);
    frames(2);
    input.mouse_button(0, false);
    frames(2);
  }
  PaneGrid grid(std::size_t count) {
    const PixelArea& area = shell_->panels().canvas;
    return {offscreen_->stage().look(), count, area.min, area.max};
  }

  std::unique_ptr<Session> session_;
  std::unique_ptr<app::Offscreen> offscreen_;
  std::unique_ptr<Shell> shell_;
};

TEST_F(PanesTest, FourMakeASquareThatFillsTheArea) {
  open(1440, 900);
  const PaneGrid four = grid(4);
  EXPECT_EQ(four.min(0).y, four.min(1).y);
  EXPECT_EQ(four.min(0).x, four.min(2).x);
  EXPECT_GT(four.min(1).x, four.max(0).x);
  EXPECT_GT(four.min(2).y, four.max(0).y);
  EXPECT_EQ(four.max(3).x, shell_->panels().canvas.max.x);
  EXPECT_EQ(four.max(3).y, shell_->panels().canvas.max.y);
}

TEST_F(PanesTest, ThereAreAsManyAsThereIsRoomFor) {
  open(1440, 900);
  const Look& look = offscreen_->stage().look();
  EXPECT_EQ(PaneGrid::room(look, {0, 0}, {1100, 700}), 4u);
  EXPECT_EQ(PaneGrid::room(look, {0, 0}, {1100, 300}), 3u);
  EXPECT_EQ(PaneGrid::room(look, {0, 0}, {500, 700}), 1u);
  EXPECT_EQ(PaneGrid::room(look, {0, 0}, {10, 10}), 1u);
}

TEST_F(PanesTest, AClickOnATitleMakesItsPaneLeadAndASecondOneOffersPlanners) {
  open(1440, 900);
  const ImVec2 title(grid(4).min(3).x + 40, grid(4).min(3).y + 24);
  click(title);
  EXPECT_EQ(session_->lead(), 3u);
  EXPECT_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  click(title);
  EXPECT_TRUE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  click({title.x, title.y + 40});  // the first of the list
  EXPECT_EQ(session_->run().choice().id, planners().front().id);
  EXPECT_EQ(session_->scenario().map, GridMap(20, 10)) << "the tool has not drawn through the title";
}

TEST_F(PanesTest, SelectingInAPaneMakesItLead) {
  open(1440, 900);
  shell_->view().tool = Tool::select;
  const ImVec2 low = grid(4).min(1), high = grid(4).max(1);
  click({(low.x + high.x) / 2, (low.y + high.y) / 2});
  EXPECT_EQ(session_->lead(), 1u);
  EXPECT_TRUE(shell_->view().view.pinned.has_value());
}

}  // namespace
}  // namespace replan::ui
