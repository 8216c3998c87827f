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

}  // namespace
}  // namespace replan::ui::menus_test
