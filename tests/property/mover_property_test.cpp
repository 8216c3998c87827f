// Moving obstacles take all steps between two of the robot's at once. Step by step, as they took them before,
// they come to the same places at the same times.
#include <cstdio>

#include <gtest/gtest.h>

#include "core/sim/mover.hpp"
#include "tests/support/missions.hpp"

namespace replan::test::mover_property_test {
namespace {

constexpr int kCrowds = 20'000;

/// The movers of a scenario, one step after the other in the order of time and then of the list.
class Stepping {
 public:
  explicit Stepping(const Scenario& scenario) : map_(scenario.map), setups_(scenario.movers) {
    for (const MovingObstacle& setup : setups_) movers_.emplace_back(setup);
  }

  void advance(std::vector<MoverState>& states, SimTime time, std::span<const Cell> keep_clear) {
    for (;;) {
      std::size_t next = states.size();
      for (std::size_t i = 0; i < states.size(); ++i) {
        const bool due = states[i].steps >= 0 && states[i].due <= time && movers_[i].goes_on(states[i].steps);
        if (due && (next == states.size() || states[i].due < states[next].due)) next = i;
      }
      if (next == states.size()) return;
      MoverState& state = states[next];
      const Cell from = movers_[next].at(state.steps), to = movers_[next].at(state.steps + 1);
      state.due += movers_[next].pace();
      ++steps;
      const bool barred = std::any_of(keep_clear.begin(), keep_clear.end(), [&](Cell cell) {
        return covers(next, to, cell) && !covers(next, from, cell);
      });
      barred ? ++waits : ++state.steps;
    }
  }

  /// How many of them cover each cell.
  [[nodiscard]] std::vector<int> cover(const std::vector<MoverState>& states) const {
    std::vector<int> counts(map_.blocked.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (states[i].steps < 0) continue;
      for (NodeId n = 0; n < counts.size(); ++n)
        counts[n] += covers(i, movers_[i].at(states[i].steps), map_.box().position(n)) ? 1 : 0;
    }
    return counts;
  }

  std::int64_t steps = 0, waits = 0;

 private:
  [[nodiscard]] bool covers(std::size_t index, Cell corner, Cell cell) const {
    const MovingObstacle& setup = setups_[index];
    return cell.x >= corner.x && cell.x < corner.x + setup.width && cell.y >= corner.y &&
           cell.y < corner.y + setup.height && cell.z >= corner.z && cell.z < corner.z + setup.depth;
  }

  GridMap map_;
  std::vector<MovingObstacle> setups_;
  std::vector<Mover> movers_;
};

Scenario random_crowd(Random& random) {
  constexpr double kSpeeds[] = {0.01, 0.7, 3, 25, 1000};
  Scenario scenario;
  scenario.map = GridMap(random.between(1, 14), random.between(1, 10));
  if (random.chance(0.2))
    scenario.map = GridMap(random.between(1, 7), random.between(1, 6), random.between(2, 5));
  for (int n = random.between(1, 5); n > 0; --n) {
    scenario.movers.push_back(random_mover(random, scenario.map));
    scenario.movers.back().speed = kSpeeds[random.below(5)];
  }
  return scenario;
}

TEST(Movers, ComeToTheSamePlacesAtOnceAsStepByStep) {
  std::int64_t steps = 0, waits = 0, changes = 0, several = 0;
  for (std::uint64_t seed = 0; seed < kCrowds; ++seed) {
    Random random(seed);
    const Scenario scenario = random_crowd(random);
    const Crowd crowd(scenario);
    Stepping stepping(scenario);
    std::vector<MoverState> at_once = crowd.initial();
    std::vector<int> counts = stepping.cover(at_once);
    SimTime time = 0;
    for (std::int64_t clock = 1; clock < 12; ++clock) {
      time += random.between(1, 3'000'000);
      std::vector<Cell> keep_clear;
      for (int n = random.between(0, 2); n > 0; --n) keep_clear.push_back(random_cell(random, scenario.map));
      std::vector<MoverState> expected = at_once;
      const auto told = crowd.advance(at_once, time, clock, keep_clear);
      // Who has just appeared is not due before the next step of the robot.
      for (std::size_t i = 0; i < expected.size(); ++i)
        if (expected[i].steps < 0) expected[i] = at_once[i];
      const std::int64_t before = stepping.steps;
      stepping.advance(expected, time, keep_clear);
      several += stepping.steps - before > static_cast<std::int64_t>(scenario.movers.size()) ? 1 : 0;
      ASSERT_EQ(at_once, expected) << "seed " << seed << ", clock " << clock << "\n"
                                   << scenario_text(scenario);
      std::size_t cells = 0;
      for (const MovingObstacle& setup : scenario.movers)
        cells += Box(setup.width, setup.height, setup.depth).node_count();
      ASSERT_LE(told.size(), 2 * cells) << "seed " << seed;
      for (const Crowd::Change& change : told) counts[scenario.map.index(change.cell)] += change.by;
      ASSERT_EQ(counts, stepping.cover(at_once)) << "seed " << seed << ", clock " << clock;
      changes += static_cast<std::int64_t>(told.size());
    }
    steps += stepping.steps;
    waits += stepping.waits;
  }
  std::printf("%d crowds: %lld steps, %lld of them barred, told as %lld changes; %lld times several steps\n",
              kCrowds, static_cast<long long>(steps), static_cast<long long>(waits),
              static_cast<long long>(changes), static_cast<long long>(several));
  for (const std::int64_t count_of : {waits, changes, several}) EXPECT_GT(count_of, 1000);
}

}  // namespace
}  // namespace replan::test::mover_property_test
