// The command palette: what comes first, and how it is used by keyboard.
#include "ui/shell/command_palette.hpp"

#include <gtest/gtest.h>

#include "core/plan/glossary.hpp"
#include "core/world/choices.hpp"
#include "tests/ui/shell_fixture.hpp"

namespace replan::ui::command_palette_test {
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

constexpr const char* kWorld = R"({"replan": 1, "name": "Room", "map": {"rows": ["..........", ".........."]},
    "start": [0, 0], "goal": [9, 1], "planners": [{"id": "dstar-lite"}]})";

class PaletteTest : public ShellTest {
 protected:
  void SetUp() override { open("room.json", kWorld); }
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
  const std::string_view tool = shell_->view().tools.chosen_id();
  press('P', true);
  for (const int key : std::initializer_list<int>{'T', 'E', 'V', '1', key::kTab}) press(key);
  EXPECT_EQ(shell_->view().dark, dark);
  EXPECT_EQ(shell_->view().panels, panels);
  EXPECT_EQ(shell_->view().tools.chosen_id(), tool);
  press(key::kEscape);
  press('T');
  EXPECT_NE(shell_->view().dark, dark) << "and on again afterwards";
}

TEST_F(PaletteTest, ArrowsChooseAndEscapeCloses) {
  const bool dark = shell_->view().dark;
  press('P', true);
  type("light theme");
  press(key::kDown);
  press(key::kUp);
  press(key::kEnter);
  EXPECT_NE(shell_->view().dark, dark);
  press('P', true);
  type("light theme");
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

TEST_F(PaletteTest, FewLettersAreNotFoundScatteredOverWords) {
  offscreen_->frame([this] {
    std::vector<Command> commands;
    Wish wish = Wish::none;
    Frame frame{offscreen_->stage().look(), *session_, shell_->view(), shell_->panels(), commands, wish};
    const std::vector<PaletteEntry> entries = palette_entries(frame, nullptr);
    const auto found = palette_hits(entries, "rhs", {});
    ASSERT_FALSE(found.empty());
    for (const PaletteHit& hit : found)
      EXPECT_NE(entries[hit.entry].label.find("rhs"), std::string::npos) << entries[hit.entry].label;
    EXPECT_FALSE(palette_hits(entries, "dld", {}).empty());
    EXPECT_FALSE(palette_hits(entries, "cow", {}).empty()) << "Colours, Copy the world: beginnings of words";
  });
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
      EXPECT_TRUE(each.rules.unlisted || ids.contains(each.name)) << each.name;
    for (const PlannerInfo& info : choices()) EXPECT_TRUE(ids.contains("planner " + std::string(info.id)));
    for (const GlossaryTerm& term : glossary()) EXPECT_TRUE(ids.contains("term " + std::string(term.id)));
  });
}

}  // namespace
}  // namespace replan::ui::command_palette_test
