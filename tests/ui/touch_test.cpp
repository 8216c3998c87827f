// Fingers, with made-up times: what a mouse would have done.
#include "ui/touch.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/keys.hpp"

namespace replan::ui {
namespace {

/// A screen without a program: each frame tells what had changed by then.
class TouchTest : public testing::Test {
 protected:
  /// Frames 10 ms apart, until `time`.
  void until(double time) {
    while (now_ < time) {
      now_ += 0.01;
      frame();
    }
  }
  void frame() {
    touches_.update(now_, ground_);
    queue_.feed(io_);
    const auto pinch = queue_.take_pinch();
    if (pinch) {
      factor_ *= pinch->factor;
      panned_x_ += pinch->to_x - pinch->from_x;
      panned_y_ += pinch->to_y - pinch->from_y;
    }
    scrolled_ += io_.MouseWheel;
    scrolled_aside_ += io_.MouseWheelH;
    io_.MouseWheel = io_.MouseWheelH = 0;
    for (const int button : {0, 1, 2}) {
      if (io_.MouseDown[button] == down_[button]) continue;
      down_[button] = io_.MouseDown[button];
      const std::string name = button == 0 ? "left" : button == 1 ? "right" : "middle";
      const std::string shift = io_.KeyShift ? "shift+" : "";
      said_.push_back(shift + name + (down_[button] ? " down at " : " up at ") +
                      std::to_string(static_cast<int>(io_.MousePos.x)) + "," +
                      std::to_string(static_cast<int>(io_.MousePos.y)));
    }
  }
  using Said = std::vector<std::string>;

  ImGuiIO io_;
  InputQueue queue_;
  Touches touches_{queue_};
  TouchGround ground_ = TouchGround::world;
  double now_ = 0;
  bool down_[3] = {};
  Said said_;
  float factor_ = 1, panned_x_ = 0, panned_y_ = 0, scrolled_ = 0, scrolled_aside_ = 0;
};

TEST_F(TouchTest, ATapIsAClickAndThenThePointerIsGone) {
  touches_.begin(1, 50, 60, now_);
  until(0.1);
  EXPECT_TRUE(said_.empty()) << "nothing is pressed while a second finger may still come";
  touches_.end(1, 52, 60, 0.1);
  until(0.2);
  EXPECT_EQ(said_, (Said{"left down at 50,60", "left up at 50,60"}));
  EXPECT_LT(io_.MousePos.x, -1e6f);
  EXPECT_FALSE(touches_.active());
}

TEST_F(TouchTest, ATapBetweenTwoFramesIsAClickToo) {
  touches_.begin(1, 50, 60, 0);
  touches_.end(1, 50, 60, 0.005);
  until(0.1);
  EXPECT_EQ(said_, (Said{"left down at 50,60", "left up at 50,60"}));
}

TEST_F(TouchTest, TwoTapsBetweenTwoFramesAreTwoClicks) {
  for (const float x : {50.0f, 80.0f}) {
    touches_.begin(1, x, 60, 0);
    touches_.end(1, x, 60, 0.005);
  }
  until(0.2);
  EXPECT_EQ(said_,
            (Said{"left down at 50,60", "left up at 50,60", "left down at 80,60", "left up at 80,60"}));
}

TEST_F(TouchTest, ADragHoldsTheButtonFromWhereItBegan) {
  touches_.begin(1, 50, 60, 0);
  until(0.03);
  touches_.move(1, 70, 60, 0.03);
  until(0.05);
  EXPECT_TRUE(said_.empty()) << "a second finger may still come";
  until(0.1);
  EXPECT_EQ(said_, (Said{"left down at 50,60"}));
  EXPECT_EQ(io_.MousePos.x, 70);
  touches_.move(1, 90, 65, 0.11);
  until(0.12);
  EXPECT_EQ(io_.MousePos.x, 90);
  touches_.end(1, 95, 65, 0.13);
  until(0.2);
  EXPECT_EQ(said_, (Said{"left down at 50,60", "left up at 95,65"}));
}

TEST_F(TouchTest, AStrokeBetweenTwoFramesIsNotLost) {
  touches_.begin(1, 50, 60, 0);
  touches_.move(1, 80, 60, 0.004);
  touches_.end(1, 90, 60, 0.008);
  until(0.2);
  EXPECT_EQ(said_, (Said{"left down at 50,60", "left up at 90,60"}));
}

TEST_F(TouchTest, TwoFingersPanAndZoomAndPressNothing) {
  touches_.begin(1, 100, 100, 0);
  until(0.03);
  touches_.move(1, 103, 100, 0.03);
  touches_.begin(2, 203, 100, 0.04);  // 100 apart, the middle at 153
  until(0.06);
  touches_.move(1, 80, 120, 0.06);
  touches_.move(2, 280, 120, 0.06);  // 200 apart, the middle at 180
  until(0.1);
  touches_.end(2, 280, 120, 0.1);
  touches_.move(1, 300, 300, 0.12);  // the one that stays draws nothing
  until(0.3);
  touches_.end(1, 300, 300, 0.3);
  until(0.4);
  EXPECT_TRUE(said_.empty());
  EXPECT_NEAR(factor_, 2, 1e-3);
  EXPECT_NEAR(panned_x_, 27, 1e-3);
  EXPECT_NEAR(panned_y_, 20, 1e-3);
  EXPECT_LT(io_.MousePos.x, -1e6f);
}

TEST_F(TouchTest, FingersThatPartWithinAFrameZoomNonetheless) {
  touches_.begin(1, 100, 100, 0);
  touches_.begin(2, 200, 100, 0);
  touches_.move(2, 400, 100, 0.005);
  until(0.1);
  EXPECT_NEAR(factor_, 3, 1e-3);
  EXPECT_NEAR(panned_x_, 100, 1e-3);
}

TEST_F(TouchTest, ASecondFingerEndsADrag) {
  touches_.begin(1, 50, 60, 0);
  until(0.08);
  touches_.move(1, 70, 60, 0.08);
  until(0.12);
  touches_.begin(2, 170, 60, 0.12);
  until(0.2);
  EXPECT_EQ(said_, (Said{"left down at 50,60", "left up at 70,60"}));
}

TEST_F(TouchTest, ALongPressAsksForTheMenuOfTheCell) {
  touches_.begin(1, 50, 60, 0);
  until(0.45);
  EXPECT_TRUE(said_.empty());
  until(0.6);
  EXPECT_EQ(said_, (Said{"shift+right down at 50,60", "shift+right up at 50,60"}));
  touches_.end(1, 50, 60, 0.7);
  until(0.8);
  EXPECT_EQ(said_.size(), 2u) << "lifting the finger is no click";
  EXPECT_FALSE(io_.KeyShift);
}

TEST_F(TouchTest, ALongPressOnAControlIsTheRightButtonAlone) {
  ground_ = TouchGround::control;
  touches_.begin(1, 50, 60, 0);
  until(0.6);
  EXPECT_EQ(said_, (Said{"right down at 50,60", "right up at 50,60"}));
}

TEST_F(TouchTest, AFingerBetweenControlsScrollsThePanel) {
  ground_ = TouchGround::panel;
  touches_.set_measures({.slack = 6, .wheel_notch = 70});
  touches_.begin(1, 50, 260, 0);
  until(0.05);
  touches_.move(1, 53, 190, 0.05);
  until(0.1);
  touches_.move(1, 54, 120, 0.1);
  until(0.2);
  EXPECT_NEAR(scrolled_, -2, 1e-3);
  EXPECT_EQ(scrolled_aside_, 0);
  touches_.end(1, 54, 120, 0.2);
  until(0.3);
  EXPECT_TRUE(said_.empty());
}

TEST_F(TouchTest, AFingerOnAControlDragsIt) {
  ground_ = TouchGround::control;
  touches_.begin(1, 50, 60, 0);
  until(0.05);
  touches_.move(1, 50, 90, 0.05);
  until(0.1);
  EXPECT_EQ(said_, (Said{"left down at 50,60"}));
  EXPECT_EQ(scrolled_, 0);
}

TEST_F(TouchTest, AFingerOnARowScrollsItsListUpAndDownAndDragsAcross) {
  ground_ = TouchGround::row;
  touches_.set_measures({.slack = 6, .wheel_notch = 70});
  touches_.begin(1, 50, 260, 0);
  until(0.05);
  touches_.move(1, 60, 190, 0.05);
  until(0.1);
  touches_.end(1, 60, 190, 0.12);
  until(0.2);
  EXPECT_NEAR(scrolled_, -1, 1e-3);
  EXPECT_TRUE(said_.empty());
  touches_.begin(1, 50, 60, 0.3);
  until(0.35);
  touches_.move(1, 90, 70, 0.4);
  until(0.5);
  EXPECT_EQ(said_, (Said{"left down at 50,60"})) << "a slider in it";
}

TEST_F(TouchTest, TwoFingersScrollAPanelWhateverIsUnderThem) {
  ground_ = TouchGround::control;
  touches_.begin(1, 50, 60, 0);
  touches_.begin(2, 150, 60, 0.01);
  until(0.05);
  touches_.move(1, 50, 130, 0.05);
  touches_.move(2, 150, 130, 0.05);
  until(0.1);
  EXPECT_NEAR(scrolled_, 1, 1e-3);
  EXPECT_EQ(factor_, 1);
  EXPECT_TRUE(said_.empty());
}

TEST_F(TouchTest, WhatTheSystemTakesAwayIsLetGo) {
  touches_.begin(1, 50, 60, 0);
  until(0.08);
  touches_.move(1, 90, 60, 0.08);
  until(0.1);
  touches_.cancel();
  until(0.2);
  EXPECT_EQ(said_, (Said{"left down at 50,60", "left up at 90,60"}));
  EXPECT_FALSE(touches_.active());
  touches_.end(1, 90, 60, 0.3);
  until(0.4);
  EXPECT_EQ(said_.size(), 2u);
}

}  // namespace
}  // namespace replan::ui
