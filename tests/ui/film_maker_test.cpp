// Films of a part of the run, made between the frames of a window.
#include "app/film_maker.hpp"

#include <filesystem>
#include <map>

#include "core/base/file.hpp"
#include "tests/ui/shell_fixture.hpp"

namespace replan::app::film_maker_test {
namespace {

constexpr const char* kWorld =
    R"({"replan": 1, "name": "Hall", "map": {"rows": ["..........", "..........", ".........."]},
    "start": [0, 1], "goal": [9, 1], "planners": [{"id": "dstar-lite"}],
    "surprises": [{"at": {"near": [3, 1], "within": 1}, "add": {"rectangles": [[5, 1, 1, 1]]}}]})";

class FilmMakerTest : public ui::ShellTest {
 protected:
  void SetUp() override { open("hall.json", kWorld, 640, 480); }

  ui::CaptureRequest request(ui::FilmPart part) {
    ui::CaptureRequest wanted;
    wanted.path = folder_.file("frames") + "/";
    wanted.film = {.part = part, .width = 96, .height = 64, .fps = 10, .speed = {FilmSpeed::Kind::move, 0}};
    return wanted;
  }
  FilmSet set() { return {filmed_view(shell_->view()), 0, {{0, 0}, {640, 480}}, 1}; }
  /// Makes the film to its end; the error, or what there is to say of it.
  std::string make(const ui::CaptureRequest& wanted) {
    if (const auto begun = maker_.begin(wanted, set(), *session_); !begun) return begun.error();
    for (int i = 0; i < 2000 && maker_.on(); ++i) {
      session_->settle();
      if (const auto made = maker_.go_on(*session_); !made) return made.error();
      EXPECT_LE(maker_.share(), 1);
    }
    EXPECT_FALSE(maker_.on());
    const auto outcome = recording_.end();
    return outcome ? outcome->sentence : "";
  }
  std::size_t pictures() {
    std::error_code failed;
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_.file("frames"), failed),
                      std::filesystem::directory_iterator()));
  }

  Recording recording_{WorkPlace::beside()};
  FilmMaker maker_{recording_};
};

TEST_F(FilmMakerTest, TheWholeRunIsFilmedFromWhereverThePlayheadStands) {
  ASSERT_TRUE(session_->apply(Seek{5}).ok());
  const std::string said = make(request(ui::FilmPart::whole));
  EXPECT_EQ(session_->run().timeline().cursor(), 5u);
  const auto frames = ui::film_frames(request(ui::FilmPart::whole).film, session_->run());
  ASSERT_TRUE(frames.ok()) << frames.error();
  EXPECT_EQ(pictures(), frames->size());
  EXPECT_NE(said.find(std::to_string(frames->size()) + " frames"), std::string::npos) << said;
}

TEST_F(FilmMakerTest, WhoeverAskedForItGoesOnLookingAtWhatTheyWant) {
  ASSERT_TRUE(session_->apply(Seek{5}).ok());
  const ui::CaptureRequest wanted = request(ui::FilmPart::whole);
  ASSERT_TRUE(maker_.begin(wanted, set(), *session_).ok());
  for (std::size_t at = 5; at < 15; ++at) {
    session_->settle();
    EXPECT_EQ(session_->run().timeline().cursor(), at);
    ASSERT_TRUE(maker_.go_on(*session_).ok());
    ASSERT_TRUE(maker_.on());
    EXPECT_EQ(session_->run().timeline().cursor(), at) << "the film plays in the window";
    ASSERT_TRUE(session_->apply(Seek{at + 1}).ok());
  }
  ASSERT_TRUE(session_->apply(Play{1}).ok());
  ASSERT_TRUE(maker_.go_on(*session_).ok());
  EXPECT_EQ(session_->playback().direction, 1) << "the film stops the playing";
  maker_.cancel();
}

TEST_F(FilmMakerTest, ThePlayheadStaysAtTheFirstPlanWhileTheRunGoesOnForTheFilm) {
  const std::size_t plan = session_->run().timeline().size();
  ASSERT_TRUE(session_->apply(Seek{plan}).ok());
  ASSERT_TRUE(maker_.begin(request(ui::FilmPart::whole), set(), *session_).ok());
  for (int i = 0; i < 5; ++i) {
    session_->settle();
    static_cast<void>(session_->update(0.02));
    ASSERT_TRUE(maker_.go_on(*session_).ok());
    EXPECT_EQ(session_->run().timeline().cursor(), plan);
  }
  EXPECT_GT(session_->run().timeline().size(), plan);
  maker_.cancel();
}

/// Who leads in the film is who led when it was asked for.
TEST_F(FilmMakerTest, AnotherPaneMayLeadMeanwhile) {
  ASSERT_TRUE(session_->apply(SetPanes{2}).ok());
  session_->settle();
  ASSERT_TRUE(session_->apply(ChoosePlanner{1, "dijkstra"}).ok());
  session_->settle();
  const auto bytes_of_all = [&] {
    std::map<std::string, std::string> bytes;
    for (const auto& each : std::filesystem::directory_iterator(folder_.file("frames")))
      bytes[each.path().filename()] = *read_file(each.path());
    return bytes;
  };
  const ui::CaptureRequest wanted = request(ui::FilmPart::whole);
  make(wanted);
  const auto undisturbed = bytes_of_all();
  ASSERT_TRUE(maker_.begin(wanted, set(), *session_).ok());
  for (int i = 0; i < 2000 && maker_.on(); ++i) {
    ASSERT_TRUE(session_->apply(Lead{static_cast<std::size_t>(i) % 2}).ok());
    session_->settle();
    const auto made = maker_.go_on(*session_);
    ASSERT_TRUE(made.ok()) << made.error();
    EXPECT_EQ(session_->lead(), static_cast<std::size_t>(i) % 2) << "the film takes the lead away";
  }
  static_cast<void>(recording_.end());
  EXPECT_GT(undisturbed.size(), 5u);
  EXPECT_TRUE(bytes_of_all() == undisturbed);
}

TEST_F(FilmMakerTest, AReplanIsFilmedFromItsBeginningToItsEnd) {
  ASSERT_TRUE(session_->apply(RunToEnd{}).ok());
  session_->settle();
  const auto end = moment_position(session_->run(), "replan:1");
  ASSERT_TRUE(end.ok());
  ASSERT_TRUE(session_->apply(Seek{*end}).ok());
  EXPECT_EQ(ui::part_words(ui::FilmPart::replan, session_->run()), "Replan 1");
  const auto frames = ui::film_frames({.part = ui::FilmPart::replan}, session_->run());
  ASSERT_TRUE(frames.ok()) << frames.error();
  EXPECT_EQ(frames->back().position, *end);
  EXPECT_GT(frames->front().position, *moment_position(session_->run(), "plan"));
  EXPECT_NE(make(request(ui::FilmPart::replan)), "");
  EXPECT_GT(pictures(), 0u);
  ASSERT_TRUE(session_->apply(Seek{3}).ok());
  EXPECT_EQ(ui::part_words(ui::FilmPart::replan, session_->run()), "The first plan");
}

TEST_F(FilmMakerTest, GivenUpOrDisturbedItLeavesNoFile) {
  ui::CaptureRequest wanted = request(ui::FilmPart::whole);
  wanted.path = folder_.file("film.gif");
  ASSERT_TRUE(maker_.begin(wanted, set(), *session_).ok());
  for (int i = 0; i < 3; ++i) {
    session_->settle();
    ASSERT_TRUE(maker_.go_on(*session_).ok());
  }
  maker_.cancel();
  EXPECT_FALSE(recording_.on());
  EXPECT_FALSE(std::filesystem::exists(wanted.path));
  ASSERT_TRUE(maker_.begin(wanted, set(), *session_).ok());
  ASSERT_TRUE(session_->apply(Restart{}).ok());
  session_->settle();
  const auto disturbed = maker_.go_on(*session_);
  ASSERT_FALSE(disturbed.ok());
  EXPECT_NE(disturbed.error().find("the run has changed"), std::string::npos);
  EXPECT_FALSE(maker_.on());
  EXPECT_FALSE(std::filesystem::exists(wanted.path));
}

}  // namespace
}  // namespace replan::app::film_maker_test
