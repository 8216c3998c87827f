// A cell's history and what a replan touched, against a plain walk over the log.
#include "core/debug/cell_history.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/debug/touched.hpp"
#include "core/scene/digest.hpp"
#include "core/session/session.hpp"

namespace replan::cell_history_test {
namespace {

constexpr std::size_t kNodes = 40;
constexpr KindSet kCosts = {EventKind::g, EventKind::rhs, EventKind::known};

std::vector<Event> random_events(std::size_t count, Random& random) {
  std::vector<Event> log;
  while (log.size() < count) {
    Event event;
    event.kind = static_cast<EventKind>(random.below(static_cast<std::uint32_t>(EventKind::gave_up) + 1));
    event.node = event.kind == EventKind::scalar ? random.below(static_cast<std::uint32_t>(Scalar::count))
                                                 : random.below(kNodes);
    event.delta = event.kind == EventKind::known || event.kind == EventKind::truth ? 1 : random.next();
    event.line = static_cast<std::uint8_t>(random.below(64));
    log.push_back(event);
  }
  return log;
}

/// The changes of a node, the newest first, by walking over everything.
std::vector<ValueChange> walked(const Timeline& log, NodeId node, KindSet kinds) {
  std::vector<ValueChange> changes;
  SearchState state(kNodes);
  for (std::size_t i = 0; i < log.size(); ++i) {
    const Event& event = log.event(i);
    const bool mine = event.node == node && kinds.has(event.kind);
    const std::uint64_t before = mine ? state.value(event.kind, node) : 0;
    state.apply(event);
    if (mine) changes.push_back({i, event.kind, event.line, before, state.value(event.kind, node)});
  }
  std::reverse(changes.begin(), changes.end());
  return changes;
}

void expect_equal(const CellHistory& history, const std::vector<ValueChange>& expected) {
  ASSERT_EQ(history.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(history[i].event, expected[i].event);
    EXPECT_EQ(history[i].kind, expected[i].kind);
    EXPECT_EQ(history[i].line, expected[i].line);
    EXPECT_EQ(history[i].before, expected[i].before);
    EXPECT_EQ(history[i].after, expected[i].after);
  }
}

TEST(CellHistory, IsTheCellsChangesWhileTheLogGrows) {
  Random random(3);
  Timeline log{SearchState(kNodes)};
  CellHistory history;
  for (int round = 0; round < 20; ++round) {
    log.append(random_events(random.below(700), random));
    const auto node = static_cast<NodeId>(round / 10);  // another cell halfway
    for (int frame = 0; frame < 1000 && (frame == 0 || !history.complete()); ++frame)
      history.follow(log, 1, node, kCosts, 3);
    for (int frame = 0; frame < 300; ++frame) history.follow(log, 1, node, kCosts, 3);
    const std::vector<ValueChange> expected = walked(log, node, kCosts);
    expect_equal(history, expected);
    for (int i = 0; i < 20; ++i) {
      const std::size_t position = random.below(static_cast<std::uint32_t>(log.size()) + 1);
      const auto behind = std::count_if(expected.begin(), expected.end(),
                                        [&](const ValueChange& c) { return c.event >= position; });
      EXPECT_EQ(history.after(position), static_cast<std::size_t>(behind));
    }
  }
}

TEST(CellHistory, ACutLogIsReadAnew) {
  Random random(4);
  Timeline log{SearchState(kNodes)};
  log.append(random_events(3000, random));
  CellHistory history;
  history.follow(log, 1, 5, kCosts, 1000);
  log.truncate(1000);
  log.append(random_events(500, random));
  history.follow(log, 2, 5, kCosts, 1000);
  EXPECT_TRUE(history.complete());
  expect_equal(history, walked(log, 5, kCosts));
}

TEST(CellHistory, PassesOverKindsThatHoldNoValueOfACell) {
  Random random(5);
  Timeline log{SearchState(kNodes)};
  log.append(random_events(2000, random));
  CellHistory history;
  history.follow(log, 1, 0, {EventKind::g, EventKind::scalar, EventKind::pop, EventKind::move}, 1000);
  expect_equal(history, walked(log, 0, {EventKind::g}));
}

/// The list of a replan is what the card over the canvas counts, and its values are those of the states
/// around.
TEST(TouchedList, IsWhatTheDigestCounts) {
  Random random(6);
  std::size_t replans = 0, touched_in_all = 0;
  for (const PlannerInfo& info : planners()) {
    Scenario scenario;
    scenario.map = GridMap(24, 16);
    scenario.start = {1, 8};
    scenario.goal = {22, 8};
    scenario.planners = {{std::string(info.id), {}}};
    for (std::int64_t move : {2, 5, 6}) {
      Surprise surprise;
      surprise.at.move = move;
      for (int y = random.between(0, 5); y < 12; ++y)
        surprise.cells.push_back({{8 + static_cast<int>(move), y}, true});
      scenario.surprises.push_back(surprise);
    }
    replan::Run run(std::make_shared<const Scenario>(scenario), 0);
    run.finish(Target::end());
    RunDigest digest;
    digest.read(run);
    for (const PlanSpan& plan : digest.plans().subspan(1)) {
      TouchedList list;
      const std::size_t middle = plan.begin + (plan.end - plan.begin) / 2;
      for (const std::size_t end : {middle, plan.end, middle}) {
        list.follow(run.log_view(), run.log_id(), plan.begin, end);
        EXPECT_EQ(list.list().size(), digest.touches_before(plan, end).size()) << info.id;
        const SearchState before = run.timeline().state_at(plan.begin), after = run.timeline().state_at(end);
        for (const Touched& each : list.list()) {
          ASSERT_EQ(list.find(each.node), &each);
          EXPECT_EQ(each.g_before, before.g(each.node));
          EXPECT_EQ(each.g_after, after.g(each.node)) << info.id;
          EXPECT_EQ(each.rhs_before, before.rhs(each.node));
          EXPECT_EQ(each.rhs_after, after.rhs(each.node));
        }
      }
      TouchedList in_parts;
      do in_parts.follow(run.log_view(), run.log_id(), plan.begin, plan.end, Deadline(0));
      while (in_parts.behind());
      EXPECT_EQ(in_parts.list().size(), digest.touches_before(plan, plan.end).size()) << info.id;
      ++replans;
      touched_in_all += static_cast<std::size_t>(plan.touched);
    }
  }
  EXPECT_GT(replans, 5u);
  EXPECT_GT(touched_in_all, 500u);
}

}  // namespace
}  // namespace replan::cell_history_test
