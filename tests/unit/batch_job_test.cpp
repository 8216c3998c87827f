// A batch off the thread that shows it: made, paused, stopped and gone on with; and the folder that it leaves.
#include "core/experiment/batch_job.hpp"

#include <chrono>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/experiment/results_text.hpp"
#include "tests/support/experiments.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::batch_job_test {
namespace {

/// Forty runs with blocks that drop ahead, in a hall that is in no file.
WorldExperiment hall() {
  auto world = std::make_shared<Scenario>();
  world->name = "Hall";
  world->map = GridMap(24, 16);
  for (int y = 3; y < 13; ++y) world->map.set({12, y}, true);
  world->start = {1, 8};
  world->goal = {22, 8};
  world->planners = {{"dstar-lite", {}}};
  WorldExperiment what;
  what.experiment.name = "hall";
  what.experiment.planners = {{"dstar-lite", {}}, {"astar", {}}};
  ExperimentWorld file;
  file.file = kept_world_file("hall");
  what.experiment.worlds = {file};
  what.experiment.surprises = {{ExperimentSurprises::Kind::blocks, {2, 2, 5}}};
  what.experiment.seeds.clear();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) what.experiment.seeds.push_back(seed);
  what.experiment.drive = true;
  what.world = std::move(world);
  return what;
}

template <class Condition>
bool wait_until(Condition condition) {
  for (int i = 0; i < 4000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return condition();
}

std::string csv_of_engine(const std::string& folder) {
  auto experiment = read_experiment(folder + "/experiment.json");
  EXPECT_TRUE(experiment) << (experiment ? "" : experiment.error());
  const auto list = RunList::load(std::move(experiment.value()));
  EXPECT_TRUE(list) << (list ? "" : list.error());
  return results_csv(test::results_of(*list));
}

TEST(BatchJob, InStepHasAllResultsAtOnceAndTheFolderRepeatsByItself) {
  const test::TemporaryFolder folder;
  BatchJob job;
  job.start({hall(), folder.file("out"), 1});
  const auto end = job.take_end();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->error, "");
  EXPECT_TRUE(end->all);
  EXPECT_EQ(job.take_results().size(), 40u);
  EXPECT_TRUE(job.take_results().empty());
  EXPECT_EQ(job.progress().done, 40u);
  EXPECT_EQ(*read_file(folder.file("out/results.csv")), csv_of_engine(folder.file("out")));
}

TEST(BatchJob, StoppedAndBegunAgainComesToTheSameResults) {
  if (!kThreads) GTEST_SKIP() << "in step a job is at work when somebody does it: steps_test.cpp";
  const test::TemporaryFolder folder;
  std::size_t kept = 0;
  {
    BatchJob job({.in_step = false, .wake = {}});
    job.start({hall(), folder.file("out"), 2});
    ASSERT_TRUE(wait_until([&] { return job.progress().done >= 3; }));
    job.stop();
    std::optional<BatchEnd> end;
    ASSERT_TRUE(wait_until([&] { return end || (end = job.take_end()); }));
    EXPECT_EQ(end->error, "");
    kept = job.progress().done;
  }
  BatchJob job({.in_step = false, .wake = {}});
  job.start({hall(), folder.file("out"), 2});
  std::optional<BatchEnd> end;
  ASSERT_TRUE(wait_until([&] { return end || (end = job.take_end()); }));
  EXPECT_TRUE(end->all) << end->error;
  EXPECT_GE(kept, 3u);
  EXPECT_EQ(job.take_results().size(), 40u) << "those that were kept too";
  EXPECT_EQ(*read_file(folder.file("out/results.csv")), csv_of_engine(folder.file("out")));
}

TEST(BatchJob, PausedMakesNoMoreRunsUntilItGoesOn) {
  if (!kThreads) GTEST_SKIP() << "in step a job is at work when somebody does it: steps_test.cpp";
  const test::TemporaryFolder folder;
  BatchJob job({.in_step = false, .wake = {}});
  job.pause();  // nothing is at work: nothing happens
  EXPECT_FALSE(job.paused());
  job.start({hall(), folder.file("out"), 1});
  job.pause();
  EXPECT_TRUE(job.paused());
  // One that has been begun may still come to its end; after it there is no other.
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_LE(job.progress().done, 1u);
  EXPECT_FALSE(job.progress().seconds_left);
  EXPECT_TRUE(job.busy());
  job.go_on();
  std::optional<BatchEnd> end;
  ASSERT_TRUE(wait_until([&] { return end || (end = job.take_end()); }));
  EXPECT_TRUE(end->all) << end->error;
}

TEST(BatchJob, EndsWhilePaused) {
  if (!kThreads) GTEST_SKIP() << "in step a job is at work when somebody does it: steps_test.cpp";
  const test::TemporaryFolder folder;
  BatchJob job({.in_step = false, .wake = {}});
  job.start({hall(), folder.file("out"), 2});
  job.pause();
}

TEST(WorldExperiment, LeavesWhatIsThereAlone) {
  const test::TemporaryFolder folder;
  WorldExperiment what = hall();
  ASSERT_TRUE(put_world(what, folder.path()));
  ASSERT_TRUE(put_world(what, folder.path())) << "the same once more is the same";
  auto other = std::make_shared<Scenario>(*what.world);
  other->goal = {20, 8};
  what.world = other;
  const auto refused = put_world(what, folder.path());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("worlds/hall.json"), std::string::npos) << refused.error();
  EXPECT_EQ(read_scenario(folder.file("worlds/hall.json"))->goal, (Cell{22, 8}));
}

TEST(WorldExperiment, ComesBackAsItWas) {
  const test::TemporaryFolder folder;
  const WorldExperiment what = hall();
  const auto put = put_world(what, folder.path());
  ASSERT_TRUE(put) << put.error();
  ASSERT_TRUE(put_experiment(*put, folder.file("experiment.json")));
  const auto read = read_experiment(folder.file("experiment.json"));
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(experiment_text(*read), experiment_text(what.experiment));
}

TEST(WorldExperiment, ItsWorldsNameIsAFilesName) {
  EXPECT_EQ(kept_world_file("demo"), "worlds/demo.json");
  EXPECT_EQ(kept_world_file("a/b [1]*?"), "worlds/a-b -1---.json");
  EXPECT_EQ(kept_world_file(""), "worlds/world.json");
}

TEST(WorldExperiment, ItsCommandIsOneThatAShellTakes) {
  EXPECT_EQ(batch_command_line("/a/experiment.json", "/a", 1), "replan batch /a/experiment.json --out /a");
  EXPECT_EQ(batch_command_line("/my maps/it's.json", "/out", 4),
            "replan batch '/my maps/it'\\''s.json' --out /out --jobs 4");
}

/// What a folder holds comes to who shows it a part at a time, and where nothing is missing nothing is written.
TEST(BatchJob, OfACompleteFolderHandsOverPartByPartAndLeavesItsFilesAlone) {
  const test::TemporaryFolder folder;
  BatchJob first;
  first.start({hall(), folder.file("out"), 1});
  ASSERT_TRUE(first.take_end()->all);
  const auto before = std::filesystem::last_write_time(folder.file("out/results.csv"));
  BatchJob again;
  again.start({hall(), folder.file("out"), 1});
  std::vector<RunResult> all;
  for (const std::size_t part : {15u, 15u, 10u, 0u}) {
    const auto taken = again.take_results(15);
    EXPECT_EQ(taken.size(), part);
    all.insert(all.end(), taken.begin(), taken.end());
  }
  EXPECT_TRUE(again.take_end()->all);
  EXPECT_EQ(results_csv(all), *read_file(folder.file("out/results.csv")));
  EXPECT_EQ(std::filesystem::last_write_time(folder.file("out/results.csv")), before);
}

}  // namespace
}  // namespace replan::batch_job_test
