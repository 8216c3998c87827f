// Floyd smoothing against brute force: which connections it may keep, and what it may never do.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/plan/registry.hpp"
#include "core/plan/stage.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::floyd_test {
namespace {

Path after(const char* stage, const Grid2& known, const Path& path, const Settings& settings = {}) {
  return find_stage(stage)->in_plane(known, path, settings);
}
Path after(const char* stage, const Voxel3& known, const Path& path, const Settings& settings = {}) {
  return find_stage(stage)->in_space(known, path, settings);
}

/// From the segment to the nearest obstacle cell's centre, by looking at all of them in long double.
long double distance_to_obstacles(const oracle::World& world, const Point& from, const Point& to) {
  const std::array<long double, 3> a = {from.x, from.y, from.z}, b = {to.x, to.y, to.z};
  long double least = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < world.blocked.size(); ++i) {
    if (world.blocked[i] == 0) continue;
    const oracle::Place c = world.place(i);
    long double length = 0, along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      length += (b[k] - a[k]) * (b[k] - a[k]);
      along += (c[k] + 0.5L - a[k]) * (b[k] - a[k]);
    }
    const long double share = length == 0 ? 0 : std::clamp(along / length, 0.0L, 1.0L);
    long double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const long double off = c[k] + 0.5L - (a[k] + share * (b[k] - a[k]));
      squared += off * off;
    }
    least = std::min(least, std::sqrt(squared));
  }
  return least;
}

struct Tally {
  std::int64_t paths = 0, joined = 0, near = 0, turns_before = 0, turns_after = 0;
  double length_before = 0, length_after = 0;
};

template <int D>
void check_smoothing(const char* planner_id, int worlds) {
  constexpr double kDistances[] = {0.8, 0.8, 0.5, 1, 1.5, 3};
  Tally tally;
  for (int seed = 0; seed < worlds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 900);
    typename BoxLattice<D>::Coordinates low{}, high{};
    low.fill(D == 2 ? 10 : 5);
    high.fill(D == 2 ? 40 : 12);
    const auto size = random_size<D>(random, low, high);
    const TwinWorld<D> world(size, random_cells<D>(random, size), {});
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    NoTrace nobody;
    const auto planner = make_planner(*find_planner(planner_id), world.lattice, {}, nobody);
    planner->begin(start, goal);
    if (finish(*planner) != PlanStatus::found) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const double distance = kDistances[seed % 6];
    Settings settings;
    settings.set("distance", distance);
    const Path path = planner->path(), corners = after("collinear", world.lattice, path),
               smooth = after("floyd", world.lattice, path, settings);
    ASSERT_EQ(smooth.point(0), path.point(0));
    ASSERT_EQ(smooth.point(smooth.size() - 1), path.point(path.size() - 1));
    ASSERT_TRUE(path_is_free(world.lattice, smooth));
    const PathFigures before = path_figures(world.lattice, path), is = path_figures(world.lattice, smooth);
    ASSERT_LE(is.length, before.length + 1e-9);
    ASSERT_LE(is.turns, before.turns);
    // Each segment is one between two neighbouring corners, or keeps its distance; and each corner is left for the
    // farthest one that it may be joined to.
    std::size_t from = 0;
    for (std::size_t i = 1; i < smooth.size(); ++i) {
      std::size_t to = from + 1;
      while (corners.nodes()[to] != smooth.nodes()[i]) ASSERT_LT(++to, corners.size()) << "not a corner";
      const long double away = distance_to_obstacles(world.plain, corners.point(from), corners.point(to));
      if (to > from + 1) {
        ASSERT_GT(away, distance - 1e-12L);
        ++tally.joined;
      } else {
        tally.near += away <= distance ? 1 : 0;
      }
      for (std::size_t farther = to + 1; farther < corners.size(); ++farther) {
        const long double there =
            distance_to_obstacles(world.plain, corners.point(from), corners.point(farther));
        const bool sees =
            oracle::sees(world.plain, world.plain.blocked, CornerRule::none, SightRule::supercover,
                         corners.nodes()[from], corners.nodes()[farther]);
        ASSERT_TRUE(!sees || there <= distance + 1e-12L) << "a farther one might have been joined";
      }
      from = to;
    }
    ASSERT_EQ(from + 1, corners.size());
    ++tally.paths;
    tally.turns_before += before.turns;
    tally.turns_after += is.turns;
    tally.length_before += before.length;
    tally.length_after += is.length;
  }
  std::printf(
      "%s, %dd: %lld paths, %lld connections, %lld nearer ones between neighbours; turns %.1f %%, length "
      "%.2f %%\n",
      planner_id, D, static_cast<long long>(tally.paths), static_cast<long long>(tally.joined),
      static_cast<long long>(tally.near),
      100.0 * static_cast<double>(tally.turns_after - tally.turns_before) /
          static_cast<double>(tally.turns_before),
      100 * (tally.length_after / tally.length_before - 1));
  EXPECT_GT(tally.joined, tally.paths / 10);
  EXPECT_GT(tally.near, 0) << "neighbours stay joined however near an obstacle is";
  EXPECT_LT(tally.length_after, tally.length_before);
}

TEST(Floyd, KeepsItsDistanceAndJoinsTheFarthestIn2d) {
  check_smoothing<2>("astar", 1500);
  check_smoothing<2>("adaptive-astar", 500);
}
TEST(Floyd, KeepsItsDistanceAndJoinsTheFarthestIn3d) {
  check_smoothing<3>("astar", 500);
}

/// Distances that are equal to D are not farther than D: 4 / 5 exactly, as a fraction and not as a double.
/// From (2, 2) to (8, 10) it is 10 cells; the centre of (6, 6) is |4 * 8 - 4 * 6| / 10 = 0.8 away.
TEST(Floyd, TakesADistanceOfExactlyDForTooNear) {
  Grid2 known({12, 12});
  const std::vector<CellEdit> edits = {{known.node(Cell{6, 6}), true}};
  known.apply(edits);
  const Path corner(known.box(), {known.node(Cell{2, 2}), known.node(Cell{2, 10}), known.node(Cell{8, 10})});
  EXPECT_EQ(after("floyd", known, corner).size(), 3u) << "0.8 is not farther than 0.8";
  Settings settings;
  settings.set("distance", 0.799999);
  EXPECT_EQ(after("floyd", known, corner, settings).size(), 2u);
}

TEST(Floyd, TakesPointsAnywhere) {
  Grid2 known({20, 20});
  const Path bent({{1, 1, 0.5}, {1, 9.25, 0.5}, {9.1, 9.25, 0.5}, {9.1, 15, 0.5}});
  EXPECT_EQ(after("floyd", known, bent), Path(std::vector<Point>{{1, 1, 0.5}, {9.1, 15, 0.5}}));
  const std::vector<CellEdit> wall = {
      {known.node(Cell{4, 7}), true}};  // its centre lies on the straight way, nearly
  known.apply(wall);
  const Path smooth = after("floyd", known, bent);
  EXPECT_EQ(smooth.size(), 3u);
  EXPECT_TRUE(path_is_free(known, smooth));
}

}  // namespace
}  // namespace replan::test::floyd_test
