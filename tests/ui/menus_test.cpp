// The menus of the bar: each of them fits into a small window, with its title in sight.
#include <imgui_internal.h>

#include "tests/ui/shell_fixture.hpp"
#include "ui/shell/gallery.hpp"

namespace replan::ui::menus_test {
namespace {

constexpr const char* kWorld =
    R"({"replan": 1, "name": "Hall", "map": {"rows": ["..........", ".........."]}, "start": [0, 0], "goal": [9, 1],
        "planners": [{"id": "dstar-lite"}, {"id": "astar"}]})";

class MenusTest : public ShellTest {
 protected:
  /// The tallest of the menus that are open.
  float height() {
    float tallest = 0;
    offscreen_->frame([&] {
      shell_->draw(offscreen_->stage().look(), *session_, 0);
      for (const ImGuiPopupData& popup : ImGui::GetCurrentContext()->OpenPopupStack)
        if (popup.Window != nullptr) tallest = std::max(tallest, popup.Window->Size.y);
    });
    return tallest;
  }
};

TEST_F(MenusTest, NoneIsTallerThan700) {
  open("hall.json", kWorld, 1440, 1600);  // tall enough for any menu to be as tall as it wants
  int menus = 0;
  for (const std::string_view name : gallery_names()) {
    if (!name.starts_with("menu_")) continue;
    shell_->show_dialog(name, *session_);
    frames(8);
    EXPECT_GT(height(), 60) << name << " did not open";
    EXPECT_LT(height(), 700) << name;
    press(key::kEscape);
    press(key::kEscape);
    ++menus;
  }
  EXPECT_GT(menus, 10);
}

TEST_F(MenusTest, WhatToolsOpenStaysInTheWindow) {
  struct Case {
    int width, height;
    ImVec2 tool;
    float least;  // how high it is
  };
  for (const Case& each : {Case{1280, 800, {24, 478}, 300}, Case{1280, 560, {24, 264}, 300},
                           Case{390, 844, {313, 55}, 300}, Case{390, 844, {277, 55}, 60}}) {
    open("hall.json", kWorld, each.width, each.height);
    click(each.tool);
    frames(6);
    const std::string what = std::to_string(each.width) + " x " + std::to_string(each.height) + " at " +
                             std::to_string(each.tool.x);
    ImVec2 min, max;
    offscreen_->frame([&] {
      shell_->draw(offscreen_->stage().look(), *session_, 0);
      const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
      if (popups.empty() || popups.back().Window == nullptr) return;
      min = popups.back().Window->Pos;
      const ImVec2 size = popups.back().Window->Size;
      max = {min.x + size.x, min.y + size.y};
    });
    EXPECT_GT(max.y - min.y, each.least) << what << " did not open";
    EXPECT_GE(min.x, 0) << what;
    EXPECT_GE(min.y, 0) << what;
    EXPECT_LE(max.x, static_cast<float>(each.width)) << what;
    EXPECT_LE(max.y, static_cast<float>(each.height)) << what;
    offscreen_->frame([this] { shell_.reset(); });
  }
}

}  // namespace
}  // namespace replan::ui::menus_test
