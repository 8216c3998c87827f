// The editing tools: what presses and drags come to, and what is selected by them.
#include <algorithm>

#include "tests/ui/canvas_fixture.hpp"
#include "ui/tools/measure.hpp"
#include "ui/tools/mover.hpp"
#include "ui/tools/surprise.hpp"

namespace replan::ui::tools_test {
namespace {

class ToolsTest : public CanvasTest {
 protected:
  void click(Cell cell, int which = 0) { drag(cell, cell, which); }
  /// Hands what the tools asked for to the session, as the window does after each frame.
  void apply_all() {
    for (const Command& command : commands_) EXPECT_TRUE(session_->apply(command).ok());
    commands_.clear();
    session_->settle();
    frame();
  }
  [[nodiscard]] const std::optional<Measure>& measure() const {
    return state_.tools.get<MeasureTool>().measure();
  }
  template <class C>
  const C* only() const {
    EXPECT_EQ(commands_.size(), 1u);
    return commands_.empty() ? nullptr : std::get_if<C>(&commands_.front());
  }
};

TEST_F(ToolsTest, ARoundBrushLeavesTheCornersOut) {
  state_.brush = 3;
  state_.editing.round = true;
  click({8, 2});
  EXPECT_EQ(cells_of<PaintCells>().size(), 5u);
}

TEST_F(ToolsTest, ALineComesWhenLetGo) {
  choose_tool(state_, "line");
  move_to({5, 1});
  button(0, true);
  move_to({12, 3});
  EXPECT_TRUE(commands_.empty());
  button(0, false);
  const auto cells = cells_of<PaintCells>();
  ASSERT_EQ(cells.size(), 8u);
  EXPECT_TRUE(std::all_of(cells.begin(), cells.end(), [](const CellChange& each) { return each.blocked; }));
  apply_all();
  drag({5, 1}, {12, 3}, 1);  // the right button takes it away
  EXPECT_EQ(cells_of<PaintCells>().size(), 8u);
  EXPECT_FALSE(cells_of<PaintCells>().front().blocked);
}

TEST_F(ToolsTest, AFillStopsAtObstaclesAndSparesWhatStandsThere) {
  choose_tool(state_, "line");
  drag({10, 0}, {10, 9});
  apply_all();
  choose_tool(state_, "fill");
  click({4, 8});
  EXPECT_EQ(cells_of<PaintCells>().size(), 99u);  // 10 x 10 but for the start
  commands_.clear();
  click({10, 4});  // on the wall: it is cleared
  const auto cleared = cells_of<PaintCells>();
  ASSERT_EQ(cleared.size(), 10u);
  EXPECT_FALSE(cleared.front().blocked);
  commands_.clear();
  click({4, 8}, 1);  // nothing to clear there
  EXPECT_TRUE(commands_.empty());
}

TEST_F(ToolsTest, TheStrokeSaysWhatItDoes) {
  ASSERT_TRUE(session_->apply(PaintCells{{{{6, 2}, true}}, 0}).ok());
  session_->settle();
  move_to({6, 2});
  button(0, true);
  EXPECT_EQ(state_.editing.stroke, StrokeKind::erases_wall);
  button(0, false);
  frame();
  EXPECT_EQ(state_.editing.stroke, StrokeKind::none);
  move_to({8, 2});
  button(1, true);
  EXPECT_EQ(state_.editing.stroke, StrokeKind::erases);
  button(1, false);
}

TEST_F(ToolsTest, AMeasureStaysAndChangesNothing) {
  choose_tool(state_, "measure");
  drag({5, 5}, {8, 1});
  ASSERT_TRUE(measure().has_value());
  EXPECT_EQ(*measure(), (Measure{{5, 5}, {8, 1}}));
  EXPECT_TRUE(commands_.empty());
  const MeasureFigures figures = measured(*measure());
  EXPECT_DOUBLE_EQ(figures.straight, 5);
  EXPECT_NEAR(figures.octile, 1 + 3 * 1.41421356, 1e-6);
  EXPECT_NEAR(figures.degrees, 53.13, 0.01);  // up and to the right
  EXPECT_EQ(measure_text(figures, 1), "5.00 cells · octile 5.24 · dx 3, dy -4 · 53.1°");
  EXPECT_EQ(measure_text(figures, 0.05), "5.00 cells · 0.25 m · octile 5.24 · dx 3, dy -4 · 53.1°");
  drag({2, 5}, {4, 5});  // on the start: measured, not moved
  EXPECT_TRUE(commands_.empty());
  click({9, 9});
  EXPECT_FALSE(measure().has_value());
}

TEST_F(ToolsTest, AWayIsDrawnCornerByCorner) {
  choose_tool(state_, "mover");
  state_.brush = 3;
  state_.tools.get<MoverTool>().next().speed = 5;
  state_.tools.get<MoverTool>().next().at_end = WayEnd::loop;
  click({5, 2});
  click({12, 2});
  click({12, 7});
  EXPECT_TRUE(commands_.empty());
  EXPECT_EQ(state_.tools.get<MoverTool>().way().size(), 3u);
  click({12, 7});  // the second click of a double click
  const auto* add = only<AddMover>();
  ASSERT_NE(add, nullptr);
  EXPECT_EQ(add->mover.way, (std::vector<Cell>{{4, 1}, {11, 1}, {11, 6}}));
  EXPECT_EQ(add->mover.width, 3);
  EXPECT_EQ(add->mover.speed, 5);
  EXPECT_EQ(add->mover.at_end, WayEnd::loop);
  apply_all();
  EXPECT_EQ(state_.editing.mover, 0u);
}

TEST_F(ToolsTest, TheRightButtonEndsAWayAndEscapeGivesItUp) {
  choose_tool(state_, "mover");
  click({5, 2});
  click({9, 2});
  click({15, 8}, 1);
  ASSERT_NE(only<AddMover>(), nullptr);
  EXPECT_EQ(only<AddMover>()->mover.way.size(), 2u);
  apply_all();
  state_.editing.mover.reset();
  click({15, 8});
  EXPECT_EQ(state_.tools.get<MoverTool>().way().size(), 1u);
  EXPECT_TRUE(let_go(state_));
  EXPECT_FALSE(holds_something(state_));
  EXPECT_TRUE(commands_.empty());
}

TEST_F(ToolsTest, AWayIsSelectedAndItsCornersAreDragged) {
  ASSERT_TRUE(session_->apply(AddMover{{.way = {{5, 2}, {12, 2}}}}).ok());
  session_->settle();
  choose_tool(state_, "mover");
  click({8, 2});
  EXPECT_EQ(state_.editing.mover, 0u);
  EXPECT_TRUE(commands_.empty());
  drag({12, 2}, {14, 8});
  ASSERT_FALSE(commands_.empty());
  const auto* change = std::get_if<ChangeMover>(&commands_.back());
  ASSERT_NE(change, nullptr);
  EXPECT_EQ(change->mover.way, (std::vector<Cell>{{5, 2}, {14, 8}}));
}

TEST_F(ToolsTest, ASurpriseCanWait) {
  choose_tool(state_, "surprise");
  state_.tools.get<SurpriseTool>().options().time = SurpriseTime::step;
  state_.tools.get<SurpriseTool>().options().step = 7;
  drag({10, 7}, {12, 8});
  const auto* later = only<ScheduleSurprise>();
  ASSERT_NE(later, nullptr);
  EXPECT_EQ(later->surprise.at.move, 7);
  EXPECT_EQ(later->surprise.cells.size(), 6u);
  EXPECT_FALSE(later->surprise.announced);
  apply_all();
  EXPECT_EQ(state_.editing.surprise, 0u);
  state_.editing.surprise.reset();
  click({11, 7});  // on it: selected, not drawn anew
  EXPECT_EQ(state_.editing.surprise, 0u);
  EXPECT_TRUE(commands_.empty());
  state_.tools.get<SurpriseTool>().options().time = SurpriseTime::near;
  state_.tools.get<SurpriseTool>().options().within = 3;
  drag({10, 1}, {12, 1});
  later = only<ScheduleSurprise>();
  ASSERT_NE(later, nullptr);
  EXPECT_EQ(later->surprise.at.near, (Cell{11, 1}));
  EXPECT_EQ(later->surprise.at.within, 3);
}

TEST_F(ToolsTest, ADragSelectsARegionAndAClickPins) {
  choose_tool(state_, "select");
  state_.editing.mover = 0;
  drag({9, 6}, {5, 3});
  EXPECT_FALSE(state_.editing.mover.has_value());
  EXPECT_EQ(state_.editing.region, (CellBox{{5, 3}, {9, 6}}));
  EXPECT_FALSE(state_.view.pinned.has_value());
  click({12, 1});
  EXPECT_FALSE(state_.editing.region.has_value());
  EXPECT_EQ(state_.view.pinned, (Cell{12, 1}));
  EXPECT_TRUE(commands_.empty());
}

TEST_F(ToolsTest, AStartThatIsLetGoOfOverAnObstacleGoesBackToWhereItStood) {
  const Cell home = session_->scenario().start, free{home.x + 2, home.y + 1}, wall{home.x + 4, home.y + 1};
  ASSERT_TRUE(session_->apply(PaintCells{{{wall, true}}}).ok());
  session_->settle();
  frame();
  move_to(home);
  button(0, true);
  move_to(free);
  apply_all();
  EXPECT_EQ(session_->scenario().start, free) << "it goes along with the mouse";
  move_to(wall);
  EXPECT_TRUE(commands_.empty());
  button(0, false);
  frame();
  const auto* set = only<SetStart>();
  ASSERT_NE(set, nullptr);
  EXPECT_EQ(set->cell, home);
}

TEST_F(ToolsTest, TheRobotIsGrabbedOnItsWay) {
  ASSERT_TRUE(session_->apply(Step{StepUnit::move, 5}).ok());
  session_->update(0);
  frame();
  drag({7, 5}, {8, 8});
  ASSERT_FALSE(commands_.empty());
  const auto* put = std::get_if<PutRobot>(&commands_.back());
  ASSERT_NE(put, nullptr);
  EXPECT_EQ(put->cell, (Cell{8, 8}));
  EXPECT_TRUE(cells_of<PaintCells>().empty());
}

TEST_F(ToolsTest, WhatIsPaintedOverTheRobotIsThereAsItWouldBeByAScript) {
  ASSERT_TRUE(session_->apply(Step{StepUnit::move, 5}).ok());
  session_->update(0);
  frame();
  choose_tool(state_, "line");
  drag({7, 2}, {7, 8});  // over the robot at (7, 5)
  const auto cells = cells_of<PaintCells>();
  EXPECT_EQ(cells.size(), 7u);
  EXPECT_TRUE(std::any_of(cells.begin(), cells.end(), [](const CellChange& each) {
    return each.cell == Cell{7, 5} && each.blocked;
  }));
}

TEST_F(ToolsTest, AnotherSizeOfTheWorldForgetsPlaces) {
  choose_tool(state_, "select");
  drag({5, 3}, {9, 6});
  click({12, 1});
  drag({5, 3}, {9, 6});
  ASSERT_TRUE(session_->apply(ResizeWorld{{30, 10, Side::low, Side::low, false}}).ok());
  session_->settle();
  frame();
  EXPECT_FALSE(state_.editing.region || state_.view.pinned);
}

}  // namespace
}  // namespace replan::ui::tools_test
