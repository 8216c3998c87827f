// Work in step: slices within a budget by a clock of the test's own, jobs that are put off, cut up and given up.
#include "core/base/steps.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/background.hpp"
#include "core/experiment/batch_job.hpp"
#include "core/session/session.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::steps_test {
namespace {

/// Milliseconds that only work takes.
double now = 0;
double test_clock() {
  return now;
}
Deadline within(double milliseconds) {
  return Deadline(milliseconds, test_clock);
}
/// A clock that goes on by one with each look at it.
double ticking_clock() {
  return now++;
}

/// So many slices of so many milliseconds each.
struct Slices final : Steps::Task {
  Slices(int its_count, double its_cost) : count(its_count), cost(its_cost) {}
  State advance() override {
    if (waiting) return State::waits;
    now += cost;
    return ++done < count ? State::more : State::done;
  }
  int count;
  double cost;
  int done = 0;
  bool waiting = false;
};

TEST(Steps, BeginAtTheSecondPump) {
  Steps steps;
  const auto task = std::make_shared<Slices>(1, 1.0);
  EXPECT_FALSE(steps.busy());
  steps.add(task);
  EXPECT_TRUE(steps.busy());
  steps.pump(within(100));
  EXPECT_EQ(task->done, 0) << "the frame that says what is waited for was not seen yet";
  steps.pump(within(100));
  EXPECT_EQ(task->done, 1);
  EXPECT_FALSE(steps.busy());
}

TEST(Steps, AreOverTheirBudgetByOneSliceAtMost) {
  Steps steps;
  const auto a = std::make_shared<Slices>(1000, 3.0), b = std::make_shared<Slices>(1000, 1.0);
  steps.add(a);
  steps.add(b);
  steps.pump(within(10));
  for (const double budget : {10.0, 0.5, 25.0, 0.0}) {
    const double begin = now;
    const int before = a->done + b->done;
    steps.pump(within(budget));
    EXPECT_GE(now - begin, budget);
    EXPECT_LT(now - begin, budget + 3.0 + 1e-9);
    EXPECT_GT(a->done + b->done, before) << "it gets on, however little time there is";
  }
  EXPECT_LE(std::abs(a->done - b->done), 1) << "in turn";
}

TEST(Steps, LeaveWhatIsGivenUpAndPassOverWhatWaits) {
  Steps steps;
  auto gone = std::make_shared<Slices>(10, 1.0);
  const auto waits = std::make_shared<Slices>(10, 1.0), works = std::make_shared<Slices>(10, 1.0);
  waits->waiting = true;
  for (const auto& task : {gone, waits, works}) steps.add(task);
  steps.pump(within(100));
  gone.reset();
  steps.pump(within(100));
  EXPECT_EQ(works->done, 10);
  EXPECT_EQ(waits->done, 0);
  EXPECT_FALSE(steps.busy()) << "nothing is to be done before somebody gives leave";
  waits->waiting = false;
  steps.pump(within(100));
  EXPECT_EQ(waits->done, 10);
}

TEST(Background, InStepsIsDoneByThem) {
  const auto place = WorkPlace::in_steps();
  Background<int> work(place);
  int slices = 0;
  work.start_slices([&slices](const StopToken&) { return ++slices < 5 ? std::nullopt : std::optional(7); });
  EXPECT_EQ(slices, 0) << "nothing is done at once";
  for (int i = 0; i < 3; ++i) place.steps->pump(within(0));
  EXPECT_EQ(slices, 2);
  EXPECT_FALSE(work.take());
  place.steps->pump(within(1));
  EXPECT_EQ(slices, 5);
  EXPECT_TRUE(work.busy());
  EXPECT_EQ(work.take(), 7);
  EXPECT_FALSE(work.busy());
}

TEST(Background, InStepsIsGivenUpWithoutAnotherSlice) {
  const auto place = WorkPlace::in_steps();
  Background<int> work(place);
  int slices = 0;
  const auto endless = [&slices](const StopToken&) {
    ++slices;
    return std::optional<int>();
  };
  work.start_slices(endless);
  for (int i = 0; i < 3; ++i) place.steps->pump(within(0));
  work.cancel();
  EXPECT_FALSE(place.steps->busy());
  place.steps->pump(within(0));
  EXPECT_EQ(slices, 2);
  work.start_slices(endless);
  work.start([](const StopToken&) { return 3; });  // takes the other's place
  for (int i = 0; i < 3; ++i) place.steps->pump(within(0));
  EXPECT_EQ(slices, 2);
  EXPECT_EQ(work.take(), 3);
}

TEST(Background, InStepsIsWaitedForByDoingIt) {
  Background<int> work(WorkPlace::in_steps());
  int slices = 0;
  work.start_slices([&slices](const StopToken&) { return ++slices < 5 ? std::nullopt : std::optional(7); });
  work.wait();
  EXPECT_EQ(work.take(), 7);
}

TEST(Background, ThatIsShortIsDoneAtOnceInAnyPlace) {
  Background<int> work(WorkPlace::in_steps().only_if(false));
  work.start([](const StopToken&) { return 3; });
  EXPECT_EQ(work.take(), 3);
}

Scenario open_field(int side) {
  Scenario scenario;
  scenario.map = GridMap(side, side);
  scenario.start = {1, side / 2};
  scenario.goal = {side - 2, side / 2};
  scenario.planners = {{"dijkstra", {}}};
  return scenario;
}

std::int64_t expansions(const Run& run) {
  std::int64_t sum = 0;
  for (const std::uint32_t each : run.expansion_curve()) sum += each;
  return sum;
}

/// Slices are counted by a clock that ticks once a look, and the planner's iterations by its log.
TEST(RunInStep, GoesNoFartherThanItsBudget) {
  replan::Run run(std::make_shared<const Scenario>(open_field(120)), 0, {}, WorkPlace::in_steps());
  run.go(Target::plan());
  EXPECT_FALSE(run.pump(Deadline(0, ticking_clock)));
  EXPECT_EQ(run.timeline().size(), 0u) << "nothing is done where there is no time";
  constexpr std::int64_t kIterations = 500;  // of a slice
  std::int64_t before = 0;
  for (int pump = 0; pump < 8; ++pump) {
    constexpr int kSlices = 4;
    static_cast<void>(run.pump(Deadline(kSlices + 1, ticking_clock)));
    EXPECT_TRUE(run.busy());
    EXPECT_LE(expansions(run) - before, kSlices * kIterations);
    before = expansions(run);
  }
  EXPECT_GT(before, 0);
  run.wait();
  EXPECT_FALSE(run.busy());
  EXPECT_FALSE(run.decisions().empty());
}

TEST(RunInStep, IsCancelledBetweenTwoSlicesAndTakenUpAgain) {
  replan::Run run(std::make_shared<const Scenario>(open_field(120)), 0, {}, WorkPlace::in_steps());
  run.go(Target::end());
  for (int pump = 0; pump < 4; ++pump) run.pump(Deadline(6, ticking_clock));
  const std::size_t size = run.timeline().size();
  EXPECT_GT(size, 0u);
  run.cancel();
  while (run.busy()) run.pump(Deadline(100, ticking_clock));
  const std::size_t stopped = run.timeline().size();
  run.pump();
  EXPECT_EQ(run.timeline().size(), stopped) << "it stands still";
  EXPECT_TRUE(run.decisions().empty());
  run.finish(Target::end());
  EXPECT_TRUE(run.over());
}

/// What is edited as a whole cannot be cut up, but is put off until a frame has said so.
TEST(SessionInStep, EditsALargeWorldAtALaterUpdate) {
  Session session(open_field(520), {}, {}, WorkPlace::in_steps());
  session.set_patience(std::chrono::milliseconds(0));
  ASSERT_TRUE(session.apply(InvertWorld{}).ok());
  EXPECT_TRUE(session.editing_world());
  EXPECT_TRUE(session.has_steps());
  session.update(0);
  EXPECT_TRUE(session.editing_world());
  session.update(0);
  EXPECT_FALSE(session.editing_world());
  EXPECT_FALSE(session.has_steps());
  EXPECT_NE(session.scenario().map.blocked[0], kFree);
}

TEST(BatchInStep, IsPausedGoneOnWithAndStopped) {
  const test::TemporaryFolder folder;
  auto world = std::make_shared<Scenario>(open_field(16));
  WorldExperiment what;
  what.experiment.name = "field";
  what.experiment.planners = {{"dijkstra", {}}, {"astar", {}}};
  ExperimentWorld file;
  file.file = kept_world_file("field");
  what.experiment.worlds = {file};
  what.experiment.surprises = {{ExperimentSurprises::Kind::blocks, {1, 2, 4}}};
  what.experiment.seeds = {1, 2, 3, 4};
  what.experiment.drive = true;
  what.world = world;
  const auto place = WorkPlace::in_steps();
  BatchJob job(place);
  job.start({what, folder.file("out"), 1});
  for (int i = 0; i < 4; ++i) place.steps->pump(within(0));
  EXPECT_EQ(job.progress().done, 2u) << "a slice to load, and one for each run";
  EXPECT_EQ(job.progress().all, 8u);
  job.pause();
  place.steps->pump(within(100));
  EXPECT_EQ(job.progress().done, 2u);
  EXPECT_FALSE(place.steps->busy());
  job.go_on();
  place.steps->pump(within(0));
  EXPECT_EQ(job.progress().done, 3u);
  job.stop();
  place.steps->pump(within(100));
  const auto stopped = job.take_end();
  ASSERT_TRUE(stopped);
  EXPECT_FALSE(stopped->all);
  job.start({what, folder.file("out"), 1});
  for (int i = 0; i < 2; ++i) place.steps->pump(within(100));
  const auto end = job.take_end();
  ASSERT_TRUE(end);
  EXPECT_TRUE(end->all) << end->error;
  EXPECT_EQ(job.take_results().size(), 8u);
  EXPECT_TRUE(std::filesystem::exists(folder.file("out/results.csv")));
}

}  // namespace
}  // namespace replan::steps_test
