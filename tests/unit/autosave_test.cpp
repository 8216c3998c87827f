// Unsaved work that outlives its program.
#include "core/session/autosave.hpp"

#include <filesystem>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::autosave_test {
namespace {

Scenario world() {
  Scenario scenario;
  scenario.name = "Hall";
  scenario.map = GridMap(20, 10);
  scenario.start = {1, 5};
  scenario.goal = {18, 5};
  scenario.planners = {{"dstar-lite", {}}};
  return scenario;
}

PaintCells wall_at(int x) {
  PaintCells paint;
  for (int y = 2; y < 9; ++y) paint.cells.push_back({{x, y}, true});
  return paint;
}

/// A session with edits of the map before the robot has set out, and with edits of the running mission.
void edit(Session& session) {
  session.settle();
  ASSERT_TRUE(session.apply(wall_at(5)).ok());
  session.settle();
  ASSERT_TRUE(session.apply(Step{StepUnit::move, 3}).ok());
  ASSERT_TRUE(session.apply(wall_at(9)).ok());
  ASSERT_TRUE(session.apply(DropSurprise{{{{15, 5}, true}}}).ok());
  session.settle();
}

std::vector<Event> whole_run(Session& session) {
  static_cast<void>(session.apply(RunToEnd{}));
  for (const auto& run : session.runs()) const_cast<Run&>(*run).finish(Target::end());
  session.update(0);
  std::vector<Event> events;
  for (std::size_t i = 0; i < session.run().timeline().size(); ++i)
    events.push_back(session.run().timeline().event(i));
  return events;
}

TEST(Autosave, IsTakenUpAsTheSameWorldScriptAndRun) {
  const test::TemporaryFolder folder;
  Session session(world(), "/maps/hall.json");
  edit(session);
  Autosaver autosaver(folder.path());
  autosaver.tick(session, 0, false);
  EXPECT_EQ(autosaver.path(), "");
  autosaver.tick(session, Autosaver::kQuietSeconds, false);
  ASSERT_NE(autosaver.path(), "");

  const Result<ReplaceScenario> found = read_autosave(autosaver.path());
  ASSERT_TRUE(found.ok()) << found.error();
  EXPECT_EQ(found->scenario, session.scenario());
  Session again(world());
  ASSERT_TRUE(again.apply(*found).ok());
  again.settle();
  EXPECT_EQ(again.file(), "/maps/hall.json");
  EXPECT_TRUE(again.modified());
  EXPECT_EQ(again.unsaved_edits(), session.unsaved_edits());
  EXPECT_EQ(again.to_save(), session.to_save());
  EXPECT_TRUE(whole_run(again) == whole_run(session));
  again.saved("/maps/hall.json");
  EXPECT_FALSE(again.modified());
  EXPECT_EQ(again.unsaved_edits(), 0u);
}

TEST(Autosave, HoldsTheCellsOfAMapThatLiesInAFile) {
  AutosaveNote note{
      .file = "/a/b.json", .name = "B", .edits = 2, .edited_at = 77, .scripted = 1, .map_file = "b.map"};
  Scenario scenario = world();
  scenario.map_file = "b.map";
  scenario.map.set({3, 3}, true);
  const test::TemporaryFolder folder;
  const std::string path = folder.with("x.json", autosave_text(note, scenario));
  EXPECT_EQ(*read_autosave_note(path), note);
  const Result<ReplaceScenario> found = read_autosave(path);
  ASSERT_TRUE(found.ok()) << found.error();
  EXPECT_EQ(found->scenario, scenario);
  EXPECT_EQ(found->unsaved_edits, 2u);
}

TEST(Autosave, WaitsForQuietAndForTheHandToBeLifted) {
  const test::TemporaryFolder folder;
  Session session(world());
  Autosaver autosaver(folder.path());
  autosaver.tick(session, 0, false);
  autosaver.tick(session, 100, false);
  EXPECT_EQ(folder.entries(), 0) << "nothing was edited";
  session.settle();
  ASSERT_TRUE(session.apply(wall_at(5)).ok());
  autosaver.tick(session, 100, true);
  autosaver.tick(session, 104.9, false);
  EXPECT_EQ(autosaver.path(), "");
  autosaver.tick(session, 106, true);
  EXPECT_EQ(autosaver.path(), "") << "in the middle of a stroke";
  autosaver.tick(session, 106, false);
  ASSERT_NE(autosaver.path(), "");
  // While edits go on without a pause they are put aside all the same.
  double now = 200;
  const std::string first = *read_file(autosaver.path());
  bool rewritten = false;
  for (int i = 0; i < 12; ++i, now += 4) {
    ASSERT_TRUE(session.apply(PaintCells{{{{i, 0}, true}}}).ok());
    autosaver.tick(session, now, false);
    rewritten = rewritten || *read_file(autosaver.path()) != first;
  }
  EXPECT_TRUE(rewritten);
}

TEST(Autosave, GoesWhenTheWorkIsSavedOrTakenBack) {
  const test::TemporaryFolder folder;
  Session session(world());
  Autosaver autosaver(folder.path());
  const auto put_aside = [&](double at) {
    autosaver.tick(session, at, false);
    autosaver.tick(session, at + 6, false);
  };
  session.settle();
  ASSERT_TRUE(session.apply(wall_at(5)).ok());
  put_aside(0);
  EXPECT_EQ(folder.entries(), 2);  // the autosave and its lock
  ASSERT_TRUE(session.apply(Undo{}).ok());
  put_aside(20);
  EXPECT_EQ(folder.entries(), 0);
  ASSERT_TRUE(session.apply(Redo{}).ok());
  put_aside(40);
  EXPECT_EQ(folder.entries(), 2);
  session.saved("/x.json");
  put_aside(60);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Autosave, SaysWhenItCannotBeWritten) {
  const test::TemporaryFolder folder;
  folder.with("file", "");
  Session session(world());
  session.settle();
  ASSERT_TRUE(session.apply(wall_at(5)).ok());
  Autosaver autosaver(folder.file("file") + "/sub");
  autosaver.tick(session, 0, false);
  autosaver.tick(session, 6, false);
  EXPECT_NE(autosaver.take_failure(), "");
  autosaver.tick(session, 12, false);
  EXPECT_EQ(autosaver.take_failure(), "") << "once for each edit";
}

TEST(Autosave, SaysOfEachEditOnceThatItsFileCannotBeWritten) {
  const test::TemporaryFolder folder;
  Session session(world());
  session.settle();
  ASSERT_TRUE(session.apply(wall_at(5)).ok());
  Autosaver autosaver(folder.file("kept"));
  autosaver.tick(session, 0, false);
  autosaver.tick(session, 6, false);
  ASSERT_EQ(autosaver.take_failure(), "");
  std::filesystem::remove_all(folder.file("kept"));
  ASSERT_TRUE(session.apply(wall_at(6)).ok());
  for (int seconds = 12; seconds < 20; ++seconds) autosaver.tick(session, seconds, false);
  EXPECT_NE(autosaver.take_failure(), "");
  for (int seconds = 20; seconds < 40; ++seconds) autosaver.tick(session, seconds, false);
  EXPECT_EQ(autosaver.take_failure(), "");
  ASSERT_TRUE(session.apply(wall_at(7)).ok());
  for (int seconds = 40; seconds < 50; ++seconds) autosaver.tick(session, seconds, false);
  EXPECT_NE(autosaver.take_failure(), "");
}

TEST(Orphans, AreThoseWhoseProgramHasEnded) {
  const test::TemporaryFolder folder;
  folder.with("damaged.json", "{\"autosave\": 3,\n");
  folder.with("empty.json", "");
  // Another process that ends without a word, and this one, which lives.
  const pid_t child = ::fork();
  if (child == 0) {
    Session session(world(), "/maps/lost.json");
    session.settle();
    static_cast<void>(session.apply(wall_at(5)));
    Autosaver autosaver(folder.path());
    autosaver.tick(session, 0, false);
    autosaver.tick(session, 6, false);
    ::_exit(autosaver.path().empty() ? 1 : 0);
  }
  if (child == -1) GTEST_SKIP() << "this process is too large for the machine to make another one of it";
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
  Session session(world(), "/maps/mine.json");
  session.settle();
  ASSERT_TRUE(session.apply(wall_at(5)).ok());
  Autosaver mine(folder.path());
  mine.tick(session, 0, false);
  mine.tick(session, 6, false);

  std::vector<Orphan> orphans = find_orphans(folder.path());
  ASSERT_EQ(orphans.size(), 1u);
  EXPECT_EQ(orphans[0].note.file, "/maps/lost.json");
  EXPECT_EQ(orphans[0].note.edits, 1u);
  EXPECT_TRUE(find_orphans(folder.path()).empty()) << "it is offered to one only";
  orphans.clear();
  orphans = find_orphans(folder.path());
  ASSERT_EQ(orphans.size(), 1u) << "put off, it is offered again";

  const std::string path = orphans[0].path;
  mine.adopt(std::move(orphans[0]), session);
  EXPECT_EQ(mine.path(), path);
  EXPECT_TRUE(find_orphans(folder.path()).empty());
  mine.remove();
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_TRUE(find_orphans(folder.file("no such folder")).empty());
}

TEST(Orphans, AreDiscardedWithTheirLock) {
  const test::TemporaryFolder folder;
  folder.with("x.json", autosave_text(AutosaveNote(), world()));
  std::vector<Orphan> orphans = find_orphans(folder.path());
  ASSERT_EQ(orphans.size(), 1u);
  discard(std::move(orphans[0]));
  EXPECT_EQ(folder.entries(), 0);
}

TEST(UnsavedEdits, AreCountedAsUndoCountsThem) {
  Session session(world());
  session.settle();
  EXPECT_EQ(session.unsaved_edits(), 0u);
  for (int x : {4, 6, 8}) ASSERT_TRUE(session.apply(wall_at(x)).ok());
  EXPECT_EQ(session.unsaved_edits(), 3u);
  session.saved("/x.json");
  EXPECT_EQ(session.unsaved_edits(), 0u);
  ASSERT_TRUE(session.apply(wall_at(10)).ok());
  EXPECT_EQ(session.unsaved_edits(), 1u);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(session.apply(Undo{}).ok());
  EXPECT_EQ(session.unsaved_edits(), 2u);
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(session.apply(Redo{}).ok());
  EXPECT_FALSE(session.modified());
  EXPECT_EQ(session.unsaved_edits(), 0u);
}

TEST(Background, WaitingLetsAJobThatListensEnd) {
  Background<int> work({false, {}});
  work.start([](const StopToken& stop) {
    for (int i = 0; i < 20; ++i) {
      if (stop.stop_requested()) return i;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return 20;
  });
  work.wait();
  EXPECT_EQ(work.take(), 20);
}

TEST(Background, GivesUpAndGoesOn) {
  if (!kThreads) GTEST_SKIP() << "in step a job is at work when somebody does it: steps_test.cpp";
  Background<int> work({false, {}});
  work.start([](const StopToken& stop) {
    while (!stop.stop_requested()) std::this_thread::yield();
    return 1;
  });
  EXPECT_TRUE(work.busy());
  EXPECT_FALSE(work.take());
  work.start([](const StopToken&) { return 2; });
  work.wait();
  EXPECT_EQ(work.take(), 2);
  EXPECT_FALSE(work.busy());
  EXPECT_FALSE(work.take());
}

}  // namespace
}  // namespace replan::autosave_test
