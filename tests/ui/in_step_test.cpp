// The window without threads: what share of a frame planning has, and documents that are read between frames.
#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/world/library.hpp"
#include "tests/ui/shell_fixture.hpp"
#include "ui/shell/frame_share.hpp"

namespace replan::ui::in_step_test {
namespace {

TEST(FrameShare, IsThreeFifthsMoreForWhoWaitsAndLessForTheHand) {
  constexpr double kFrame = 1000.0 / 60;
  EXPECT_NEAR(share_of_frame({}), 0.6 * kFrame, 1e-9);
  EXPECT_GT(share_of_frame({.waited = true}), 0.8 * kFrame);
  EXPECT_LT(share_of_frame({.in_hand = true}), 0.4 * kFrame);
  EXPECT_LT(share_of_frame({.in_hand = true, .waited = true}), 0.4 * kFrame) << "the hand comes first";
}

TEST(FrameShare, GrowsWithSlowDrawingButNeverStopsTheWindow) {
  EXPECT_NEAR(share_of_frame({.drawing_ms = 12}), 18, 1e-9) << "three fifths of 30 ms";
  for (const double drawing : {0.0, 5.0, 50.0, 500.0})
    for (const bool in_hand : {false, true})
      for (const bool waited : {false, true}) {
        const double share = share_of_frame({drawing, in_hand, waited});
        EXPECT_GE(share, 5);
        EXPECT_LE(share, in_hand ? 10 : 50);
      }
}

std::string shipped(const char* name) {
  return *read_file(std::string(REPLAN_SOURCE_DIR "/maps/") + name);
}

class InStep : public ShellTest {
 protected:
  void open_in_step(const char* name) {
    open("first.json", shipped(name));
    session_ = std::make_unique<Session>(*read_scenario(path_), path_, RunLimits{}, WorkPlace::in_steps());
    shell_->documents().settle_in(*session_, {{}, REPLAN_SOURCE_DIR "/maps", session_->work()});
  }
};

TEST_F(InStep, PlansWithItsFramesAndSleepsThen) {
  open_in_step("demo.json");
  session_->set_share(0.5);
  EXPECT_TRUE(session_->run().busy());
  frames(1);
  EXPECT_TRUE(shell_->wants_frames(*session_));
  for (int i = 0; i < 10'000 && session_->run().busy(); ++i) frames(1);
  ASSERT_FALSE(session_->run().decisions().empty());
  for (int i = 0; i < 200 && shell_->wants_frames(*session_); ++i) frames(1);
  EXPECT_FALSE(shell_->wants_frames(*session_));
}

TEST_F(InStep, ReadsADocumentOnceAFrameHasSaidSo) {
  open_in_step("demo.json");
  frames(3);
  const std::string other = folder_.with("second.json", shipped("spiral.json"));
  shell_->documents().open(*session_, other);
  EXPECT_EQ(session_->file(), path_);
  EXPECT_TRUE(shell_->wants_frames(*session_)) << "or it would never be read";
  frames(1);
  EXPECT_EQ(session_->file(), path_) << "that frame says that it is read";
  frames(2);
  EXPECT_EQ(session_->file(), other);
  EXPECT_EQ(session_->scenario().name, read_scenario(other)->name);
}

TEST_F(InStep, LooksAtTheLibraryOneWorldAfterTheOther) {
  open_in_step("demo.json");
  WorldLibrary* library = shell_->documents().library();
  ASSERT_NE(library, nullptr);
  session_->set_share(0);
  library->refresh();
  std::size_t known = 0;
  for (int i = 0; i < 2000 && library->busy(); ++i) {
    frames(1);
    static_cast<void>(library->update());
    std::size_t now = 0;
    for (const LibraryWorld& world : library->worlds()) now += world.looked_at ? 1 : 0;
    EXPECT_LE(now, known + 1);
    known = now;
  }
  EXPECT_EQ(known, library_files(REPLAN_SOURCE_DIR "/maps").size());
}

}  // namespace
}  // namespace replan::ui::in_step_test
