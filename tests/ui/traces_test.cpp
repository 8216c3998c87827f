// A moment of a run through the clipboard and back, and its log into a file, in the window.
#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/export/case_text.hpp"
#include "tests/support/posthoc_check.hpp"
#include "tests/ui/gap_fixture.hpp"

namespace replan::ui::traces_test {
namespace {

class TracesTest : public GapTest {
 protected:
  void SetUp() override { begin(kGapWorld); }

  void run_to_end() {
    ASSERT_TRUE(session_->apply(RunToEnd{}).ok());
    session_->settle();
    frames(2);
  }
  [[nodiscard]] std::uint64_t state() const { return session_->run().timeline().state().hash(); }
};

TEST_F(TracesTest, AMomentIsCopiedAndPastedHashForHash) {
  ASSERT_TRUE(session_->apply(Lead{1}).ok());
  run_to_end();
  const std::size_t size = session_->run().timeline().size();
  for (const std::size_t position : {size - 3, size, size / 2, std::size_t{0}}) {
    ASSERT_TRUE(session_->apply(Seek{position}).ok());
    const std::uint64_t there = state();
    press('T', true, true);
    ASSERT_TRUE(is_case_text(ImGui::GetClipboardText()));
    // Elsewhere: another world in another window.
    Scenario other;
    other.map = GridMap(5, 5);
    other.goal = {4, 4};
    other.planners = {{"astar", {}}};
    ASSERT_TRUE(session_->apply(ReplaceScenario{other, ""}).ok());
    session_->settle();
    frames(2);
    press('V', true);
    rest();
    EXPECT_EQ(session_->run().timeline().cursor(), position);
    EXPECT_EQ(session_->lead(), 1u);
    EXPECT_EQ(session_->run().choice().id, "dstar-lite");
    EXPECT_EQ(state(), there);
    EXPECT_EQ(session_->file(), "");
    run_to_end();
    EXPECT_EQ(session_->run().timeline().size(), size);
  }
}

TEST_F(TracesTest, PastingAsksBeforeEditsAreLost) {
  press('T', true, true);
  ASSERT_TRUE(session_->apply(PaintCells{{{{5, 0}, true}}}).ok());
  session_->settle();
  ASSERT_TRUE(session_->modified());
  press('V', true);
  EXPECT_TRUE(session_->modified()) << "the question comes first";
  EXPECT_EQ(session_->file(), path_);
  press(key::kEscape);
  rest();
  EXPECT_TRUE(session_->modified());
}

TEST_F(TracesTest, ADamagedTextIsRefusedInASentence) {
  press('T', true, true);
  std::string text = ImGui::GetClipboardText();
  ImGui::SetClipboardText(text.substr(0, text.find("scenario {")).c_str());
  const Scenario before = session_->scenario();
  press('V', true);
  rest();
  EXPECT_EQ(session_->scenario(), before);
}

TEST_F(TracesTest, AnEventBeyondTheRunsEndIsTold) {
  press('T', true, true);
  std::string text = ImGui::GetClipboardText();
  const std::size_t at = text.find("\"event\":", text.find("\nat "));
  text.replace(at, 8, "\"event\":9");
  ImGui::SetClipboardText(text.c_str());
  press('V', true);
  rest();
  EXPECT_FALSE(shell_->wants_frames(*session_)) << "it does not wait for ever";
  EXPECT_GT(session_->run().timeline().size(), 100u) << "it has gone as far as it could";
}

TEST_F(TracesTest, TheTraceIsExportedByItsEnding) {
  ASSERT_TRUE(session_->apply(Lead{1}).ok());
  run_to_end();
  press('E', true, true);
  press('A', true);
  type(folder_.file("out.trace.yaml"));
  press(key::kEnter);
  rest();
  const auto yaml = read_file(folder_.file("out.trace.yaml"));
  ASSERT_TRUE(yaml.ok()) << yaml.error();
  EXPECT_EQ(test::PosthocCheck::check("out.trace.yaml", *yaml), "");
  EXPECT_TRUE(std::filesystem::exists(folder_.file("out.trace.map")));
  press('E', true, true);
  press('A', true);
  type(folder_.file("out.jsonl"));
  press(key::kEnter);
  rest();
  const auto lines = read_file(folder_.file("out.jsonl"));
  ASSERT_TRUE(lines.ok()) << lines.error();
  EXPECT_EQ(static_cast<std::size_t>(std::count(lines->begin(), lines->end(), '\n')),
            session_->run().timeline().size() + 1);
}

TEST_F(TracesTest, ANameWithoutAKnownEndingGetsTheChosenOne) {
  press('E', true, true);
  press('A', true);
  type(folder_.file("out.txt"));
  press(key::kEnter);
  rest();
  EXPECT_FALSE(std::filesystem::exists(folder_.file("out.txt")));
  EXPECT_TRUE(std::filesystem::exists(folder_.file("out.txt.trace.yaml")));
  press('B');
  EXPECT_EQ(shell_->view().tools.chosen_id(), "paint") << "keys are the window's again";
}

TEST_F(TracesTest, AnExportIsGivenUpWhenItsRunIsGone) {
  TraceExport writing;
  ASSERT_TRUE(writing.begin(*session_, folder_.file("x.jsonl"), false).ok());
  EXPECT_TRUE(writing.busy());
  Scenario other = session_->scenario();
  other.goal = {6, 2};
  ASSERT_TRUE(session_->apply(ReplaceScenario{other, ""}).ok());
  const auto outcome = writing.go_on(*session_);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_TRUE(outcome->bad);
  EXPECT_FALSE(writing.busy());
  EXPECT_FALSE(std::filesystem::exists(folder_.file("x.jsonl")));
  EXPECT_FALSE(writing.go_on(*session_).has_value());
}

TEST(TraceExportNames, TheMapHasANameOfItsOwn) {
  EXPECT_EQ(TraceExport::map_name("a/arena.trace.yaml"), "a/arena.trace.map");
  EXPECT_EQ(TraceExport::map_name("arena.trace.json"), "arena.trace.map");
}

}  // namespace
}  // namespace replan::ui::traces_test
