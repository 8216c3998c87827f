// The legend on the canvas explains itself; tools show where a start or goal would stand.
#include "ui/canvas/legend.hpp"

#include <imgui_internal.h>

#include "tests/ui/canvas_fixture.hpp"

namespace replan::ui::legend_test {
namespace {

class LegendTest : public CanvasTest {
 protected:
  [[nodiscard]] bool tooltip_shows() {
    bool shows = false;
    offscreen_->frame([&] {
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({kCanvasWidth, kCanvasHeight});
      ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
      canvas_->draw(offscreen_->stage().look(), *session_, 0, state_, {0, 0}, {kCanvasWidth, kCanvasHeight},
                    true, commands_);
      ImGui::End();
      for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        shows = shows || ((window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->Active);
    });
    return shows;
  }
  bool tooltip_after_a_while(float x, float y) {
    input().mouse_move(x, y);
    bool shows = false;
    for (int i = 0; i < 90; ++i) shows = tooltip_shows();
    return shows;
  }
};

TEST_F(LegendTest, EverySignHasASentence) {
  for (const LegendEntry& entry : all_signs(offscreen_->stage().look())) {
    const std::string_view help = entry.help;
    EXPECT_GT(help.size(), 8u) << entry.label;
    EXPECT_TRUE(help.ends_with('.')) << entry.label;
  }
}

TEST_F(LegendTest, TheKeyOfTheNumbersExplainsThemWhileTheyShow) {
  const float x = 50, y = kCanvasHeight - 90;
  state_.view.camera = {10, 5, 12};
  EXPECT_FALSE(tooltip_after_a_while(x, y));
  state_.view.overlays.set(Overlay::numbers, true);
  state_.view.camera = {10, 5, 80};
  EXPECT_TRUE(tooltip_after_a_while(x, y));
}

TEST_F(LegendTest, StartAndGoalAreNotPutIntoWalls) {
  ASSERT_TRUE(session_->apply(PaintCells{{{{9, 3}, true}, {{10, 3}, true}}, 0}).ok());
  session_->settle();
  for (const char* tool : {"start", "goal"}) {
    choose_tool(state_, tool);
    commands_.clear();
    drag({9, 3}, {9, 3});
    EXPECT_TRUE(commands_.empty()) << tool << ": a wall is refused";
    drag({12, 3}, {12, 3});
    EXPECT_FALSE(commands_.empty()) << tool;
  }
  commands_.clear();
  drag({17, 5}, {10, 3});
  for (const Command& command : commands_)
    if (const auto* set = std::get_if<SetGoal>(&command)) {
      EXPECT_NE(set->cell, (Cell{10, 3}));
    }
}

}  // namespace
}  // namespace replan::ui::legend_test
