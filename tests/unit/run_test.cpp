// A run's log as its readers see it: what stays of it when an edit cuts it.
#include "core/session/run.hpp"

#include <gtest/gtest.h>

#include "core/scene/digest.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::run_test {
namespace {

std::vector<Event> events_of(const Run& run) {
  std::vector<Event> events;
  for (std::size_t i = 0; i < run.timeline().size(); ++i) events.push_back(run.timeline().event(i));
  return events;
}

std::shared_ptr<const Scenario> open_ground() {
  Scenario scenario;
  scenario.map = GridMap(20, 12);
  scenario.start = {1, 6};
  scenario.goal = {18, 6};
  scenario.planners = {{"dstar-lite", {}}};
  return std::make_shared<const Scenario>(scenario);
}

std::shared_ptr<const Scenario> with_wall(const Scenario& scenario, std::int64_t clock, int x) {
  auto changed = std::make_shared<Scenario>(scenario);
  Surprise& surprise = changed->surprises.emplace_back();
  surprise.at.move = clock;
  surprise.announced = true;
  for (int y = 3; y < 10; ++y) surprise.cells.push_back({{x, y}, true});
  return changed;
}

TEST(RunLog, KnowsWhatItsLogHasInCommonWithEarlierOnes) {
  replan::Run run(open_ground(), 0);
  run.finish(Target::end());
  std::vector<std::pair<std::uint64_t, std::vector<Event>>> logs = {{run.log_id(), events_of(run)}};
  EXPECT_EQ(run.common_with(run.log_id()), run.timeline().size());
  EXPECT_EQ(run.common_with(run.log_id() + 1000), 0u);
  const auto base = open_ground();
  // Cut late, then earlier, then later again than that.
  const std::pair<std::int64_t, int> walls[] = {{9, 15}, {3, 10}, {6, 12}};
  for (const auto& [clock, x] : walls) {
    run.rebase(with_wall(*base, clock, x), 0);
    for (const auto& [id, events] : logs) {  // exactly as many as are equal, before anything is added
      const std::vector<Event> now = events_of(run);
      const auto parted = std::mismatch(now.begin(), now.end(), events.begin(), events.end());
      ASSERT_EQ(run.common_with(id), static_cast<std::size_t>(parted.first - now.begin()));
    }
    const std::size_t kept = run.common_with(logs.back().first);
    EXPECT_GT(kept, 0u);
    EXPECT_LT(kept, logs.back().second.size());
    run.finish(Target::end());
    EXPECT_EQ(run.common_with(logs.back().first), kept);
    EXPECT_EQ(run.common_with(run.log_id()), run.timeline().size());
    logs.emplace_back(run.log_id(), events_of(run));
  }
}

TEST(RunLog, StatesOfALogThatWasReplacedMayBeKept) {
  const auto world = open_ground();
  replan::Run run(world, 0);
  run.finish(Target::end());
  std::vector<SearchState> kept;
  std::vector<std::uint64_t> hashes;
  for (int round = 0; round < 50; ++round) {
    run.timeline().seek(run.timeline().size() * static_cast<std::size_t>(round) / 50);
    kept.push_back(run.timeline().state());
    hashes.push_back(kept.back().hash());
    run.restart(world);
    run.finish(Target::end());
    if (round % 5 != 4) continue;
    for (std::size_t i = 0; i < kept.size(); ++i) ASSERT_EQ(kept[i].hash(), hashes[i]);
    kept.clear();
    hashes.clear();
  }
  auto last = std::make_unique<replan::Run>(world, 0);
  last->finish(Target::end());
  const SearchState state = last->timeline().state();
  const std::uint64_t hash = state.hash();
  last.reset();
  EXPECT_EQ(state.hash(), hash);
}

TEST(RunLog, ADigestThatKeptItsBeginningIsThatOfTheWholeLog) {
  const auto base = open_ground();
  replan::Run run(base, 0);
  run.finish(Target::end());
  RunDigest kept;
  kept.read(run);
  const std::pair<std::int64_t, int> walls[] = {{9, 15}, {3, 10}, {6, 12}, {14, 17}};
  for (const auto& [clock, x] : walls) {
    run.rebase(with_wall(*base, clock, x), 0);
    if (clock == 6) kept.read(run);  // once in between, while there is nothing new
    run.finish(Target::end());
    kept.read(run);
    RunDigest fresh;
    fresh.read(run);
    const auto same = [](const auto& a, const auto& b) { return a.event == b.event && a.node == b.node; };
    EXPECT_TRUE(std::equal(kept.map_events().begin(), kept.map_events().end(), fresh.map_events().begin(),
                           fresh.map_events().end(), same));
    EXPECT_TRUE(std::equal(kept.touches().begin(), kept.touches().end(), fresh.touches().begin(),
                           fresh.touches().end(), same));
    ASSERT_EQ(kept.plans().size(), fresh.plans().size());
    EXPECT_GT(kept.plans().size(), 1u);
    for (std::size_t i = 0; i < kept.plans().size(); ++i) {
      EXPECT_EQ(kept.plans()[i].begin, fresh.plans()[i].begin);
      EXPECT_EQ(kept.plans()[i].end, fresh.plans()[i].end);
      EXPECT_EQ(kept.plans()[i].touched, fresh.plans()[i].touched);
      EXPECT_EQ(kept.plans()[i].last_touch, fresh.plans()[i].last_touch);
      EXPECT_EQ(kept.plans()[i].cause.blocked, fresh.plans()[i].cause.blocked);
    }
    for (std::size_t p = 0; p <= run.timeline().size(); p += 7)
      ASSERT_EQ(kept.expansions(run, p), fresh.expansions(run, p)) << p;
  }
}

}  // namespace
}  // namespace replan::test::run_test
