// The open list in the planner's order, against the planner itself: what it takes next is what stands first.
#include "core/debug/open_order.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/session/run.hpp"
#include "tests/support/worlds.hpp"

namespace replan::open_order_test {
namespace {

constexpr int kWorlds = 12;

/// A mission with surprises in a small random world, run to its end.
std::unique_ptr<Run> random_run(const PlannerInfo& info, Random& random) {
  Scenario scenario;
  scenario.map = GridMap(random.between(8, 16), random.between(6, 12));
  for (std::size_t cell = 0; cell < scenario.map.blocked.size(); ++cell)
    scenario.map.blocked[cell] = random.chance(0.25) ? 1 : 0;
  scenario.start = {0, 0};
  scenario.goal = {scenario.map.width - 1, scenario.map.height - 1};
  scenario.map.set(scenario.start, false);
  scenario.map.set(scenario.goal, false);
  scenario.planners = {{std::string(info.id), test::random_settings(random, info)}};
  for (std::int64_t move : {1, 3, 4}) {
    Surprise surprise;
    surprise.at.move = move;
    for (int y = 1; y + 1 < scenario.map.height; ++y)
      if (random.chance(0.5))
        surprise.cells.push_back({{random.between(1, scenario.map.width - 2), y}, random.chance(0.7)});
    scenario.surprises.push_back(surprise);
  }
  auto run = std::make_unique<Run>(std::make_shared<const Scenario>(scenario), 0);
  run->finish(Target::end());
  return run;
}

/// All of it, by a plain sort of everything that is in the list.
std::vector<OpenEntry> sorted(const Run& run) {
  std::vector<OpenEntry> entries;
  const SearchState& state = run.timeline().state();
  for (NodeId n = 0; n < state.node_count(); ++n)
    if (state.queued(n)) entries.push_back(open_entry(state, run.info().values.order, n));
  std::sort(entries.begin(), entries.end());
  return entries;
}

void expect_order(const OpenOrder& order, const std::vector<OpenEntry>& expected) {
  ASSERT_EQ(order.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(order[i], expected[i]) << "rank " << i;
    ASSERT_EQ(order.rank_of(expected[i]), i);
  }
}

TEST(OpenOrder, BeforeEveryPopTheFirstIsTheOneThatIsTaken) {
  Random random(11);
  std::size_t pops = 0;
  for (const PlannerInfo& info : planners())
    for (int world = 0; world < kWorlds && !info.can_miss(); ++world) {  // samples and children wait in no list
      const auto run = random_run(info, random);
      Timeline& log = run->timeline();
      OpenOrder order;
      for (std::size_t p = 0; p < log.size(); ++p) {
        if (log.event(p).kind != EventKind::pop) continue;
        log.seek(p);
        order.follow(run->log_view(), run->log_id());
        ASSERT_GT(order.size(), 0u) << info.id;
        ASSERT_EQ(order[0].node, log.event(p).node) << info.id << ", event " << p;
        ++pops;
      }
    }
  EXPECT_GT(pops, 1000u);
}

TEST(OpenOrder, KeptUpWithACursorIsAsSortedAnew) {
  Random random(12);
  for (const PlannerInfo& info : planners())
    for (int world = 0; world < 3; ++world) {
      const auto run = random_run(info, random);
      Timeline& log = run->timeline();
      OpenOrder order;
      for (int i = 0; i < 60; ++i) {
        const auto size = static_cast<std::uint32_t>(log.size());
        const std::size_t near = std::min<std::size_t>(log.cursor() + random.below(30), size);
        log.seek(i % 5 == 0   ? random.below(size + 1)
                 : i % 2 == 0 ? near
                              : near - std::min(near, std::size_t{40}));
        order.follow(run->log_view(), run->log_id());
        ASSERT_EQ(order.position(), log.cursor());
        expect_order(order, sorted(*run));
      }
    }
}

/// Enough to be spread over buckets and many blocks, with keys that tie.
TEST(OpenOrder, ManyEntriesAreSortedAsByComparison) {
  Random random(13);
  std::vector<OpenEntry> entries;
  for (NodeId n = 0; n < 30000; ++n)
    entries.push_back({{static_cast<std::int64_t>(random.below(500)) * (n % 7 == 0 ? 1000003 : 1)},
                       {static_cast<std::int64_t>(random.below(20))},
                       {static_cast<std::int64_t>(random.below(3))},
                       n});
  entries.push_back({Cost::infinity(), Cost::infinity(), Cost{}, 30000});
  std::vector<OpenEntry> expected = entries;
  std::sort(expected.begin(), expected.end());
  sort_entries(entries);
  EXPECT_TRUE(entries == expected);
}

/// A log of random insertions, re-keyings and removals over many nodes, long enough to split and empty
/// blocks.
TEST(OpenOrder, BlocksSplitAndEmpty) {
  constexpr std::size_t kNodes = 6000;
  Random random(14);
  const Box lattice(100, 60);
  const PlannerInfo& info = *find_planner("dstar-lite");
  const Settings settings;
  Timeline log{SearchState(kNodes)};
  std::vector<std::uint64_t> queue(kNodes);
  for (int round = 0; round < 40; ++round) {
    std::vector<Event> events;
    for (int i = 0; i < 1000; ++i) {
      const NodeId node = random.below(kNodes);
      const std::uint64_t after = random.chance(round < 20 ? 0.1 : 0.9) ? 0 : 1 + random.below(1000);
      events.push_back({queue[node] ^ after, node, EventKind::queue, 31});
      queue[node] = after;
    }
    log.append(events);
  }
  OpenOrder order;
  std::size_t longest = 0;
  for (std::size_t p = 0; p <= log.size(); p += 500) {
    log.seek(p);
    order.follow({log, lattice, info, settings}, 1);
    longest = std::max(longest, order.size());
    std::vector<OpenEntry> expected;
    for (NodeId n = 0; n < kNodes; ++n)
      if (log.state().queued(n)) expected.push_back(open_entry(log.state(), info.values.order, n));
    std::sort(expected.begin(), expected.end());
    expect_order(order, expected);
  }
  EXPECT_GT(longest, 4000u);
}

}  // namespace
}  // namespace replan::open_order_test
