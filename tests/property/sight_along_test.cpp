// Sight checked along the path (`sight_checks=path`) beside the paper's way, in the search: the search is
// that of the planner without sight, no path crosses an obstacle, loops or is longer than the lattice path,
// and paths have fewer vertices with a fraction of the checks.
#include <array>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/trace/search_state.hpp"
#include "core/world/generators.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::sight_along_test {
namespace {

Settings with(bool along_path) {
  Settings settings;
  settings.set("sight_checks", along_path ? 1 : 0);
  return settings;
}

struct Means {
  double nodes = 0, length = 0, turns = 0, least_clearance = 0, checks = 0;
};

struct World {
  GridMap map;
  Cell start, goal;
};

/// Plans once in each world; the lattice path of the same search beside it.
Means means_of(const PlannerInfo& info, const Settings& settings, const std::vector<World>& worlds) {
  Means sum;
  const auto share = 1 / static_cast<double>(worlds.size());
  for (const World& world : worlds) {
    const TwinWorld<2> twin({world.map.width, world.map.height}, world.map.blocked.plain(),
                            move_rules(settings));
    const NodeId start = twin.lattice.node(world.start), goal = twin.lattice.node(world.goal);
    NoTrace nobody;
    const auto planner = make_planner(info, twin.lattice, settings, nobody);
    const auto lattice = make_planner(lattice_twin(info), twin.lattice, {}, nobody);
    for (const auto& each : {planner.get(), lattice.get()}) {
      each->begin(start, goal);
      EXPECT_EQ(finish(*each), PlanStatus::found);
    }
    EXPECT_EQ(planner->counters().expansions, lattice->counters().expansions);
    EXPECT_EQ(planner->counters().queue_operations, lattice->counters().queue_operations);
    const Path path = planner->path();
    EXPECT_TRUE(path_is_free(twin.lattice, path.nodes, SightRule::supercover));
    EXPECT_EQ(fault_of_length(twin.plain, path, lattice->path()), "");
    const PathFigures figures = path_figures(twin.lattice, path.nodes);
    sum.nodes += static_cast<double>(figures.nodes) * share;
    sum.length += figures.length * share;
    sum.turns += static_cast<double>(figures.turns) * share;
    sum.least_clearance += figures.min_clearance * share;
    sum.checks += static_cast<double>(planner->counters().sight_checks) * share;
  }
  return sum;
}

/// Both ways in the same worlds, as a row of a table each.
std::array<Means, 2> beside_each_other(const char* id, const char* name, const std::vector<World>& worlds) {
  std::array<Means, 2> both;
  for (const bool along_path : {false, true}) {
    const Means means = both[along_path] = means_of(*find_planner(id), with(along_path), worlds);
    std::printf("| %-14s | %-10s | %-6s | %6.1f | %8.3f | %6.1f | %5.3f | %9.1f |\n", id, name,
                along_path ? "path" : "search", means.nodes, means.length, means.turns, means.least_clearance,
                means.checks);
  }
  return both;
}

std::vector<World> rectangles() {
  std::vector<World> worlds;
  const std::array<Cell, 2> ends = {Cell{15, 15}, Cell{175, 175}};
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
    worlds.push_back({*random_rectangles(200, 200, 0.17, 5, 15, seed, ends), ends[0], ends[1]});
  return worlds;
}

class SightAlong : public ::testing::TestWithParam<const char*> {};

TEST_P(SightAlong, makesPathsOfFewerVerticesWithFewerChecksOnRandomRectangles) {
  const auto [search, path] = beside_each_other(GetParam(), "rectangles", rectangles());
  EXPECT_LT(path.nodes, search.nodes);
  EXPECT_LE(path.length, search.length);
  EXPECT_LT(path.turns, search.turns);
  EXPECT_LT(path.checks, search.checks / 20);
  EXPECT_GT(path.least_clearance, search.least_clearance - 0.05);
}

TEST_P(SightAlong, makesPathsOfNoMoreVerticesWithFewerChecksInMazes) {
  for (const int corridor : {1, 7}) {
    const int side = corridor == 1 ? 501 : 497, first = corridor / 2 + 1;
    const GridMap map = *maze(side, side, {.corridor = corridor, .braid = 0, .loops = 0.1}, 1);
    const std::string name = "maze " + std::to_string(corridor);
    const auto [search, path] = beside_each_other(
        GetParam(), name.c_str(), {{map, {first, first}, {side - 1 - first, side - 1 - first}}});
    EXPECT_LE(path.nodes, search.nodes);
    // Leaps begin and end on the lattice path, which may cost a little: 0.2 % at most in these.
    EXPECT_LE(path.length, search.length * 1.003);
    EXPECT_LT(path.checks, search.checks / 10);
  }
}

/// A small world drawn from a seed, which changes as it goes on.
struct Changing {
  Random random;
  Grid2::Coordinates size;
  TwinWorld<2> world;
  NodeId start, goal;

  Changing(std::uint64_t seed, const Settings& settings)
      : random(seed),
        size(random_size<2>(random, {8, 8}, {30, 24})),
        world(size, random_cells<2>(random, size), move_rules(settings)),
        start(random_free(random, world.plain)),
        goal(random_free(random, world.plain)) {}

  void change(Planner<Grid2>& planner) {
    const auto edits = random_edits<2>(random, world.plain, 5);
    const auto moves = world.apply(edits);
    start = random_free(random, world.plain);
    planner.update({.cells = edits, .moves = moves}, start);
  }
};

/// What a search and its repairs write down, but for sight and what is read out of it.
std::vector<Event> search_events(const PlannerInfo& info, const Settings& settings, std::uint64_t seed) {
  Changing changing(seed, settings);
  Recorder recorder;
  const auto planner = make_planner(info, changing.world.lattice, settings, recorder);
  planner->begin(changing.start, changing.goal);
  for (int i = 0; i < 6; ++i) {
    finish(*planner);
    (void)planner->path();
    changing.change(*planner);
  }
  finish(*planner);
  std::vector<Event> events = recorder.take();
  std::erase_if(events, [](const Event& event) {
    return event.kind == EventKind::rp || event.kind == EventKind::sight || event.line > 200;
  });
  return events;
}

TEST_P(SightAlong, leavesTheSearchAsItIsWithoutSight) {
  const PlannerInfo& info = *find_planner(GetParam());
  for (std::uint64_t seed = 0; seed < 200; ++seed)
    ASSERT_EQ(search_events(info, with(true), seed), search_events(lattice_twin(info), {}, seed))
        << "seed " << seed;
}

/// rp holds the path that was read out last and nothing else.
void expect_path_in(const SearchState& state, const std::vector<NodeId>& path) {
  std::size_t set = 0;
  for (NodeId n = 0; n < state.node_count(); ++n) set += state.rp(n) != kNoNode;
  ASSERT_EQ(set, path.size());
  for (std::size_t k = 1; k < path.size(); ++k) ASSERT_EQ(state.rp(path[k - 1]), path[k]);
  ASSERT_EQ(state.rp(path.back()), path.back());
}

TEST_P(SightAlong, setsRemoteParentsOfThePathAlone) {
  const Settings settings = with(true);
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Changing changing(seed, settings);
    Recorder recorder;
    const auto planner = make_planner(*find_planner(GetParam()), changing.world.lattice, settings, recorder);
    SearchState state(changing.world.lattice.node_count());
    planner->begin(changing.start, changing.goal);
    for (int i = 0; i < 5; ++i) {
      finish(*planner);
      const std::vector<NodeId> path = planner->path().nodes;
      for (const Event& event : recorder.take()) state.apply(event);
      if (!path.empty()) expect_path_in(state, path);
      ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
      changing.change(*planner);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Family, SightAlong, ::testing::Values("los-dstar-lite", "dld-star-lite"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace replan::test::sight_along_test
