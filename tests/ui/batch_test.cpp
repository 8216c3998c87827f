// Batches in the whole window: begun, stopped and gone on with, looked through, and a run of one opened.
#include <chrono>
#include <filesystem>
#include <thread>

#include "core/base/file.hpp"
#include "core/base/lock_file.hpp"
#include "core/experiment/results_folder.hpp"
#include "core/experiment/results_text.hpp"
#include "tests/support/experiments.hpp"
#include "tests/ui/shell_fixture.hpp"

namespace replan::ui::batch_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHall = R"({
  "replan": 1, "name": "Hall", "seed": 3,
  "map": {"rows": [
    "................",
    "................",
    "......@.........",
    "......@.........",
    "......@.........",
    "......@.........",
    "................",
    "................"]},
  "start": [1, 4], "goal": [14, 4],
  "planners": [{"id": "dstar-lite"}, {"id": "weighted-astar", "settings": {"weight": 2}}]
})";

std::string text_of(const std::string& path) {
  const auto text = read_file(path);
  return text ? *text : "";
}

/// The experiment that is in a folder, as the command line would load it.
RunList list_in(const std::string& folder) {
  auto experiment = read_experiment(folder + "/experiment.json");
  EXPECT_TRUE(experiment) << (experiment ? "" : experiment.error());
  auto list = RunList::load(std::move(experiment.value()));
  EXPECT_TRUE(list) << (list ? "" : list.error());
  return std::move(list.value());
}

// Where things are in a window of 1280 x 800.
const ImVec2 kOpenExperiment{370, 182}, kSaveExperiment{574, 182}, kFirstButton{82, 93},
    kSecondButton{176, 93}, kChooseFolder{870, 560}, kChoose{1080, 700}, kLengthHead{720, 369},
    kFirstRow{400, 392};

class BatchTest : public ShellTest {
 protected:
  void open_hall(const WorkPlace& work = {}) {
    open("hall.json", kHall, 1280, 800);
    shell_->documents().settle_in(*session_, {"", folder_.file("library"), work});
    frames(2);
  }
  void close() {
    offscreen_->frame([this] { shell_.reset(); });
    offscreen_.reset();
  }
  void show() {
    shell_->perform_next(ActionId::batch);
    frames(3);
    ASSERT_TRUE(shell_->batch().open());
  }
  /// In the file dialog that a click has just opened.
  void choose(const std::string& path) {
    frames(8);
    type(path);
    press(key::kEnter);
    frames(4);
  }
  [[nodiscard]] std::string results() const { return folder_.file("hall-batch"); }
  /// Goes on drawing until it is so, or for some seconds at most.
  template <class Condition>
  bool wait_until(Condition condition) {
    for (int i = 0; i < 1200 && !condition(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      frames(1);
    }
    return condition();
  }
};

TEST_F(BatchTest, RunsThePanesPlannersAndItsResultsAreThoseOfTheEngine) {
  open_hall();
  show();
  press(key::kEnter);
  ASSERT_EQ(shell_->batch().error(), "");
  EXPECT_EQ(shell_->batch().table().count(), 2u) << "nothing is drawn by chance: one run for each planner";
  const RunList list = list_in(results());
  EXPECT_EQ(list.experiment().planners, session_->scenario().planners);
  EXPECT_EQ(list.experiment().seeds.size(), 5u);
  EXPECT_EQ(text_of(results() + "/results.csv"), results_csv(test::results_of(list)));
}

TEST_F(BatchTest, GoesOnWithWhatTheFolderHas) {
  open_hall();
  show();
  press(key::kEnter);
  const std::string whole = text_of(results() + "/results.csv");
  // As if it had been stopped after its first run.
  const std::string journal = text_of(results() + "/runs.jsonl");
  const std::string first = journal.substr(0, journal.find('\n') + 1);
  fs::remove(results() + "/results.csv");
  ASSERT_TRUE(write_file_atomically(results() + "/runs.jsonl", first));
  close();
  open_hall();
  show();
  press(key::kEnter);
  EXPECT_EQ(shell_->batch().error(), "");
  EXPECT_EQ(shell_->batch().table().count(), 2u);
  EXPECT_EQ(text_of(results() + "/results.csv"), whole);
  EXPECT_EQ(text_of(results() + "/runs.jsonl").substr(0, first.size()), first)
      << "the run that was kept is not made again";
}

TEST_F(BatchTest, GoesOnInTheBackgroundWhileItsDialogIsClosed) {
  open_hall({.in_step = false, .wake = {}});
  show();
  press(key::kEnter);
  press(key::kEscape);
  EXPECT_FALSE(shell_->batch().open());
  ASSERT_TRUE(wait_until([this] { return fs::exists(results() + "/results.csv"); }));
  ASSERT_TRUE(wait_until([this] { return !shell_->panels().batch; }));
  EXPECT_EQ(shell_->batch().table().count(), 2u);
  EXPECT_EQ(text_of(results() + "/results.csv"), results_csv(test::results_of(list_in(results()))));
}

TEST_F(BatchTest, EnterOpensTheRunThatIsChosenAndItIsTheEnginesScenario) {
  open_hall();
  show();
  press(key::kEnter);
  press(key::kDown);
  press(key::kDown);
  press(key::kEnter);
  EXPECT_FALSE(shell_->batch().open());
  const RunList list = list_in(results());
  const Scenario expected = list.scenario(list.parts(1));
  EXPECT_EQ(session_->scenario().map, expected.map);
  EXPECT_EQ(session_->scenario().planners, expected.planners);
  EXPECT_EQ(session_->scenario().robot, expected.robot);
  EXPECT_EQ(session_->scenario().seed, expected.seed);
  EXPECT_EQ(session_->scenario().start, expected.start);
  EXPECT_EQ(session_->scenario().goal, expected.goal);
  EXPECT_EQ(session_->runs().size(), 1u);
  EXPECT_EQ(session_->file(), "");
  // The table is still there.
  show();
  EXPECT_EQ(shell_->batch().table().count(), 2u);
}

TEST_F(BatchTest, AClickOpensARunOnceUnsavedWorkIsDealtWith) {
  open_hall();
  show();
  press(key::kEnter);
  press(key::kEscape);
  ASSERT_TRUE(session_->apply(PaintCells{{{{3, 3}, true}}, 1}));
  show();
  press(key::kDown);
  press(key::kEnter);
  EXPECT_FALSE(shell_->batch().open());
  EXPECT_EQ(session_->runs().size(), 2u) << "the edits are asked about first";
  EXPECT_TRUE(session_->modified());
  press(key::kEscape);
  EXPECT_EQ(session_->runs().size(), 2u);
  EXPECT_TRUE(session_->modified());
}

/// Sixty runs with blocks that drop ahead of the robot, in a file.
constexpr const char* kSixty =
    R"({"format": "replan experiment", "version": 1, "name": "Sixty", "drive": true,
  "planners": [{"id": "dstar-lite"}, {"id": "astar"}, {"id": "weighted-astar"}], "worlds": ["hall.json"],
  "surprises": [{"blocks": 2, "side": 2, "ahead": 5}], "seeds": {"from": 1, "count": 20}})";

class BatchOfAFile : public BatchTest {
 protected:
  /// Each run is made so many times over.
  void open_sixty(const WorkPlace& work = {}, int repeat = 1) {
    open_hall(work);
    const std::string times = R"({"repeat": )" + std::to_string(repeat) + ", ";
    sixty_ = folder_.with("sixty.json", times + std::string(kSixty).substr(1));
    show();
    click(kOpenExperiment);
    choose(sixty_);
    press(key::kEnter);
    ASSERT_EQ(shell_->batch().error(), "");
  }
  [[nodiscard]] std::string out() const { return folder_.file("sixty-results"); }
  /// Repeats are for times alone.
  [[nodiscard]] RunList engine() const {
    Experiment experiment = *read_experiment(sixty_);
    experiment.repeat = 1;
    return *RunList::load(std::move(experiment));
  }

  std::string sixty_;
};

TEST_F(BatchOfAFile, IsRunAsTheEngineRunsIt) {
  open_sixty();
  EXPECT_EQ(shell_->batch().table().count(), 60u);
  EXPECT_EQ(shell_->batch().table().summaries().size(), 3u);
  EXPECT_EQ(text_of(out() + "/results.csv"), results_csv(test::results_of(engine())));
}

TEST_F(BatchOfAFile, StopsAndGoesOn) {
  if (!kThreads) GTEST_SKIP() << "in step a job is at work when somebody does it: steps_test.cpp";
  // Many times over, so that it is not done before the mouse is there.
  open_sixty({.in_step = false, .wake = {}}, 500);
  ASSERT_TRUE(wait_until([this] { return shell_->batch().table().count() > 0; }));
  click(kFirstButton);
  frames(4);
  click(kSecondButton);
  ASSERT_TRUE(wait_until([this] { return !shell_->batch().at_work(); }));
  EXPECT_EQ(shell_->batch().error(), "");
  const std::size_t kept = shell_->batch().table().count();
  ASSERT_LT(kept, 60u) << "it was done before it could be stopped";
  EXPECT_FALSE(fs::exists(out() + "/results.csv"));
  click(kFirstButton);
  ASSERT_TRUE(wait_until([this] { return fs::exists(out() + "/results.csv"); }));
  ASSERT_TRUE(wait_until([this] { return !shell_->batch().at_work(); }));
  EXPECT_EQ(shell_->batch().table().count(), 60u);
  EXPECT_EQ(text_of(out() + "/results.csv"), results_csv(test::results_of(engine())));
}

TEST_F(BatchOfAFile, AClickOnAColumnSortsAndOneOnARowOpensItsRun) {
  open_sixty();
  click(kLengthHead);
  EXPECT_EQ(shell_->batch().table().order(), BatchColumn::length);
  EXPECT_FALSE(shell_->batch().table().descending());
  click(kLengthHead);
  EXPECT_TRUE(shell_->batch().table().descending());
  const auto length = [this](std::size_t row) {
    return shell_->batch().table().row(row).number(BatchColumn::length).value_or(0);
  };
  const BatchRow first = shell_->batch().table().row(0);
  for (std::size_t i = 1; i < 60; ++i) EXPECT_GE(length(i - 1), length(i));
  click(kFirstRow);
  EXPECT_FALSE(shell_->batch().open());
  const RunList list = engine();
  const Scenario expected = list.scenario(list.parts(first.run));
  ASSERT_FALSE(expected.surprises.empty());
  EXPECT_EQ(session_->scenario().surprises, expected.surprises);
  EXPECT_EQ(session_->scenario().planners, expected.planners);
  EXPECT_EQ(session_->scenario().map, expected.map);
  EXPECT_EQ(session_->scenario().seed, expected.seed);
  // Driven to its end in the window it comes to the same figures.
  ASSERT_TRUE(session_->apply(Step{StepUnit::mission, 1}));
  session_->settle();
  const Decision* last = session_->run().decision_at(session_->run().timeline().cursor());
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->state, MissionState::arrived);
  EXPECT_DOUBLE_EQ(last->figures.travelled, first.number(BatchColumn::length).value_or(0));
}

TEST_F(BatchTest, SavesAnExperimentThatMakesTheSameRunsElsewhere) {
  open_hall();
  show();
  click(kSaveExperiment);
  choose(folder_.file("saved.json"));
  const auto saved = read_experiment(folder_.file("saved.json"));
  ASSERT_TRUE(saved) << saved.error();
  const auto list = RunList::load(*saved);
  ASSERT_TRUE(list) << list.error();
  press(key::kEnter);  // starts the batch
  EXPECT_EQ(shell_->batch().error(), "");
  EXPECT_EQ(text_of(results() + "/results.csv"), results_csv(test::results_of(*list)));
  EXPECT_EQ(list->digest(), list_in(results()).digest());
}

/// Opened in whichever way, an experiment is no document: the world that is open stays, and nobody is asked about it.
TEST_F(BatchOfAFile, OpenedAsAFileIsShownInTheBatchDialog) {
  open_hall();
  sixty_ = folder_.with("sixty.json", kSixty);
  ASSERT_TRUE(session_->apply(PaintCells{{{{3, 3}, true}}, 1}));
  shell_->documents().open(*session_, sixty_);
  frames(4);
  ASSERT_TRUE(shell_->batch().open());
  EXPECT_EQ(session_->scenario().name, "Hall");
  EXPECT_TRUE(session_->modified());
  EXPECT_EQ(shell_->told(), "");
  press(key::kEnter);
  EXPECT_EQ(shell_->batch().error(), "");
  EXPECT_EQ(shell_->batch().table().count(), 60u);
  EXPECT_EQ(text_of(out() + "/results.csv"), results_csv(test::results_of(engine())));
}

TEST_F(BatchOfAFile, DroppedOrChosenInTheOpenDialogIsShownInTheBatchDialog) {
  open_hall();
  sixty_ = folder_.with("sixty.json", kSixty);
  shell_->documents().drop(*session_, {sixty_});
  frames(4);
  EXPECT_TRUE(shell_->batch().open());
  press(key::kEscape);
  ASSERT_FALSE(shell_->batch().open());
  press('O', true);
  choose(sixty_);
  EXPECT_TRUE(shell_->batch().open());
  press(key::kEnter);
  EXPECT_EQ(shell_->batch().table().count(), 60u);
}

/// What was begun by the command line, in a folder of its own.
TEST_F(BatchOfAFile, AFolderOfResultsGivesItsExperimentAndGoesOn) {
  open_hall();
  sixty_ = folder_.with("sixty.json", kSixty);
  const std::string kept = folder_.file("kept");
  {
    const RunList list = engine();
    auto results = ResultsFolder::open(kept, list, {});
    ASSERT_TRUE(results);
    for (const RunResult& each : test::results_of(list, {0, 1, 2, 3, 4, 5, 6}))
      ASSERT_TRUE(results->add(each));
  }
  const std::string journal = text_of(kept + "/runs.jsonl");
  show();
  click(kChooseFolder);
  frames(8);
  ASSERT_EQ(shell_->documents().names_on_show().find("sixty.json") != std::string::npos, true)
      << "the folder's dialog is not there";
  type(kept);
  click(kChoose);
  frames(4);
  EXPECT_EQ(shell_->batch().folder(), kept);
  press(key::kEnter);
  EXPECT_EQ(shell_->batch().error(), "");
  EXPECT_EQ(shell_->batch().table().count(), 60u);
  EXPECT_EQ(text_of(kept + "/results.csv"), results_csv(test::results_of(engine())));
  EXPECT_EQ(text_of(kept + "/runs.jsonl").substr(0, journal.size()), journal) << "they are not made again";
}

TEST_F(BatchOfAFile, TheFileOfAFolderOfResultsOpensItsTable) {
  open_sixty();
  const std::string journal = text_of(out() + "/runs.jsonl");
  close();
  open_hall();
  shell_->documents().open(*session_, out() + "/results.json");
  frames(4);
  ASSERT_TRUE(shell_->batch().open());
  EXPECT_EQ(shell_->batch().folder(), out());
  press(key::kEnter);
  EXPECT_EQ(shell_->batch().table().count(), 60u);
  EXPECT_EQ(text_of(out() + "/runs.jsonl"), journal);
}

TEST_F(BatchTest, APartOfAnExperimentIsRefusedWithTheMend) {
  open_hall();
  const std::string sixty = folder_.with("sixty.json", kSixty);
  const RunList list = *RunList::load(*read_experiment(sixty));
  { ASSERT_TRUE(ResultsFolder::open(folder_.file("part"), list, {1, 4})); }
  show();
  shell_->show_batch(*session_, folder_.file("part") + "/batch.json");
  frames(4);
  press(key::kEnter);
  EXPECT_EQ(shell_->batch().table().count(), 0u);
  EXPECT_NE(shell_->batch().why_not().find("--shard 2/4"), std::string::npos) << shell_->batch().why_not();
}

TEST_F(BatchTest, CopiesTheCommandThatMakesTheSameRuns) {
  open_hall();
  show();
  press(key::kEnter);
  click(kFirstButton);
  EXPECT_EQ(std::string(ImGui::GetClipboardText()),
            batch_command_line(results() + "/experiment.json", results(), 1));
}

TEST_F(BatchTest, OfAnExperimentThatCannotBeReadNothingIsStarted) {
  open_hall();
  const std::string wrong = folder_.with("wrong.json", R"({"format": "replan experiment", "version": 1,
    "planners": [{"id": "astra"}], "worlds": ["hall.json"]})");
  show();
  click(kOpenExperiment);
  choose(wrong);
  press(key::kEnter);
  EXPECT_TRUE(shell_->batch().open());
  EXPECT_EQ(shell_->batch().table().count(), 0u);
  EXPECT_FALSE(fs::exists(folder_.file("wrong-results")));
}

TEST_F(BatchTest, RefusesAFolderThatAnotherProcessIsAtWorkIn) {
  open_hall();
  fs::create_directories(results());
  const auto lock = LockFile::try_lock(results() + "/lock");
  ASSERT_TRUE(lock);
  show();
  press(key::kEnter);
  EXPECT_TRUE(shell_->batch().open());
  EXPECT_NE(shell_->batch().error().find("another process is at work"), std::string::npos)
      << shell_->batch().error();
  EXPECT_EQ(shell_->batch().table().count(), 0u);
}

TEST_F(BatchTest, RefusesAFolderWithResultsOfAWorldThatHasChanged) {
  open_hall();
  show();
  press(key::kEnter);
  fs::remove(results() + "/results.csv");  // so that the folder is offered again
  const std::string journal = text_of(results() + "/runs.jsonl");
  close();
  open("hall.json", std::string(kHall).replace(std::string(kHall).find("[14, 4]"), 7, "[13, 4]"), 1280, 800);
  show();
  press(key::kEnter);
  EXPECT_NE(shell_->batch().error().find("another world"), std::string::npos) << shell_->batch().error();
  EXPECT_EQ(text_of(results() + "/runs.jsonl"), journal);
}

TEST_F(BatchTest, SaysWhyAFolderCannotBeMade) {
  open_hall();
  folder_.with("hall-batch", "a file, and no folder");
  show();
  press(key::kEnter);
  EXPECT_TRUE(shell_->batch().open());
  EXPECT_NE(shell_->batch().error().find("hall-batch"), std::string::npos) << shell_->batch().error();
}

TEST_F(BatchTest, OffersAnotherFolderOnceOneIsComplete) {
  open_hall();
  EXPECT_EQ(shell_->documents().batch_folder(*session_), results());
  show();
  press(key::kEnter);
  EXPECT_EQ(shell_->documents().batch_folder(*session_), results() + "-2");
}

}  // namespace
}  // namespace replan::ui::batch_test
