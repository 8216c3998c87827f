// A canvas on frames without a display, with scripted mouse input and the commands that come of it.
#pragma once

#include <gtest/gtest.h>

#include "app/platform/offscreen.hpp"
#include "core/scene/scene.hpp"
#include "ui/canvas/canvas.hpp"

namespace replan::ui {

inline constexpr int kCanvasWidth = 640, kCanvasHeight = 480;

/// A world of 20 x 10 free cells, drawn at 29 pixels a cell.
class CanvasTest : public testing::Test {
 protected:
  void SetUp() override {
    Scenario scenario;
    scenario.map = GridMap(20, 10);
    scenario.start = {2, 5};
    scenario.goal = {17, 5};
    scenario.planners = {{"dstar-lite", {}}};
    session_ = std::make_unique<Session>(scenario);
    session_->settle();
    choose_tool(state_, "paint");
    auto offscreen = app::Offscreen::create({kCanvasWidth, kCanvasHeight, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    offscreen_ = std::move(*offscreen);
    offscreen_->frame([this] { canvas_ = std::make_unique<Canvas>(offscreen_->stage().renderer()); });
    frame();
  }
  void TearDown() override {
    if (offscreen_) offscreen_->frame([this] { canvas_.reset(); });
  }

  void frame() {
    offscreen_->frame([this] {
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({kCanvasWidth, kCanvasHeight});
      ImGui::Begin("pane", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
      canvas_->draw(offscreen_->stage().look(), *session_, 0, state_, {0, 0}, {kCanvasWidth, kCanvasHeight},
                    true, commands_);
      ImGui::End();
    });
  }
  void move_to(Cell cell) {
    const Camera camera = canvas_->scene().camera;
    input().mouse_move(static_cast<float>((cell.x + 0.5 - camera.x) * camera.zoom + kCanvasWidth / 2.0),
                       static_cast<float>((cell.y + 0.5 - camera.y) * camera.zoom + kCanvasHeight / 2.0));
    frame();
  }
  void button(int which, bool down) {
    input().mouse_button(which, down);
    frame();
  }
  void drag(Cell from, Cell to, int which = 0) {
    move_to(from);
    button(which, true);
    move_to(to);
    button(which, false);
    frame();
  }
  InputQueue& input() { return offscreen_->stage().input(); }

  /// All cells of all commands of a kind, and the strokes they belong to.
  template <class C>
  std::vector<CellChange> cells_of(std::uint64_t* stroke = nullptr) const {
    std::vector<CellChange> cells;
    for (const Command& command : commands_)
      if (const C* each = std::get_if<C>(&command)) {
        cells.insert(cells.end(), each->cells.begin(), each->cells.end());
        if (stroke == nullptr) continue;
        EXPECT_TRUE(*stroke == 0 || *stroke == each->stroke);
        *stroke = each->stroke;
      }
    return cells;
  }

  std::unique_ptr<Session> session_;
  std::unique_ptr<app::Offscreen> offscreen_;
  std::unique_ptr<Canvas> canvas_;
  ViewState state_;
  std::vector<Command> commands_;
};

}  // namespace replan::ui
