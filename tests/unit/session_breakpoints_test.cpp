// Breakpoints and watches of a session: where playing stops, hunts, values followed to their changes.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/session/session.hpp"

namespace replan::session_breakpoints_test {
namespace {

/// A room with a wall and a gap in it, and a surprise on the way that closes the gap beside another.
Scenario wall_with_gaps() {
  Scenario scenario;
  scenario.map = GridMap(24, 16);
  for (int y = 0; y < 16; ++y)
    if (y != 5 && y != 13) scenario.map.set({12, y}, true);
  scenario.start = {2, 8};
  scenario.goal = {21, 8};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot.sensor_radius = 4;
  Surprise closes;
  closes.at.move = 3;
  closes.cells = {{{12, 5}, true}};
  scenario.surprises = {closes};
  return scenario;
}

struct Standing {
  Session session{wall_with_gaps()};
  Standing() {
    session.settle();
    EXPECT_TRUE(session.apply(Seek{0}).ok());
  }
  [[nodiscard]] std::size_t cursor() const { return session.run().timeline().cursor(); }
  [[nodiscard]] Event latest() const { return session.run().timeline().event(cursor() - 1); }
  void go(const Command& command) {
    const auto done = session.apply(command);
    ASSERT_TRUE(done.ok()) << done.error();
    session.settle();
  }
  /// Plays until it stops by itself.
  void play(int direction) {
    ASSERT_TRUE(session.apply(Play{direction}).ok());
    for (int frames = 0; frames < 200'000 && session.playback().direction != 0; ++frames)
      session.update(0.02);
    ASSERT_EQ(session.playback().direction, 0) << "it never stops";
  }
};

TEST(SessionBreakpoints, refuseWhatCannotBeRead) {
  Standing at;
  const auto wrong = at.session.apply(AddBreakpoint{"g(99, 3) > 1"});
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(
      wrong.error(),
      "breakpoint 'g(99, 3) > 1': character 2: (99, 3) is outside the world: x goes from 0 to 23, y from 0 "
      "to 15");
  EXPECT_TRUE(at.session.breakpoints().list().empty());
  ASSERT_TRUE(at.session.apply(AddBreakpoint{"km>5"}).ok());
  EXPECT_EQ(at.session.apply(AddBreakpoint{"km > 5"}).error(),
            "breakpoint 'km > 5': there is a breakpoint of that condition already");
  EXPECT_FALSE(at.session.apply(SwitchBreakpoint{1, false}).ok());
  EXPECT_FALSE(at.session.apply(RemoveBreakpoint{1}).ok());
  ASSERT_TRUE(at.session.apply(SwitchBreakpoint{0, false}).ok());
  EXPECT_EQ(at.session.apply(GoToBreakpoint{1}).error(), "no breakpoint is switched on");
  ASSERT_TRUE(at.session.apply(RemoveBreakpoint{0}).ok());
  EXPECT_EQ(at.session.apply(GoToBreakpoint{1}).error(),
            "there is no breakpoint: add a condition to stop at");
}

TEST(SessionBreakpoints, hitsAreThoseOfAScanAndGrowWithTheLog) {
  Standing at;
  at.go(AddBreakpoint{"taken(11, 5)"});
  at.go(AddBreakpoint{"event(plan) || event(replan)"});
  at.go(RunToEnd{});
  while (at.session.run().busy()) at.session.update(0);
  at.session.settle();
  const auto& run = at.session.run();
  std::vector<Hit> right;
  for (std::size_t p = 1; p <= run.timeline().size(); ++p) {
    const Event event = run.timeline().event(p - 1);
    if (event.kind == EventKind::pop && event.node == run.lattice().node(Cell{11, 5}))
      right.push_back({p, 0});
    if (event.kind == EventKind::plan_begin) right.push_back({p, 1});
  }
  ASSERT_GE(right.size(), 3u);
  EXPECT_EQ(std::vector<Hit>(at.session.breakpoints().hits().begin(), at.session.breakpoints().hits().end()),
            right);
  EXPECT_EQ(at.session.breakpoints().looked_through(), run.timeline().size());
}

// A window draws while something changes: a search that finds nothing has to be seen to get on.
TEST(SessionBreakpoints, lookingThroughALogIsAChangeUntilItsEnd) {
  Standing at;
  ASSERT_TRUE(at.session.apply(AddBreakpoint{"km > 1000000"}).ok());
  const Breakpoints& breakpoints = at.session.breakpoints();
  ASSERT_LT(breakpoints.looked_through(), at.session.run().timeline().size());
  while (breakpoints.looked_through() < at.session.run().timeline().size()) {
    const std::uint64_t revision = at.session.revision();
    const std::size_t looked = breakpoints.looked_through();
    at.session.update(0);
    ASSERT_GT(breakpoints.looked_through(), looked);
    EXPECT_NE(at.session.revision(), revision);
  }
  const std::uint64_t revision = at.session.revision();
  at.session.update(0);
  EXPECT_EQ(at.session.revision(), revision);
}

TEST(SessionBreakpoints, hitsFollowALogThatIsCut) {
  Standing at;
  at.go(AddBreakpoint{"event(plan) || event(replan)"});
  at.go(Step{StepUnit::mission, 1});
  const auto replans = [&] {
    std::vector<std::size_t> found;
    for (const Milestone& milestone : at.session.run().milestones())
      if (milestone.kind == EventKind::plan_begin) found.push_back(milestone.event + 1);
    return found;
  };
  const auto hits = [&] {
    std::vector<std::size_t> found;
    for (const Hit& hit : at.session.breakpoints().hits()) found.push_back(hit.position);
    return found;
  };
  const auto before = replans();
  ASSERT_EQ(hits(), before);
  at.go(Seek{0});
  at.go(Step{StepUnit::move, 2});
  at.go(PaintCells{{{{4, 8}, true}, {{5, 7}, true}}, 1});
  EXPECT_EQ(hits(), replans());
  EXPECT_NE(hits(), before);
  at.go(Undo{});
  at.go(Step{StepUnit::mission, 1});
  EXPECT_EQ(hits(), before);
}

TEST(SessionBreakpoints, playingStopsAtThemInBothDirections) {
  Standing at;
  at.go(AddBreakpoint{"taken(11, 5)"});
  at.go(SetSpeed{Session::kFullSpeed});
  at.play(1);
  const std::size_t first = at.cursor();
  ASSERT_GT(first, 0u);
  EXPECT_EQ(at.latest().kind, EventKind::pop);
  EXPECT_EQ(at.latest().node, at.session.run().lattice().node(Cell{11, 5}));
  EXPECT_EQ(at.session.breakpoints().stopped(), "stopped: taken(11, 5) (took (11, 5) from the open list)");
  at.play(1);
  const std::size_t second = at.cursor();
  EXPECT_GT(second, first);
  EXPECT_EQ(at.latest().kind, EventKind::pop) << "the mission was run on to the replan that takes it again";
  at.play(-1);
  EXPECT_EQ(at.cursor(), first);
  at.play(-1);
  EXPECT_EQ(at.cursor(), 0u);
  EXPECT_EQ(at.session.breakpoints().stopped(), "") << "the cursor has moved on";
  at.go(SwitchBreakpoint{0, false});
  at.play(1);
  EXPECT_EQ(at.cursor(), at.session.run().timeline().size());
  EXPECT_EQ(at.session.run().decisions().back().state, MissionState::arrived);
}

TEST(SessionBreakpoints, aStopTellsTheValues) {
  Standing at;
  at.go(AddBreakpoint{"g(20, 8) < 5 && size(U) > 1"});
  at.go(GoToBreakpoint{1});
  EXPECT_TRUE(at.session.breakpoints().stopped().starts_with(
      "stopped: g(20, 8) < 5 && size(U) > 1 (g(20, 8) is 1.000, size(U) is "))
      << at.session.breakpoints().stopped();
  at.go(Step{StepUnit::expansion, 1});
  EXPECT_EQ(at.session.breakpoints().stopped(), "");
}

TEST(SessionBreakpoints, aHuntRunsTheMissionOnAndStopsThere) {
  Standing at;
  const std::size_t planned = at.session.run().timeline().size();
  at.go(AddBreakpoint{"event(replan)"});
  at.go(AddBreakpoint{"robot == (12, 13)"});
  at.go(GoToBreakpoint{1});
  EXPECT_GT(at.cursor(), planned);
  EXPECT_EQ(at.latest().kind, EventKind::plan_begin);
  EXPECT_FALSE(at.session.breakpoints().hunt());
  const std::size_t replan = at.cursor();
  at.go(GoToBreakpoint{1});
  EXPECT_EQ(at.session.run().timeline().state().node(Scalar::robot),
            at.session.run().lattice().node(Cell{12, 13}));
  at.go(GoToBreakpoint{-1});
  EXPECT_EQ(at.cursor(), replan);
  at.go(GoToBreakpoint{-1});
  EXPECT_EQ(at.cursor(), replan) << "nothing there: it stays";
  EXPECT_EQ(at.session.log().back(), "no breakpoint before here");
  at.go(GoToBreakpoint{1});
  const std::size_t last = at.cursor();
  at.go(GoToBreakpoint{1});
  EXPECT_EQ(at.cursor(), last);
  EXPECT_EQ(at.session.log().back(), "no breakpoint after here");
  EXPECT_EQ(at.session.run().decisions().back().state, MissionState::arrived)
      << "it was run to its end to know";
}

TEST(SessionBreakpoints, aHuntGoesOnOverUpdatesAndCanBeCancelled) {
  Standing at;
  at.go(AddBreakpoint{"moves > 1000000"});
  at.go(AddBreakpoint{"event(arrival)"});
  ASSERT_TRUE(at.session.apply(GoToBreakpoint{1}).ok());
  EXPECT_TRUE(at.session.breakpoints().hunt());
  EXPECT_EQ(at.session.breakpoints().hunt()->direction, 1);
  ASSERT_TRUE(at.session.apply(Cancel{}).ok());
  EXPECT_FALSE(at.session.breakpoints().hunt());
  EXPECT_EQ(at.cursor(), 0u);
  ASSERT_TRUE(at.session.apply(GoToBreakpoint{1}).ok());
  for (int i = 0; i < 1'000'000 && at.session.breakpoints().hunt(); ++i) at.session.update(0);
  EXPECT_EQ(at.latest().kind, EventKind::arrival);
}

TEST(SessionBreakpoints, theOtherPanesGoAlong) {
  Scenario scenario = wall_with_gaps();
  scenario.planners = {{"dstar-lite", {}}, {"astar", {}}};
  Session session(scenario);
  session.settle();
  ASSERT_TRUE(session.apply(SetLockstep{Lockstep::moves}).ok());
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  ASSERT_TRUE(session.apply(AddBreakpoint{"robot == (12, 13)"}).ok());
  ASSERT_TRUE(session.apply(GoToBreakpoint{1}).ok());
  session.settle();
  const auto moves = [&](std::size_t pane) {
    return session.runs()[pane]->timeline().state().scalar(Scalar::moves);
  };
  EXPECT_GT(moves(0), 10u);
  EXPECT_NEAR(static_cast<double>(moves(0)), static_cast<double>(moves(1)), 1);
}

TEST(SessionBreakpoints, valuesAreFollowedToTheirChanges) {
  Standing at;
  at.go(Step{StepUnit::mission, 1});
  const Timeline& log = at.session.run().timeline();
  const NodeId node = at.session.run().lattice().node(Cell{11, 6});
  std::vector<std::size_t> changes;
  for (std::size_t i = 0; i < log.size(); ++i)
    if (log.event(i).kind == EventKind::rhs && log.event(i).node == node) changes.push_back(i + 1);
  ASSERT_GE(changes.size(), 2u);
  for (std::size_t i = changes.size(); i-- > 0;) {
    at.go(GoToChange{EventKind::rhs, node, -1});
    EXPECT_EQ(at.cursor(), changes[i]);
  }
  at.go(GoToChange{EventKind::rhs, node, -1});
  EXPECT_EQ(at.cursor(), changes.front());
  EXPECT_EQ(at.session.log().back(), "rhs(11, 6) does not change before here");
  for (std::size_t i = 1; i < changes.size(); ++i) {
    at.go(GoToChange{EventKind::rhs, node, 1});
    EXPECT_EQ(at.cursor(), changes[i]);
  }
  at.go(GoToChange{EventKind::rhs, node, 1});
  EXPECT_EQ(at.cursor(), changes.back());
  EXPECT_EQ(at.session.log().back(), "rhs(11, 6) does not change after here");
  EXPECT_FALSE(at.session.apply(GoToChange{EventKind::rhs, 24 * 16, 1}).ok());
}

TEST(SessionBreakpoints, aChangeBeyondTheLogIsRunOnTo) {
  Standing at;
  const std::size_t planned = at.session.run().timeline().size();
  at.go(GoToChange{EventKind::scalar, static_cast<NodeId>(Scalar::replans), 1});
  EXPECT_GT(at.cursor(), planned);
  EXPECT_EQ(at.session.run().timeline().state().scalar(Scalar::replans), 1u);
}

TEST(SessionBreakpoints, stepsToTheGoalAndBack) {
  Standing at;
  at.go(Step{StepUnit::mission, 1});
  EXPECT_EQ(at.latest().kind, EventKind::arrival);
  at.go(Step{StepUnit::mission, -1});
  EXPECT_EQ(at.cursor(), 0u);
  at.go(Step{StepUnit::mission, 1});
  const std::size_t arrival = at.cursor();
  at.go(Step{StepUnit::mission, 1});
  EXPECT_EQ(at.cursor(), at.session.run().timeline().size()) << "behind the arrival there is the end";
  EXPECT_GE(at.cursor(), arrival);
}

TEST(SessionBreakpoints, withoutAnArrivalTheStepGoesToTheEnd) {
  Scenario scenario = wall_with_gaps();
  scenario.map.set({12, 13}, true);
  scenario.robot.patience = 1;
  Session session(scenario);
  session.settle();
  ASSERT_TRUE(session.apply(Seek{0}).ok());
  ASSERT_TRUE(session.apply(Step{StepUnit::mission, 1}).ok());
  session.settle();
  EXPECT_EQ(session.run().decisions().back().state, MissionState::no_path);
  EXPECT_EQ(session.run().timeline().cursor(), session.run().timeline().size());
}

TEST(SessionBreakpoints, areSavedButNeitherUndoneNorModifications) {
  Standing at;
  at.go(AddBreakpoint{"km > 5"});
  at.go(AddBreakpoint{"taken"});
  at.go(SwitchBreakpoint{1, false});
  at.go(AddWatch{"size(U)"});
  EXPECT_FALSE(at.session.modified());
  EXPECT_EQ(at.session.undo_text(), "");
  const DebugSetup right{{{"km > 5", true}, {"taken", false}}, {"size(U)"}};
  EXPECT_EQ(at.session.to_save().debug, right);
  at.go(PaintCells{{{{4, 4}, true}}, 1});
  at.go(Undo{});
  EXPECT_EQ(at.session.debug(), right);
  Session again(at.session.to_save());
  EXPECT_EQ(again.debug(), right);
  at.go(ReplaceScenario{wall_with_gaps(), "", 0, {}});
  EXPECT_EQ(at.session.debug(), DebugSetup{});
}

TEST(SessionBreakpoints, onASmallerWorldTheyWaitForALargerOne) {
  Standing at;
  at.go(AddBreakpoint{"g(20, 8) < 100"});
  at.go(AddWatch{"g(20, 8)"});
  at.go(GenerateWorld{"cells", {}, 10, 10, 1});
  ASSERT_EQ(at.session.scenario().map.width, 10);
  EXPECT_NE(at.session.breakpoints().problem(0).find("outside the world"), std::string::npos);
  EXPECT_NE(at.session.watches().problem(0).find("outside the world"), std::string::npos);
  EXPECT_EQ(at.session.watches().value(0, 0), HUGE_VAL);
  EXPECT_FALSE(at.session.apply(GoToBreakpoint{1}).ok());
  at.go(Undo{});
  EXPECT_EQ(at.session.breakpoints().problem(0), "");
  EXPECT_FALSE(at.session.breakpoints().hits().empty());
}

TEST(Watches, areExactAtTheCursorAndKeepThePeaks) {
  Standing at;
  at.go(AddWatch{"size(U)"});
  at.go(AddWatch{"expansions - moves"});
  at.go(AddWatch{"g(20, 8)"});
  EXPECT_FALSE(at.session.apply(AddWatch{"km > 5"}).ok());
  at.go(Step{StepUnit::mission, 1});
  const auto& run = at.session.run();
  std::size_t most = 0;
  std::int64_t expansions = 0;
  bool popped = false;
  SearchState state = run.timeline().state_at(0);
  for (std::size_t p = 0; p <= run.timeline().size(); ++p) {
    if (p > 0) {
      const Event event = run.timeline().event(p - 1);
      state.apply(event);
      if (event.kind == EventKind::plan_begin) popped = false;
      if (event.kind == EventKind::pop) popped = true;
      expansions += popped && event.kind == EventKind::visit;
    }
    most = std::max(most, state.queue_size());
    if (p % 97 != 0) continue;
    ASSERT_TRUE(at.session.apply(Seek{p}).ok());
    EXPECT_EQ(at.session.watches().value(0, 0), static_cast<double>(state.queue_size())) << p;
    EXPECT_EQ(at.session.watches().value(0, 1),
              static_cast<double>(expansions) - static_cast<double>(state.scalar(Scalar::moves)))
        << p;
    EXPECT_EQ(at.session.watches().value(0, 2), state.g(run.lattice().node(Cell{20, 8})).to_double()) << p;
  }
  const auto series = at.session.watches().series(0, 0);
  ASSERT_FALSE(series.empty());
  EXPECT_LE(series.size(), WatchSeries::kMostPoints);
  EXPECT_EQ(series.front(), (WatchPoint{0, 0}));
  const auto peak = std::max_element(series.begin(), series.end(),
                                     [](const auto& a, const auto& b) { return a.value < b.value; });
  EXPECT_EQ(peak->value, static_cast<double>(most));
  for (const WatchPoint& point : series)
    EXPECT_EQ(point.value, static_cast<double>(run.timeline().state_at(point.position).queue_size()));
  at.go(RemoveWatch{0});
  EXPECT_EQ(at.session.watches().list().front(), "expansions - moves");
  EXPECT_EQ(at.session.watches().series(0, 1).front(), (WatchPoint{0, HUGE_VAL}));
}

TEST(Watches, aSeriesThinsOutAndIsTakenUpAgainAfterACut) {
  Random random(5);
  for (int round = 0; round < 50; ++round) {
    std::vector<WatchPoint> all;
    for (std::size_t p = 0; p < 60'000; p += 1 + random.below(20)) all.push_back({p, 1000 * random.unit()});
    WatchSeries series;
    for (const WatchPoint& point : all) series.add(point);
    const std::size_t cut = random.below(60'000);
    const std::size_t from = series.truncate(cut);
    ASSERT_LE(from, cut);
    for (const WatchPoint& point : series.points()) ASSERT_LE(point.position, cut);
    const bool any = !series.points().empty();
    const std::size_t last = any ? series.points().back().position : 0;
    for (const WatchPoint& point : all)
      if (point.position >= from && (!any || point.position > last)) series.add(point);
    const auto points = series.points();
    ASSERT_LE(points.size(), WatchSeries::kMostPoints);
    const auto by_value = [](const WatchPoint& a, const WatchPoint& b) { return a.value < b.value; };
    EXPECT_EQ(*std::max_element(points.begin(), points.end(), by_value),
              *std::max_element(all.begin(), all.end(), by_value));
    EXPECT_EQ(*std::min_element(points.begin(), points.end(), by_value),
              *std::min_element(all.begin(), all.end(), by_value));
    EXPECT_EQ(points.back(), all.back());
    for (std::size_t i = 1; i < points.size(); ++i) ASSERT_LT(points[i - 1].position, points[i].position);
  }
}

}  // namespace
}  // namespace replan::session_breakpoints_test
