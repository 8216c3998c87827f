// Panes in lockstep over random missions: what each mode promises holds at random places of the leading log,
// whichever way they are reached and however far the other runs had come.
#include <cstdio>

#include <gtest/gtest.h>

#include "core/session/session.hpp"
#include "tests/support/missions.hpp"
#include "tests/support/panes.hpp"

namespace replan::test::lockstep_property_test {
namespace {

constexpr int kMissions = 120;
constexpr Lockstep kModes[] = {Lockstep::expansions, Lockstep::moves, Lockstep::race};

Scenario random_comparison(Random& random) {
  const auto infos = planners();
  Scenario scenario = random_scenario(random, infos[static_cast<std::size_t>(random.between(0, 5))]);
  // A twin of the first one in every other mission: it must stand exactly where the leading one stands.
  const int more = random.between(1, 3);
  for (int i = 0; i < more; ++i) {
    const PlannerInfo& info = infos[static_cast<std::size_t>(random.between(0, 5))];
    scenario.planners.push_back(i == 0 && random.chance(0.5)
                                    ? scenario.planners.front()
                                    : PlannerChoice{std::string(info.id), random_settings(random, info)});
  }
  return scenario;
}

void run_to_the_end(Session& session) {
  for (const auto& run : session.runs()) run->finish(Target::end());
  session.update(0);
}

/// The events that are expansions: the visits of an iteration. What a planner wipes before it iterates is
/// none.
std::vector<std::size_t> expansions_of(const Run& run) {
  std::vector<std::size_t> all;
  bool iterates = false;
  for (std::size_t p = 0; p < run.timeline().size(); ++p) {
    const EventKind kind = run.timeline().event(p).kind;
    if (kind == EventKind::pop) iterates = true;
    if (kind == EventKind::plan_begin) iterates = false;
    if (iterates && kind == EventKind::visit) all.push_back(p);
  }
  return all;
}

/// Counted event by event and decision by decision.
struct Counted {
  std::int64_t clock = -1, plan = 0, expansions = 0, total = 0;
};
Counted count(const Run& run, std::size_t position) {
  Counted counted;
  std::size_t begin = 0;
  for (const Decision& decision : run.decisions()) {
    if (decision.event > position) break;
    counted.plan = decision.clock == counted.clock ? counted.plan + 1 : 0;
    counted.clock = decision.clock;
    begin = decision.event;
  }
  for (const std::size_t p : expansions_of(run)) {
    if (p >= position) break;
    ++counted.total;
    if (p >= begin) ++counted.expansions;
  }
  return counted;
}

std::int64_t last_clock(const Run& run) {
  return run.decisions().back().clock;
}
/// The number of the last decision at a step, and -1 if the run passed over that step.
std::int64_t last_plan(const Run& run, std::int64_t clock) {
  std::int64_t plan = -1;
  for (const Decision& decision : run.decisions()) plan += decision.clock == clock ? 1 : 0;
  return plan;
}
/// Whether the robot waited through a step: it is at an earlier one before, and at a later one after.
bool passed_over(const Run& run, std::int64_t clock) {
  return last_plan(run, clock) < 0 && last_clock(run) > clock;
}
/// What a pane does after its decision number `plan` of a step, up to the next one.
struct Search {
  std::int64_t length = 0;       ///< in expansions
  std::int64_t next_clock = -1;  ///< of the robot, once the plan stands; a wait may come before the search
};
Search search_after(const Run& run, std::int64_t clock, std::int64_t plan) {
  const auto decisions = run.decisions();
  std::size_t next = clock < 0 ? 0 : static_cast<std::size_t>(plan) + 1;
  for (std::size_t i = 0; clock >= 0 && i < decisions.size() && decisions[i].clock < clock; ++i) ++next;
  if (next >= decisions.size()) return {0, clock};
  Search search{0, decisions[next].clock};
  for (const std::size_t p : expansions_of(run))
    search.length += p >= (next == 0 ? 0 : decisions[next - 1].event) && p < decisions[next].event ? 1 : 0;
  return search;
}

void expect_same_expansions(const Run& leader, const Run& other) {
  const Counted wanted = count(leader, leader.timeline().cursor());
  const Counted got = count(other, other.timeline().cursor());
  if (wanted.clock > last_clock(other)) {
    EXPECT_EQ(other.timeline().cursor(), other.timeline().size()) << "its run had ended";
    return;
  }
  if (wanted.clock >= 0 && passed_over(other, wanted.clock)) {
    EXPECT_LT(got.clock, wanted.clock);
    return;
  }
  const std::int64_t plan = std::min(wanted.plan, std::max<std::int64_t>(0, last_plan(other, wanted.clock)));
  const Search search = search_after(other, wanted.clock, plan);
  if (got.clock == wanted.clock && got.plan == plan) {
    EXPECT_EQ(got.expansions, std::min(wanted.expansions, search.length))
        << "step " << wanted.clock << ", plan " << wanted.plan << ", leader at " << leader.timeline().cursor()
        << ", other at " << other.timeline().cursor();
  } else {
    // Its plan had ended and stands.
    EXPECT_EQ(got.clock, search.next_clock);
    EXPECT_EQ(got.expansions, 0);
    EXPECT_LE(search.length, wanted.expansions);
  }
}

void expect_same_step(const Run& leader, const Run& other) {
  const Counted wanted = count(leader, leader.timeline().cursor());
  const std::size_t cursor = other.timeline().cursor();
  const Counted got = count(other, cursor);
  if (leader.timeline().cursor() == 0) {
    EXPECT_EQ(cursor, 0u);
  } else if (wanted.clock > last_clock(other)) {
    EXPECT_EQ(cursor, other.timeline().size()) << "its run had ended";
  } else {
    const bool waited = wanted.clock >= 0 && passed_over(other, wanted.clock);
    if (waited) {
      EXPECT_LT(got.clock, wanted.clock);
    } else {
      EXPECT_EQ(got.clock, std::max<std::int64_t>(0, wanted.clock));
    }
    if (wanted.clock >= 0) {
      EXPECT_EQ(got.plan, last_plan(other, got.clock));
    }
    EXPECT_EQ(other.decision_at(cursor)->event, cursor) << "its plan stands";
  }
}

void expect_same_race(const Run& leader, const Run& other) {
  const std::int64_t wanted = count(leader, leader.timeline().cursor()).total;
  const std::int64_t got = count(other, other.timeline().cursor()).total;
  if (other.timeline().cursor() == other.timeline().size()) {
    EXPECT_LE(got, wanted);
  } else {
    EXPECT_EQ(got, wanted);
  }
}

void expect_lockstep(const Session& session) {
  const Run& leader = session.run();
  const bool at_end = leader.timeline().cursor() == leader.timeline().size();
  for (const auto& other : session.runs()) {
    if (other.get() == &leader) continue;
    if (at_end) {
      EXPECT_EQ(other->timeline().cursor(), other->timeline().size()) << "all stand at their ends";
    } else if (session.lockstep() == Lockstep::expansions) {
      expect_same_expansions(leader, *other);
    } else if (session.lockstep() == Lockstep::moves) {
      expect_same_step(leader, *other);
    } else {
      expect_same_race(leader, *other);
    }
  }
}

std::vector<std::size_t> cursors(const Session& session) {
  std::vector<std::size_t> all;
  for (const auto& run : session.runs()) all.push_back(run->timeline().cursor());
  return all;
}

/// Random places of the leading log, its beginning, decisions and end among them.
std::vector<std::size_t> places(Random& random, const Run& run) {
  std::vector<std::size_t> all = {0, run.timeline().size()};
  for (int i = 0; i < 12; ++i) {
    all.push_back(static_cast<std::size_t>(random.between(0, static_cast<int>(run.timeline().size()))));
    all.push_back(next_stop(run, all.back(), StepUnit::expansion));
    all.push_back(run.decisions()[static_cast<std::size_t>(
                                      random.between(0, static_cast<int>(run.decisions().size()) - 1))]
                      .event);
  }
  return all;
}

TEST(LockstepProperty, EachModeKeepsItsPromiseWhicheverWayAPlaceIsReached) {
  std::int64_t checked = 0, moved = 0;
  for (int mission = 0; mission < kMissions; ++mission) {
    Random random(static_cast<std::uint64_t>(mission) + 1);
    const Scenario scenario = random_comparison(random);
    Session session(scenario);
    run_to_the_end(session);
    for (const auto& run : session.runs())
      EXPECT_EQ(expansions_until(*run, run->timeline().size()),
                run->decisions().back().figures.counters.expansions)
          << run->choice().id << " counts them itself";
    ASSERT_TRUE(session.apply(Lead{random.below(static_cast<std::uint32_t>(scenario.planners.size()))}).ok());
    std::vector<std::size_t> order = places(random, session.run());
    for (const Lockstep mode : kModes) {
      SCOPED_TRACE("mission " + std::to_string(mission) + ", mode " + std::to_string(static_cast<int>(mode)));
      ASSERT_TRUE(session.apply(SetLockstep{mode}).ok());
      std::map<std::size_t, std::vector<std::size_t>> found;
      std::sort(order.begin(), order.end());
      for (const std::size_t place : order) {
        ASSERT_TRUE(session.apply(Seek{place}).ok());
        expect_lockstep(session);
        found.emplace(place, cursors(session));
        ++checked;
      }
      for (std::size_t i = order.size(); i-- > 0;) {
        const std::size_t place =
            order[i % 2 == 0 ? i : random.below(static_cast<std::uint32_t>(order.size()))];
        ASSERT_TRUE(session.apply(Seek{place}).ok());
        EXPECT_EQ(cursors(session), found[place]) << "at " << place << ", reached another way";
      }
      moved += found.size() > 2 && found.rbegin()->second != found.begin()->second ? 1 : 0;
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(moved, kMissions * 2);  // or nothing was shown
  std::printf("[ lockstep ] %lld places checked in %d missions\n", static_cast<long long>(checked),
              kMissions);
}

TEST(LockstepProperty, PanesThatHaveYetToRunStandWhereTheyWouldStandInAFinishedRun) {
  for (int mission = 0; mission < kMissions / 3; ++mission) {
    Random random(static_cast<std::uint64_t>(mission) + 1000);
    const Scenario scenario = random_comparison(random);
    Session whole(scenario);
    run_to_the_end(whole);
    for (const Lockstep mode : kModes) {
      SCOPED_TRACE("mission " + std::to_string(mission) + ", mode " + std::to_string(static_cast<int>(mode)));
      Session session(scenario);
      session.settle();
      ASSERT_TRUE(session.apply(SetLockstep{mode}).ok());
      ASSERT_TRUE(whole.apply(SetLockstep{mode}).ok());
      for (int i = 0; i < 15; ++i) {
        const auto unit = static_cast<StepUnit>(random.below(4));
        ASSERT_TRUE(session.apply(Step{unit, random.chance(0.7) ? 1 : -1}).ok());
        settle_panes(session);
        ASSERT_TRUE(whole.apply(Seek{session.run().timeline().cursor()}).ok());
        EXPECT_EQ(cursors(session), cursors(whole));
      }
      if (HasFailure()) return;
    }
  }
}

TEST(LockstepProperty, ATwinStandsWhereTheLeaderStands) {
  for (int mission = 0; mission < kMissions / 3; ++mission) {
    Random random(static_cast<std::uint64_t>(mission) + 2000);
    Scenario scenario = random_comparison(random);
    scenario.planners = {scenario.planners.front(), scenario.planners.front()};
    Session session(scenario);
    run_to_the_end(session);
    for (const std::size_t place : places(random, session.run())) {
      const std::size_t stop = next_stop(session.run(), place, StepUnit::expansion);
      ASSERT_TRUE(session.apply(Seek{stop}).ok());
      // By value: of two temporaries it would give references.
      const auto [low, high] =
          std::minmax({session.runs()[0]->timeline().cursor(), session.runs()[1]->timeline().cursor()});
      for (const std::size_t p : expansions_of(session.run()))
        EXPECT_FALSE(low <= p && p < high) << "one has expanded more";
      const auto decisions = session.run().decisions();
      for (const Decision& decision : decisions)
        if (low < decision.event && decision.event < high) ADD_FAILURE() << "one has decided more often";
      if (HasFailure()) FAIL() << "mission " << mission << " at " << stop;
    }
  }
}

}  // namespace
}  // namespace replan::test::lockstep_property_test
