// The planner `visibility-graph`: as short as a visibility graph by brute force, after every change too; never longer than
// any other planner's path, smoothed or not; of the lengths that were computed by another program; and driven over cells
// that a robot may go through.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <memory>
#include <sstream>

#include <gtest/gtest.h>

#include "core/plan/any_angle.hpp"
#include "core/plan/figures.hpp"
#include "core/plan/stage.hpp"
#include "core/sim/route.hpp"
#include "core/world/formats/movingai.hpp"
#include "tests/support/brute_visibility.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::visibility_graph_test {
namespace {

const PlannerInfo& visibility_graph() {
  return *find_planner("visibility-graph");
}

/// Whether each segment is one that brute force allows.
bool is_allowed(const BruteVisibility& brute, const Path& path) {
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!brute.sees(half_point(path.point(i - 1)), half_point(path.point(i)))) return false;
  return true;
}

/// Why the planner's answer is not the shortest one, or empty.
std::string fault_beside_brute_force(const TwinWorld<2>& world, CornerRule corners, NodeId start, NodeId goal,
                                     Planner<Grid2>& planner) {
  BruteVisibility brute(world.plain, corners);
  const double right =
      brute.length(half_centre(world.lattice.position(start)), half_centre(world.lattice.position(goal)));
  const Path path = planner.path();
  if (path.empty() != (right == HUGE_VAL)) return "a path where there is none, or none";
  if (path.empty()) return planner.cost().is_infinite() ? "" : "a cost without a path";
  if (std::abs(path_length(path) - right) > 1e-9) return "a path that is not the shortest";
  if (std::abs(planner.cost().to_double() - right) > 1e-7) return "a cost that is not the path's length";
  if (!is_allowed(brute, path) || !path_is_free(world.lattice, path)) return "a path that is not free";
  return "";
}

TEST(VisibilityGraph, FindsWhatBruteForceFindsBeforeAndAfterChanges) {
  int found = 0, bent = 0, none = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed + 500'000);
    const auto corners = static_cast<CornerRule>(seed % 3);
    Settings settings;
    settings.set("corners", static_cast<double>(corners));
    settings.set("heuristic", random.below(2));
    const auto size = random_size<2>(random, {1, 1}, {9, 8});
    TwinWorld<2> world(size, random_cells<2>(random, size), {corners, true});
    NoTrace nobody;
    const auto planner = make_planner(visibility_graph(), world.lattice, settings, nobody);
    NodeId start = random_free(random, world.plain);
    const NodeId goal = random_free(random, world.plain);
    planner->begin(start, goal);
    for (int round = 0; round < 3; ++round) {
      finish(*planner);
      ASSERT_EQ(fault_beside_brute_force(world, corners, start, goal, *planner), "")
          << "seed " << seed << ", " << round;
      const std::size_t points = planner->path().size();
      (points == 0 ? none : found) += 1;
      bent += points > 2 ? 1 : 0;
      const auto edits = random_edits<2>(random, world.plain, 5);
      const auto moves = world.apply(edits);
      start = random_free(random, world.plain);
      planner->update({.cells = edits, .moves = moves}, start);
    }
  }
  std::printf("visibility-graph: %d plans as by brute force, %d of them bent, %d times none\n", found, bent,
              none);
  EXPECT_GT(found, 4000);
  EXPECT_GT(bent, 500);
  EXPECT_GT(none, 100);
}

/// The path of a planner, smoothed or not, where the visibility graph's is not allowed to be longer.
struct Rival {
  const char* planner;
  std::vector<StageChoice> stages = {};
  double over = 0;  ///< the sum of how much longer theirs were
};

TEST(VisibilityGraph, IsNeverLongerThanAnyOtherPathSmoothedOrNot) {
  Rival rivals[] = {{"theta-star"},
                    {"lazy-theta-star"},
                    {"field-dstar"},
                    {"astar"},
                    {"los-dstar-lite"},
                    {"astar", {{"floyd", {}}}},
                    {"theta-star", {{"floyd", {}}}},
                    {"field-dstar", {{"floyd", {}}}}};
  std::int64_t held = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed + 9000);
    const auto size = random_size<2>(random, {5, 5}, {60, 48});
    const MoveRules rules{static_cast<CornerRule>(seed % 3), true};
    Settings settings;
    settings.set("corners", static_cast<double>(rules.corners));
    const TwinWorld<2> world(size, random_cells<2>(random, size), rules);
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    NoTrace nobody;
    const auto path_of = [&](const char* id, std::span<const StageChoice> stages) {
      const auto planner = make_planner(*find_planner(id), world.lattice, settings, nobody);
      planner->begin(start, goal);
      finish(*planner);
      return through_stages(world.lattice, planner->path(), stages);
    };
    const Path shortest = path_of("visibility-graph", {});
    for (Rival& rival : rivals) {
      const Path path = path_of(rival.planner, rival.stages);
      ASSERT_EQ(path.empty(), shortest.empty()) << rival.planner << ", seed " << seed;
      if (path.empty()) continue;
      ASSERT_GE(path_length(path), path_length(shortest) - 1e-9) << rival.planner << ", seed " << seed;
      rival.over += start == goal ? 0 : path_length(path) / path_length(shortest) - 1;
      ++held;
    }
  }
  for (const Rival& rival : rivals)
    std::printf("%s%s: %.3f %% above the shortest on average\n", rival.planner,
                rival.stages.empty() ? "" : " smoothed",
                100 * rival.over * static_cast<double>(std::size(rivals)) / static_cast<double>(held));
  EXPECT_GT(held, 2500);
}

/// The robot goes from cell to free cell by moves of the lattice, along the whole path, and stays beside it.
std::string fault_of_route(const TwinWorld<2>& world, const Path& path, NodeId start, NodeId goal,
                           CornerRule corners) {
  const Route route = lay_out(world.lattice.box(), world.lattice.cells(), path);
  NodeId at = start;
  for (std::size_t i = 0; i < route.cells.size(); ++i) {
    const NodeId next = route.cells[i];
    const auto near = oracle::neighbours(world.plain, {corners, true}, at);
    if (!std::binary_search(near.begin(), near.end(), std::size_t{next})) return "a step is not a move";
    if (i > 0 && route.along[i] < route.along[i - 1]) return "it drives backwards";
    if (distance_to(path, route.points[i]) > 1e-9) return "a point beside the path";
    if (distance_to(path, centre_of(world.lattice.position(next))) > 1.5) return "a cell far from the path";
    at = next;
  }
  if (at != goal) return "it does not arrive";
  const double way = route.along.empty() ? 0 : route.along.back();
  return std::abs(way - path_length(path)) < 1e-9 ? "" : "its way is not as long as the path";
}

TEST(VisibilityGraph, IsDrivenOverFreeCellsByMoves) {
  std::int64_t driven = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed + 70'000);
    const auto corners = static_cast<CornerRule>(seed % 3);
    const auto size = random_size<2>(random, {2, 2}, {24, 20});
    const TwinWorld<2> world(size, random_cells<2>(random, size), {corners, true});
    AnyAngle optimum(world.lattice);
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    Path path = optimum.shortest(half_centre(world.lattice.position(start)),
                                 half_centre(world.lattice.position(goal)));
    if (path.empty()) continue;
    path.touches = true;
    ASSERT_EQ(fault_of_route(world, path, start, goal, corners), "") << "seed " << seed;
    ++driven;
  }
  EXPECT_GT(driven, 2000);
}

/// A map of the shared data, and planners on it.
struct Ground {
  Grid2 lattice;
  NoTrace nobody;
  std::unique_ptr<Planner<Grid2>> shortest, astar;
  double seconds = 0, astar_seconds = 0;
  int questions = 0;

  explicit Ground(const std::filesystem::path& file) {
    const auto map = read_movingai_map(file.string());
    EXPECT_TRUE(map.ok()) << map.error();
    if (!map) return;
    lattice = Grid2({map->width, map->height}, map->blocked.plain());
    shortest = make_planner(visibility_graph(), lattice, {}, nobody);
    astar = make_planner(*find_planner("astar"), lattice, {}, nobody);
  }
  double length(Cell start, Cell goal) {
    ++questions;
    time(*astar, start, goal, astar_seconds);
    const Path path = time(*shortest, start, goal, seconds);
    EXPECT_TRUE(path_is_free(lattice, path));
    return path_length(path);
  }
  void tell(const std::string& name) const {
    std::printf("%s: %d lengths, %.2f times A*'s time\n", name.c_str(), questions, seconds / astar_seconds);
  }

 private:
  Path time(Planner<Grid2>& planner, Cell start, Cell goal, double& total) const {
    const std::clock_t begin = std::clock();
    planner.begin(lattice.node(start), lattice.node(goal));
    EXPECT_EQ(finish(planner), PlanStatus::found);
    Path path = planner.path();
    total += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return path;
  }
};

TEST(VisibilityGraph, HasTheLengthsThatAnotherProgramComputed) {
  REPLAN_NEED_SHARED_DATA();
  std::ifstream in(shared_data() / "anyangle" / "computed.tsv");
  if (!in) GTEST_SKIP() << "The any-angle lengths are absent.";
  std::string open_map;
  std::unique_ptr<Ground> ground;
  int agreed = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string name;
    Cell start, goal;
    double by_corners = 0, by_centres = 0;
    if (!(fields >> name >> start.x >> start.y >> goal.x >> goal.y >> by_corners >> by_centres)) continue;
    if (name != open_map) {
      if (ground) ground->tell(open_map);
      ground = std::make_unique<Ground>(shared_data() / "movingai" / (name + ".map"));
      open_map = name;
    }
    ASSERT_NEAR(ground->length(start, goal), by_centres, 1e-8) << line;
    ++agreed;
  }
  if (ground) ground->tell(open_map);
  std::printf("%d computed lengths agree\n", agreed);
  EXPECT_EQ(agreed, 1602);
}

/// The published lengths are from corner to corner, which no planner between cells can be asked for: half a cell's diagonal
/// from the centres at each end. What has exactly those, core/plan/any_angle.hpp, has the planner's between the centres.
TEST(VisibilityGraph, IsAsFarFromThePublishedLengthsAsCentresAreFromCorners) {
  REPLAN_NEED_SHARED_DATA();
  const auto folder = shared_data() / "anyangle";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "The any-angle lengths are absent.";
  Ground ground(folder / "AcrosstheCape.map");
  AnyAngle optimum(ground.lattice);
  std::ifstream in(folder / "AcrosstheCape.map.scen");
  int agreed = 0, inside = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string bucket, name;
    int width = 0, height = 0;
    Cell start, goal;
    double published = 0;
    if (!(fields >> bucket >> name >> width >> height >> start.x >> start.y >> goal.x >> goal.y >> published))
      continue;
    const auto blocked = [&](Cell cell) { return ground.lattice.blocked(ground.lattice.node(cell)); };
    ASSERT_NEAR(path_length(optimum.shortest(half_corner(start), half_corner(goal))), published, 1e-8)
        << line;
    if (blocked(start) || blocked(goal)) {
      ++inside;
      continue;
    }
    const double length = ground.length(start, goal);
    ASSERT_NEAR(length, path_length(optimum.shortest(half_centre(start), half_centre(goal))), 1e-8) << line;
    ASSERT_NEAR(length, published, std::sqrt(2.0)) << line;
    ++agreed;
  }
  ground.tell("AcrosstheCape");
  std::printf("%d agree, %d begin or end in an obstacle's cell\n", agreed, inside);
  EXPECT_EQ(agreed + inside, 101);
  EXPECT_GT(agreed, 50);
}

}  // namespace
}  // namespace replan::test::visibility_graph_test
