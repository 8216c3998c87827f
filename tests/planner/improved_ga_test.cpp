// The improved genetic algorithm, read off its log: children are made of their parents' parts, have no loops and take the
// fittest of their free neighbours; the fittest path is never lost; and no path leads through an obstacle.
#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "core/lattice/body_way.hpp"
#include "core/plan/population_values.hpp"
#include "core/plan/registry.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::improved_ga_test {
namespace {

const PlannerInfo& improved_ga() {
  return *find_planner("improved-ga");
}

template <int D>
bool sees(const BoxLattice<D>& lattice, NodeId a, NodeId b) {
  return !hit_on_way(lattice, centre_of(lattice.position(a)), centre_of(lattice.position(b)));
}

std::vector<NodeId> cells_of(const BredPath& path) {
  std::vector<NodeId> cells;
  for (const PathPlace& place : path) cells.push_back(place.cell);
  return cells;
}

/// Fitness worked out anew, from cells alone.
template <int D>
Unfitness unfitness_by_hand(const BoxLattice<D>& lattice, const Settings& settings,
                            const std::vector<NodeId>& cells) {
  Unfitness unfitness{false, Cost::zero()};
  const Cost penalty{static_cast<std::int64_t>(settings.get("hit_penalty", 200) * (1 << 30))};
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    unfitness.cost = unfitness.cost + euclidean_ceil(lattice.squared_distance(cells[i], cells[i + 1]));
    if (sees(lattice, cells[i], cells[i + 1])) continue;
    unfitness.hits = true;
    unfitness.cost = unfitness.cost + penalty;
  }
  return unfitness;
}

/// Where a path comes to a cell again, all between is left out: by a map from each cell to where it stands last.
std::vector<NodeId> without_loops(const std::vector<NodeId>& cells) {
  std::map<NodeId, std::size_t> last;
  for (std::size_t i = 0; i < cells.size(); ++i) last[cells[i]] = i;
  std::vector<NodeId> kept;
  for (std::size_t i = 0; i < cells.size(); i = last[cells[i]] + 1) kept.push_back(cells[i]);
  return kept;
}

std::vector<std::uint32_t> members(const SearchState& state) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < path_count(state); ++i)
    if (i != path_named(state, Scalar::child)) all.push_back(i);
  return all;
}

/// One child as the log tells of it: the states after the last event of each line, and the events.
struct Birth {
  SearchState before;
  std::map<int, SearchState> after;  ///< by line
  SearchState end;
  std::vector<Event> events;

  [[nodiscard]] BredPath child(int line) const {
    return bred_path(after.at(line), path_named(before, Scalar::child));
  }
  [[nodiscard]] NodeId node(Scalar which) const { return end.node(which); }
};

/// Splits a log of one lattice into children, calls `visit(birth)` for each.
template <class Visit>
void each_birth(std::span<const Event> log, SearchState& state, Visit&& visit) {
  const auto is_pop = [](const Event& event) { return event.kind == EventKind::pop; };
  auto at = std::find_if(log.begin(), log.end(), is_pop);
  for (auto i = log.begin(); i != at; ++i) state.apply(*i);
  while (at != log.end()) {
    const auto next = std::find_if(at + 1, log.end(), is_pop);
    Birth birth{.before = state, .after = {}, .end = {}, .events = {at, next}};
    for (const Event& event : birth.events) {
      state.apply(event);
      birth.after.insert_or_assign(event.line, state);
    }
    birth.end = state;
    visit(birth);
    at = next;
  }
}

template <int D>
class BirthCheck {
 public:
  BirthCheck(const BoxLattice<D>& lattice, const Settings& settings)
      : lattice_(lattice), settings_(settings) {}

  void check(const Birth& birth) {
    parents_are_the_fittest_drawn(birth);
    child_is_made_of_its_parents(birth);
    mutation_takes_the_fittest(birth);
    child_is_evaluated(birth);
    least_fit_gives_way(birth);
    ++children;
  }
  int children = 0, mutated = 0, crossed = 0, shared = 0, looped = 0, taken_in = 0;

 private:
  [[nodiscard]] Unfitness held(const SearchState& state, std::uint32_t path) const {
    return {hits_something(bred_path(state, path)), path_cost(state, path)};
  }
  void parents_are_the_fittest_drawn(const Birth& birth) {
    std::vector<std::uint32_t> drawn;
    for (const Event& event : birth.events)
      if (event.kind == EventKind::candidate) drawn.push_back(event.node);
    const auto size = static_cast<std::size_t>(settings_.get("tournament", 2));
    ASSERT_EQ(drawn.size(), 2 * size);
    for (const auto& [which, first] : {std::pair{Scalar::mother, std::size_t{0}}, {Scalar::father, size}}) {
      const std::uint32_t parent = path_named(birth.end, which);
      bool among = false;
      for (std::size_t i = first; i < first + size; ++i) {
        ASSERT_NE(drawn[i], path_named(birth.before, Scalar::child));
        ASSERT_LE(held(birth.before, parent), held(birth.before, drawn[i]));
        among |= drawn[i] == parent;
      }
      ASSERT_TRUE(among);
    }
  }
  void child_is_made_of_its_parents(const Birth& birth) {
    const auto mother = cells_of(bred_path(birth.before, path_named(birth.end, Scalar::mother))),
               father = cells_of(bred_path(birth.before, path_named(birth.end, Scalar::father)));
    const auto taken = static_cast<std::ptrdiff_t>(birth.end.scalar(Scalar::taken)),
               joined = static_cast<std::ptrdiff_t>(birth.end.scalar(Scalar::joined));
    std::vector<NodeId> whole(mother.begin(), mother.begin() + taken);
    whole.insert(whole.end(), father.begin() + joined, father.end());
    const auto before_change = cells_before_change(birth);
    ASSERT_EQ(before_change, without_loops(whole));
    looped += before_change.size() < whole.size() ? 1 : 0;
    if (joined == static_cast<std::ptrdiff_t>(father.size())) return;
    ++crossed;
    const NodeId last = mother[static_cast<std::size_t>(taken) - 1];
    ASSERT_EQ(last, birth.node(Scalar::crossed_at));
    const bool at_shared = father[static_cast<std::size_t>(joined) - 1] == last && taken > 1;
    shared += at_shared ? 1 : 0;
    if (settings_.get("crossover", 0) == 0) {
      std::set<NodeId> inner(mother.begin() + 1, mother.end() - 1);
      const bool any = std::any_of(father.begin() + 1, father.end() - 1,
                                   [&](NodeId cell) { return inner.contains(cell); });
      ASSERT_TRUE(!any || at_shared);
    }
  }
  [[nodiscard]] static std::vector<NodeId> cells_before_change(const Birth& birth) {
    int line = 0;
    for (const auto& [number, state] : birth.after)
      if (number <= 7) line = number;
    return cells_of(birth.child(line));
  }
  void mutation_takes_the_fittest(const Birth& birth) {
    const NodeId from = birth.node(Scalar::changed_from), to = birth.node(Scalar::changed_to);
    ASSERT_EQ(from == kNoNode, to == kNoNode);
    const auto before = cells_before_change(birth), after = cells_of(birth.child(10));
    if (from == kNoNode) {
      ASSERT_EQ(before, after);
      return;
    }
    ++mutated;
    const auto place =
        static_cast<std::size_t>(std::find(before.begin(), before.end(), from) - before.begin());
    ASSERT_GT(place, 0u);
    ASSERT_LT(place, before.size() - 1);
    const auto with = [&](NodeId cell) {
      std::vector<NodeId> cells = before;
      cells[place] = cell;
      return cells;
    };
    ASSERT_EQ(after, without_loops(with(to)));
    const int reach = static_cast<int>(settings_.get("mutation_reach", 1));
    Unfitness least;
    NodeId fittest = kNoNode;
    for (NodeId node = 0; node < lattice_.node_count(); ++node) {
      const auto p = lattice_.coordinates(node), q = lattice_.coordinates(from);
      int away = 0;
      for (std::size_t axis = 0; axis < D; ++axis) away = std::max(away, std::abs(p[axis] - q[axis]));
      if (away == 0 || away > reach || lattice_.blocked(node)) continue;
      const Unfitness unfitness = unfitness_by_hand(lattice_, settings_, with(node));
      if (!(unfitness < least)) continue;
      least = unfitness;
      fittest = node;
    }
    if (settings_.get("mutation", 0) == 0) {
      ASSERT_EQ(to, fittest);
    }
    ASSERT_FALSE(lattice_.blocked(to));
  }
  void child_is_evaluated(const Birth& birth) {
    const std::uint32_t child = path_named(birth.before, Scalar::child);
    const BredPath path = bred_path(birth.end, child);
    ASSERT_EQ(held(birth.end, child), unfitness_by_hand(lattice_, settings_, cells_of(path)));
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      ASSERT_EQ(path[i].hit == kNoNode, sees(lattice_, path[i].cell, path[i + 1].cell));
    ASSERT_EQ(cells_of(path), without_loops(cells_of(path)));
  }
  void least_fit_gives_way(const Birth& birth) {
    const std::uint32_t child = path_named(birth.before, Scalar::child),
                        leaves = path_named(birth.end, Scalar::child);
    bool has_twin = false;
    Unfitness worst{false, Cost::zero()}, best;
    for (const std::uint32_t i : members(birth.before)) {
      has_twin |= bred_path(birth.before, i) == bred_path(birth.end, child);
      worst = std::max(worst, held(birth.before, i));
      best = std::min(best, held(birth.before, i));
    }
    const bool fitter = held(birth.end, child) < worst;
    ASSERT_EQ(leaves != child, fitter && !has_twin);
    taken_in += leaves != child ? 1 : 0;
    if (leaves != child) {
      ASSERT_EQ(held(birth.before, leaves), worst);
    }
    const std::uint32_t leader = path_named(birth.end, Scalar::leader);
    ASSERT_LE(held(birth.end, leader), best);
    ASSERT_NE(leader, leaves);
    for (const std::uint32_t i : members(birth.end)) ASSERT_LE(held(birth.end, leader), held(birth.end, i));
  }

  const BoxLattice<D>& lattice_;
  const Settings& settings_;
};

template <int D>
void check_births(typename BoxLattice<D>::Coordinates low, typename BoxLattice<D>::Coordinates high) {
  int mutated = 0, crossed = 0, shared = 0, looped = 0, taken_in = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    Settings settings = random_settings(random, improved_ga());
    settings.set("most_cells", 9);  // so that paths share cells and close loops
    SCOPED_TRACE(describe_settings(improved_ga(), settings) + ", seed " + std::to_string(seed));
    const auto size = random_size<D>(random, low, high);
    TwinWorld<D> world(size, random_cells<D>(random, size), move_rules(settings));
    Recorder recorder;
    const auto planner = make_planner(improved_ga(), world.lattice, settings, recorder);
    SearchState state(world.lattice.node_count(), improved_ga().values.all_fields());
    planner->begin(random_free(random, world.plain), random_free(random, world.plain));
    for (int round = 0; round < 3; ++round) {
      finish(*planner);
      BirthCheck<D> check(world.lattice, settings);
      const std::vector<Event> log = recorder.take();
      each_birth(log, state, [&](const Birth& birth) { check.check(birth); });
      ASSERT_FALSE(::testing::Test::HasFatalFailure());
      mutated += check.mutated, crossed += check.crossed, shared += check.shared;
      looped += check.looped, taken_in += check.taken_in;
      const auto edits = random_edits<D>(random, world.plain, 5);
      const auto moves = world.apply(edits);
      planner->update({.cells = edits, .moves = moves}, random_free(random, world.plain));
    }
  }
  EXPECT_GT(mutated, 500);
  EXPECT_GT(crossed, 500);
  EXPECT_GT(taken_in, 300);
  EXPECT_GT(shared, 50);
  EXPECT_GT(looped, 2);
}

TEST(ImprovedGa, BreedsChildrenAsItsPageSaysIn2d) {
  check_births<2>({4, 4}, {14, 12});
}
TEST(ImprovedGa, BreedsChildrenAsItsPageSaysIn3d) {
  check_births<3>({4, 4, 3}, {8, 7, 6});
}

/// Each member joins the start and the goal on the map as it is known, and its cost is right, after every replan.
template <int D>
void check_repairs(typename BoxLattice<D>::Coordinates low, typename BoxLattice<D>::Coordinates high) {
  int kept = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    Settings settings = random_settings(random, improved_ga());
    SCOPED_TRACE(describe_settings(improved_ga(), settings) + ", seed " + std::to_string(seed));
    const auto size = random_size<D>(random, low, high);
    TwinWorld<D> world(size, random_cells<D>(random, size), move_rules(settings));
    Recorder recorder;
    const auto planner = make_planner(improved_ga(), world.lattice, settings, recorder);
    SearchState state(world.lattice.node_count(), improved_ga().values.all_fields());
    NodeId start = random_free(random, world.plain);
    const NodeId goal = random_free(random, world.plain);
    planner->begin(start, goal);
    for (int round = 0; round < 6; ++round) {
      for (const Event& event : recorder.take()) state.apply(event);
      if (start != goal && !world.lattice.blocked(start) && !world.lattice.blocked(goal))
        for (const std::uint32_t i : members(state)) {
          const auto cells = cells_of(bred_path(state, i));
          ASSERT_EQ(cells.front(), start);
          ASSERT_EQ(cells.back(), goal);
          ASSERT_EQ(path_cost(state, i), unfitness_by_hand(world.lattice, settings, cells).cost);
          ++kept;
        }
      finish(*planner);
      const auto edits = random_edits<D>(random, world.plain, 5);
      const auto moves = world.apply(edits);
      start = random_free(random, world.plain);
      planner->update({.cells = edits, .moves = moves}, start);
    }
  }
  EXPECT_GT(kept, 1000);
}

TEST(ImprovedGa, KeepsItsPopulationWhenTheMapOrTheStartChangesIn2d) {
  check_repairs<2>({6, 6}, {20, 16});
}
TEST(ImprovedGa, KeepsItsPopulationWhenTheMapOrTheStartChangesIn3d) {
  check_repairs<3>({4, 4, 3}, {8, 7, 6});
}

/// A path is free by an independent check, in worlds with gaps, without any, and with a robot of some size; where there is
/// none, it says so.
TEST(ImprovedGa, NeverReturnsAPathThroughAnObstacle) {
  int found = 0, none = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    Settings settings;
    settings.set("population", 10);
    settings.set("generations", 8);
    settings.set("hit_penalty", random.chance(0.5) ? 0 : 200);
    settings.set("seed", static_cast<double>(seed));
    const auto size = random_size<2>(random, {10, 10}, {30, 24});
    TwinWorld<2> world(size, random_cells<2>(random, size), move_rules(settings));
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    if (random.chance(0.25)) {  // the goal is walled in
      std::vector<CellEdit> wall;
      world.lattice.box().each_cell_around(world.lattice.position(goal), 1, [&](NodeId node) {
        if (node != goal && node != start && world.plain.blocked[node] == 0) wall.push_back({node, true});
      });
      world.apply(wall);
    }
    NoTrace nobody;
    const auto planner = make_planner(improved_ga(), world.lattice, settings, nobody);
    planner->begin(start, goal);
    finish(*planner);
    ASSERT_EQ(fault_of_answer<2>(improved_ga(), settings, world.plain, start, goal, *planner), "")
        << "seed " << seed;
    const Path path = planner->path();
    for (std::size_t i = 1; i < path.size(); ++i)
      ASSERT_FALSE(oracle::enters_bad(world.plain, path.point(i - 1).x, path.point(i - 1).y, path.point(i).x,
                                      path.point(i).y))
          << "seed " << seed;
    ++(planner->status() == PlanStatus::found ? found : none);
  }
  EXPECT_GT(found, 150);
  EXPECT_GT(none, 60);
}

TEST(ImprovedGa, IsTheSameForTheSameSeedAndAnotherForAnother) {
  Random random(3);
  std::vector<std::uint8_t> cells(60 * 40);
  for (std::uint8_t& cell : cells) cell = random.chance(0.15) ? 1 : 0;
  cells.front() = cells.back() = 0;
  const Grid2 world({60, 40}, cells, {});
  const auto log = [&](double seed) {
    Settings settings;
    settings.set("seed", seed);
    settings.set("generations", 5);
    Recorder recorder;
    const auto planner = make_planner(improved_ga(), world, settings, recorder);
    planner->begin(0, static_cast<NodeId>(cells.size() - 1));
    finish(*planner);
    return recorder.take();
  };
  EXPECT_TRUE(log(1) == log(1));
  EXPECT_FALSE(log(1) == log(2));
}

}  // namespace
}  // namespace replan::test::improved_ga_test
