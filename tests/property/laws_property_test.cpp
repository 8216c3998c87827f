// The law checker looks only at what a step touched. On random missions of every planner, sound or broken on
// purpose, and on logs with one wrong event in them, it finds its first breach exactly where brute force,
// which looks at every vertex after every step, finds one.
#include <cstdio>
#include <memory>

#include <gtest/gtest.h>

#include "core/debug/law_checker.hpp"
#include "core/sim/mission.hpp"
#include "core/trace/timeline.hpp"
#include "tests/support/each_planner.hpp"
#include "tests/support/law_oracle.hpp"
#include "tests/support/missions.hpp"
#include "tests/support/trials.hpp"

namespace replan::test::laws_property_test {
namespace {

const int kMissions = trials(3000);  // of each planner
constexpr std::size_t kMostEvents = 12000;

/// A mission's log and what an instrument reads of it.
struct Log {
  Scenario scenario;
  const PlannerInfo* info;
  Box lattice;
  std::vector<Event> events;

  [[nodiscard]] Timeline timeline() const {
    Timeline timeline(initial_state(scenario, scenario.planners.front()));
    timeline.append(events);
    return timeline;
  }
  [[nodiscard]] LogView view(const Timeline& timeline) const {
    return {timeline, lattice, *info, scenario.planners[0].settings, scenario.robot.radius};
  }
};

Log drive(Scenario scenario) {
  const PlannerChoice& choice = scenario.planners[0];
  Log log{scenario, find_planner(choice.id), Box(scenario.map.width, scenario.map.height), {}};
  Recorder recorder;
  const auto mission = make_mission(scenario, choice, &recorder);
  while (mission->advance(64) && recorder.buffer().size() < kMostEvents) {
  }
  log.events = recorder.take();
  return log;
}

/// Where both find the first breach; -1: nowhere. Fails if they disagree.
std::ptrdiff_t compare(const Log& log) {
  const Timeline timeline = log.timeline();
  LawChecker checker(log.view(timeline));
  while (checker.advance(1000)) {
  }
  EXPECT_EQ(checker.checked(), log.events.size());
  const auto fault = oracle::first_fault(log.view(timeline), log.events);
  const auto found = checker.breaches();
  EXPECT_EQ(found.empty(), !fault) << (found.empty()
                                           ? "brute force finds one at " + std::to_string(fault->position)
                                           : found.front().words);
  if (found.empty() || !fault) return -1;
  EXPECT_EQ(found.front().position, fault->position) << found.front().law << ": " << found.front().words;
  if (found.front().position == fault->position) {
    std::vector<NodeId> nodes;
    for (const Breach& breach : found)
      if (breach.position == fault->position && (nodes.empty() || nodes.back() != breach.node))
        nodes.push_back(breach.node);
    EXPECT_EQ(nodes, fault->nodes);
  }
  return static_cast<std::ptrdiff_t>(fault->position);
}

Scenario mission_of(const PlannerInfo& info, std::uint64_t seed) {
  Random random(seed * 1000 + static_cast<std::uint64_t>(&info - planners().data()));
  Scenario scenario = random_scenario(random, info, {11, 9});
  if (seed % 4 == 0) give_size(random, scenario);
  return scenario;
}

std::string about(const Log& log, std::uint64_t seed) {
  return describe_settings(*log.info, log.scenario.planners[0].settings) + ", seed " + std::to_string(seed);
}

class Laws : public ::testing::TestWithParam<const PlannerInfo*> {};

TEST_P(Laws, holdOnRandomMissionsAsBruteForceSays) {
  if (GetParam()->values.laws == "none") GTEST_SKIP() << "its values keep no laws";
  std::size_t events = 0, broken = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(kMissions); ++seed) {
    const Log log = drive(mission_of(*GetParam(), seed));
    const std::ptrdiff_t first = compare(log);
    events += log.events.size();
    broken += first >= 0 ? 1 : 0;
    if (!GetParam()->exercise) {
      EXPECT_LT(first, 0) << about(log, seed);
    }
    ASSERT_FALSE(HasFailure()) << about(log, seed);
  }
  std::printf("%s: %d missions, %zu events, a breach in %zu\n", std::string(GetParam()->id).c_str(),
              kMissions, events, broken);
  EXPECT_GT(events, static_cast<std::size_t>(kMissions) * 100);
}

/// One event left out, or one value written wrongly.
void mutate(Random& random, const PlannerInfo& info, std::vector<Event>& events) {
  for (;;) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(events.size()));
    if (!events[at].changes_value()) continue;
    if (random.chance(0.4)) {
      events.erase(events.begin() + static_cast<std::ptrdiff_t>(at));
      return;
    }
    if (info.values.waves && is_own_field(events[at].kind)) {
      const bool tag = events[at].kind == fields::kTag.kind;
      events[at].delta ^= std::uint64_t{1} << random.below(tag ? 2 : 38);
      return;
    }
    switch (events[at].kind) {
      case EventKind::g:
      case EventKind::rhs:
      case EventKind::dist:
      case EventKind::queue:
        events[at].delta ^= std::uint64_t{1} << random.below(38);
        return;
      case EventKind::lp:
      case EventKind::rp:
        events[at].delta ^= std::uint64_t{1} << random.below(5);
        return;
      case EventKind::scalar:
        if (events[at].node == static_cast<NodeId>(Scalar::km)) {
          events[at].delta ^= std::uint64_t{1} << random.below(36);
          return;
        }
        break;
      default:
        break;
    }
  }
}

TEST_P(Laws, areFoundBrokenWhereBruteForceFindsThemInALogWithOneWrongEvent) {
  if (GetParam()->values.laws == "none") GTEST_SKIP() << "its values keep no laws";
  std::size_t caught = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(kMissions); ++seed) {
    Log log = drive(mission_of(*GetParam(), seed));
    Random random(seed);
    mutate(random, *GetParam(), log.events);
    caught += compare(log) >= 0 ? 1 : 0;
    ASSERT_FALSE(HasFailure()) << about(log, seed);
  }
  std::printf("%s: %d logs with a wrong event, a breach in %zu\n", std::string(GetParam()->id).c_str(),
              kMissions, caught);
  // Not every event matters to a law: where the robot is, say, or a remote parent.
  EXPECT_GT(caught, kMissions / 3);
}

/// A checker that had read on when the log was cut finds what one finds that never read that far.
TEST_P(Laws, areTheSameAfterALogWasCut) {
  if (GetParam()->values.laws == "none") GTEST_SKIP() << "its values keep no laws";
  std::size_t cut = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(kMissions / 4); ++seed) {
    Log log = drive(mission_of(*GetParam(), seed));
    Random random(seed);
    if (random.chance(0.5)) mutate(random, *GetParam(), log.events);
    std::vector<std::size_t> marks;
    for (std::size_t i = 0; i < log.events.size(); ++i)
      if (log.events[i].kind == EventKind::plan_end) marks.push_back(i + 1);
    if (marks.empty()) continue;
    const std::size_t mark = marks[random.below(static_cast<std::uint32_t>(marks.size()))];
    Timeline timeline = log.timeline();
    LawChecker checker(log.view(timeline)), fresh(log.view(timeline));
    checker.advance(log.events.size() * random.below(4) / 3);
    timeline.truncate(mark);
    checker.rewind(mark);
    timeline.append({log.events.begin() + static_cast<std::ptrdiff_t>(mark), log.events.end()});
    for (LawChecker* each : {&checker, &fresh})
      while (each->advance(777)) {
      }
    ASSERT_EQ(checker.breach_count(), fresh.breach_count()) << about(log, seed);
    for (std::size_t i = 0; i < fresh.breaches().size(); ++i) {
      EXPECT_EQ(checker.breaches()[i].position, fresh.breaches()[i].position);
      EXPECT_EQ(checker.breaches()[i].words, fresh.breaches()[i].words);
    }
    ++cut;
  }
  EXPECT_GT(cut, kMissions / 8);
}

INSTANTIATE_TEST_SUITE_P(Planners, Laws, ::testing::ValuesIn(each_of(planners())), planner_test_name);

/// Each mistake of the exercise, and a remote parent that is trusted unseen, breaks a law in some missions.
class Mistakes : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Mistakes, areCaughtAtTheFirstBadStep) {
  const auto& [planner, setting] = GetParam();
  const PlannerInfo& info = *find_planner(planner);
  const std::string text = setting;
  int caught = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(kMissions); ++seed) {
    Scenario scenario = mission_of(info, seed);
    ASSERT_TRUE(set_from_text(scenario.planners[0].settings, info.parameters, text.substr(0, text.find('=')),
                              text.substr(text.find('=') + 1)));
    const Log log = drive(std::move(scenario));
    caught += compare(log) >= 0 ? 1 : 0;
    ASSERT_FALSE(HasFailure()) << about(log, seed);
  }
  std::printf("%s %s: a breach in %d of %d missions\n", planner, setting, caught, kMissions);
  EXPECT_GT(caught, 0);
}

INSTANTIATE_TEST_SUITE_P(All, Mistakes,
                         ::testing::Values(std::pair("broken-dstar-lite", "fault=forgotten-update"),
                                           std::pair("broken-dstar-lite", "fault=greedy-parent"),
                                           std::pair("broken-dstar-lite", "fault=key-without-km"),
                                           std::pair("broken-dstar-lite", "fault=stale-queue"),
                                           std::pair("los-dstar-lite", "remote_parents=printed"),
                                           std::pair("dld-star-lite", "remote_parents=printed")),
                         [](const auto& param) {
                           std::string name = param.param.second;
                           for (char& c : name)
                             if (c == '-' || c == '=') c = '_';
                           return name + "_" + std::string(param.param.first).substr(0, 3);
                         });

}  // namespace
}  // namespace replan::test::laws_property_test
