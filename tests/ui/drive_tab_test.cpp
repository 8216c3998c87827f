// The Drive tab and the arcs on the canvas: what clicks and the mouse on them come to.
#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/drive/sample_grid.hpp"
#include "core/scene/arcs.hpp"
#include "core/session/film_plan.hpp"
#include "tests/ui/canvas_fixture.hpp"
#include "tests/ui/shell_fixture.hpp"
#include "ui/keys.hpp"

namespace replan::ui::drive_tab_test {
namespace {

class DriveTabTest : public ShellTest {
 protected:
  static constexpr int kWidth = 960;

  /// A window on the boxes of the fusion paper, after so many steps.
  void drive_to(const char* moment) {
    const auto text = read_file(REPLAN_SOURCE_DIR "/maps/fusion-boxes.json");
    ASSERT_TRUE(text.ok());
    open("boxes.json", *text, kWidth, 720);
    for (const auto& run : session_->runs()) run->finish(Target::end());
    shell_->view().tab = "drive";
    shell_->panels().panes = 1;
    go_to(moment);
  }
  void go_to(const char* moment) {
    frames(2);
    const auto position = moment_position(session_->run(), moment);
    ASSERT_TRUE(position.ok()) << position.error();
    ASSERT_TRUE(session_->apply(Seek{*position}).ok());
    frames(6);
  }
  [[nodiscard]] DriveWhy why() const {
    auto found = why_at_cursor(session_->run());
    EXPECT_TRUE(found.has_value());
    return std::move(*found);
  }
  [[nodiscard]] View& view() { return shell_->view().view; }
  void point(ImVec2 at) {
    offscreen_->stage().input().mouse_move(at.x, at.y);
    frames(4);
  }
  std::optional<Twist> pointed_at(float x, float y) {
    offscreen_->stage().input().mouse_move(x, y);
    frames(1);
    return view().pointed_motion;
  }
  /// Where the picture of the samples has that motion: the mouse looks for its upper edge, its column and its row.
  std::optional<ImVec2> place_of(const Twist& motion) {
    constexpr float kMiddle = kWidth - 280, kLeft = kWidth - 356, kRight = kWidth - 142;
    float top = 150;
    while (top < 600 && !pointed_at(kMiddle, top)) top += 8;
    float x = kLeft;
    const auto column = [&] {
      const auto pointed = pointed_at(x, top);
      return pointed && pointed->w == motion.w;
    };
    while (x < kRight && !column()) x += 4;
    for (float y = top; y < top + 150; y += 4)
      if (pointed_at(x, y) == motion) return ImVec2(x, y);
    return std::nullopt;
  }
};

TEST_F(DriveTabTest, AClickInThePictureChoosesItsSampleAndAnotherLetsGo) {
  drive_to("move:60");
  const DriveWhy now = why();
  ASSERT_TRUE(now.explanation.runner_up.has_value());
  const Twist motion = now.explanation.samples[*now.explanation.runner_up].motion;
  const auto place = place_of(motion);
  ASSERT_TRUE(place.has_value()) << "the sample is nowhere in the picture";
  EXPECT_FALSE(view().motion.has_value()) << "the mouse alone chooses nothing";
  click(*place);
  EXPECT_EQ(view().motion, motion);
  click(*place);
  EXPECT_FALSE(view().motion.has_value());
  point({200, 400});
  EXPECT_FALSE(view().pointed_motion.has_value());
}

TEST_F(DriveTabTest, EverySampleHasItsPlace) {
  drive_to("move:60");
  const DriveWhy now = why();
  const SampleGrid grid(now.explanation, now.settings);
  const auto low = place_of(now.explanation.samples.front().motion);
  const auto high = place_of(now.explanation.samples.back().motion);
  ASSERT_TRUE(low && high);
  EXPECT_GT(low->y, high->y) << "speed points up";
  EXPECT_LT(low->x, high->x) << "a turn to the right is on the right";
  // Between the two corners they lie evenly.
  std::size_t found = 0, tried = 0;
  for (int row = 0; row < grid.rows; row += 3)
    for (int column = 0; column < grid.columns; column += 4) {
      const auto part = [](int i, int count) {
        return static_cast<float>(i) / static_cast<float>(count - 1);
      };
      const float x = low->x + (high->x - low->x) * part(column, grid.columns),
                  y = low->y + (high->y - low->y) * part(row, grid.rows);
      if (pointed_at(x + 2, y + 2) == now.explanation.samples[grid.sample(row, column)].motion) ++found;
      ++tried;
    }
  EXPECT_GE(found, tried * 9 / 10) << "of " << tried;
}

TEST_F(DriveTabTest, WhatIsLookedAtStaysFromTickToTickUntilEscape) {
  drive_to("move:60");
  const DriveWhy now = why();
  view().motion = now.explanation.samples[*now.explanation.decision.winner].motion;
  const Twist motion = *view().motion;
  go_to("move:90");
  EXPECT_EQ(view().motion, motion);
  press(key::kEscape);
  EXPECT_FALSE(view().motion.has_value());
}

/// A canvas alone, with the boxes of the fusion paper.
class ArcsOnCanvas : public CanvasTest {
 protected:
  void SetUp() override {
    CanvasTest::SetUp();
    auto scenario = read_scenario(REPLAN_SOURCE_DIR "/maps/fusion-boxes.json");
    ASSERT_TRUE(scenario.ok()) << scenario.error();
    session_ = std::make_unique<Session>(*scenario);
    session_->settle();
    for (const auto& run : session_->runs()) run->finish(Target::end());
    const auto position = moment_position(session_->run(), "move:60");
    ASSERT_TRUE(position.ok()) << position.error();
    ASSERT_TRUE(session_->apply(Seek{*position}).ok());
    choose_tool(state_, "select");
    state_.view.camera = {4.5, 4.5, 60};
    frame();
  }
  void click_at(Point at) {
    const Camera camera = canvas_->scene().camera;
    input().mouse_move(static_cast<float>((at.x - camera.x) * camera.zoom + kCanvasWidth / 2.0),
                       static_cast<float>((at.y - camera.y) * camera.zoom + kCanvasHeight / 2.0));
    frame();
    button(0, true);
    button(0, false);
    frame();
  }
  [[nodiscard]] std::size_t strong_lines() const {
    return static_cast<std::size_t>(std::count_if(
        canvas_->scene().shapes.begin(), canvas_->scene().shapes.end(), [this](const Shape& shape) {
          const auto* line = std::get_if<Polyline>(&shape);
          return line != nullptr && line->colour == offscreen_->stage().look().theme.text;
        }));
  }
};

TEST_F(ArcsOnCanvas, AClickNearAnArcLooksAtItsSample) {
  const auto why = why_at_cursor(session_->run());
  ASSERT_TRUE(why.has_value());
  const Point robot{why->state.pose.x / why->frame.side, why->state.pose.y / why->frame.side};
  state_.view.camera = {robot.x, robot.y, 60};
  frame();
  EXPECT_EQ(strong_lines(), 0u);
  std::size_t clicked = 0;
  for (std::size_t i = 3; i < why->explanation.samples.size(); i += 17) {
    const DriveSample& sample = why->explanation.samples[i];
    const Point end = arc_points(*why, sample).back();
    if (std::hypot(end.x - robot.x, end.y - robot.y) < 0.7) continue;  // there the robot is taken hold of
    click_at(end);
    ASSERT_TRUE(state_.view.motion.has_value());
    EXPECT_EQ(*state_.view.motion, sample.motion) << i;
    EXPECT_EQ(strong_lines(), 1u);
    ++clicked;
  }
  EXPECT_GT(clicked, 4u);
  EXPECT_EQ(state_.tab, "drive");
  EXPECT_FALSE(state_.view.pinned.has_value());
}

TEST_F(ArcsOnCanvas, BesideTheArcsAClickPinsACell) {
  click_at({2.5, 7.5});
  EXPECT_FALSE(state_.view.motion.has_value());
  EXPECT_TRUE(state_.view.pinned.has_value());
}

TEST_F(ArcsOnCanvas, WhereArcsAreNotShownTheyAreNotClicked) {
  const auto why = why_at_cursor(session_->run());
  ASSERT_TRUE(why.has_value());
  const DriveSample& winner = why->explanation.samples[*why->explanation.decision.winner];
  const Point end = arc_points(*why, winner).back();
  EXPECT_EQ(arc_at(session_->run(), state_.view, end, 0.1), winner.motion);
  state_.view.overlays.set(Overlay::arcs, false);
  EXPECT_FALSE(arc_at(session_->run(), state_.view, end, 0.1).has_value());
}

}  // namespace
}  // namespace replan::ui::drive_tab_test
