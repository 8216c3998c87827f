// The hand on the canvas: scripted mouse input on frames without a display, and the commands that come of it.
#include "tests/ui/canvas_fixture.hpp"

namespace replan::ui::canvas_test {
namespace {

TEST_F(CanvasTest, AStrokeHasNoGapsAndOneNumber) {
  drag({5, 2}, {12, 2});
  std::uint64_t stroke = 0;
  const auto cells = cells_of<PaintCells>(&stroke);
  ASSERT_EQ(cells.size(), 8u);
  for (const CellChange& change : cells) EXPECT_TRUE(change.blocked && change.cell.y == 2);
  EXPECT_NE(stroke, 0u);
}

TEST_F(CanvasTest, TheFirstCellDecidesAndTheRightButtonErases) {
  ASSERT_TRUE(session_->apply(PaintCells{{{{6, 2}, true}, {{7, 2}, true}}, 0}).ok());
  session_->settle();
  drag({6, 2}, {8, 2});
  const auto erased = cells_of<PaintCells>();
  ASSERT_EQ(erased.size(), 2u);
  EXPECT_FALSE(erased[0].blocked);
  commands_.clear();
  drag({7, 2}, {7, 3}, 1);
  ASSERT_EQ(cells_of<PaintCells>().size(), 1u);
  EXPECT_FALSE(cells_of<PaintCells>()[0].blocked);
}

TEST_F(CanvasTest, ABroadBrushPaintsASquareAndSparesTheStart) {
  state_.brush = 3;
  drag({4, 5}, {3, 5});
  EXPECT_TRUE(cells_of<PaintCells>().size() == 11u);  // 3 x 4 but for the start at (2, 5)
}

TEST_F(CanvasTest, AGrabbedStartMovesWithAnyTool) {
  drag({2, 5}, {4, 6});
  ASSERT_FALSE(commands_.empty());
  const auto* set = std::get_if<SetStart>(&commands_.back());
  ASSERT_NE(set, nullptr);
  EXPECT_EQ(set->cell, (Cell{4, 6}));
  EXPECT_TRUE(cells_of<PaintCells>().empty());
}

TEST_F(CanvasTest, ARectangleOrASelectionMayBeginBesideTheWorld) {
  choose_tool(state_, "rectangle");
  drag({3, -2}, {5, 1});
  const std::vector<CellChange> cells = cells_of<PaintCells>();
  EXPECT_EQ(cells.size(), 6u) << "what of it lies in the world: 3 x 2";
  EXPECT_TRUE(std::all_of(cells.begin(), cells.end(), [](const CellChange& each) { return each.blocked; }));
  commands_.clear();
  drag({3, -2}, {9, -1});
  move_to({4, -2});
  button(0, true);
  button(0, false);
  EXPECT_TRUE(cells_of<PaintCells>().empty()) << "none of it lies in the world";
  choose_tool(state_, "select");
  drag({18, 11}, {20, 8});
  ASSERT_TRUE(state_.editing.region);
  EXPECT_EQ(state_.editing.region->low, (Cell{18, 8}));
  EXPECT_EQ(state_.editing.region->high, (Cell{19, 9}));
  move_to({4, -2});
  button(0, true);
  button(0, false);
  EXPECT_FALSE(state_.view.pinned) << "a click beside the world is a click on no cell";
}

TEST_F(CanvasTest, RectangleAndSurpriseComeWhenLetGo) {
  choose_tool(state_, "rectangle");
  drag({5, 1}, {7, 2});
  EXPECT_EQ(cells_of<PaintCells>().size(), 6u);
  commands_.clear();
  choose_tool(state_, "surprise");
  drag({12, 8}, {10, 7});
  EXPECT_EQ(cells_of<DropSurprise>().size(), 6u);
  EXPECT_EQ(commands_.size(), 1u);
}

TEST_F(CanvasTest, AClickPinsAndAnotherUnpins) {
  choose_tool(state_, "select");
  drag({9, 3}, {9, 3});
  EXPECT_EQ(state_.view.pinned, (Cell{9, 3}));
  EXPECT_EQ(state_.view.hovered, (Cell{9, 3}));
  drag({9, 3}, {9, 3});
  EXPECT_FALSE(state_.view.pinned.has_value());
  EXPECT_TRUE(commands_.empty());
}

TEST_F(CanvasTest, TheWheelZoomsToTheCursor) {
  move_to({15, 8});
  input().wheel(0, 3);
  for (int i = 0; i < 60 || canvas_->animating(); ++i) {
    ASSERT_LT(i, 300);
    frame();
  }
  EXPECT_NEAR(state_.view.camera.zoom, 29 * 1.25 * 1.25 * 1.25, 1e-6);
  EXPECT_EQ(state_.view.hovered, (Cell{15, 8}));
  canvas_->fit();
  frame();
  EXPECT_EQ(state_.view.camera.zoom, 0);
}

TEST_F(CanvasTest, TheMiddleButtonMovesTheView) {
  drag({10, 5}, {12, 5}, 2);
  EXPECT_NEAR(state_.view.camera.x, 10 - 2, 0.1);
  EXPECT_TRUE(commands_.empty());
}

}  // namespace
}  // namespace replan::ui::canvas_test
