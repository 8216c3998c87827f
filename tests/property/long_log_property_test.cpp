// A log that exceeds its limit, against the same log in full: wherever one looks, in whatever order, dropped
// events come back as they were. Also after edits that cut the log, and after undo.
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "core/session/session.hpp"
#include "tests/support/each_planner.hpp"
#include "tests/support/missions.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::long_log_property_test {
namespace {

/// Events of the longest logs that are compared: without key frames a look costs a whole run.
constexpr std::size_t kLongest = 8000;

/// So little that nearly everything is dropped, cut up finely and otherwise each time.
RunLimits tight_limits(Random& random) {
  RunLimits limits;
  limits.log.chunk_events = std::size_t{16} << random.below(6);
  limits.log.bytes = random.chance(0.15) ? 0 : std::size_t{1} << random.between(8, 16);
  limits.log.frame_interval = std::size_t{8} << random.below(8);
  limits.slice_iterations = random.between(1, 60);
  return limits;
}

/// Compares two logs everywhere and at random places in random order; what differs, or nothing.
std::string difference(const Run& tight, const Run& ample, Random& random) {
  const Timeline &a = tight.timeline(), &b = ample.timeline();
  if (a.size() != b.size()) return "sizes differ";
  if (a.head().hash() != b.head().hash()) return "the ends differ";
  const auto size = static_cast<std::uint32_t>(b.size());
  for (int i = 0; i < 60; ++i) {
    const std::size_t place = random.below(size);
    if (a.event(place) != b.event(place)) return "event " + std::to_string(place) + " differs";
    const std::size_t there = random.below(size + 1);
    if (a.state_at(there).hash() != b.state_at(there).hash())
      return "the states at " + std::to_string(there) + " differ";
  }
  const auto nodes = static_cast<std::uint32_t>(b.head().node_count());
  for (int i = 0; i < 30; ++i) {
    const NodeId node = random.below(nodes);
    const KindSet kinds{EventKind::g, EventKind::queue, EventKind::known};
    const std::size_t place = random.below(size + 1);
    if (a.last_event(node, kinds, place) != b.last_event(node, kinds, place)) return "last_event differs";
    if (a.next_event(node, kinds, place) != b.next_event(node, kinds, place)) return "next_event differs";
  }
  for (std::size_t i = b.size(), last = i - std::min<std::size_t>(i, 5000); i-- > last;)
    if (a.event(i) != b.event(i)) return "event " + std::to_string(i) + " differs, backwards";
  return a.log_hash() == b.log_hash() ? "" : "the logs differ, forwards";
}

/// The cursor wanders about in both logs.
std::string wandering(Run& tight, Run& ample, Random& random) {
  for (int i = 0; i < 40; ++i) {
    const std::size_t to = random.below(static_cast<std::uint32_t>(ample.timeline().size()) + 1);
    tight.timeline().seek(to);
    ample.timeline().seek(to);
    if (tight.timeline().state().hash() != ample.timeline().state().hash())
      return "the cursors' states differ at " + std::to_string(to);
  }
  return "";
}

/// Every fourth robot has a size.
Scenario scenario_of(Random& random, const PlannerInfo& info, std::uint64_t seed) {
  Scenario scenario = random_scenario(random, info);
  if (seed % 4 == 0) give_size(random, scenario);
  return scenario;
}

class LongLogs : public ::testing::TestWithParam<const PlannerInfo*> {
 protected:
  [[nodiscard]] std::uint64_t planner() const {
    return static_cast<std::uint64_t>(GetParam() - planners().data());
  }
  /// Of planners that sample or breed fewer: the log of a tree or a population is long.
  [[nodiscard]] std::uint64_t worlds() const {
    return static_cast<std::uint64_t>(trials(GetParam()->can_miss() ? 25 : 100));
  }
};

TEST_P(LongLogs, DroppedEventsComeBackAsTheyWere) {
  std::size_t dropped = 0;
  for (std::uint64_t seed = 0; seed < worlds(); ++seed) {
    Random random(seed * 1000 + planner());
    const auto scenario = std::make_shared<const Scenario>(scenario_of(random, *GetParam(), seed));
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + scenario_text(*scenario));
    replan::Run tight(scenario, 0, tight_limits(random)), ample(scenario, 0);
    tight.finish(Target::plan());
    tight.finish(Target::end());
    ample.finish(Target::end());
    if (ample.timeline().size() > kLongest) continue;
    dropped += tight.timeline().dropped() ? 1 : 0;
    ASSERT_EQ(difference(tight, ample, random), "");
    ASSERT_EQ(wandering(tight, ample, random), "");
  }
  EXPECT_GT(dropped, worlds() / 10);  // or it says nothing
}

/// Another script: some surprises of the end are gone, others are added.
std::shared_ptr<const Scenario> with_other_surprises(const Scenario& scenario, Random& random,
                                                     std::size_t& common) {
  auto changed = std::make_shared<Scenario>(scenario);
  Surprises& surprises = changed->surprises;
  common = random.below(static_cast<std::uint32_t>(surprises.size()) + 1);
  if (random.chance(0.6)) common = surprises.size();
  surprises.truncate(common);
  for (int n = random.between(common == scenario.surprises.size() ? 1 : 0, 2); n > 0; --n) {
    Surprise surprise = random_surprise(random, scenario.map);
    surprise.at = {.move = random.between(0, 30), .near = {}, .within = 0};
    surprises.push_back(surprise);
  }
  return changed;
}

TEST_P(LongLogs, AfterACutTheLogIsThatOfTheNewScriptFromTheStart) {
  std::uint64_t rebased = 0;
  for (std::uint64_t seed = 0; seed < worlds(); ++seed) {
    Random random(seed * 1000 + 500 + planner());
    auto scenario = std::make_shared<const Scenario>(scenario_of(random, *GetParam(), seed));
    replan::Run tight(scenario, 0, tight_limits(random));
    tight.finish(random.chance(0.5) ? Target::end() : Target::clock_at(random.between(0, 30)));
    for (int edit = 0; edit < 4; ++edit) {
      const std::string before = scenario_text(*scenario);
      tight.timeline().seek(random.below(static_cast<std::uint32_t>(tight.timeline().size()) + 1));
      std::size_t common = 0;
      scenario = with_other_surprises(*scenario, random, common);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", edit " + std::to_string(edit) + "\n" + before +
                   scenario_text(*scenario));
      const std::uint64_t whole = tight.log_id();
      tight.rebase(scenario, common);
      rebased += tight.common_with(whole) > 0 ? 1 : 0;  // else it begins afresh
      tight.finish(Target::end());
      replan::Run ample(scenario, 0);
      ample.finish(Target::end());
      if (ample.timeline().size() > kLongest) break;
      ASSERT_EQ(difference(tight, ample, random), "");
      ASSERT_EQ(wandering(tight, ample, random), "");
    }
  }
  EXPECT_GT(rebased, 6 * worlds() / 10);
}

/// A hash over the first events of a log.
std::uint64_t hash_of_first(const Timeline& log, std::size_t count) {
  std::uint64_t seed = count;
  for (std::size_t i = 0; i < count; ++i) {
    const Event event = log.event(i);
    seed = hash_combine(hash_combine(seed, event.delta), event.node);
    seed = hash_combine(seed, static_cast<std::uint64_t>(event.kind) << 8 | event.line);
  }
  return seed;
}

/// The logs of a session's panes and where their cursors stand.
struct Past {
  std::vector<std::size_t> sizes, cursors;
  std::vector<std::uint64_t> hashes;
};

Past past_of(const Session& session) {
  Past past;
  for (const auto& run : session.runs()) {
    past.sizes.push_back(run->timeline().size());
    past.cursors.push_back(run->timeline().cursor());
    past.hashes.push_back(hash_of_first(run->timeline(), run->timeline().size()));
  }
  return past;
}

Command random_edit(Random& random, const GridMap& map) {
  const Cell low = random_cell(random, map);
  std::vector<CellChange> cells;
  const bool blocked = random.chance(0.6);
  for (int y = low.y; y <= std::min(map.height - 1, low.y + 2); ++y)
    for (int x = low.x; x <= std::min(map.width - 1, low.x + 2); ++x) cells.push_back({{x, y}, blocked});
  if (random.chance(0.2)) {
    Surprise surprise;
    surprise.at.move = random.between(0, 30);
    surprise.cells = cells;
    return ScheduleSurprise{surprise};
  }
  if (random.chance(0.3)) return DropSurprise{cells};
  return PaintCells{cells};
}

/// Edits at random moments; then back and forth through the history: every state of the document shows the
/// log and the cursors with which it was left.
void check_undo(std::uint64_t seed, const PlannerInfo& info, std::size_t panes, int& compared, int& longer) {
  Random random(seed);
  Scenario scenario = scenario_of(random, info, seed);
  while (scenario.planners.size() < panes) scenario.planners.push_back({"dstar-lite", {}});
  SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + scenario_text(scenario));
  Session session(scenario, {}, random.chance(0.3) ? tight_limits(random) : RunLimits{});
  session.settle();
  std::vector<Past> left;
  const auto move_about = [&] {
    if (random.chance(0.5)) (void)session.apply(RunToEnd{});
    for (const auto& run : session.runs()) run->cancel();
    session.update(0);
    if (random.chance(0.8))
      (void)session.apply(
          Seek{random.below(static_cast<std::uint32_t>(session.run().timeline().size()) + 1)});
    for (const auto& run : session.runs())
      run->finish(run->decisions().empty() ? Target::plan()
                                           : Target::clock_at(run->decisions().back().clock));
    session.settle();
  };
  for (int edit = 0; edit < 4; ++edit) {
    move_about();
    const Past past = past_of(session);
    const std::size_t before = session.history_position();
    if (!session.apply(random_edit(random, scenario.map))) continue;
    if (session.history_position() != before) left.push_back(past);
    session.settle();
  }
  move_about();
  left.push_back(past_of(session));
  for (int i = 0; i < 8; ++i) {
    const std::size_t at = session.history_position();
    const std::size_t to = random.below(static_cast<std::uint32_t>(left.size()));
    if (at > 0 && random.chance(0.3))
      (void)session.apply(Undo{});
    else if (at + 1 < left.size() && random.chance(0.3))
      (void)session.apply(Redo{});
    else
      (void)session.apply(GoToHistory{to});
    session.settle();
    const Past& then = left[session.history_position()];
    for (std::size_t pane = 0; pane < panes; ++pane) {
      SCOPED_TRACE("from edit " + std::to_string(at) + " to " + std::to_string(session.history_position()));
      const Timeline& log = session.runs()[pane]->timeline();
      // Longer only where the edits between made no difference to what had happened.
      ASSERT_GE(log.size(), then.sizes[pane]);
      ASSERT_EQ(hash_of_first(log, then.sizes[pane]), then.hashes[pane]);
      ASSERT_EQ(log.cursor(), then.cursors[pane]);
      longer += log.size() > then.sizes[pane] ? 1 : 0;
      ++compared;
    }
  }
}

TEST_P(LongLogs, UndoBringsTheOldFutureBack) {
  int compared = 0, longer = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(trials(60)); ++seed) {
    check_undo(seed * 1000 + planner(), *GetParam(), 1 + seed % 2, compared, longer);
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_GT(compared, trials(500));
  EXPECT_LT(longer, compared / 4);
}

/// What a user may do while the background is at work, without waiting for it.
void meddle(Session& session, Random& random, const GridMap& map) {
  const std::uint32_t what = random.below(10);
  if (what < 5) {
    (void)session.apply(random_edit(random, map));
  } else if (what == 5) {
    (void)session.apply(Undo{});
  } else if (what == 6) {
    (void)session.apply(random.chance(0.5) ? Command(Redo{}) : Command(Cancel{}));
  } else if (what == 7) {
    (void)session.apply(SetGoal{random_cell(random, map), random.below(3)});
  } else if (what == 8) {
    (void)session.apply(Seek{random.below(static_cast<std::uint32_t>(session.run().timeline().size()) + 1)});
  } else {
    (void)session.apply(RunToEnd{});
  }
  if (random.chance(0.5)) session.update(0.01);
  if (random.chance(0.3)) std::this_thread::sleep_for(std::chrono::microseconds(random.below(2000)));
}

// An edit that does not wait until the background stands still must lead to the same as one that does: to the
// run of the scenario as it is then.
TEST_P(LongLogs, EditsWhileTheBackgroundIsAtWorkLeadToTheRunOfTheirScenario) {
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(trials(60)); ++seed) {
    Random random(seed * 1000 + 700 + planner());
    Scenario scenario = scenario_of(random, *GetParam(), seed);
    if (seed % 3 == 0) scenario.planners.push_back({"dstar-lite", {}});
    RunLimits limits;
    limits.slice_iterations = random.between(1, 50);
    Session session(scenario, {}, limits);
    for (int i = 0; i < 20; ++i) meddle(session, random, scenario.map);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + scenario_text(session.scenario()));
    session.settle();
    const auto as_it_is = std::make_shared<const Scenario>(session.scenario());
    for (std::size_t pane = 0; pane < session.runs().size(); ++pane) {
      replan::Run& run = *session.runs()[pane];
      run.finish(Target::end());
      replan::Run fresh(as_it_is, pane);
      fresh.finish(Target::end());
      if (fresh.timeline().size() > kLongest) continue;
      ASSERT_EQ(run.timeline().size(), fresh.timeline().size());
      ASSERT_EQ(hash_of_first(run.timeline(), run.timeline().size()),
                hash_of_first(fresh.timeline(), fresh.timeline().size()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, LongLogs, ::testing::ValuesIn(each_of(planners())), planner_test_name);

}  // namespace
}  // namespace replan::test::long_log_property_test
