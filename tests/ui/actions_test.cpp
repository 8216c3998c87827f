// The table of actions: what menus, tooltips, the legend of keys and the key handling are made from.
#include "ui/shell/actions.hpp"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/keys.hpp"

namespace replan::ui::actions_test {
namespace {

TEST(Actions, StandAtTheirOwnNumber) {
  ASSERT_EQ(actions().size(), static_cast<std::size_t>(ActionId::count));
  for (std::size_t i = 0; i < actions().size(); ++i) EXPECT_EQ(static_cast<std::size_t>(actions()[i].id), i);
}

TEST(Actions, NoTwoChordsClash) {
  std::map<std::string, std::string> owners;
  for (const Action& each : actions()) {
    if (each.chord.key == 0) continue;
    const auto [owner, is_new] = owners.emplace(each.keys, each.name);
    EXPECT_TRUE(is_new) << each.keys << " is claimed by " << owner->second << " and by " << each.name;
  }
}

TEST(Actions, NoTwoChordsClashInAPage) {
  std::map<std::string, std::string> owners;
  for (const Action& each : actions()) {
    if (each.chord.key == 0) continue;
    const std::string keys = chord_text(chord_in_page(each.chord));
    EXPECT_TRUE(owners.emplace(keys, each.name).second)
        << each.name << " and " << owners[keys] << ": " << keys;
  }
  EXPECT_EQ(chord_text(chord_in_page(ctrl('T'))), "Alt+T");
  EXPECT_EQ(chord_text(chord_in_page(ctrl_shift('W'))), "Shift+Alt+W");
  EXPECT_EQ(chord_text(chord_in_page(ctrl('S'))), "Ctrl+S");
  EXPECT_EQ(words_in_page("Press **Ctrl+T**, or Ctrl+Shift+L; Ctrl+N."),
            "Press **Alt+T**, or Ctrl+Shift+L; Alt+N.");
}

TEST(Actions, HaveWordsThatTeach) {
  std::set<std::string> labels;
  for (const Action& each : actions()) {
    EXPECT_FALSE(each.label.empty()) << each.name;
    EXPECT_FALSE(each.teach.empty()) << each.name;
    EXPECT_NE(each.effect, nullptr) << each.name;
    EXPECT_TRUE(labels.insert(each.label).second) << "two actions are called " << each.label;
  }
}

TEST(Actions, EveryOverlayHasOne) {
  for (const OverlayInfo& info : overlays()) {
    ASSERT_NE(overlay_action(info.overlay), ActionId::count) << info.id;
    EXPECT_EQ(action(overlay_action(info.overlay)).label, info.label);
  }
}

TEST(Actions, EveryToolHasOneAndOneToolIsChosenAtFirst) {
  int at_first = 0;
  for (const ToolKind& kind : tool_kinds()) {
    EXPECT_EQ(action(tool_action(kind.id)).label, kind.label);
    EXPECT_NE(kind.make(), nullptr) << kind.id;
    at_first += kind.at_first ? 1 : 0;
  }
  EXPECT_EQ(at_first, 1);
}

TEST(Actions, EveryTabHasOneAndOneTabShowsAtFirst) {
  int at_first = 0;
  for (const TabKind& kind : tab_kinds()) {
    EXPECT_EQ(action(tab_action(kind.id)).label, kind.label);
    EXPECT_NE(kind.make(), nullptr) << kind.id;
    at_first += kind.at_first ? 1 : 0;
  }
  EXPECT_EQ(at_first, 1);
}

TEST(Actions, PromisedKeysLeadWhereTheyShould) {
  const auto keys = [](ActionId id) { return action(id).keys; };
  EXPECT_EQ(keys(ActionId::play), "Space");
  EXPECT_EQ(keys(ActionId::step_forward), "→");
  EXPECT_EQ(keys(ActionId::ten_back), "Shift+←");
  EXPECT_EQ(keys(ActionId::move_forward), "↑");
  EXPECT_EQ(keys(ActionId::replan_forward), "PgDn");
  EXPECT_EQ(keys(ActionId::line_back), "Shift+S");
  EXPECT_EQ(keys(ActionId::save_as), "Ctrl+Shift+S");
  EXPECT_EQ(keys(ActionId::keys), "F1");
  EXPECT_EQ(keys(ActionId::overlay_g), "1");
  EXPECT_EQ(keys(ActionId::breakpoint_back), ",");
  EXPECT_EQ(keys(ActionId::breakpoint_forward), ".");
}

/// A frame of ImGui with some keys down, without a window.
class Keyboard : public testing::Test {
 protected:
  Keyboard() : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    key::install(io);
    io.IniFilename = nullptr;
    io.DisplaySize = {100, 100};
    io.Fonts->Build();
    frame();  // keys that go down in the very first frame count as held before
  }
  ~Keyboard() override { ImGui::DestroyContext(context_); }

  std::vector<ActionId> frame() {
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = 0.01f;
    ImGui::NewFrame();
    std::vector<ActionId> pressed = pressed_actions(io);
    ImGui::EndFrame();
    return pressed;
  }
  std::vector<ActionId> press(int key) {
    ImGui::GetIO().KeysDown[key] = true;
    return frame();
  }

 private:
  ImGuiContext* context_;
};

TEST_F(Keyboard, AKeyIsItsAction) {
  EXPECT_EQ(press(key::kSpace), std::vector{ActionId::play});
}

TEST_F(Keyboard, ModifiersMustMatchExactly) {
  ImGui::GetIO().KeyCtrl = true;
  EXPECT_EQ(press('S'), std::vector{ActionId::save});
  ImGui::GetIO().KeysDown[static_cast<int>('S')] = false;
  frame();
  ImGui::GetIO().KeyCtrl = false;
  EXPECT_EQ(press('S'), std::vector{ActionId::line_forward});
}

TEST_F(Keyboard, IsOffWhileTextIsTyped) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeysDown[key::kSpace] = true;
  io.DeltaTime = 0.01f;
  ImGui::NewFrame();
  io.WantTextInput = true;
  EXPECT_TRUE(pressed_actions(io).empty());
  EXPECT_FALSE(key_is_held(io));
  ImGui::EndFrame();
}

TEST_F(Keyboard, AHeldKeyRepeatsOnlyWhereThatIsWanted) {
  press(key::kRight);
  press(key::kSpace);
  EXPECT_TRUE(key_is_held(ImGui::GetIO()));
  int steps = 0, plays = 0;
  for (int i = 0; i < 100; ++i)
    for (const ActionId id : frame()) {
      steps += id == ActionId::step_forward ? 1 : 0;
      plays += id == ActionId::play ? 1 : 0;
    }
  EXPECT_GT(steps, 5);
  EXPECT_EQ(plays, 0);
}

}  // namespace
}  // namespace replan::ui::actions_test
