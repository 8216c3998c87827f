// The whole window on frames without a display, with a keyboard: what a user does and what comes of it.
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "app/platform/offscreen.hpp"
#include "tests/support/temporary_folder.hpp"
#include "ui/keys.hpp"
#include "ui/shell/shell.hpp"

namespace replan::ui {

class ShellTest : public testing::Test {
 protected:
  void TearDown() override {
    if (offscreen_) offscreen_->frame([this] { shell_.reset(); });
  }

  /// Opens a window on a scenario, held in a file of that name.
  void open(const std::string& name, const std::string& scenario, int width = 1280, int height = 800) {
    path_ = folder_.with(name, scenario);
    session_ = std::make_unique<Session>(*read_scenario(path_), path_);
    session_->settle();
    auto offscreen = app::Offscreen::create({width, height, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    offscreen_ = std::move(*offscreen);
    offscreen_->frame([this] { shell_ = std::make_unique<Shell>(offscreen_->stage().renderer()); });
    frames(2);
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i)
      offscreen_->frame([this] {
        session_->update(0);
        shell_->draw(offscreen_->stage().look(), *session_, 0);
      });
  }
  void press(int key, bool ctrl = false, bool shift = false) {
    InputQueue& input = offscreen_->stage().input();
    const auto modifiers = [&](bool down) {
      if (ctrl) input.key(key::kLeftControl, down);
      if (shift) input.key(key::kLeftShift, down);
    };
    modifiers(true);
    input.key(key, true);
    frames(6);
    input.key(key, false);
    modifiers(false);
    frames(6);
  }
  void click(ImVec2 at, int button = 0) {
    InputQueue& input = offscreen_->stage().input();
    input.mouse_move(at.x, at.y);
    frames(2);
    input.mouse_button(button, true);
    frames(2);
    input.mouse_button(button, false);
    frames(2);
  }
  void type(const std::string& text) {
    for (const char c : text) offscreen_->stage().input().character(static_cast<unsigned>(c));
    frames(static_cast<int>(text.size()) * 2 + 4);
  }

  test::TemporaryFolder folder_;
  std::string path_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<app::Offscreen> offscreen_;
  std::unique_ptr<Shell> shell_;
};

}  // namespace replan::ui
