// What lies between the window's pixels and a film: the queue, and the part that is cut out.
#include "app/recording.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "app/film/frame_queue.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::app::recording_test {
namespace {

/// A picture of one grey, which tells it from others.
ui::Image grey(int width, int height, std::uint8_t value) {
  return {width, height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4,
                                    value)};
}

TEST(FrameQueue, HandsOnEveryFrameInOrder) {
  std::vector<std::uint8_t> taken;
  FrameQueue queue(
      [&](std::size_t number, const ui::Image& frame) {
        EXPECT_EQ(number, taken.size());
        taken.push_back(frame.rgba[0]);
        return Result<void>();
      },
      1);
  for (std::uint8_t i = 0; i < 100; ++i) ASSERT_TRUE(queue.push(grey(1, 1, i)).ok());
  ASSERT_TRUE(queue.finish().ok());
  ASSERT_EQ(taken.size(), 100u);
  EXPECT_TRUE(std::is_sorted(taken.begin(), taken.end()));
}

TEST(FrameQueue, ASlowTakerHoldsThePusherBack) {
  std::atomic<int> taken = 0;
  FrameQueue queue(
      [&](std::size_t, const ui::Image&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ++taken;
        return Result<void>();
      },
      2);
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(queue.push(grey(1, 1, 0)).ok());
    EXPECT_LE(i - taken, 8) << "frames pile up";
  }
  ASSERT_TRUE(queue.finish().ok());
  EXPECT_EQ(taken, 50);
}

TEST(FrameQueue, TellsTheTakersErrorAndTakesNoMore) {
  std::atomic<int> calls = 0;
  FrameQueue queue(
      [&](std::size_t number, const ui::Image&) {
        ++calls;
        return number == 3 ? Result<void>(Error{"full"}) : Result<void>();
      },
      1);
  Result<void> pushed;
  for (int i = 0; i < 1000 && pushed.ok(); ++i) pushed = queue.push(grey(1, 1, 0));
  ASSERT_FALSE(pushed.ok());
  EXPECT_EQ(pushed.error(), "full");
  const Result<void> finished = queue.finish();
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.error(), "full");
  EXPECT_EQ(calls, 4);
}

TEST(Recording, CutsOutTheCanvasWhateverItsSizeNow) {
  ui::Image picture = grey(4, 3, 0);
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) picture.rgba[i] = static_cast<std::uint8_t>(i / 4);
  const ui::Image part = cut_out(picture, {{1, 1}, {3, 3}}, 2, 2);
  EXPECT_EQ(part.at(0, 0)[0], 5);
  EXPECT_EQ(part.at(1, 1)[0], 10);
  EXPECT_EQ(part.at(1, 1)[3], 255) << "a film has no transparency";
  const ui::Image larger = cut_out(picture, {{1, 1}, {3, 3}}, 3, 3);
  EXPECT_EQ(larger.at(1, 1)[0], 10);
  EXPECT_EQ(larger.at(2, 2)[0], 0) << "black where nothing is";
  const ui::Image beyond = cut_out(picture, {{3, 2}, {9, 9}}, 3, 3);
  EXPECT_EQ(beyond.at(0, 0)[0], 11);
  EXPECT_EQ(beyond.at(1, 1)[0], 0);
  EXPECT_EQ(cut_out(picture, {{9, 9}, {12, 12}}, 1, 1).rgba, (std::vector<std::uint8_t>{0, 0, 0, 255}));
}

class Recorded : public testing::Test {
 protected:
  ui::CaptureRequest request(const std::string& name) const {
    return {ui::CaptureRequest::Kind::film, false, folder_.file(name), {.fps = 25}};
  }
  test::TemporaryFolder folder_;
  const ui::PixelArea area_{{0, 0}, {32, 16}};
};

TEST_F(Recorded, FramesIntoAFolder) {
  Recording recording(WorkPlace::beside());
  ASSERT_TRUE(recording.start(request("frames/"), area_).ok());
  EXPECT_TRUE(recording.on());
  EXPECT_DOUBLE_EQ(recording.step(), 0.04);
  for (int i = 0; i < 50; ++i) recording.take(grey(64, 48, static_cast<std::uint8_t>(i)), area_);
  EXPECT_DOUBLE_EQ(recording.state().seconds, 2);
  recording.stop();
  EXPECT_FALSE(recording.on());
  std::optional<FilmOutcome> outcome;
  for (int i = 0; i < 1000 && !outcome; ++i) {
    outcome = recording.outcome();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_TRUE(outcome.has_value());
  EXPECT_FALSE(outcome->bad) << outcome->sentence;
  EXPECT_NE(outcome->sentence.find("(50 frames)"), std::string::npos) << outcome->sentence;
  EXPECT_FALSE(recording.state().busy());
  const auto last = ui::read_image(folder_.file("frames/000049.png"));
  ASSERT_TRUE(last.ok());
  EXPECT_EQ(last->width, 32);
  EXPECT_EQ(last->at(31, 15)[0], 49);
}

TEST_F(Recorded, TheEndOfTheProgramCompletesTheFilm) {
  Recording recording(WorkPlace::beside());
  EXPECT_FALSE(recording.end().has_value());
  ASSERT_TRUE(recording.start(request("frames/"), area_).ok());
  recording.take(grey(64, 48, 7), area_);
  const auto outcome = recording.end();
  ASSERT_TRUE(outcome.has_value());
  EXPECT_NE(outcome->sentence.find("(1 frame)"), std::string::npos) << outcome->sentence;
}

TEST_F(Recorded, WithoutAFrameThereIsNoFilm) {
  Recording recording(WorkPlace::beside());
  const Result<void> started = recording.start(request("x.mp4"), area_);
  if (!started) GTEST_SKIP() << started.error();
  const auto outcome = recording.end();
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->sentence, "Nothing was recorded");
  EXPECT_EQ(folder_.entries(), 0);
}

TEST_F(Recorded, AFailureIsTold) {
  Recording recording(WorkPlace::beside());
  EXPECT_FALSE(recording.start(request("x.avi"), area_).ok());
  EXPECT_FALSE(recording.start(request("x.gif"), {{5, 5}, {5, 5}}).ok()) << "no canvas to be seen";
  ASSERT_TRUE(recording.start(request("frames/"), area_).ok());
  std::filesystem::remove_all(folder_.file("frames"));
  for (int i = 0; i < 100 && recording.on(); ++i) recording.take(grey(64, 48, 7), area_);
  EXPECT_FALSE(recording.on());
  const auto outcome = recording.outcome();
  ASSERT_TRUE(outcome.has_value());
  EXPECT_TRUE(outcome->bad);
  EXPECT_NE(outcome->sentence.find("png"), std::string::npos) << outcome->sentence;
}

}  // namespace
}  // namespace replan::app::recording_test
