// Sight checked along the path (`sight_checks=path`) beside the paper's way, in the search: the search is
// that of the planner without sight, no path crosses an obstacle, loops or is longer than the lattice path,
// and paths have fewer vertices with a fraction of the checks. Leaps outlive a change of the map that stays
// out of their boxes.
#include <array>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/trace/search_state.hpp"
#include "core/world/generators/generators.hpp"
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
    EXPECT_TRUE(path_is_free(twin.lattice, path));
    EXPECT_EQ(fault_of_length(twin.plain, path, lattice->path()), "");
    const PathFigures figures = path_figures(twin.lattice, path);
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

/// rp holds the path that was read out last. Elsewhere it is what it was, or all of it was forgotten.
void expect_path_in(const SearchState& before, const SearchState& state, const std::vector<NodeId>& path) {
  for (std::size_t k = 1; k < path.size(); ++k) ASSERT_EQ(state.rp(path[k - 1]), path[k]);
  ASSERT_EQ(state.rp(path.back()), path.back());
  std::size_t elsewhere = 0, changed = 0;
  for (NodeId n = 0; n < state.node_count(); ++n) {
    if (std::find(path.begin(), path.end(), n) != path.end()) continue;
    elsewhere += state.rp(n) != kNoNode;
    changed += state.rp(n) != before.rp(n);
  }
  ASSERT_LE(elsewhere, 64 + 2 * path.size());
  ASSERT_TRUE(changed == 0 || elsewhere == 0) << elsewhere << " leaps elsewhere, " << changed << " changed";
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
      for (const Event& event : recorder.take()) state.apply(event);
      const SearchState before = state;
      const std::vector<NodeId> path = planner->path().nodes();
      for (const Event& event : recorder.take()) state.apply(event);
      if (!path.empty()) expect_path_in(before, state, path);
      ASSERT_FALSE(HasFatalFailure()) << "seed " << seed;
      changing.change(*planner);
    }
  }
}

/// A planner that is followed by its log while the world changes, and the lattice planner beside it.
struct Followed {
  Changing changing;
  Recorder recorder;
  NoTrace nobody;
  std::unique_ptr<Planner<Grid2>> planner, lattice;
  SearchState state;
  std::vector<Event> events;  // of the last call

  Followed(const PlannerInfo& info, const Settings& settings, std::uint64_t seed)
      : changing(seed, settings),
        planner(make_planner(info, changing.world.lattice, settings, recorder)),
        lattice(make_planner(lattice_twin(info), changing.world.lattice, {}, nobody)),
        state(changing.world.lattice.node_count()) {
    planner->begin(changing.start, changing.goal);
    lattice->begin(changing.start, changing.goal);
  }

  void read_events() {
    events = recorder.take();
    for (const Event& event : events) state.apply(event);
  }
  Path read_path() {
    finish(*planner);
    finish(*lattice);
    read_events();
    Path path = planner->path();
    read_events();
    return path;
  }
  std::vector<CellEdit> change() {
    const auto edits = random_edits<2>(changing.random, changing.world.plain, 3);
    const auto moves = changing.world.apply(edits);
    // Onwards along the leap, to its end, or somewhere else, or nowhere.
    if (changing.random.below(4) == 0) changing.start = random_free(changing.random, changing.world.plain);
    if (const NodeId next = state.rp(changing.start); next != kNoNode && changing.random.below(2) == 0) {
      const Cell a = changing.world.lattice.position(changing.start),
                 b = changing.world.lattice.position(next);
      const NodeId middle = changing.world.lattice.node(Cell{(a.x + b.x) / 2, (a.y + b.y) / 2});
      const NodeId there = changing.random.below(2) == 0 ? next : middle;
      if (!changing.world.lattice.blocked(there)) changing.start = there;
    }
    planner->update({.cells = edits, .moves = moves}, changing.start);
    lattice->update({.cells = edits, .moves = moves}, changing.start);
    return edits;
  }
};

TEST_P(SightAlong, isNeverLongerThanTheLatticePathAfterAnyNumberOfChanges) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Followed run(*find_planner(GetParam()), with(true), seed);
    for (int i = 0; i < 10; ++i) {
      const Path path = run.read_path();
      ASSERT_TRUE(path_is_free(run.changing.world.lattice, path)) << "seed " << seed;
      ASSERT_FALSE(path.loops) << "seed " << seed;
      ASSERT_EQ(fault_of_length(run.changing.world.plain, path, run.lattice->path()), "") << "seed " << seed;
      run.change();
    }
  }
}

/// Whether the cell lies in the box that the two cells span.
bool in_box(const Grid2& lattice, NodeId a, NodeId b, NodeId cell) {
  const Cell p = lattice.position(a), q = lattice.position(b), at = lattice.position(cell);
  return std::min(p.x, q.x) <= at.x && at.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= at.y &&
         at.y <= std::max(p.y, q.y);
}

/// Cells that a leap may look at, and that the change made good or bad for it: those that were written, and
/// with clearance those that came near an obstacle or are no longer.
std::vector<NodeId> turned_cells(const SearchState& before, const SearchState& after,
                                 const std::vector<CellEdit>& edits) {
  std::vector<NodeId> turned;
  for (const CellEdit& edit : edits) turned.push_back(edit.node);
  for (NodeId n = 0; n < before.node_count(); ++n)
    if ((before.dist(n) == Cost::zero()) != (after.dist(n) == Cost::zero())) turned.push_back(n);
  return turned;
}

TEST_P(SightAlong, forgetsTheLeapsWithAChangedCellInTheirBoxAndNoOther) {
  std::size_t kept = 0, forgotten = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Followed run(*find_planner(GetParam()), with(true), seed);
    for (int i = 0; i < 8; ++i) {
      (void)run.read_path();
      const SearchState before = run.state;
      const auto edits = run.change();
      run.read_events();
      const auto turned = turned_cells(before, run.state, edits);
      for (NodeId n = 0; n < before.node_count(); ++n) {
        const NodeId end = before.rp(n);
        if (end == kNoNode || n == run.changing.goal) continue;
        const bool touched = std::any_of(turned.begin(), turned.end(), [&](NodeId cell) {
          return in_box(run.changing.world.lattice, n, end, cell);
        });
        ASSERT_EQ(run.state.rp(n), touched ? kNoNode : end) << "seed " << seed << " vertex " << n;
        ++(touched ? forgotten : kept);
      }
    }
  }
  EXPECT_GT(kept, 200u);
  EXPECT_GT(forgotten, 200u);
}

TEST_P(SightAlong, asksAndWritesNothingIfItIsReadAgain) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Followed run(*find_planner(GetParam()), with(true), seed);
    for (int i = 0; i < 8; ++i) {
      const Path path = run.read_path();
      const Path again = run.read_path();
      ASSERT_EQ(again, path) << "seed " << seed;
      ASSERT_TRUE(run.events.empty()) << "seed " << seed;
      run.change();
    }
  }
}

/// Two walls that leave a way round their ends, start and goal on both sides of them:
///   0         10        20        30        40
///   S         #                             G
///             #         |
///             #         |  (walls: x = 10 from above, x = 30 from below)
GridMap two_walls() {
  GridMap map(41, 31);
  for (int y = 0; y <= 20; ++y) map.set({10, y}, true);
  for (int y = 10; y <= 30; ++y) map.set({30, y}, true);
  return map;
}

/// What a change of one cell makes the reading of the path ask, the robot at `start`.
struct Reading {
  std::vector<NodeId> path;
  std::int64_t checks = 0;
};

struct Hall {
  Grid2 lattice;
  NoTrace nobody;
  std::unique_ptr<Planner<Grid2>> planner;

  explicit Hall(const char* id) : lattice({41, 31}, two_walls().blocked.plain()) {
    planner = make_planner(*find_planner(id), lattice, with(true), nobody);
    planner->begin(node(1, 1), node(39, 29));
  }
  [[nodiscard]] NodeId node(int x, int y) const { return lattice.node(Cell{x, y}); }
  Reading read() {
    EXPECT_EQ(finish(*planner), PlanStatus::found);
    const std::int64_t before = planner->counters().sight_checks;
    std::vector<NodeId> path = planner->path().nodes();
    return {std::move(path), planner->counters().sight_checks - before};
  }
  Reading write(Cell cell, bool blocked, NodeId start) {
    const std::vector<CellEdit> edits = {{lattice.node(cell), blocked}};
    const auto moves = lattice.apply(edits);
    planner->update({.cells = edits, .moves = moves}, start);
    return read();
  }
};

TEST_P(SightAlong, keepsAllLeapsIfTheChangeIsOutOfTheirBoxes) {
  Hall hall(GetParam());
  const Reading first = hall.read();
  EXPECT_GT(first.checks, 0);
  const Reading then = hall.write({39, 1}, true, hall.node(1, 1));
  EXPECT_EQ(then.path, first.path);
  EXPECT_EQ(then.checks, 0);
  const Reading last = hall.write({39, 1}, false, hall.node(1, 1));
  EXPECT_EQ(last.path, first.path);
  EXPECT_EQ(last.checks, 0);
}

TEST_P(SightAlong, looksAgainFromTheOneLeapWithAChangeInItsBox) {
  Hall hall(GetParam());
  const Reading first = hall.read();
  // Beside the first leap, out of its way; what was found from the start must come out as it did.
  const Reading blocked = hall.write({2, 6}, true, hall.node(1, 1));
  EXPECT_GT(blocked.checks, 0);
  EXPECT_LT(blocked.checks, first.checks);
  const Reading freed = hall.write({2, 6}, false, hall.node(1, 1));
  EXPECT_GT(freed.checks, 0);
  EXPECT_LT(freed.checks, first.checks);
}

TEST_P(SightAlong, goesOnAlongItsLeapsFromTheMiddleOfOne) {
  Hall hall(GetParam());
  const Reading first = hall.read();
  ASSERT_GT(first.path.size(), 3u);
  const Cell a = hall.lattice.position(first.path[0]), b = hall.lattice.position(first.path[1]);
  const Reading then = hall.write({39, 1}, true, hall.node((a.x + b.x) / 2, (a.y + b.y) / 2));
  EXPECT_EQ(then.path.back(), first.path.back());
  EXPECT_EQ(then.path[then.path.size() - 2], first.path[first.path.size() - 2]);
  EXPECT_LT(then.checks, first.checks);
}

TEST_P(SightAlong, goesOnFromItsLogAsIfItHadNeverStopped) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const PlannerInfo& info = *find_planner(GetParam());
    Followed run(info, with(true), seed);
    for (int i = 0; i < 6; ++i) {
      (void)run.read_path();
      Recorder recorder;
      const auto second = make_planner(info, run.changing.world.lattice, with(true), recorder);
      second->restore(run.state, run.planner->counters());
      const auto edits = random_edits<2>(run.changing.random, run.changing.world.plain, 3);
      const auto moves = run.changing.world.apply(edits);
      for (const auto& each : {run.planner.get(), second.get()}) {
        each->update({.cells = edits, .moves = moves}, run.changing.start);
        finish(*each);
      }
      ASSERT_EQ(second->path().nodes(), run.planner->path().nodes()) << "seed " << seed;
      ASSERT_EQ(second->counters().sight_checks, run.planner->counters().sight_checks) << "seed " << seed;
      run.read_events();
      ASSERT_EQ(recorder.take(), run.events) << "seed " << seed;
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
