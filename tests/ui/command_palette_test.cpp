// The command palette: what comes first, and how it is used by keyboard.
#include "ui/shell/command_palette.hpp"

#include <gtest/gtest.h>

#include "app/platform/offscreen.hpp"
#include "core/plan/glossary.hpp"
#include "ui/keys.hpp"
#include "ui/shell/shell.hpp"

namespace replan::ui {
namespace {

std::vector<PaletteEntry> entries_of(const std::vector<std::string>& labels) {
  std::vector<PaletteEntry> entries;
  for (const std::string& label : labels)
    entries.push_back(
        {.id = label, .label = label, .place = {}, .keys = {}, .teach = {}, .reason = {}, .effect = {}});
  return entries;
}

std::vector<std::string> found(const std::vector<std::string>& labels, std::string_view typed,
                               const std::vector<std::string>& used = {}) {
  const std::vector<PaletteEntry> entries = entries_of(labels);
  std::vector<std::string> order;
  for (const PaletteHit& hit : palette_hits(entries, typed, used)) order.push_back(entries[hit.entry].label);
  return order;
}

using Labels = std::vector<std::string>;

TEST(PaletteHits, WithoutLettersWhatWasUsedLastComesFirst) {
  EXPECT_EQ(found({"Open…", "Save", "Undo"}, ""), (Labels{"Open…", "Save", "Undo"}));
  EXPECT_EQ(found({"Open…", "Save", "Undo"}, "", {"Undo", "Save"}), (Labels{"Undo", "Save", "Open…"}));
}

TEST(PaletteHits, WhatWasUsedLastIsPreferredAmongEqualsOnly) {
  EXPECT_EQ(found({"Turn left", "Turn right"}, "turn", {"Turn right"}), (Labels{"Turn right", "Turn left"}));
  EXPECT_EQ(found({"Save", "Show values of every cell"}, "save", {"Show values of every cell"}).front(),
            "Save");
}

TEST(PaletteHits, LeavesOutWhatDoesNotMatch) {
  EXPECT_EQ(found({"Open…", "Save", "Undo"}, "xyz"), Labels{});
}

class PaletteTest : public testing::Test {
 protected:
  void SetUp() override {
    Scenario scenario;
    scenario.map = GridMap(20, 10);
    scenario.start = {2, 5};
    scenario.goal = {17, 5};
    scenario.planners = {{"dstar-lite", {}}};
    session_ = std::make_unique<Session>(scenario);
    session_->settle();
    auto offscreen = app::Offscreen::create({1280, 800, 1});
    ASSERT_TRUE(offscreen.ok()) << offscreen.error();
    offscreen_ = std::move(*offscreen);
    offscreen_->frame([this] { shell_ = std::make_unique<Shell>(offscreen_->stage().renderer()); });
    frames(2);
  }
  void TearDown() override {
    if (offscreen_) offscreen_->frame([this] { shell_.reset(); });
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i)
      offscreen_->frame([this] {
        session_->update(0);
        shell_->draw(offscreen_->stage().look(), *session_, 0);
      });
  }
  void press(int key, bool ctrl = false) {
    InputQueue& input = offscreen_->stage().input();
    if (ctrl) input.key(key::kLeftControl, true);
    input.key(key, true);
    frames(5);
    input.key(key, false);
    if (ctrl) input.key(key::kLeftControl, false);
    frames(5);
  }
  void type(const std::string& text) {
    for (const char c : text) offscreen_->stage().input().character(static_cast<unsigned>(c));
    frames(static_cast<int>(text.size()) * 2 + 4);
  }
  [[nodiscard]] static bool open() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup); }

  std::unique_ptr<Session> session_;
  std::unique_ptr<app::Offscreen> offscreen_;
  std::unique_ptr<Shell> shell_;
};

TEST_F(PaletteTest, CarriesOutTheBestHitOnEnter) {
  press('P', true);
  type("two panes");
  press(key::kEnter);
  EXPECT_EQ(session_->runs().size(), 2u);
  press('P', true);
  type("dldl");
  press(key::kEnter);
  EXPECT_EQ(session_->run().choice().id, "dld-star-lite");
}

TEST_F(PaletteTest, KeysAreOffWhileTyping) {
  const bool dark = shell_->view().dark, panels = shell_->view().panels;
  const Tool tool = shell_->view().tool;
  press('P', true);
  for (const int key : std::initializer_list<int>{'T', 'E', 'V', '1', key::kTab}) press(key);
  EXPECT_EQ(shell_->view().dark, dark);
  EXPECT_EQ(shell_->view().panels, panels);
  EXPECT_EQ(shell_->view().tool, tool);
  press(key::kEscape);
  press('T');
  EXPECT_NE(shell_->view().dark, dark) << "and on again afterwards";
}

TEST_F(PaletteTest, ArrowsChooseAndEscapeCloses) {
  const bool dark = shell_->view().dark;
  press('P', true);
  type("light or dark");
  press(key::kDown);
  press(key::kUp);
  press(key::kEnter);
  EXPECT_NE(shell_->view().dark, dark);
  press('P', true);
  type("light or dark");
  press(key::kEscape);
  EXPECT_NE(shell_->view().dark, dark) << "nothing was done";
  press(key::kSpace);
  EXPECT_NE(session_->playback().direction, 0) << "the keys are the window's again";
}

TEST_F(PaletteTest, WhatCannotBeDoneIsNotDoneAndSaysWhy) {
  offscreen_->frame([this] {
    std::vector<Command> commands;
    Wish wish = Wish::none;
    Frame frame{offscreen_->stage().look(), *session_, shell_->view(), shell_->panels(), commands, wish};
    int disabled = 0;
    for (const PaletteEntry& entry : palette_entries(frame, nullptr)) {
      EXPECT_FALSE(entry.label.empty());
      if (entry.id == "undo") {
        EXPECT_EQ(entry.reason, "no edit was made");
      }
      disabled += entry.enabled ? 0 : 1;
    }
    EXPECT_GT(disabled, 3);
  });
  press('P', true);
  type("undo");
  press(key::kEnter);
  type("x");
  EXPECT_TRUE(session_->undo_text().empty());
}

TEST_F(PaletteTest, HoldsEveryActionPlannerAndTermOnce) {
  offscreen_->frame([this] {
    std::vector<Command> commands;
    Wish wish = Wish::none;
    Frame frame{offscreen_->stage().look(), *session_, shell_->view(), shell_->panels(), commands, wish};
    std::map<std::string, int> ids;
    for (const PaletteEntry& entry : palette_entries(frame, nullptr)) ++ids[entry.id];
    for (const auto& [id, count] : ids) EXPECT_EQ(count, 1) << id;
    for (const Action& each : actions())
      EXPECT_TRUE(each.id == ActionId::palette || ids.contains(each.name)) << each.name;
    for (const PlannerInfo& info : planners()) EXPECT_TRUE(ids.contains("planner " + std::string(info.id)));
    for (const GlossaryTerm& term : glossary()) EXPECT_TRUE(ids.contains("term " + std::string(term.id)));
  });
}

}  // namespace
}  // namespace replan::ui
