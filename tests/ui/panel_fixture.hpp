// One panel on frames without a display, with a mouse and a keyboard: what clicks in it come to.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/platform/offscreen.hpp"
#include "ui/shell/panels.hpp"
#include "ui/tabs/cell_past.hpp"

namespace replan::ui {

/// One panel in a window of its own, with the commands that come of it.
class PanelTest : public testing::Test {
 protected:
  static constexpr int kWidth = 372, kHeight = 900;

  void open(const Scenario& scenario, const std::function<void(Frame&)>& panel) {
    session_ = std::make_unique<Session>(scenario);
    for (const auto& run : session_->runs()) run->finish(Target::end());
    session_->update(0);
    panel_ = panel;
    auto offscreen = app::Offscreen::create({kWidth, kHeight, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    offscreen_ = std::move(*offscreen);
    frames(2);
  }
  /// What draws a tab of the side panel.
  std::function<void(Frame&)> tab(std::string_view id) {
    return [number = tab_number(id)](Frame& frame) { frame.panels.tabs[number].draw(frame); };
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i)
      offscreen_->frame([this] {
        Wish wish = Wish::none;
        Frame frame{offscreen_->stage().look(), *session_, view_, panels_, commands_, wish};
        area("panel", {0, 0}, {kWidth, kHeight}, frame.look.theme.panel, {16, 12}, [&] { panel_(frame); });
      });
  }
  void move_to(float x, float y) {
    input().mouse_move(x, y);
    frames(1);
  }
  void click(float x, float y, int button = 0) {
    move_to(x, y);
    input().mouse_button(button, true);
    frames(1);
    input().mouse_button(button, false);
    frames(2);
  }
  void type(const char* text) {
    for (const char* c = text; *c != '\0'; ++c) {
      input().character(static_cast<unsigned char>(*c));
      frames(2);
    }
  }
  void press(int key) {
    input().key(key, true);
    frames(1);
    input().key(key, false);
    frames(2);
  }
  InputQueue& input() { return offscreen_->stage().input(); }

  /// Clicks down a column of the panel and returns the commands of one kind that it gave.
  template <class C>
  std::vector<C> sweep(float x, float step) {
    std::vector<C> found;
    for (float y = 4; y < kHeight; y += step) {
      commands_.clear();
      click(x, y);
      for (const Command& command : commands_)
        if (const C* each = std::get_if<C>(&command)) found.push_back(*each);
    }
    return found;
  }
  [[nodiscard]] const replan::Run& run() const { return session_->run(); }

  std::unique_ptr<Session> session_;
  std::unique_ptr<app::Offscreen> offscreen_;
  std::function<void(Frame&)> panel_;
  ViewState view_;
  PanelState panels_;
  CellPast past_;
  std::vector<Command> commands_;
};

}  // namespace replan::ui
