// What the debugger tells of a population of paths: the child in hand and why it is so, the cost of each generation, and what
// is drawn.
#include <algorithm>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "core/debug/child_words.hpp"
#include "core/debug/event_words.hpp"
#include "core/debug/fitness_curve.hpp"
#include "core/scene/scene.hpp"
#include "core/session/run.hpp"
#include "tests/support/growing_log.hpp"
#include "tests/support/log_places.hpp"

namespace replan::population_debug_test {
namespace {

using test::after;

/// Two walls, each with a gap; the goal is put elsewhere at the robot's third move, if so.
std::unique_ptr<replan::Run> finished(double mutation = 0, std::optional<Cell> later_goal = {}) {
  auto scenario = std::make_shared<Scenario>();
  scenario->map = GridMap(40, 30);
  for (int y = 0; y < 30; ++y) {
    scenario->map.set({14, y}, y < 20 || y > 24);
    scenario->map.set({26, y}, y < 5 || y > 9);
  }
  scenario->start = {4, 15};
  scenario->goal = {35, 15};
  scenario->planners = {{"improved-ga", {}}};
  scenario->planners[0].settings.set("generations", 12);
  scenario->planners[0].settings.set("mutation", mutation);
  if (later_goal) {
    Surprise surprise;
    surprise.at.move = 3;
    surprise.goal = later_goal;
    scenario->surprises.push_back(surprise);
  }
  auto run = std::make_unique<replan::Run>(scenario, 0);
  run->finish(Target::end());
  return run;
}

/// Where the n-th child is done with.
std::size_t end_of_child(const replan::Run& run, std::size_t n) {
  return after(run, EventKind::pop, n + 1) - 1;
}

std::vector<FitnessPoint> curve_of(const replan::Run& run) {
  FitnessCurve read;
  read.follow(run.log_view(), run.log_id(), SIZE_MAX);
  return {read.points().begin(), read.points().end()};
}

std::vector<std::uint32_t> members(const SearchState& state) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < path_count(state); ++i)
    if (i != path_named(state, Scalar::child)) all.push_back(i);
  return all;
}

TEST(PopulationDebug, TellsTheChildInHandFromItsParentsToItsEnd) {
  const auto run = finished();
  Timeline& log = run->timeline();
  int changed = 0, alike = 0, taken_in = 0, given_up = 0;
  for (std::size_t n = 3; n < 300; n += 7) {
    const std::size_t end = end_of_child(*run, n), pop = after(*run, EventKind::pop, n);
    log.seek(end);
    const SearchState before = log.state_at(pop);
    const auto hand = child_in_hand(run->log_view());
    ASSERT_TRUE(hand.has_value());
    EXPECT_EQ(hand->number, path_named(before, Scalar::child));
    EXPECT_EQ(hand->path, bred_path(log.state(), hand->number));
    EXPECT_EQ(hand->cost, path_cost(log.state(), hand->number));
    for (const ChildInHand::Parent* parent : {&hand->mother, &hand->father}) {
      ASSERT_EQ(parent->drawn.size(), 2u);
      EXPECT_EQ(parent->path, bred_path(before, parent->chosen));
      EXPECT_LE(path_cost(before, parent->chosen), std::max(parent->drawn[0].cost, parent->drawn[1].cost));
    }
    EXPECT_NE(hand->rejected.has_value(), hand->leaves.has_value());
    ++(hand->rejected ? given_up : taken_in);
    if (hand->changed_to == kNoNode) continue;
    ++changed;
    const auto best =
        std::min_element(hand->tried.begin(), hand->tried.end(),
                         [](const auto& a, const auto& b) { return a.unfitness < b.unfitness; });
    ASSERT_NE(best, hand->tried.end());
    EXPECT_EQ(best->cell, hand->changed_to);
    EXPECT_GE(best->unfitness.cost, hand->cost);  // a loop that this closes is deleted
    alike += best->unfitness.cost == hand->cost ? 1 : 0;
  }
  EXPECT_GT(changed, 20);
  EXPECT_GT(alike, changed / 2);
  EXPECT_GT(taken_in, 3);
  EXPECT_GT(given_up, 3);
}

/// A sentence more for each thing that is decided.
TEST(PopulationDebug, SaysWhyStepByStep) {
  const auto run = finished();
  Timeline& log = run->timeline();
  std::size_t n = 0;
  while (log.state_at(end_of_child(*run, n)).scalar(Scalar::changed_to) == 0) ++n;
  const std::size_t pop = after(*run, EventKind::pop, n), end = end_of_child(*run, n);
  std::size_t told = 0;
  for (std::size_t p = pop; p <= end; ++p) {
    log.seek(p);
    const auto hand = child_in_hand(run->log_view());
    ASSERT_TRUE(hand.has_value());
    const std::size_t now = child_words(run->log_view(), *hand).size();
    ASSERT_GE(now, told) << "at event " << p;
    told = now;
  }
  EXPECT_EQ(told, 5u);
  const auto hand = child_in_hand(run->log_view());
  const std::vector<std::string> words = child_words(run->log_view(), *hand);
  EXPECT_EQ(words[0].find("The mother is path "), 0u) << words[0];
  EXPECT_EQ(words[1].find("The father is path "), 0u) << words[1];
  EXPECT_EQ(words[3].find("Mutation replaced " + node_text(run->lattice(), hand->changed_from) + " by " +
                          node_text(run->lattice(), hand->changed_to) + ", the fittest of "),
            0u)
      << words[3];
  EXPECT_NE(words[3].find(cost_text(hand->cost, 3)), std::string::npos) << words[3];
  log.seek(log.size());
  EXPECT_FALSE(child_in_hand(run->log_view()).has_value()) << "the plan stands";
}

/// A path keeps its rank while the child is bred, also where the child has taken another one's place by then.
TEST(PopulationDebug, NamesParentsByTheirFitness) {
  const auto run = finished();
  Timeline& log = run->timeline();
  int told = 0;
  for (std::size_t n = 3; n < 300; n += 7) {
    const SearchState before = log.state_at(after(*run, EventKind::pop, n));
    const auto rank_of = [&](std::uint32_t path) {
      const Unfitness own{hits_something(bred_path(before, path)), path_cost(before, path)};
      std::size_t rank = 1;
      for (const std::uint32_t other : members(before)) {
        const Unfitness its{hits_something(bred_path(before, other)), path_cost(before, other)};
        if (its < own || (its == own && other < path)) ++rank;
      }
      return rank;
    };
    log.seek(end_of_child(*run, n));
    const auto hand = child_in_hand(run->log_view());
    ASSERT_TRUE(hand.has_value());
    for (const ChildInHand::Parent* parent : {&hand->mother, &hand->father}) {
      EXPECT_EQ(parent->rank, rank_of(parent->chosen)) << "child " << n;
      for (const ChildInHand::Drawn& drawn : parent->drawn) {
        EXPECT_EQ(drawn.rank, rank_of(drawn.path));
        EXPECT_GE(drawn.rank, parent->rank) << "the fittest of those that were drawn";
      }
    }
    told += hand->leaves ? 1 : 0;
  }
  EXPECT_GT(told, 3);
}

TEST(PopulationDebug, CostsAreToldInMetresWhereLengthsAre) {
  const auto run = finished();
  run->timeline().seek(end_of_child(*run, 5));
  const auto hand = child_in_hand(run->log_view());
  ASSERT_TRUE(hand.has_value());
  const std::string cells = child_words(run->log_view(), *hand)[0],
                    metres = child_words(run->log_view(), *hand, {0.05})[0];
  EXPECT_EQ(cells.find(" m"), cells.find(" mother")) << cells;
  const double cost = hand->mother.drawn.front().cost.to_double();
  EXPECT_NE(metres.find(decimal_text(cost * 0.05, 2) + " m"), std::string::npos) << metres;
}

TEST(PopulationDebug, APlainMutationIsSaidToBeByChance) {
  const auto run = finished(1);
  Timeline& log = run->timeline();
  std::size_t n = 0;
  while (log.state_at(end_of_child(*run, n)).scalar(Scalar::changed_to) == 0) ++n;
  log.seek(end_of_child(*run, n));
  const auto hand = child_in_hand(run->log_view());
  ASSERT_TRUE(hand.has_value());
  EXPECT_TRUE(hand->tried.empty());
  const std::string words = child_words(run->log_view(), *hand)[3];
  EXPECT_NE(words.find("drawn by chance"), std::string::npos) << words;
}

/// The child as which a member was bred is like it.
TEST(PopulationDebug, KnowsWhereEachPathComesFrom) {
  const auto run = finished();
  Timeline& log = run->timeline();
  int bred = 0;
  for (std::size_t n = 10; n < 900; n += 23) {
    log.seek(end_of_child(*run, n));
    for (const std::uint32_t member : members(log.state())) {
      const auto birth = birth_of_path(run->log_view(), member);
      if (!birth) continue;  // one of the first
      ++bred;
      EXPECT_EQ(birth->number, member);
      EXPECT_EQ(birth->path, bred_path(log.state(), member));
      EXPECT_TRUE(birth->leaves.has_value());
    }
  }
  EXPECT_GT(bred, 1000);
}

/// What is kept is what is read anew, wherever the cursor goes; and a frame with nothing new reads nothing.
TEST(PopulationDebug, WhereAPathComesFromIsKeptWhileTheCursorMoves) {
  const auto run = finished();
  Timeline& log = run->timeline();
  PathBirth kept;
  std::vector<std::size_t> stops;
  for (std::size_t p = 0; p <= log.size(); p += 211) stops.push_back(p);
  for (std::size_t p = log.size(); p > 3000; p -= 3000) stops.push_back(p);
  for (std::size_t p = 0; p < log.size(); p += 5000) stops.push_back(p);
  int bred = 0;
  for (const std::size_t stop : stops) {
    log.seek(stop);
    const std::uint32_t leader = path_named(log.state(), Scalar::leader);
    if (leader == kNoNode) continue;
    const auto anew = birth_of_path(run->log_view(), leader);
    const auto held = kept.follow(run->log_view(), run->log_id(), leader);
    ASSERT_EQ(held.has_value(), anew.has_value()) << "at " << stop;
    const std::size_t read = kept.turns_read();
    kept.follow(run->log_view(), run->log_id(), leader);
    EXPECT_EQ(kept.turns_read(), read) << "at " << stop;
    if (!anew) continue;
    ++bred;
    EXPECT_EQ(held->path, anew->path) << "at " << stop;
    EXPECT_EQ(held->leaves, anew->leaves) << "at " << stop;
    EXPECT_EQ(held->tried.size(), anew->tried.size()) << "at " << stop;
  }
  EXPECT_GT(bred, 100);
}

/// A step on reads the turns of that step alone, though the fittest path may be as old as the plan.
TEST(PopulationDebug, AStepOnReadsOnlyWhatIsNew) {
  const auto run = finished();
  Timeline& log = run->timeline();
  log.seek(end_of_child(*run, 500));
  PathBirth kept;
  const std::uint32_t leader = path_named(log.state(), Scalar::leader);
  kept.follow(run->log_view(), run->log_id(), leader);
  const std::size_t before = kept.turns_read();
  for (std::size_t n = 501; n < 510; ++n) {
    log.seek(end_of_child(*run, n));
    if (path_named(log.state(), Scalar::leader) != leader) return;
    kept.follow(run->log_view(), run->log_id(), leader);
  }
  EXPECT_LE(kept.turns_read() - before, 9u);
}

/// The log of a run under way ends anywhere in a child.
TEST(PopulationDebug, WhereAPathComesFromFollowsALogThatGrows) {
  const auto run = finished();
  const Timeline& whole = run->timeline();
  Timeline log(whole.state_at(0));
  const LogView given = run->log_view(), view{log, given.lattice, given.info, given.settings};
  PathBirth kept;
  int bred = 0;
  while (log.size() < whole.size()) {
    std::vector<Event> events;
    for (std::size_t i = log.size(); i < whole.size() && events.size() < 137; ++i)
      events.push_back(whole.event(i));
    log.append(events);
    log.seek(log.size());
    const std::uint32_t leader = path_named(log.state(), Scalar::leader);
    if (leader == kNoNode) continue;
    const auto anew = birth_of_path(view, leader);
    const auto held = kept.follow(view, 1, leader);
    ASSERT_EQ(held.has_value(), anew.has_value()) << "at " << log.size();
    if (!anew) continue;
    ++bred;
    EXPECT_EQ(held->path, anew->path);
    EXPECT_EQ(held->leaves, anew->leaves);
    EXPECT_EQ(held->rejected, anew->rejected);
  }
  EXPECT_GT(bred, 100);
}

/// Against what a walk over all states finds; within a plan the fittest path never becomes dearer once it hits nothing.
TEST(PopulationDebug, TheCurveIsThatOfTheStates) {
  const auto run = finished();
  const Timeline& log = run->timeline();
  const auto curve = curve_of(*run);
  ASSERT_EQ(curve.size(), 12u);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const SearchState state = log.state_at(curve[i].event + 1);
    EXPECT_EQ(curve[i].generation, static_cast<std::int64_t>(i + 1));
    double sum = 0, least = HUGE_VAL;
    bool free = false;
    for (const std::uint32_t member : members(state)) {
      const double cost = path_cost(state, member).to_double();
      const bool hits = hits_something(bred_path(state, member));
      if (!hits && !free) least = HUGE_VAL;
      free |= !hits;
      if (hits != free) least = std::min(least, cost);
      sum += cost;
    }
    EXPECT_EQ(curve[i].free, free);
    EXPECT_DOUBLE_EQ(curve[i].fittest.to_double(), least);
    EXPECT_NEAR(curve[i].mean.to_double(), sum / static_cast<double>(members(state).size()), 1e-6);
    if (i > 0) {
      EXPECT_GE(curve[i].free, curve[i - 1].free);
      EXPECT_TRUE(curve[i].fittest <= curve[i - 1].fittest || curve[i].free > curve[i - 1].free);
    }
  }
  const std::string csv = fitness_csv(curve);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 13);
  EXPECT_EQ(csv.find("generation,best,mean,free\n1,"), 0u) << csv;
}

/// The planner counts its generations anew for a goal that has moved; the curve counts those of the whole run.
TEST(PopulationDebug, TheCurveGoesOnWhereTheGoalIsPutElsewhere) {
  const auto run = finished(0, Cell{35, 25});
  const std::vector<FitnessPoint> curve = curve_of(*run);
  ASSERT_EQ(curve.size(), 24u);
  for (std::size_t i = 0; i < curve.size(); ++i)
    EXPECT_EQ(curve[i].generation, static_cast<std::int64_t>(i + 1));
  EXPECT_EQ(run->timeline().head().scalar(Scalar::generation), 12u);
}

/// However the log is cut into slices, and however few generations are read of each.
TEST(PopulationDebug, TheCurveIsReadOnAsTheLogGrows) {
  const auto run = finished(0, Cell{35, 25});
  const std::vector<FitnessPoint> whole = curve_of(*run);
  for (const std::size_t slice : {7u, 1000u, 100000u}) {
    for (const std::size_t most : {std::size_t{1}, SIZE_MAX}) {
      FitnessCurve read;
      read_while_growing(*run, slice, [&](const LogView& view) {
        const std::size_t before = read.points().size();
        read.follow(view, 1, most);
        EXPECT_LE(read.points().size() - before, most);
      });
      while (!read.complete()) read.follow(run->log_view(), 1, most);
      ASSERT_EQ(read.points().size(), whole.size());
      for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(read.points()[i].event, whole[i].event);
        EXPECT_EQ(read.points()[i].generation, whole[i].generation);
        EXPECT_EQ(read.points()[i].fittest, whole[i].fittest);
        EXPECT_EQ(read.points()[i].mean, whole[i].mean);
        EXPECT_EQ(read.points()[i].free, whole[i].free);
      }
    }
  }
}

TEST(PopulationDebug, IsDrawnWithTheChildInHand) {
  const auto run = finished();
  Timeline& log = run->timeline();
  std::size_t n = 0;
  while (log.state_at(end_of_child(*run, n)).scalar(Scalar::changed_to) == 0) ++n;
  log.seek(end_of_child(*run, n));
  View view;
  view.overlays = {};
  view.overlays.set(Overlay::population, true);
  static const Palette palette;
  const Scene scene = build_scene(*run, view, {800, 600}, palette);
  for (const Sign sign : {Sign::population, Sign::leader, Sign::child, Sign::changed})
    EXPECT_TRUE(scene.shows(sign)) << static_cast<int>(sign);
  log.seek(log.size());
  const Scene done = build_scene(*run, view, {800, 600}, palette);
  EXPECT_TRUE(done.shows(Sign::population));
  EXPECT_FALSE(done.shows(Sign::child));
}

}  // namespace
}  // namespace replan::population_debug_test
