// Tall, narrow windows, and fingers on them.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "tests/ui/canvas_fixture.hpp"
#include "tests/ui/golden_picture.hpp"
#include "tests/ui/shell_fixture.hpp"

namespace replan::ui {
namespace {

class NarrowTest : public ShellTest {
 protected:
  void SetUp() override {
    const auto demo = read_file(std::string(REPLAN_SOURCE_DIR) + "/maps/demo.json", 1 << 20);
    ASSERT_TRUE(demo.ok());
    open("demo.json", *demo, 390, 844);
  }
  /// Frames of 10 ms.
  void follow(double seconds) {
    for (const double end = now_ + seconds; now_ < end;) {
      now_ += 0.01;
      offscreen_->frame([this] {
        session_->update(0);
        shell_->draw(offscreen_->stage().look(), *session_, 0);
      });
      offscreen_->stage().follow_touches(now_);
    }
  }
  Touches& touches() { return offscreen_->stage().touches(); }
  void tap(float x, float y) {
    touches().begin(1, x, y, now_);
    follow(0.1);
    touches().end(1, x, y, now_);
    follow(0.1);
  }
  ImVec2 middle_of_canvas() {
    const PixelArea& area = shell_->panels().canvas;
    return {std::round((area.min.x + area.max.x) * 0.5f), std::round((area.min.y + area.max.y) * 0.5f)};
  }

  double now_ = 0;
};

TEST_F(NarrowTest, TheSideStandsUnderTheWorld) {
  EXPECT_TRUE(shell_->panels().stacked);
  const PixelArea& area = shell_->panels().canvas;
  EXPECT_EQ(area.min.x, 0);
  EXPECT_EQ(area.max.x, 390);
  EXPECT_GT(area.max.y - area.min.y, 250);
}

TEST_F(NarrowTest, ATappedCellIsToldOf) {
  const ImVec2 at = middle_of_canvas();
  tap(at.x, at.y);
  EXPECT_TRUE(shell_->view().view.pinned);
  EXPECT_FALSE(session_->modified());
  EXPECT_TRUE(touches().used());
}

TEST_F(NarrowTest, ALongPressOpensTheMenuOfTheCellWhateverTheTool) {
  choose_tool(shell_->view(), "paint");
  const ImVec2 at = middle_of_canvas();
  touches().begin(1, at.x, at.y, now_);
  follow(0.8);
  EXPECT_TRUE(shell_->panels().menu_open);
  touches().end(1, at.x, at.y, now_);
  follow(0.1);
  EXPECT_TRUE(shell_->panels().menu_open);
  EXPECT_FALSE(session_->modified());
}

TEST_F(NarrowTest, TwoFingersKeepTheWorldUnderTheirMiddleAndPaintNothing) {
  choose_tool(shell_->view(), "paint");
  const ImVec2 at = middle_of_canvas();
  const double fitted = shell_->panels().zoom;
  touches().begin(1, at.x - 40, at.y, now_);
  touches().begin(2, at.x + 40, at.y, now_);
  follow(0.05);
  for (int i = 1; i <= 10; ++i) {
    touches().move(1, at.x - 40 - 4 * static_cast<float>(i) + 20, at.y + 10, now_);
    touches().move(2, at.x + 40 + 4 * static_cast<float>(i) + 20, at.y + 10, now_);
    follow(0.02);
  }
  const Camera camera = shell_->view().view.camera;
  EXPECT_NEAR(camera.zoom, 2 * fitted, 0.02 * fitted);
  touches().end(1, at.x, at.y, now_);
  touches().end(2, at.x, at.y, now_);
  follow(0.1);
  EXPECT_FALSE(session_->modified());
}

TEST_F(NarrowTest, AFingerDrawsAStroke) {
  choose_tool(shell_->view(), "paint");
  const ImVec2 at = middle_of_canvas();
  touches().begin(1, at.x - 60, at.y, now_);
  follow(0.05);
  for (int i = 0; i < 10; ++i) {
    touches().move(1, at.x - 60 + 12 * static_cast<float>(i), at.y, now_);
    follow(0.02);
  }
  touches().end(1, at.x + 60, at.y, now_);
  follow(0.1);
  EXPECT_TRUE(session_->modified());
}

TEST_F(CanvasTest, WhatLiesUnderTwoFingersGoesWithThem) {
  const Camera before = canvas_->scene().camera;
  const auto world = [](const Camera& camera, double x, double y) {
    return Point{camera.x + (x - kCanvasWidth / 2.0) / camera.zoom,
                 camera.y + (y - kCanvasHeight / 2.0) / camera.zoom};
  };
  input().mouse_move(200, 150);
  frame();
  input().pinch({200, 150, 260, 190, 1.5f});
  frame();
  frame();
  const Camera after = canvas_->scene().camera;
  EXPECT_NEAR(after.zoom, 1.5 * before.zoom, 1e-3);
  const Point held = world(before, 200, 150), now = world(after, 260, 190);
  const double pixel = 1 / after.zoom;  // a view stands on whole ones
  EXPECT_NEAR(held.x, now.x, 0.6 * pixel);
  EXPECT_NEAR(held.y, now.y, 0.6 * pixel);
  EXPECT_TRUE(commands_.empty());
}

}  // namespace
}  // namespace replan::ui

namespace replan::app {
namespace {

class NarrowGolden : public testing::TestWithParam<const char*> {};

RenderRequest narrow(const char* theme, int width, int height) {
  RenderRequest request;
  auto scenario = read_scenario(std::string(REPLAN_SOURCE_DIR) + "/maps/demo.json");
  EXPECT_TRUE(scenario.ok());
  request.scenario = *scenario;
  request.width = width;
  request.height = height;
  request.theme = theme;
  request.window = true;
  request.actions = {"large_targets"};
  request.pinned = Cell{12, 20};
  return request;
}

TEST_P(NarrowGolden, Phone) {
  compare_with_golden(narrow(GetParam(), 390, 844), std::string("narrow_phone_") + GetParam());
}

TEST_P(NarrowGolden, Tablet) {
  compare_with_golden(narrow(GetParam(), 768, 1024), std::string("narrow_tablet_") + GetParam());
}

INSTANTIATE_TEST_SUITE_P(Themes, NarrowGolden, testing::Values("dark", "light"));

}  // namespace
}  // namespace replan::app
