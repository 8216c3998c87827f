// On a thread or in step: the same logs, the same settled sessions.
#include <algorithm>
#include <ostream>

#include <gtest/gtest.h>

#include "core/base/hash.hpp"
#include "core/session/fresh_plan.hpp"
#include "core/session/session.hpp"
#include "core/world/library.hpp"

namespace replan::work_places_test {
namespace {

std::uint64_t hash_of(const Run& run, std::size_t end) {
  std::uint64_t hash = end;
  for (std::size_t i = 0; i < end; ++i) {
    const Event event = run.timeline().event(i);
    hash = hash_combine(hash, event.delta);
    hash = hash_combine(hash, std::uint64_t{event.node} << 16 | std::uint64_t{event.line} << 8 |
                                  static_cast<std::uint64_t>(event.kind));
  }
  return hash;
}

/// What can be seen of a session that has come to rest.
struct Seen {
  struct Pane {
    std::uint64_t log = 0, state = 0;
    std::size_t cursor = 0, decisions = 0, milestones = 0;
    std::vector<std::uint32_t> curve = {};
    friend bool operator==(const Pane&, const Pane&) = default;
  };
  std::vector<Pane> panes;
  std::vector<std::string> log;
  std::string undo, stopped, comparison;
  std::vector<std::size_t> hits, breaches, disagreements, asked;
  friend bool operator==(const Seen&, const Seen&) = default;
};

/// For messages: what differs is seen at a glance.
std::ostream& operator<<(std::ostream& out, const Seen& all) {
  for (const Seen::Pane& pane : all.panes)
    out << "pane: log " << pane.log << ", state " << pane.state << ", cursor " << pane.cursor
        << ", decisions " << pane.decisions << ", milestones " << pane.milestones << ", chunks "
        << pane.curve.size() << "\n";
  for (std::size_t i = 0; i < all.asked.size(); ++i)
    out << "checks: " << all.breaches[i] << " breaches, " << all.asked[i] << " asked, "
        << all.disagreements[i] << " disagreements\n";
  for (const std::string& line : all.log) out << "log: " << line << "\n";
  return out << "undo: " << all.undo << "\nstopped: " << all.stopped << "\ncomparison: " << all.comparison
             << "\n"
             << all.hits.size() << " hits";
}

/// Of panes beside the leading one what lies before their cursors, unless all have run to their ends: how far one runs
/// ahead until it has caught up is not told by anybody.
Seen seen(const Session& session, bool at_ends) {
  Seen all;
  for (std::size_t i = 0; i < session.runs().size(); ++i) {
    const Run& run = *session.runs()[i];
    const bool whole = at_ends || i == session.lead();
    Seen::Pane pane{.state = run.timeline().state().hash(), .cursor = run.timeline().cursor()};
    pane.log = hash_of(run, whole ? run.timeline().size() : pane.cursor);
    if (whole) {
      pane.decisions = run.decisions().size();
      pane.milestones = run.milestones().size();
      pane.curve.assign(run.expansion_curve().begin(), run.expansion_curve().end());
    }
    all.panes.push_back(std::move(pane));
    all.breaches.push_back(session.checks().laws(i).breaches);
    all.disagreements.push_back(session.checks().oracle(i).disagreements);
    all.asked.push_back(session.checks().oracle(i).asked);
  }
  all.log.assign(session.log().begin(), session.log().end());
  all.undo = session.undo_text();
  all.stopped = session.breakpoints().stopped();
  all.comparison = session.checks().comparison();
  for (const Hit& hit : session.breakpoints().hits()) all.hits.push_back(hit.position);
  return all;
}

/// What is done to a session, between two looks at it.
using Deeds = std::vector<Command>;

/// A pane that has come to where it belongs may be on its way to farther on still: that is waited for too.
void rest(Session& session) {
  do session.settle();
  while (
      std::any_of(session.runs().begin(), session.runs().end(), [](const auto& run) { return run->busy(); }));
}

/// Does the deeds of each round, lets some updates go by that need not suffice, and looks once all has settled.
std::vector<Seen> carried_out(const Scenario& scenario, const std::vector<Deeds>& rounds,
                              const WorkPlace& place) {
  Session session(scenario, {}, {}, place);
  rest(session);
  std::vector<Seen> all = {seen(session, false)};
  for (const Deeds& deeds : rounds) {
    for (const Command& deed : deeds) {
      const auto done = session.apply(deed);
      EXPECT_TRUE(done.ok()) << done.error();
    }
    rest(session);
    all.push_back(seen(session, std::holds_alternative<RunToEnd>(deeds.back())));
  }
  return all;
}

void expect_the_same(const Scenario& scenario, const std::vector<Deeds>& rounds) {
  const auto threads = carried_out(scenario, rounds, WorkPlace::beside());
  const auto steps = carried_out(scenario, rounds, WorkPlace::in_steps());
  ASSERT_EQ(threads.size(), steps.size());
  for (std::size_t round = 0; round < threads.size(); ++round) {
    EXPECT_EQ(threads[round], steps[round]) << scenario.name << ", round " << round;
    EXPECT_GT(threads[round].panes.front().cursor, 0u);
  }
}

Scenario world(const char* name) {
  const auto scenario = read_scenario(std::string(REPLAN_SOURCE_DIR "/maps/") + name);
  EXPECT_TRUE(scenario.ok()) << (scenario.ok() ? "" : scenario.error());
  return *scenario;
}

TEST(WorkPlaces, RunAllShippedWorldsAlike) {
  for (const std::string& file : library_files(REPLAN_SOURCE_DIR "/maps")) {
    SCOPED_TRACE(file);
    const auto scenario = read_scenario(file);
    if (!scenario) continue;  // a map
    expect_the_same(*scenario, {{RunToEnd{}}});
  }
}

std::vector<CellChange> wall(int x, int from, int to) {
  std::vector<CellChange> cells;
  for (int y = from; y < to; ++y) cells.push_back({{x, y}, true});
  return cells;
}

/// Edits that follow one another before the repairs for those before them are done; undone and done again.
TEST(WorkPlaces, EditAlikeInTheMiddleOfRuns) {
  Scenario scenario = world("demo.json");
  scenario.planners = {{"dstar-lite", {}}, {"astar", {}}};
  Surprise later;
  later.at.move = 9;
  later.cells = wall(scenario.goal.x - 4, 2, 9);
  expect_the_same(scenario, {{Step{StepUnit::move, 3}},
                             {PaintCells{wall(9, 3, 6), 1}, PaintCells{wall(10, 4, 8), 2}},
                             {Undo{}},
                             {Redo{}, Undo{}, Undo{}, Redo{}},
                             {ScheduleSurprise{later}},
                             {RunToEnd{}},
                             {Seek{2000}, DropSurprise{wall(20, 5, 9), 3}},
                             {RunToEnd{}, SetGoal{{scenario.goal.x - 1, scenario.goal.y}, 4}},
                             {RunToEnd{}, Cancel{}, RunToEnd{}},
                             {Restart{}, RunToEnd{}},
                             {TurnWorld{}, RunToEnd{}}});
}

TEST(WorkPlaces, HuntAlike) {
  const Scenario scenario = world("demo.json");
  expect_the_same(scenario, {{AddBreakpoint{"event(replan)"}, Seek{0}, GoToBreakpoint{1}},
                             {GoToBreakpoint{1}},
                             {GoToBreakpoint{1}},
                             {GoToBreakpoint{-1}},
                             {Step{StepUnit::mission, 1}},
                             {Step{StepUnit::replan, -1}},
                             {AddWatch{"km"}, Step{StepUnit::replan, 1}}});
}

TEST(WorkPlaces, CheckAndCompareAlike) {
  Scenario scenario = world("demo.json");
  scenario.planners = {{"dstar-lite", {}}, {"dstar-lite", {}}, {"astar", {}}};
  scenario.planners[1].settings.set("range", 3);
  expect_the_same(scenario, {{SetChecks{true, true}},
                             {RunToEnd{}},
                             {FindDifference{{0, 2}, Compare::expansions}},
                             {SetPanes{4}},
                             {Lead{1}, SetLockstep{Lockstep::moves}, Seek{900}},
                             {SetPanes{1}}});
}

TEST(WorkPlaces, MakeFreshPlansAlike) {
  Session session(world("demo.json"), {}, {}, WorkPlace::in_steps());
  session.settle();
  ASSERT_TRUE(session.apply(RunToEnd{}).ok());
  session.settle();
  std::int64_t number = -1;
  FreshPlans threads(WorkPlace::beside()), steps(session.work());
  for (const Milestone& milestone : session.run().milestones()) {
    if (milestone.kind != EventKind::plan_end) continue;
    const auto plan = static_cast<std::size_t>(++number);
    ASSERT_TRUE(session.apply(Seek{milestone.event + 1}).ok());
    const FreshPlan right = plan_from_scratch(FreshPlanTask(session.run()), {});
    auto fresh = steps.of(session.run(), plan, false);
    EXPECT_FALSE(fresh) << "not where it is asked for";
    EXPECT_TRUE(steps.busy());
    for (int update = 0; update < 100'000 && !fresh; ++update) {
      session.update(0);
      fresh = steps.of(session.run(), plan, false);
    }
    ASSERT_TRUE(fresh);
    EXPECT_FALSE(steps.busy());
    const auto beside = threads.of(session.run(), plan, true);
    ASSERT_TRUE(beside);
    for (const FreshPlan& each : {*fresh, *beside}) {
      EXPECT_EQ(each.expansions, right.expansions);
      EXPECT_EQ(each.touched, right.touched);
    }
  }
  EXPECT_GT(number, 1);
}

/// A window that draws frames, and neither waits nor settles.
TEST(WorkPlaces, AFrameAtATimeComesToTheSame) {
  const Scenario scenario = world("demo.json");
  Session threads(scenario), steps(scenario, {}, {}, WorkPlace::in_steps());
  for (Session* session : {&threads, &steps}) {
    session->set_patience(std::chrono::milliseconds(0));
    session->set_share(0.2);
    ASSERT_TRUE(session->apply(SetChecks{true, true}).ok());
    ASSERT_TRUE(session->apply(RunToEnd{}).ok());
    const auto busy = [&] {
      for (const auto& run : session->runs())
        if (run->busy()) return true;
      return session->checks().busy() || session->has_steps();
    };
    for (int frame = 0; frame < 1'000'000 && busy(); ++frame) session->update(0.02);
    EXPECT_FALSE(busy());
    session->update(0.02);
  }
  const Seen right = seen(threads, true);
  EXPECT_EQ(seen(steps, true), right);
  EXPECT_GT(right.asked.front(), 1u);
}

}  // namespace
}  // namespace replan::work_places_test
