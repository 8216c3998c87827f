// Worlds of several layers on the canvas: which slice a pane shows, and tools that draw on it.
#include <algorithm>

#include "tests/ui/canvas_fixture.hpp"
#include "ui/canvas/chips.hpp"
#include "ui/canvas/orbit_marks.hpp"
#include "ui/canvas/slice_bar.hpp"
#include "ui/keys.hpp"
#include "ui/tools/measure.hpp"
#include "ui/tools/mover.hpp"

namespace replan::ui::slices_test {
namespace {

/// A box of 20 x 10 x 6 free cells, seen along y: 20 columns, 6 rows.
class SlicesTest : public CanvasTest {
 protected:
  void SetUp() override {
    CanvasTest::SetUp();
    Scenario scenario;
    scenario.map = GridMap(20, 10, 6);
    scenario.start = {2, 5, 1};
    scenario.goal = {17, 5, 4};
    scenario.planners = {{"dstar-lite", {}}};
    ASSERT_TRUE(session_->apply(ReplaceScenario{scenario, ""}).ok());
    session_->settle();
    frame();
  }
  void look_along(Axis axis, int layer) {
    state_.slices.set_all({axis, layer});
    frame();
  }
  void wheel(float steps, bool ctrl = false) {
    input().key(key::kLeftShift, true);
    if (ctrl) input().key(key::kLeftControl, true);
    frame();
    frame();
    input().wheel(0, steps);
    frame();
    input().key(key::kLeftShift, false);
    if (ctrl) input().key(key::kLeftControl, false);
    frame();
    frame();
  }
};

TEST_F(SlicesTest, BeginWithTheLayerOfTheStart) {
  EXPECT_EQ(state_.slices.of(0), (Slice{Axis::z, 1}));
  EXPECT_EQ(canvas_->scene().columns, 20);
  EXPECT_EQ(canvas_->scene().rows, 10);
  look_along(Axis::y, 5);
  EXPECT_EQ(canvas_->scene().rows, 6);
}

TEST_F(SlicesTest, ShiftAndTheWheelMoveThem) {
  move_to({9, 4});
  const Camera before = state_.view.camera;
  wheel(1);
  EXPECT_EQ(state_.slices.of(0), (Slice{Axis::z, 2}));
  EXPECT_EQ(state_.slices.of(1), (Slice{Axis::z, 2})) << "panes that show the same go together";
  EXPECT_EQ(state_.view.camera, before) << "and nothing zooms";
  wheel(-1, true);
  EXPECT_EQ(state_.slices.of(0), (Slice{Axis::z, 1}));
  EXPECT_EQ(state_.slices.of(1), (Slice{Axis::z, 2})) << "with Ctrl one goes alone";
  for (int i = 0; i < 9; ++i) wheel(-1);
  EXPECT_EQ(state_.slices.of(0).layer, 0) << "there is none below the lowest";
  EXPECT_EQ(state_.slices.of(1).layer, 2);
}

TEST_F(SlicesTest, AreTurnedToThePinnedCell) {
  const Box world = session_->run().lattice();
  turn_slice(state_.slices, 0, world, Axis::x, std::nullopt);
  EXPECT_EQ(state_.slices.of(0), (Slice{Axis::x, 10})) << "the middle, where none is pinned";
  turn_slice(state_.slices, 0, world, Axis::y, Cell{3, 8, 2});
  EXPECT_EQ(state_.slices.of(0), (Slice{Axis::y, 8}));
  turn_slice(state_.slices, 0, world, Axis::y, Cell{3, 2, 2});
  EXPECT_EQ(state_.slices.of(0), (Slice{Axis::y, 8})) << "it looks along y already";
  turn_slice(state_.slices, 0, world, Axis::z, Cell{30, 8, 2});
  EXPECT_EQ(state_.slices.of(0), (Slice{Axis::z, 3})) << "the cell is of another world";
}

TEST_F(SlicesTest, TheCellUnderTheCursorIsTheWorlds) {
  look_along(Axis::y, 7);
  move_to({3, 0});
  EXPECT_EQ(state_.view.hovered, (Cell{3, 7, 5})) << "the highest row is the highest z";
  look_along(Axis::x, 12);
  move_to({3, 5});
  EXPECT_EQ(state_.view.hovered, (Cell{12, 3, 0}));
}

TEST_F(SlicesTest, ToolsDrawOnTheSliceThatShows) {
  look_along(Axis::y, 7);
  drag({5, 0}, {8, 0});
  std::vector<CellChange> cells = cells_of<PaintCells>();
  ASSERT_EQ(cells.size(), 4u);
  for (const CellChange& each : cells) EXPECT_TRUE(each.cell.y == 7 && each.cell.z == 5 && each.blocked);
  commands_.clear();
  choose_tool(state_, "rectangle");
  state_.layers = 3;
  drag({5, 1}, {8, 2});
  cells = cells_of<PaintCells>();
  EXPECT_EQ(cells.size(), 24u) << "4 x 2, 3 layers deep";
  for (const CellChange& each : cells)
    EXPECT_TRUE(each.cell.y >= 7 && each.cell.y <= 9 && (each.cell.z == 3 || each.cell.z == 4));
  commands_.clear();
  look_along(Axis::y, 9);
  choose_tool(state_, "surprise");
  drag({10, 3}, {11, 3});
  EXPECT_EQ(cells_of<DropSurprise>().size(), 2u) << "behind the last layer there is none";
}

TEST_F(SlicesTest, AFillStaysInItsLayer) {
  look_along(Axis::y, 7);
  choose_tool(state_, "fill");
  drag({10, 3}, {10, 3});
  const auto cells = cells_of<PaintCells>();
  EXPECT_EQ(cells.size(), 120u);
  EXPECT_TRUE(
      std::all_of(cells.begin(), cells.end(), [](const CellChange& each) { return each.cell.y == 7; }));
}

TEST_F(SlicesTest, TheStartIsGrabbedWhereItStandsAlone) {
  drag({2, 5}, {4, 6});
  const auto* set = commands_.empty() ? nullptr : std::get_if<SetStart>(&commands_.back());
  ASSERT_NE(set, nullptr);
  EXPECT_EQ(set->cell, (Cell{4, 6, 1}));
  commands_.clear();
  look_along(Axis::z, 3);
  drag({2, 5}, {4, 6});
  EXPECT_TRUE(std::none_of(commands_.begin(), commands_.end(), [](const Command& each) {
    return std::holds_alternative<SetStart>(each);
  })) << "two layers below";
}

TEST_F(SlicesTest, SelectionMeasureAndWaysAreInTheWorld) {
  look_along(Axis::x, 4);
  choose_tool(state_, "select");
  drag({1, 0}, {3, 2});
  EXPECT_EQ(state_.editing.region, (CellBox{{4, 1, 3}, {4, 3, 5}}));
  choose_tool(state_, "measure");
  drag({1, 5}, {3, 2});
  const auto& measure = state_.tools.get<MeasureTool>().measure();
  ASSERT_TRUE(measure);
  const MeasureFigures figures = measured(*measure);
  EXPECT_EQ(figures.dx, 0);
  EXPECT_EQ(figures.dy, 2);
  EXPECT_EQ(figures.dz, 3);
  EXPECT_NEAR(figures.octile, 1 + 2 * 1.41421356, 1e-6);
  EXPECT_EQ(measure_text(figures, 1, true), "3.61 cells · octile 3.83 · dx 0, dy 2, dz 3");
  choose_tool(state_, "mover");
  state_.brush = 2;
  drag({2, 4}, {2, 4});
  look_along(Axis::z, 3);
  drag({9, 6}, {9, 6});
  drag({9, 6}, {9, 6});
  const auto* add = commands_.empty() ? nullptr : std::get_if<AddMover>(&commands_.back());
  ASSERT_NE(add, nullptr) << "a way may lead from slice to slice";
  EXPECT_EQ(add->mover.way, (std::vector<Cell>{{4, 2, 1}, {9, 6, 3}}));
  EXPECT_EQ(add->mover.depth, 2);
}

/// A box of two cells, whose middle lies between cells, on a slice where z grows against the rows.
TEST_F(SlicesTest, TheNextMovingBoxIsShownWhereItWillStand) {
  look_along(Axis::y, 7);
  choose_tool(state_, "mover");
  state_.brush = 2;
  input().mouse_leave();
  frame();
  frame();
  const Image before = offscreen_->picture();
  move_to({5, 2});
  const Image after = offscreen_->picture();
  const Camera camera = canvas_->scene().camera;
  // Whether something was drawn over the upper border of a row, in the middle of column 5.
  const auto drawn = [&](int row) {
    const auto x = static_cast<std::size_t>((5.5 - camera.x) * camera.zoom + kCanvasWidth / 2.0);
    const auto y = static_cast<std::size_t>((row - camera.y) * camera.zoom + kCanvasHeight / 2.0);
    for (std::size_t near = y - 2; near <= y + 2; ++near)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t at = (near * static_cast<std::size_t>(kCanvasWidth) + x) * 4 + i;
        if (before.rgba[at] != after.rgba[at]) return true;
      }
    return false;
  };
  EXPECT_TRUE(drawn(1)) << "it is there in z = 3 and 4";
  EXPECT_TRUE(drawn(3));
  EXPECT_FALSE(drawn(4));
  drag({5, 2}, {5, 2});
  drag({5, 2}, {5, 2});
  const auto* add = commands_.empty() ? nullptr : std::get_if<AddMover>(&commands_.back());
  ASSERT_NE(add, nullptr);
  EXPECT_EQ(add->mover.way.front(), (Cell{5, 7, 3}));
}

TEST_F(SlicesTest, FollowTheRobotWhereverItGoes) {
  state_.slices.follows_robot = true;
  frame();
  EXPECT_EQ(state_.slices.of(0).layer, 1);
  ASSERT_TRUE(session_->apply(Step{StepUnit::move, 15}).ok());
  session_->settle();
  frame();
  const NodeId robot = session_->run().timeline().state().node(Scalar::robot);
  EXPECT_EQ(state_.slices.of(0).layer, session_->run().lattice().position(robot).z);
  EXPECT_GT(state_.slices.of(0).layer, 1);
  move_to({9, 4});
  wheel(1);
  EXPECT_FALSE(state_.slices.follows_robot) << "a slice that is moved by hand stays there";
}

TEST_F(SlicesTest, AnotherWorldBeginsAgain) {
  look_along(Axis::x, 12);
  Scenario plane;
  plane.map = GridMap(8, 8);
  plane.goal = {7, 7};
  plane.planners = {{"dstar-lite", {}}};
  ASSERT_TRUE(session_->apply(ReplaceScenario{plane, ""}).ok());
  session_->settle();
  frame();
  EXPECT_EQ(canvas_->scene().columns, 8);
  move_to({3, 4});
  EXPECT_EQ(state_.view.hovered, (Cell{3, 4, 0}));
}

/// The same world from outside.
class OrbitTest : public SlicesTest {
 protected:
  void SetUp() override {
    SlicesTest::SetUp();
    state_.slices.set_orbits(0, true);
    frame();
    const Look& look = offscreen_->stage().look();
    above_ = static_cast<int>(pane_title_height(look) + slice_bar_height(look));
  }
  void drag_pixels(float x, float y, float dx, float dy, int which = 0) {
    input().mouse_move(x, y);
    frame();
    button(which, true);
    input().mouse_move(x + dx, y + dy);
    frame();
    button(which, false);
    frame();
  }
  [[nodiscard]] OrbitLens lens() const {
    const Scene& scene = canvas_->scene();
    return {state_.orbit, session_->run().lattice(), {scene.width, scene.height, above_, 0}};
  }
  int above_ = 0;  // what the title and the bar take
};

TEST_F(OrbitTest, ADragTurnsTheWorldAndTheWheelComesNearer) {
  const Orbit before = state_.orbit;
  drag_pixels(320, 300, 40, 20);
  EXPECT_LT(state_.orbit.yaw, before.yaw);
  EXPECT_GT(state_.orbit.pitch, before.pitch);
  EXPECT_GT(state_.orbit.distance, 0) << "what was fitted stands from now on";
  const double distance = state_.orbit.distance;
  input().wheel(0, 1);
  frame();
  EXPECT_LT(state_.orbit.distance, distance);
  const Point focus = state_.orbit.focus;
  drag_pixels(320, 300, 40, 0, 1);
  EXPECT_NE(state_.orbit.focus, focus) << "the right button moves it";
  EXPECT_TRUE(commands_.empty()) << "and nothing of it changes the world";
  EXPECT_FALSE(state_.view.pinned);
  canvas_->fit();
  frame();
  EXPECT_EQ(state_.orbit.distance, 0);
  wheel(1);
  EXPECT_EQ(state_.slices.of(0), (Slice{Axis::z, 2}));
}

TEST_F(OrbitTest, AClickPinsWhatIsUnderTheCursor) {
  state_.view.overlays = {};  // no cell of the open list stands before it
  ASSERT_TRUE(session_->apply(PaintCells{{{{10, 5, 3}, true}}, 0}).ok());
  session_->settle();
  frame();
  const auto pixel = lens().pixel(centre_of(Cell{10, 5, 3}));
  ASSERT_TRUE(pixel);
  drag_pixels(static_cast<float>(pixel->x), static_cast<float>(pixel->y), 0, 0);
  EXPECT_EQ(state_.view.hovered, (Cell{10, 5, 3}));
  EXPECT_EQ(state_.view.pinned, (Cell{10, 5, 3}));
  drag_pixels(static_cast<float>(pixel->x), static_cast<float>(pixel->y), 0, 0, 1);
  EXPECT_EQ(state_.menu, (Cell{10, 5, 3})) << "and the right button asks for its menu";
  drag_pixels(static_cast<float>(pixel->x), static_cast<float>(pixel->y), 0, 0);
  EXPECT_FALSE(state_.view.pinned);
}

TEST_F(OrbitTest, AClickMeetsThePathInsideOfGlass) {
  state_.solid.see_through = true;
  state_.view.overlays = {};
  state_.view.overlays.set(Overlay::path, true);
  frame();
  const Path& path = *session_->run().decision_at(session_->run().timeline().cursor())->plan->path;
  const Cell on_path = cell_of(path.point(path.size() / 2));
  const auto pixel = lens().pixel(centre_of(on_path));
  drag_pixels(static_cast<float>(pixel->x), static_cast<float>(pixel->y), 0, 0);
  EXPECT_EQ(state_.view.pinned, on_path);
}

TEST_F(OrbitTest, TheCompassTurnsTheWorld) {
  const Look& look = offscreen_->stage().look();
  const Scene& scene = canvas_->scene();
  const PaneArea area{{0, 0}, {scene.width, scene.height, above_, 0}};
  const auto go_to = [&](CompassPart part) {
    for (float y = kCanvasHeight - 120; y < kCanvasHeight; y += 2)
      for (float x = 0; x < 120; x += 2)
        if (compass_part(look, lens(), area, {x, y}) == part) return input().mouse_move(x, y);
    ADD_FAILURE() << "the compass has no such part";
  };
  const auto click = [&] {
    frame();
    button(0, true);
    button(0, false);
  };
  state_.view.pinned.reset();
  for (const auto& [part, view] : {std::pair{CompassPart::y, front_view()}, {CompassPart::x, side_view()}}) {
    state_.orbit = {};
    frame();
    go_to(part);
    click();
    EXPECT_EQ(state_.orbit, view);
  }
  state_.orbit = {0.3, 0.3, 12, {4, 4, 4}};
  frame();
  go_to(CompassPart::middle);
  click();
  EXPECT_EQ(state_.orbit.distance, 12) << "a single click does nothing";
  click();
  EXPECT_EQ(state_.orbit, Orbit{}) << "a double click shows all";
  EXPECT_FALSE(state_.view.pinned) << "and nothing behind it is pinned";
}

TEST_F(OrbitTest, KeysZoomAndMoveAndTheMouseLeavesNothingBehind) {
  state_.zoom_steps = 1;
  frame();
  EXPECT_EQ(state_.zoom_steps, 0);
  const double near = state_.orbit.distance;
  EXPECT_GT(near, 0);
  state_.zoom_steps = -1;
  state_.pan_x = 1;
  const Point focus = state_.orbit.focus;
  frame();
  EXPECT_GT(state_.orbit.distance, near);
  EXPECT_NE(state_.orbit.focus, focus);
  ASSERT_TRUE(session_->apply(PaintCells{{{{10, 5, 3}, true}}, 0}).ok());
  session_->settle();
  canvas_->fit();
  frame();
  const auto pixel = lens().pixel(centre_of(Cell{10, 5, 3}));
  input().mouse_move(static_cast<float>(pixel->x), static_cast<float>(pixel->y));
  frame();
  ASSERT_TRUE(state_.view.hovered);
  input().mouse_leave();
  frame();
  EXPECT_FALSE(state_.view.hovered);
}

TEST_F(OrbitTest, TheLegendTellsWhatShows) {
  EXPECT_TRUE(canvas_->scene().shows(Sign::path));
  EXPECT_TRUE(canvas_->scene().shows(Sign::queue));
  state_.view.overlays.set(Overlay::path, false);
  frame();
  EXPECT_FALSE(canvas_->scene().shows(Sign::path));
}

}  // namespace
}  // namespace replan::ui::slices_test
