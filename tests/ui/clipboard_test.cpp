// Cells through the clipboard as text, and what is deleted.
#include <gtest/gtest.h>
#include <imgui.h>

#include "core/base/random.hpp"
#include "ui/shell/actions.hpp"

namespace replan::ui::clipboard_test {
namespace {

class ClipboardTest : public testing::Test {
 protected:
  ClipboardTest() : context_(ImGui::CreateContext()) {
    // ImGui's own clipboard needs no window; a desktop's would be shared with the user.
    static std::string held;
    ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { held = text; };
    ImGui::GetIO().GetClipboardTextFn = [](void*) { return held.c_str(); };
    ImGui::GetIO().IniFilename = nullptr;
  }
  ~ClipboardTest() override { ImGui::DestroyContext(context_); }

  void SetUp() override {
    Scenario scenario;
    scenario.map = GridMap(8, 4);
    for (int y = 0; y < 3; ++y) scenario.map.set({4, y}, true);
    scenario.start = {1, 1};
    scenario.goal = {6, 1};
    scenario.planners = {{"dstar-lite", {}}};
    session_ = std::make_unique<Session>(scenario);
    session_->settle();
  }
  void perform(ActionId id) {
    ActionContext context{*session_, view_, panels_, commands_, wish_};
    ASSERT_TRUE(action(id).available(context)) << action(id).name;
    action(id).effect(context);
    for (const Command& command : commands_) ASSERT_TRUE(session_->apply(command).ok());
    commands_.clear();
    session_->settle();
  }
  static std::string clipboard() { return ImGui::GetClipboardText(); }

  ImGuiContext* context_;
  std::unique_ptr<Session> session_;
  ViewState view_;
  PanelState panels_;
  std::vector<Command> commands_;
  Wish wish_ = Wish::none;
};

TEST_F(ClipboardTest, TheWorldGoesOutAndComesBack) {
  perform(ActionId::copy_world);
  EXPECT_EQ(clipboard(), "....@...\n.S..@.G.\n....@...\n........\n");
  const Scenario before = session_->scenario();
  perform(ActionId::clear_world);
  EXPECT_FALSE(session_->world().at({4, 0}));
  perform(ActionId::paste);  // of the same size and ends: cell by cell, so that the plan is repaired
  EXPECT_EQ(session_->world(), before.map);
  EXPECT_EQ(session_->scenario().surprises.size(), 2u);
  ImGui::SetClipboardText("S..\n..G\n");
  perform(ActionId::paste);
  EXPECT_EQ(session_->scenario().map.width, 3);
  EXPECT_EQ(session_->scenario().goal, (Cell{2, 1}));
  perform(ActionId::undo);
  EXPECT_EQ(session_->world(), before.map);
}

TEST_F(ClipboardTest, ARegionIsCutAndPastedWhereThePinIs) {
  ActionContext context{*session_, view_, panels_, commands_, wish_};
  EXPECT_FALSE(action(ActionId::copy).available(context));
  view_.editing.region = CellBox{{3, 0}, {5, 1}};
  perform(ActionId::copy);
  EXPECT_EQ(clipboard(), ".@.\n.@.\n");
  perform(ActionId::cut);
  EXPECT_FALSE(session_->world().at({4, 0}) || session_->world().at({4, 1}));
  EXPECT_TRUE(session_->world().at({4, 2}));
  view_.editing.region.reset();
  view_.view.pinned = Cell{0, 1};
  perform(ActionId::paste);
  EXPECT_TRUE(session_->world().at({1, 2}));
  EXPECT_FALSE(session_->world().at({1, 1})) << "the start stays free";
  EXPECT_EQ(view_.editing.region, (CellBox{{0, 1}, {2, 2}}));
}

TEST_F(ClipboardTest, WhatReachesOverTheEdgeIsLeftOut) {
  ImGui::SetClipboardText("@@@@\n@@@@\n");
  view_.view.hovered = Cell{6, 3};
  perform(ActionId::paste);
  EXPECT_TRUE(session_->world().at({6, 3}) && session_->world().at({7, 3}));
  EXPECT_NE(panels_.said.find("left out"), std::string::npos);
  EXPECT_EQ(session_->world().width, 8);
}

TEST_F(ClipboardTest, WhatIsNoMapIsRefusedInWords) {
  ImGui::SetClipboardText("..@\n.q.\n");
  perform(ActionId::paste);
  EXPECT_EQ(panels_.tone, Tone::bad);
  EXPECT_NE(panels_.said.find("clipboard"), std::string::npos) << panels_.said;
  ImGui::SetClipboardText("");
  perform(ActionId::paste);
  EXPECT_EQ(panels_.tone, Tone::bad);
  EXPECT_EQ(session_->history().size(), 0u);
}

TEST_F(ClipboardTest, DeleteTakesWhatIsSelected) {
  ASSERT_TRUE(session_->apply(AddMover{{.way = {{2, 3}, {6, 3}}}}).ok());
  view_.editing.mover = 0;
  perform(ActionId::delete_selected);
  EXPECT_TRUE(session_->scenario().movers.empty());
  EXPECT_FALSE(holds_something(view_));
  view_.editing.region = CellBox{{4, 0}, {4, 1}};
  perform(ActionId::delete_selected);
  EXPECT_FALSE(session_->world().at({4, 1}));
  EXPECT_TRUE(session_->world().at({4, 2}));
}

TEST_F(ClipboardTest, MatricesArePastedAndWhatPartsThemIsTold) {
  for (const char* text : {"S 0 0\n1 1 1\nG 0 0\n", "\xEF\xBB\xBF[[S, 0, 0], [1, 1, 1], [G, 0, 0]]"}) {
    ImGui::SetClipboardText(text);
    perform(ActionId::paste);
    EXPECT_EQ(session_->scenario().map.width, 3) << text;
    EXPECT_EQ(session_->scenario().goal, (Cell{0, 2}));
    EXPECT_TRUE(session_->world().at({2, 1}));
    EXPECT_NE(panels_.said.find("part the"), std::string::npos) << panels_.said;
    EXPECT_EQ(panels_.tone, Tone::done);
    perform(ActionId::undo);
  }
  ImGui::SetClipboardText("0 1 2\n");
  perform(ActionId::paste);
  EXPECT_EQ(panels_.tone, Tone::bad);
  EXPECT_NE(panels_.said.find("there are the numbers 0, 1 and 2"), std::string::npos) << panels_.said;
}

class ClipboardInSpaceTest : public ClipboardTest {
 protected:
  void SetUp() override {
    Scenario scenario;
    scenario.map = GridMap(7, 6, 5);
    Random random(3);
    for (NodeId node = 0; node < scenario.map.blocked.size(); ++node)
      if (random.chance(0.4)) scenario.map.blocked[node] = kObstacle;
    for (NodeId node = 0; node < 8; ++node)
      scenario.map.set(
          {static_cast<int>(node & 1), static_cast<int>(node >> 1 & 1), static_cast<int>(node >> 2)},
          (node & 3) == 0);
    scenario.start = {1, 1, 1};
    scenario.goal = {6, 5, 4};
    for (const Cell end : {scenario.start, scenario.goal}) scenario.map.set(end, false);
    scenario.planners = {{"dstar-lite", {}, {}}};
    session_ = std::make_unique<Session>(scenario);
    session_->settle();
  }
  /// Copies a box, pastes it where the pin is, and looks at every cell of the world; then takes it back.
  void expect_copied(const CellBox& from, Cell to) {
    const GridMap before = session_->world();
    view_.editing.region = from;
    perform(ActionId::copy);
    view_.editing.region.reset();
    view_.view.pinned = to;
    perform(ActionId::paste);
    const GridMap after = session_->world();
    const Scenario& scenario = session_->scenario();
    std::size_t changed = 0;
    for (NodeId node = 0; node < before.blocked.size(); ++node) {
      const Cell cell = before.box().position(node);
      const Cell source{cell.x - to.x + from.low.x, cell.y - to.y + from.low.y, cell.z - to.z + from.low.z};
      const bool pasted = cell.x >= to.x && cell.y >= to.y && cell.z >= to.z && source.x <= from.high.x &&
                          source.y <= from.high.y && source.z <= from.high.z;
      const bool kept = cell == scenario.start || cell == scenario.goal;
      ASSERT_EQ(after.at(cell), pasted && !kept ? before.at(source) : before.at(cell))
          << cell.x << ", " << cell.y << ", " << cell.z;
      changed += after.at(cell) != before.at(cell) ? 1 : 0;
    }
    EXPECT_GT(changed, 0u);
    perform(ActionId::undo);
    EXPECT_EQ(session_->world(), before);
    perform(ActionId::redo);
    EXPECT_EQ(session_->world(), after);
    perform(ActionId::undo);
  }
};

TEST_F(ClipboardInSpaceTest, ARegionOfSeveralLayersIsPastedAnywhere) {
  view_.editing.region = CellBox{{0, 0, 0}, {1, 1, 1}};
  perform(ActionId::copy);
  EXPECT_EQ(clipboard(), "@.\n..\n\n@.\n..\n");
  expect_copied({{0, 0, 0}, {2, 1, 2}}, {1, 3, 1});
  expect_copied({{0, 0, 0}, {2, 3, 4}}, {3, 1, 0});
  expect_copied({{1, 2, 1}, {3, 4, 3}}, {0, 0, 0});  // the start lies there and stays free
}

TEST_F(ClipboardInSpaceTest, ARegionAcrossAnyAxisIsABoxOfTheWorld) {
  expect_copied({{2, 0, 0}, {2, 4, 3}}, {4, 1, 1});  // as selected on a slice across x
  expect_copied({{0, 3, 1}, {4, 3, 3}}, {1, 1, 0});  // across y
  expect_copied({{0, 0, 2}, {3, 3, 2}}, {1, 2, 4});  // across z
}

TEST_F(ClipboardInSpaceTest, LayersOverTheTopAreLeftOut) {
  expect_copied({{0, 0, 0}, {1, 1, 3}}, {4, 1, 3});
  view_.view.pinned = Cell{4, 1, 3};
  perform(ActionId::paste);
  EXPECT_EQ(view_.editing.region, (CellBox{{4, 1, 3}, {5, 2, 4}}));
  EXPECT_NE(panels_.said.find("left out"), std::string::npos);
}

}  // namespace
}  // namespace replan::ui::clipboard_test
