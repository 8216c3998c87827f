// What every registered planner owes its caller, on both lattices, traced or not.
#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/plan/replanner.hpp"
#include "core/trace/search_state.hpp"
#include "tests/support/each_planner.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::planner_conformance_test {
namespace {

/// A small world as rows of text: '#' obstacle, 'S' start, 'G' goal, 's' and 'g' the same inside an obstacle,
/// '*' both.
struct Fixture {
  const char* name;
  std::vector<std::string> rows;
  PlanStatus status;
  CornerRule corners = CornerRule::none;
};

const std::vector<Fixture>& fixtures() {
  static const std::vector<Fixture> all = {
      {"empty", {"S.......", "........", "........", ".......G"}, PlanStatus::found},
      {"wall with a gap", {"S..#....", "...#....", "...#....", "...#...G", "........"}, PlanStatus::found},
      {"rooms", {"S..#...", "...#.#.", ".#...#.", ".#####.", "...G..."}, PlanStatus::found},
      {"no path", {"S..#....", "...#....", "...#....", "...#...G"}, PlanStatus::no_path},
      {"goal walled in", {".......", ".###...", ".#G#.S.", ".###...", "......."}, PlanStatus::no_path},
      {"start walled in", {".......", ".###...", ".#S#.G.", ".###...", "......."}, PlanStatus::no_path},
      {"start is goal", {"...", ".*.", "#.#"}, PlanStatus::found},
      {"start is goal, walled in", {"###", "#*#", "###"}, PlanStatus::found},
      {"start blocked", {"s...", "..G."}, PlanStatus::start_blocked},
      {"goal blocked", {"S...", "..g."}, PlanStatus::goal_blocked},
      {"both blocked", {"s...", "..g."}, PlanStatus::start_blocked},
      {"one row", {"S........G"}, PlanStatus::found},
      {"one row, blocked", {"S...#....G"}, PlanStatus::no_path},
      {"one column", {"G", ".", ".", "S"}, PlanStatus::found},
      {"one cell", {"*"}, PlanStatus::found},
      {"neighbours", {"SG"}, PlanStatus::found},
      {"diagonal neighbours", {"S.", ".G"}, PlanStatus::found},
      {"round a corner, none", {"S#.", ".G.", "..."}, PlanStatus::found},
      {"round a corner, one", {"S#.", ".G.", "..."}, PlanStatus::found, CornerRule::one},
      {"between two corners, none", {"S#", "#G"}, PlanStatus::no_path},
      {"between two corners, one", {"S#", "#G"}, PlanStatus::no_path, CornerRule::one},
      {"between two corners, any", {"S#", "#G"}, PlanStatus::found, CornerRule::any},
      {"long way round", {"S#G..", ".#.#.", ".#.#.", ".#.#.", "...#."}, PlanStatus::found},
  };
  return all;
}

/// A fixture as a lattice; in 3D `depth` equal layers, so that walls stay walls.
template <int D>
struct Stage {
  typename BoxLattice<D>::Coordinates size{};
  std::vector<std::uint8_t> cells;
  NodeId start = 0, goal = 0;

  explicit Stage(const Fixture& fixture, int depth) {
    size[0] = static_cast<int>(fixture.rows[0].size());
    size[1] = static_cast<int>(fixture.rows.size());
    if constexpr (D == 3) size[2] = depth;
    for (int z = 0; z < (D == 3 ? depth : 1); ++z)
      for (const std::string& row : fixture.rows)
        for (const char c : row) {
          const auto node = static_cast<NodeId>(cells.size());
          if (z == 0 && (c == 'S' || c == 's' || c == '*')) start = node;
          if (z == 0 && (c == 'G' || c == 'g' || c == '*')) goal = node;
          cells.push_back(c == '#' || c == 's' || c == 'g' ? 1 : 0);
        }
  }
};

/// What a planner answered.
struct Answer {
  PlanStatus status = PlanStatus::searching;
  Cost cost;
  Path path;
  Counters counters;
  std::vector<Event> log;  ///< empty if nobody listened
};

void expect_same(const Answer& a, const Answer& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.path, b.path);
  EXPECT_EQ(a.counters.expansions, b.counters.expansions);
  EXPECT_EQ(a.counters.queue_operations, b.counters.queue_operations);
  EXPECT_EQ(a.counters.sight_checks, b.counters.sight_checks);
}

template <int D, class T>
Answer answer(const PlannerInfo& info, const BoxLattice<D>& lattice, const Settings& settings, NodeId start,
              NodeId goal, std::int64_t slice) {
  T trace;
  const auto planner = make_planner(info, lattice, settings, trace);
  planner->begin(start, goal);
  for (int i = 0; !planner->advance(slice); ++i)
    if (i > 1'000'000) break;
  Answer result{.status = planner->status(),
                .cost = planner->cost(),
                .path = planner->path(),
                .counters = {},
                .log = {}};
  result.counters = planner->counters();
  if constexpr (T::kEnabled) result.log = trace.take();
  return result;
}

void expect_counters_match(const Answer& answer) {
  const auto count = [&answer](EventKind kind) {
    return std::count_if(answer.log.begin(), answer.log.end(),
                         [kind](const Event& e) { return e.kind == kind; });
  };
  EXPECT_EQ(answer.counters.expansions, count(EventKind::visit));
  EXPECT_EQ(answer.counters.queue_operations, count(EventKind::queue));
  EXPECT_EQ(answer.counters.sight_checks, count(EventKind::sight));
}

template <int D>
void check_fixture(const PlannerInfo& info, const Fixture& fixture, int depth, Settings settings) {
  SCOPED_TRACE(std::string(fixture.name) + ", depth " + std::to_string(depth));
  settings.set("corners", static_cast<double>(fixture.corners));
  if (info.sampling)
    settings.set("samples", std::min<double>(kFewSamples, settings.get("samples", kFewSamples)));
  if (info.evolving)
    settings.set("generations",
                 std::min<double>(kFewGenerations, settings.get("generations", kFewGenerations)));
  const Stage<D> stage(fixture, depth);
  const TwinWorld<D> world(stage.size, stage.cells, move_rules(settings));
  const auto ask = [&](auto trace, std::int64_t slice) {
    return answer<D, decltype(trace)>(info, world.lattice, settings, stage.start, stage.goal, slice);
  };
  const Answer whole = ask(Recorder{}, std::int64_t{1} << 30), sliced = ask(Recorder{}, 1);
  EXPECT_TRUE(is_right(info, whole.status, fixture.status)) << status_name(whole.status);
  EXPECT_EQ(whole.cost.is_infinite(), whole.status != PlanStatus::found);
  EXPECT_TRUE(path_is_free(world.lattice, whole.path) || whole.path.empty());
  expect_counters_match(whole);
  expect_same(whole, sliced);
  EXPECT_TRUE(whole.log == sliced.log) << "slices change the log";
  expect_same(whole, ask(NoTrace{}, std::int64_t{1} << 30));
  expect_same(whole, ask(NoTrace{}, 1));
  NoTrace nobody;
  const auto planner = make_planner(info, world.lattice, settings, nobody);
  planner->begin(stage.start, stage.goal);
  finish(*planner);
  EXPECT_EQ(fault_of_answer<D>(info, settings, world.plain, stage.start, stage.goal, *planner), "");
  const bool exact = info.optimal(settings) || info.values.least_cost;
  EXPECT_EQ(exact ? fault_of_plan<D>(info, settings, world.plain, stage.start, stage.goal, *planner) : "",
            "");
}

class EveryPlanner : public ::testing::TestWithParam<const PlannerInfo*> {};

TEST_P(EveryPlanner, answersTheFixturesIn2d) {
  for (const Fixture& fixture : fixtures()) check_fixture<2>(*GetParam(), fixture, 1, {});
}

TEST_P(EveryPlanner, answersTheFixturesIn3d) {
  if (GetParam()->planar) GTEST_SKIP() << "plans in the plane alone";
  for (const Fixture& fixture : fixtures())
    for (const int depth : {1, 3}) check_fixture<3>(*GetParam(), fixture, depth, {});
}

/// Who plans in the plane alone says so by name, and is not made for a world with layers.
TEST_P(EveryPlanner, fitsTheWorldsThatItIsMadeFor) {
  NoTrace trace;
  const Result<void> in_space = fits(*GetParam(), Box(4, 3, 2), 0);
  EXPECT_TRUE(fits(*GetParam(), Box(4, 3), 0));
  EXPECT_EQ(make_planner(*GetParam(), Grid2({4, 3}), {}, trace) != nullptr, true);
  EXPECT_EQ(make_planner(*GetParam(), Voxel3({4, 3, 2}), {}, trace) != nullptr, in_space.ok());
  if (!GetParam()->planar) return;
  EXPECT_NE(in_space.error().find(GetParam()->id), std::string::npos) << in_space.error();
  EXPECT_FALSE(Replanner::make(Box(4, 3, 2), std::vector<std::uint8_t>(24), GetParam()->id));
}

/// Each value of each choice and both ends of each range, one at a time.
TEST_P(EveryPlanner, answersTheFixturesUnderEverySetting) {
  for (const Parameter& parameter : GetParam()->parameters) {
    if (parameter.key == "remote_parents" || parameter.key == "corners" || parameter.key == "moves") continue;
    if (parameter.key == "impassable") continue;  // what a fixture expects to be found it may close
    std::vector<double> values = {parameter.low, parameter.high};
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) values.push_back(static_cast<double>(i));
    for (const double value : values) {
      SCOPED_TRACE(std::string(parameter.key) + " = " + format_value(parameter, value));
      Settings settings;
      settings.set(parameter.key, value);
      for (const Fixture& fixture : fixtures()) check_fixture<2>(*GetParam(), fixture, 1, settings);
    }
  }
}

/// A world, two of its cells and settings, drawn from a seed.
template <int D>
struct Trial {
  using Coordinates = typename BoxLattice<D>::Coordinates;

  Random random;
  Settings settings;
  TwinWorld<D> world;
  NodeId start, goal;

  Trial(const PlannerInfo& info, std::uint64_t seed, const Coordinates& low, const Coordinates& high)
      : random(seed),
        settings(random_settings(random, info)),
        world(drawn_world(low, high)),
        start(random_free(random, world.plain)),
        goal(random_free(random, world.plain)) {}

 private:
  TwinWorld<D> drawn_world(const Coordinates& low, const Coordinates& high) {
    const auto size = random_size<D>(random, low, high);
    return {size, random_cells<D>(random, size), move_rules(settings)};
  }
};

template <int D>
void check_random_worlds(const PlannerInfo& info, typename BoxLattice<D>::Coordinates low,
                         typename BoxLattice<D>::Coordinates high) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Trial<D> trial(info, seed, low, high);
    const auto& [random, settings, world, start, goal] = trial;
    SCOPED_TRACE(describe_settings(info, settings) + ", seed " + std::to_string(seed));
    NoTrace trace;
    const auto planner = make_planner(info, world.lattice, settings, trace);
    planner->begin(start, goal);
    const Answer recorded = answer<D, Recorder>(info, world.lattice, settings, start, goal, 7);
    expect_counters_match(recorded);
    expect_same(recorded, answer<D, NoTrace>(info, world.lattice, settings, start, goal, 1000));
    finish(*planner);
    ASSERT_EQ(fault_of_answer<D>(info, settings, world.plain, start, goal, *planner), "");
    const bool exact = info.optimal(settings) || info.values.least_cost;
    ASSERT_EQ(exact ? fault_of_plan<D>(info, settings, world.plain, start, goal, *planner) : "", "");
  }
}

TEST_P(EveryPlanner, agreesWithTheOracleOnRandomWorldsIn2d) {
  check_random_worlds<2>(*GetParam(), {1, 1}, {16, 12});
}
TEST_P(EveryPlanner, agreesWithTheOracleOnRandomWorldsIn3d) {
  if (GetParam()->planar) GTEST_SKIP() << "plans in the plane alone";
  check_random_worlds<3>(*GetParam(), {1, 1, 1}, {7, 6, 5});
}

/// After every change of the map and of its start a planner answers as it must: one whose update() does nothing
/// shows here.
template <int D>
void check_changing_worlds(const PlannerInfo& info, typename BoxLattice<D>::Coordinates low,
                           typename BoxLattice<D>::Coordinates high) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Trial<D> trial(info, seed, low, high);
    auto& [random, settings, world, start, goal] = trial;
    SCOPED_TRACE(describe_settings(info, settings) + ", seed " + std::to_string(seed));
    NoTrace trace;
    const auto planner = make_planner(info, world.lattice, settings, trace);
    planner->begin(start, goal);
    for (int round = 0; round < 8; ++round) {
      finish(*planner);
      ASSERT_EQ(fault_of_answer<D>(info, settings, world.plain, start, goal, *planner), "") << round;
      const auto edits = random_edits<D>(random, world.plain, 5);
      const auto moves = world.apply(edits);
      start = random_free(random, world.plain);
      planner->update({.cells = edits, .moves = moves}, start);
    }
  }
}

TEST_P(EveryPlanner, answersAfterEveryChangeIn2d) {
  check_changing_worlds<2>(*GetParam(), {2, 2}, {16, 12});
}
TEST_P(EveryPlanner, answersAfterEveryChangeIn3d) {
  if (GetParam()->planar) GTEST_SKIP() << "plans in the plane alone";
  check_changing_worlds<3>(*GetParam(), {2, 2, 2}, {7, 6, 5});
}

/// Work that the log of a whole run shows; a search that starts afresh empties its open list on line 1, which
/// is not counted as work.
Counters work_in(const PlannerInfo& info, std::span<const Event> log, std::size_t nodes) {
  SearchState state(nodes, info.values.all_fields());
  Counters work;
  for (const Event& event : log) {
    state.apply(event);
    work.expansions +=
        event.kind == EventKind::visit && state.value(EventKind::visit, event.node) != 0 ? 1 : 0;
    work.queue_operations += event.kind == EventKind::queue && event.line != 1 ? 1 : 0;
    work.sight_checks += event.kind == EventKind::sight ? 1 : 0;
  }
  return work;
}

TEST_P(EveryPlanner, tracedOrNotReplansAlikeAndCountsItsWork) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Trial<2> trial(*GetParam(), seed, {6, 6}, {16, 12});
    auto& [random, settings, world, start, goal] = trial;
    NoTrace nobody;
    Recorder recorder;
    const auto silent = make_planner(*GetParam(), world.lattice, settings, nobody);
    const auto traced = make_planner(*GetParam(), world.lattice, settings, recorder);
    silent->begin(start, goal);
    traced->begin(start, goal);
    for (int i = 0; i < 8; ++i) {
      finish(*silent);
      while (!traced->advance(1)) {
      }
      const Answer a{silent->status(), silent->cost(), silent->path(), silent->counters(), {}};
      const Answer b{traced->status(), traced->cost(), traced->path(), traced->counters(), {}};
      expect_same(a, b);
      const Counters work = work_in(*GetParam(), recorder.buffer(), world.lattice.node_count());
      ASSERT_EQ(work.expansions, b.counters.expansions) << "seed " << seed;
      ASSERT_EQ(work.queue_operations, b.counters.queue_operations) << "seed " << seed;
      ASSERT_EQ(work.sight_checks, b.counters.sight_checks) << "seed " << seed;
      const auto edits = random_edits<2>(random, world.plain, 5);
      const auto moves = world.apply(edits);
      start = random_free(random, world.plain);
      silent->update({.cells = edits, .moves = moves}, start);
      traced->update({.cells = edits, .moves = moves}, start);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, EveryPlanner, ::testing::ValuesIn(each_of(sound_planners())),
                         planner_test_name);

}  // namespace
}  // namespace replan::test::planner_conformance_test
