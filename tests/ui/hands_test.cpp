// What lies over the world takes its own clicks, and the mouse asks the pane that it is over.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "tests/ui/shell_fixture.hpp"
#include "ui/canvas/chips.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/canvas/pane_grid.hpp"
#include "ui/tabs/open_list.hpp"

namespace replan::ui::hands_test {
namespace {

constexpr const char* kWorld = R"({"replan": 1, "name": "Room",
    "map": {"rows": ["....................", "....................", "....................", "....................",
                     "....................", "....................", "....................", "...................."]},
    "start": [1, 4], "goal": [18, 4], "planners": [{"id": "dstar-lite"}]})";

class HandsTest : public ShellTest {
 protected:
  void SetUp() override { open("room.json", kWorld, 1440, 900); }

  ImVec2 at(Cell cell, std::size_t pane = 0) {
    const ScreenArea area = pane_area(pane);
    const Camera camera = resolve(shell_->view().view.camera, 20, 8, viewport(pane));
    return {area.min.x + static_cast<float>((cell.x + 0.5 - camera.x) * camera.zoom) +
                (area.max.x - area.min.x) / 2,
            area.min.y + static_cast<float>((cell.y + 0.5 - camera.y) * camera.zoom) +
                (area.max.y - area.min.y) / 2};
  }
  ScreenArea pane_area(std::size_t pane) {
    const Look& look = offscreen_->stage().look();
    const std::size_t count = session_->runs().size();
    ImVec2 min = shell_->panels().canvas.min, max = shell_->panels().canvas.max;
    if (count > 1) max.y -= Legend::height(look);
    const PaneGrid grid(look, count, min, max);
    return {grid.min(pane), grid.max(pane)};
  }
  Viewport viewport(std::size_t pane) {
    const Look& look = offscreen_->stage().look();
    const ScreenArea area = pane_area(pane);
    return {static_cast<int>(area.max.x - area.min.x), static_cast<int>(area.max.y - area.min.y),
            static_cast<int>(pane_title_height(look)),
            session_->runs().size() > 1 ? 0 : static_cast<int>(Legend::height(look))};
  }
  /// The robot replans: a wall is painted in its way.
  void repair() {
    session_->settle();
    ASSERT_TRUE(session_->apply(PaintCells{{{{9, 4}, true}, {{9, 5}, true}}, 0}).ok());
    session_->settle();
    frames(3);
  }
  [[nodiscard]] bool popup() {
    bool open = false;
    offscreen_->frame([&] {
      shell_->draw(offscreen_->stage().look(), *session_, 0);
      open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    });
    return open;
  }
  /// Of a window that floats over the canvas; nothing if there is none.
  ImVec2 middle_of(std::string_view name) {
    ImVec2 middle;
    offscreen_->frame([&] {
      shell_->draw(offscreen_->stage().look(), *session_, 0);
      for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (window->Active && std::string_view(window->Name).starts_with(name))
          middle = {window->Pos.x + window->Size.x / 2, window->Pos.y + window->Size.y / 2};
    });
    return middle;
  }
  ImVec2 card() const {
    const PixelArea& canvas = shell_->panels().canvas;
    return {canvas.max.x - 60, canvas.min.y + 60};
  }
};

TEST_F(HandsTest, AClickOnTheLegendExplainsAKeyAndPaintsNothing) {
  choose_tool(shell_->view(), "paint");
  const PixelArea& canvas = shell_->panels().canvas;
  const float y = canvas.max.y - 24;
  for (float x = canvas.min.x + 20; x < canvas.min.x + 400; x += 20) {
    click({x, y});
    if (popup()) press(key::kEscape);
  }
  EXPECT_TRUE(session_->history().empty()) << session_->undo_text();
  click({canvas.min.x + 80, y});
  EXPECT_TRUE(popup()) << "the key says nothing";
}

TEST_F(HandsTest, EveryKeyOfTheLegendHasWords) {
  for (const LegendEntry& entry : all_signs(offscreen_->stage().look())) {
    const LegendWords words = legend_words(entry.label);
    EXPECT_FALSE(words.title.empty() || words.text.empty()) << entry.label;
  }
  for (const OverlayInfo& info : overlays()) {
    const bool told = !info.is_field() || !legend_words(info.label).text.empty();
    EXPECT_TRUE(told) << info.label;
  }
}

TEST_F(HandsTest, AClickOnTheCardOpensTheLastRepair) {
  repair();
  choose_tool(shell_->view(), "paint");
  const std::size_t before = session_->history().size();
  click(card());
  EXPECT_EQ(session_->history().size(), before);
  EXPECT_EQ(shell_->view().tab, "open_list");
}

TEST_F(HandsTest, ACardFoldsAfterAWhileAndIsOpenedByAClick) {
  repair();
  const ImVec2 foot(card().x, card().y + 40);  // on the whole card alone
  frames(60 * 6);
  choose_tool(shell_->view(), "select");
  click(foot);
  EXPECT_EQ(shell_->view().tab, "") << "it is still whole";
  click({card().x, shell_->panels().canvas.min.y + 24});  // the one line
  frames(2);
  click(foot);
  EXPECT_EQ(shell_->view().tab, "open_list");
}

TEST_F(HandsTest, AFittedWorldLiesBetweenTitleAndLegend) {
  for (const std::size_t panes : {1u, 2u, 4u}) {
    ASSERT_TRUE(session_->apply(SetPanes{panes}).ok());
    session_->settle();
    press('F');
    for (std::size_t pane = 0; pane < panes; ++pane) {
      const Look& look = offscreen_->stage().look();
      const ScreenArea area = pane_area(pane);
      const float half = static_cast<float>(shell_->panels().zoom / 2);
      EXPECT_GE(at({0, 0}, pane).y - half, area.min.y + pane_title_height(look)) << panes;
      const float low = panes == 1 ? Legend::height(look) : 0;
      EXPECT_LE(at({0, 7}, pane).y + half, area.max.y - low) << panes;
      EXPECT_GE(at({0, 0}, pane).x - half, area.min.x) << panes;
    }
  }
}

TEST_F(HandsTest, TheRightButtonAsksWithSelectAndErasesWithADrawingTool) {
  ASSERT_TRUE(session_->apply(PaintCells{{{{9, 4}, true}}, 0}).ok());
  session_->settle();
  const std::size_t before = session_->history().size();
  click(at({9, 4}), 1);
  EXPECT_EQ(session_->history().size(), before) << "a wall was erased";
  EXPECT_TRUE(popup());
  EXPECT_EQ(shell_->view().menu, (Cell{9, 4}));
  press(key::kEscape);
  choose_tool(shell_->view(), "paint");
  click(at({9, 4}), 1);
  EXPECT_FALSE(popup());
  EXPECT_EQ(session_->history().size(), before + 1);
}

TEST_F(HandsTest, TheFirstClickChangesNothing) {
  click(at({9, 6}));
  EXPECT_TRUE(session_->history().empty());
  EXPECT_EQ(shell_->view().view.pinned, (Cell{9, 6}));
}

TEST_F(HandsTest, TheCellStaysOnTheWayToItsNumbersAndIsThatOfItsPane) {
  ASSERT_TRUE(session_->apply(SetPanes{2}).ok());
  session_->settle();
  frames(2);
  InputQueue& input = offscreen_->stage().input();
  const ImVec2 over = at({6, 2}, 1);
  input.mouse_move(over.x, over.y);
  frames(2);
  input.mouse_move(1300, 500);  // the side panel
  frames(2);
  EXPECT_FALSE(shell_->view().view.hovered.has_value());
  ASSERT_TRUE(shell_->view().pointed.has_value());
  EXPECT_EQ(shell_->view().pointed->cell, (Cell{6, 2}));
  EXPECT_EQ(shell_->view().pointed->pane, 1u);
  std::vector<Command> commands;
  Wish wish = Wish::none;
  Frame frame{offscreen_->stage().look(), *session_, shell_->view(), shell_->panels(), commands, wish};
  EXPECT_EQ(frame.cell(), (Cell{6, 2}));
  EXPECT_EQ(frame.cell_pane(), 1u);
  EXPECT_EQ(session_->lead(), 0u);
}

TEST_F(HandsTest, SpaceAndADragPanAndDoNotPlay) {
  InputQueue& input = offscreen_->stage().input();
  const ImVec2 from = at({9, 4});
  input.mouse_move(from.x, from.y);
  input.key(key::kSpace, true);
  frames(3);
  EXPECT_EQ(session_->playback().direction, 0);
  const Camera before = shell_->view().view.camera;
  input.mouse_button(0, true);
  frames(2);
  input.mouse_move(from.x + 60, from.y + 20);
  frames(2);
  input.mouse_button(0, false);
  frames(2);
  input.key(key::kSpace, false);
  frames(3);
  EXPECT_EQ(session_->playback().direction, 0) << "it plays";
  EXPECT_NE(shell_->view().view.camera, before);
  press(key::kSpace);
  EXPECT_EQ(session_->playback().direction, 1);
}

TEST_F(HandsTest, PlayingPausesBehindADialogAndGoesOnAfterIt) {
  press(key::kSpace);
  ASSERT_EQ(session_->playback().direction, 1);
  press('N', true);
  EXPECT_EQ(session_->playback().direction, 0);
  press(key::kEscape);
  EXPECT_EQ(session_->playback().direction, 1);
  press('G', true);
  press(key::kEnter);  // another world
  EXPECT_EQ(session_->playback().direction, 0);
}

TEST_F(HandsTest, KeysZoomAndMoveTheView) {
  const double fitted = shell_->panels().zoom;
  press('=');
  frames(60);
  EXPECT_GT(shell_->panels().zoom, fitted * 1.1);
  const Camera before = shell_->view().view.camera;
  press(key::kRight, true);
  EXPECT_GT(shell_->view().view.camera.x, before.x);
  press(key::kUp, true);
  EXPECT_LT(shell_->view().view.camera.y, before.y);
  press('0', true);
  frames(60);
  EXPECT_NEAR(shell_->panels().zoom, fitted, 1e-9);
  press('-');
  frames(60);
  EXPECT_LT(shell_->panels().zoom, fitted);
}

TEST_F(HandsTest, TabReachesTheToolsAndSpacePressesOne) {
  for (int i = 0; i < 3; ++i) press(key::kTab);  // the search, Select, Paint
  press(key::kSpace);
  EXPECT_EQ(shell_->view().tools.chosen_id(), "paint");
  EXPECT_EQ(session_->playback().direction, 0) << "the key went to the world too";
  press(key::kTab, false, true);  // back
  press(key::kSpace);
  EXPECT_EQ(shell_->view().tools.chosen_id(), "select");
  press(key::kEscape);
  press(key::kSpace);
  EXPECT_EQ(session_->playback().direction, 1) << "Esc has not given the keys back";
}

TEST_F(HandsTest, EnterPressesTheButtonWithTheRingAndNotAnother) {
  ASSERT_TRUE(session_->apply(PaintCells{{{{5, 0}, true}}}).ok());
  ASSERT_TRUE(session_->modified());
  shell_->perform_next(ActionId::quit);
  frames(6);
  press(key::kTab);  // Discard, where Enter alone would save
  press(key::kEnter);
  EXPECT_TRUE(shell_->documents().quitting());
  EXPECT_TRUE(session_->modified()) << "it was saved";
}

TEST_F(HandsTest, QuittingAsksBeforeAFilmIsGivenUp) {
  shell_->panels().recording.made = 0.3;
  shell_->perform_next(ActionId::quit);
  frames(6);
  EXPECT_FALSE(shell_->documents().quitting());
  press(key::kEscape);
  EXPECT_FALSE(shell_->documents().quitting());
  EXPECT_FALSE(shell_->documents().may_close(*session_));
  frames(6);
  press(key::kTab);
  press(key::kEnter);
  EXPECT_TRUE(shell_->documents().quitting());
}

TEST_F(HandsTest, InASmallWindowTheLegendStaysOnItsPane) {
  TearDown();
  open("room.json", kWorld, 640, 480);
  frames(2);
  float right = 0;
  offscreen_->frame([&] {
    shell_->draw(offscreen_->stage().look(), *session_, 0);
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
      if (std::string_view(window->Name) == "legend") right = window->Pos.x + window->Size.x;
  });
  EXPECT_GT(right, 0);
  EXPECT_LE(right, shell_->panels().canvas.max.x);
}

TEST_F(HandsTest, WhyStandsBesideThePinnedCell) {
  click(at({9, 6}));
  ASSERT_TRUE(shell_->view().view.pinned.has_value());
  click(middle_of("question"));
  EXPECT_TRUE(shell_->panels().why_open);
  EXPECT_EQ(shell_->view().view.pinned, (Cell{9, 6})) << "the click went through to the world";
}

TEST_F(HandsTest, TheMinimapShowsWhileSomeOfTheWorldIsOutOfSightAndMovesTheView) {
  choose_tool(shell_->view(), "paint");
  frames(2);
  EXPECT_EQ(middle_of("minimap").x, 0) << "all is in sight";
  shell_->view().view.camera = {2, 2, 200};
  frames(2);
  const ImVec2 middle = middle_of("minimap");
  ASSERT_GT(middle.x, 0);
  click(middle);
  EXPECT_NEAR(shell_->view().view.camera.x, 10, 0.3);
  EXPECT_NEAR(shell_->view().view.camera.y, 4, 0.3);
  EXPECT_EQ(shell_->view().view.camera.zoom, 200);
  EXPECT_TRUE(session_->history().empty()) << "it was clicked through";
  shell_->view().captured = true;
  frames(2);
  EXPECT_EQ(middle_of("minimap").x, 0) << "in a picture";
  shell_->view().captured = false;
  shell_->view().minimap = false;
  frames(2);
  EXPECT_EQ(middle_of("minimap").x, 0) << "it is switched off";
}

TEST_F(HandsTest, TheAnswerIsClosedWhenItIsAboutAnotherCell) {
  click(at({9, 6}));
  click(middle_of("question"));
  ASSERT_TRUE(shell_->panels().why_open);
  frames(2);
  ASSERT_TRUE(session_->apply(Seek{3}).ok());
  frames(2);
  EXPECT_TRUE(shell_->panels().why_open) << "the same run at another moment";
  shell_->view().view.pinned = Cell{2, 2};
  frames(2);
  EXPECT_FALSE(shell_->panels().why_open);
}

}  // namespace
}  // namespace replan::ui::hands_test
