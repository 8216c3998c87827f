// The view from outside on frames without a display: what goes to the graphics card, and what the pixels show.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/base/random.hpp"
#include "tests/ui/canvas_fixture.hpp"
#include "ui/canvas/orbit_pane.hpp"
#include "ui/widgets/widgets.hpp"

namespace replan::ui::orbit_test {
namespace {

/// A pane of a hall of 70 x 40 x 40 cells, 3 x 2 x 2 blocks.
class OrbitPaneTest : public CanvasTest {
 protected:
  void SetUp() override {
    CanvasTest::SetUp();
    scenario_.map = GridMap(70, 40, 40);
    for (int x = 5; x < 60; x += 9)
      for (int y = 2; y < 38; ++y) scenario_.map.set({x, y, (x * y) % 37}, true);
    scenario_.start = {2, 5, 1};
    scenario_.goal = {40, 20, 20};
    scenario_.map.set(scenario_.start, false);
    scenario_.map.set(scenario_.goal, false);
    scenario_.planners = {{"dstar-lite", {}, {}}};
    begin();
  }
  void TearDown() override {
    if (offscreen_) offscreen_->frame([this] { pane_.reset(); });
    CanvasTest::TearDown();
  }
  void begin() {
    hall_ = std::make_unique<Session>(scenario_);
    hall_->settle();
    offscreen_->frame([this] { pane_ = std::make_unique<OrbitPane>(offscreen_->stage().renderer()); });
    state_.live = false;  // all of the world at once
    draw();
  }
  void draw() {
    offscreen_->frame([this] {
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({kCanvasWidth, kCanvasHeight});
      ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
      ImGui::Begin("orbit", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
      pane_->draw(offscreen_->stage().look(), *hall_, hall_->run(), slice_, area_, state_, memory_);
      ImGui::End();
      ImGui::PopStyleVar();
    });
  }
  /// What goes to the graphics card while something is done.
  template <class Deed>
  SolidBuffers::Uploads uploads(Deed&& deed) {
    const SolidBuffers::Uploads before = pane_->uploads();
    deed();
    draw();
    const SolidBuffers::Uploads after = pane_->uploads();
    return {after.blocks - before.blocks, after.scenes - before.scenes};
  }
  [[nodiscard]] OrbitLens lens() const { return {state_.orbit, hall_->run().lattice(), area_.view}; }
  /// The colour where a point of the world is seen.
  [[nodiscard]] std::array<int, 3> colour_at(const Point& point) const {
    const auto pixel = lens().pixel(point);
    const Image picture = offscreen_->picture();
    const auto at = (static_cast<std::size_t>(pixel->y) * static_cast<std::size_t>(picture.width) +
                     static_cast<std::size_t>(pixel->x)) *
                    4;
    return {picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]};
  }

  const PaneArea area_{{0, 0}, {kCanvasWidth, kCanvasHeight, 0, 0}};
  Scenario scenario_;
  std::unique_ptr<Session> hall_;
  std::unique_ptr<OrbitPane> pane_;
  SceneMemory memory_;
  Slice slice_{Axis::z, 10};
};

TEST_F(OrbitPaneTest, ATurnBuildsAndUploadsNothing) {
  EXPECT_GT(pane_->uploads().blocks, 4u);
  EXPECT_EQ(pane_->uploads().scenes, 1u);
  const Image before = offscreen_->picture();
  const auto sent = uploads([&] {
    for (int i = 0; i < 5; ++i) {
      state_.orbit.yaw += 0.2;
      draw();
    }
  });
  EXPECT_EQ(sent.blocks, 0u);
  EXPECT_EQ(sent.scenes, 0u);
  EXPECT_NE(offscreen_->picture().rgba, before.rgba) << "though it does turn";
  state_.solid.cut = true;
  draw();
  const auto over_the_top = uploads([&] { state_.orbit.pitch = -0.5; });
  EXPECT_EQ(over_the_top.scenes, 1u) << "a cut is another one from below";
}

TEST_F(OrbitPaneTest, AStrokeUploadsItsOwnBlocksAlone) {
  ASSERT_TRUE(hall_->apply(Seek{hall_->run().timeline().size()}).ok());
  draw();
  const auto sent = uploads([&] {
    ASSERT_TRUE(hall_->apply(PaintCells{{{{10, 10, 10}, true}, {{11, 10, 10}, true}}, 1}).ok());
    hall_->settle();
  });
  EXPECT_EQ(sent.blocks, 1u);
  const auto at_a_border = uploads([&] {
    ASSERT_TRUE(hall_->apply(PaintCells{{{{31, 10, 12}, true}, {{32, 10, 12}, true}}, 2}).ok());
    hall_->settle();
  });
  EXPECT_EQ(at_a_border.blocks, 2u);
  ASSERT_TRUE(hall_->apply(Seek{100}).ok());
  draw();
  const auto stepping = uploads([&] { ASSERT_TRUE(hall_->apply(Step{StepUnit::expansion, 3}).ok()); });
  EXPECT_EQ(stepping.blocks, 0u);
  EXPECT_EQ(stepping.scenes, 1u);
}

TEST_F(OrbitPaneTest, InAWindowThePictureFillsInOverFrames) {
  state_.live = true;
  scenario_.map = GridMap(192, 192, 192);
  Random random(5);
  for (NodeId node = 0; node < scenario_.map.blocked.size(); node += 1 + random.below(3))
    scenario_.map.blocked[node] = kObstacle;
  scenario_.map.set(scenario_.start, false);
  scenario_.goal = {3, 5, 1};
  scenario_.map.set(scenario_.goal, false);
  hall_ = std::make_unique<Session>(scenario_);
  hall_->settle();
  draw();
  EXPECT_TRUE(pane_->behind());
  const std::size_t first = pane_->uploads().blocks;
  draw();
  EXPECT_GT(pane_->uploads().blocks, first) << "another frame, some more of it";
}

/// A cell that is painted shows where it is, and can be picked; undone, it is gone.
TEST_F(OrbitPaneTest, PaintingShows) {
  const Cell painted{20, 30, 12};
  const auto before = colour_at(centre_of(painted));
  ASSERT_TRUE(hall_->apply(PaintCells{{{painted, true}}, 1}).ok());
  hall_->settle();
  draw();
  EXPECT_NE(colour_at(centre_of(painted)), before);
  ASSERT_TRUE(hall_->apply(Undo{}).ok());
  hall_->settle();
  draw();
  EXPECT_EQ(colour_at(centre_of(painted)), before);
}

TEST_F(OrbitPaneTest, StepsShowTheOpenListAndThePathComesInTheEnd) {
  const auto shows = [this](Sign sign) { return pane_->legend().shows(sign); };
  ASSERT_TRUE(hall_->apply(Seek{0}).ok());
  draw();
  EXPECT_FALSE(shows(Sign::queue));
  EXPECT_FALSE(shows(Sign::path));
  ASSERT_TRUE(hall_->apply(Step{StepUnit::expansion, 5}).ok());
  draw();
  EXPECT_TRUE(shows(Sign::queue));
  ASSERT_TRUE(pane_->legend().field) << "and the field of g is in the legend";
  EXPECT_TRUE(pane_->legend().range);
  ASSERT_TRUE(hall_->apply(Seek{hall_->run().timeline().size()}).ok());
  draw();
  EXPECT_TRUE(shows(Sign::path));
}

/// A surprise is drawn as one that is to come, then as what it is, and what the replan touched with it.
TEST_F(OrbitPaneTest, ASurpriseShowsBeforeItComesAndOnceItIsThere) {
  Surprise surprise;
  surprise.at.move = 3;
  for (int y = 0; y < 12; ++y)
    for (int z = 0; z < 12; ++z) surprise.cells.push_back({{8, y, z}, true});
  scenario_.surprises = {surprise};
  begin();
  const auto shows = [this](Sign sign) { return pane_->legend().shows(sign); };
  EXPECT_TRUE(shows(Sign::to_come));
  EXPECT_FALSE(shows(Sign::surprise));
  ASSERT_TRUE(hall_->apply(RunToEnd{}).ok());
  hall_->settle();
  ASSERT_TRUE(hall_->apply(Seek{hall_->run().timeline().size()}).ok());
  draw();
  EXPECT_FALSE(shows(Sign::to_come));
  EXPECT_TRUE(shows(Sign::surprise));
  EXPECT_TRUE(shows(Sign::repair));
}

/// A line one cell behind a wall is faint and one that lies on it is not, from near and from far; also where the near plane
/// is close to the eye.
TEST_F(OrbitPaneTest, AWallHidesWhatIsBehindItFromNearAndFar) {
  scenario_.map = GridMap(70, 40, 40);
  for (int x = 10; x < 60; ++x)
    for (int z = 5; z < 35; ++z) scenario_.map.set({x, 20, z}, true);
  scenario_.start = {2, 18, 20};
  scenario_.goal = {68, 18, 20};
  begin();
  state_.view.overlays = {};
  const auto differs = [&](double distance, double y) {
    state_.orbit = {0, 0, distance, {35, 20, 20}};
    state_.view.pinned.reset();
    draw();
    const auto without = colour_at({35.5, y, 20.0});
    // The edges of a cell that is pinned lie along this place.
    state_.view.pinned = Cell{35, static_cast<int>(y) - (y > 20 ? 1 : 0), 20};
    draw();
    const auto with = colour_at({35.5, y, 20.0});
    int most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(with[i] - without[i]));
    return most;
  };
  for (const double distance : {4.0, 12.0, 60.0, 200.0, 900.0}) {
    const int on_it = differs(distance, 21), behind = differs(distance, 19);
    EXPECT_GT(on_it, 80) << distance;
    EXPECT_LT(behind, on_it * 3 / 4) << distance;
  }
}

}  // namespace
}  // namespace replan::ui::orbit_test
