// The panes of the window: how they share its area, and what a click on one does.
#include <gtest/gtest.h>

#include "tests/ui/shell_fixture.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/canvas/pane_grid.hpp"
#include "ui/shell/frame.hpp"

namespace replan::ui::panes_test {
namespace {

constexpr const char* kWorld = R"({"replan": 1, "name": "Room",
    "map": {"rows": ["..........", "..........", "..........", "..........", ".........."]}, "start": [0, 0], "goal": [9, 1],
    "planners": [{"id": "dstar-lite"}, {"id": "dld-star-lite"}, {"id": "astar"}, {"id": "dijkstra"}]})";

class PanesTest : public ShellTest {
 protected:
  void SetUp() override { open("room.json", kWorld, 1440, 900); }
  PaneGrid grid(std::size_t count) {
    // The legend lies under all panes.
    const Look& look = offscreen_->stage().look();
    const PixelArea& area = shell_->panels().canvas;
    return {look, count, area.min, {area.max.x, area.max.y - Legend::height(look)}};
  }
};

TEST_F(PanesTest, FourMakeASquareThatFillsTheArea) {
  const PaneGrid four = grid(4);
  EXPECT_EQ(four.min(0).y, four.min(1).y);
  EXPECT_EQ(four.min(0).x, four.min(2).x);
  EXPECT_GT(four.min(1).x, four.max(0).x);
  EXPECT_GT(four.min(2).y, four.max(0).y);
  EXPECT_EQ(four.max(3).x, shell_->panels().canvas.max.x);
  EXPECT_LT(four.max(3).y, shell_->panels().canvas.max.y) << "the legend has no room";
}

TEST_F(PanesTest, ThereAreAsManyAsThereIsRoomFor) {
  const Look& look = offscreen_->stage().look();
  EXPECT_EQ(PaneGrid::room(look, {0, 0}, {1100, 700}), 4u);
  EXPECT_EQ(PaneGrid::room(look, {0, 0}, {1100, 300}), 3u);
  EXPECT_EQ(PaneGrid::room(look, {0, 0}, {500, 700}), 1u);
  EXPECT_EQ(PaneGrid::room(look, {0, 0}, {10, 10}), 1u);
}

TEST_F(PanesTest, AClickOnATitleMakesItsPaneLeadAndASecondOneOffersPlanners) {
  const ImVec2 title(grid(4).min(3).x + 40, grid(4).min(3).y + 24);
  click(title);
  EXPECT_EQ(session_->lead(), 3u);
  EXPECT_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  click(title);
  EXPECT_TRUE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  click({title.x, title.y + 40});  // the first of the list
  EXPECT_EQ(session_->run().choice().id, planners().front().id);
  EXPECT_EQ(session_->scenario().map, GridMap(10, 5)) << "the tool has not drawn through the title";
}

TEST_F(PanesTest, SelectingInAPaneMakesItLead) {
  choose_tool(shell_->view(), "select");
  const ImVec2 low = grid(4).min(1), high = grid(4).max(1);
  click({(low.x + high.x) / 2, (low.y + high.y) / 2});
  EXPECT_EQ(session_->lead(), 1u);
  EXPECT_TRUE(shell_->view().view.pinned.has_value());
}

/// One that brings its robot: the others keep the world's, and its page is followed by that of what plans for it.
TEST_F(PanesTest, APilotDrivesBesidePlannersAndShowsTheCodeOfItsOwn) {
  const auto choose = [this](const Command& command) {
    ASSERT_TRUE(session_->apply(command).ok());
    session_->settle();
    frames(3);
  };
  choose(ChoosePlanner{1, "fusion"});
  choose(ChoosePlanner{2, "dwa"});
  choose(RunToEnd{});
  EXPECT_FALSE(session_->runs()[0]->decisions().back().drive.begun);
  for (const std::size_t pane : {1u, 2u}) {
    const Decision& end = session_->runs()[pane]->decisions().back();
    EXPECT_TRUE(end.drive.begun) << pane;
    EXPECT_EQ(end.state, MissionState::arrived) << pane;
  }
  PanelState& panels = shell_->panels();
  const auto titles = [&](std::size_t pane) {
    const Result<PlannerPage>& page = page_of(panels, *session_->runs()[pane]);
    EXPECT_TRUE(page.ok());
    std::vector<std::string> all = {page->title};
    for (const PseudoBlock& block : page->code) all.push_back(block.title);
    return all;
  };
  EXPECT_EQ(titles(1), (std::vector<std::string>{"Fusion", "Fusion", "Mission", "Plan"}));
  EXPECT_EQ(titles(2), (std::vector<std::string>{"DWA", "Mission", "Plan", "Window"}));
  const std::string before = page_name(*session_->runs()[1]);
  choose(SetParameter{1, "global", 0});
  EXPECT_NE(page_name(*session_->runs()[1]), before) << "another planner's code follows";
}

}  // namespace
}  // namespace replan::ui::panes_test
