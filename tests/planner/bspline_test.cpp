// The B-spline stage: its curve is free of collision by a check that knows nothing of how it is made, meets both ends, keeps
// near its polygon, and is pulled in where it would have hit something.
#include "core/stages/bspline.hpp"

#include <bit>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/lattice/sight.hpp"
#include "core/plan/figures.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::bspline_test {
namespace {

Settings settings_of(int samples, bool corners_only) {
  Settings settings;
  settings.set("samples", samples);
  settings.set("corners_only", corners_only ? 1 : 0);
  return settings;
}

/// Steps of a walk that likes to go on as it went, or leaps to what is in sight: paths as planners give them, but with
/// every turn that there can be.
template <int D>
Path random_path(Random& random, const BoxLattice<D>& known, NodeId start, bool leaps) {
  const auto bad = [&known](NodeId n) { return known.blocked(n); };
  std::vector<NodeId> nodes = {start};
  int last = -1;
  for (int left = random.between(2, leaps ? 8 : 30); left > 0; --left) {
    const std::uint32_t moves = known.moves(nodes.back());
    if (leaps) {
      const NodeId to = random.below(static_cast<std::uint32_t>(known.node_count()));
      if (to != nodes.back() && line_of_sight(known, SightRule::supercover, nodes.back(), to, bad))
        nodes.push_back(to);
    } else if (moves != 0) {
      if (last < 0 || (moves >> last & 1u) == 0 || random.chance(0.4)) {
        std::uint32_t rest = moves;
        for (auto skip = random.below(static_cast<std::uint32_t>(std::popcount(moves))); skip > 0; --skip)
          rest &= rest - 1;
        last = std::countr_zero(rest);
      }
      nodes.push_back(known.neighbour(nodes.back(), last));
    }
  }
  return Path(known.box(), std::move(nodes));
}

std::array<double, 3> parts(const Point& p) {
  return {p.x, p.y, p.z};
}

/// How far the point at a share of the segment is from the cube of a cell.
double gap_at(const Point& a, const Point& b, const Cell& cell, double share) {
  const std::array<double, 3> from = parts(a), to = parts(b),
                              low = parts({cell.x + 0.0, cell.y + 0.0, cell.z + 0.0});
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double at = from[i] + share * (to[i] - from[i]);
    const double off = std::max({low[i] - at, at - low[i] - 1, 0.0});
    squared += off * off;
  }
  return std::sqrt(squared);
}
/// The least of them: along a segment it falls and rises once.
double least_gap(const Point& a, const Point& b, const Cell& cell) {
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double first = low + (high - low) / 3, second = high - (high - low) / 3;
    (gap_at(a, b, cell, first) <= gap_at(a, b, cell, second) ? high : low) =
        gap_at(a, b, cell, first) <= gap_at(a, b, cell, second) ? second : first;
  }
  return std::min({gap_at(a, b, cell, low), gap_at(a, b, cell, 0), gap_at(a, b, cell, 1)});
}
/// Whether the segment is inside of a cube for a while, by the times at which it is between each pair of its sides.
bool enters(const Point& a, const Point& b, const Cell& cell) {
  constexpr double kLeast = 1e-9;
  const std::array<double, 3> from = parts(a), to = parts(b),
                              low = parts({cell.x + 0.0, cell.y + 0.0, cell.z + 0.0});
  double begin = 0, end = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double first = low[i] + kLeast, last = low[i] + 1 - kLeast, way = to[i] - from[i];
    if (way == 0) {
      if (from[i] <= first || from[i] >= last) return false;
      continue;
    }
    begin = std::max(begin, std::min((first - from[i]) / way, (last - from[i]) / way));
    end = std::min(end, std::max((first - from[i]) / way, (last - from[i]) / way));
  }
  return begin < end;
}

/// What the curve does that it must not, or empty.
template <int D>
std::string fault_of_curve(const oracle::World& world, double radius, const Path& path, const Path& curve) {
  if (curve.point(0) != path.point(0) || curve.point(curve.size() - 1) != path.point(path.size() - 1))
    return "its ends";
  const Path corners = Collinear::apply(Grid2(), path, {});
  double longest = 0;  // of the legs that it may be drawn from
  for (std::size_t i = 1; i < corners.size(); ++i)
    longest = std::max(longest, distance(corners.point(i - 1), corners.point(i)));
  const int reach = static_cast<int>(std::ceil(radius)) + 1;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Point a = curve.point(i - 1), b = curve.point(i);
    if (a == b) return "it repeats a point";
    if (distance_to(path, b) > longest / 3 + 1e-3) return "it is far from its polygon";
    const Cell p = cell_of(a), q = cell_of(b);
    for (int z = std::min(p.z, q.z) - reach; z <= std::max(p.z, q.z) + reach; ++z)
      for (int y = std::min(p.y, q.y) - reach; y <= std::max(p.y, q.y) + reach; ++y)
        for (int x = std::min(p.x, q.x) - reach; x <= std::max(p.x, q.x) + reach; ++x) {
          if (!world.inside({x, y, z}) || world.blocked[world.index({x, y, z})] == 0) continue;
          if (enters(a, b, {x, y, z})) return "it enters an obstacle";
          if (radius > 0 && least_gap(a, b, {x, y, z}) < radius - 1e-9) return "its body touches an obstacle";
        }
  }
  return "";
}

/// So many random paths, each through a world of its own. Adds up how many curves were pulled in.
template <int D>
void check_random_paths(int paths, double radius, std::size_t& pulled) {
  typename BoxLattice<D>::Coordinates low{}, high{};
  low.fill(D == 2 ? 6 : 4);
  high.fill(D == 2 ? 20 : 9);
  const std::size_t before = pulled;
  int done = 0;
  for (std::uint64_t seed = 0; done < paths; ++seed) {
    Random random(seed);
    const auto size = random_size<D>(random, low, high);
    std::vector<std::uint8_t> cells(cell_count<D>(size));
    const double share = (radius > 0 ? 0.06 : 0.4) * random.unit();
    for (std::uint8_t& cell : cells) cell = random.chance(share) ? 1 : 0;
    MoveRules rules;
    rules.corners = static_cast<CornerRule>(random.below(3));
    rules.radius = radius;
    const TwinWorld<D> world(size, cells, rules);
    const NodeId start = random.below(static_cast<std::uint32_t>(cells.size()));
    if (world.lattice.blocked(start)) continue;
    const Path path = random_path<D>(random, world.lattice, start, random.chance(0.3));
    if (path.size() < 3) continue;
    ++done;
    const Path curve =
        BSpline::apply(world.lattice, path, settings_of(random.between(1, 12), random.chance(0.3)));
    ASSERT_TRUE(curve.spline) << "seed " << seed << ": a path of a lattice was left alone";
    ASSERT_EQ(fault_of_curve<D>(world.plain, radius, path, curve), "") << "seed " << seed;
    ASSERT_TRUE(path_is_free(world.lattice, curve)) << "seed " << seed;
    pulled += curve.spline->pulled_in.empty() ? 0 : 1;
  }
  std::printf("%dD, radius %.2f: %d curves, %zu of them pulled in\n", D, radius, paths, pulled - before);
}

// Of all these some have to be pulled in, or little was shown.
TEST(BSpline, IsFreeOfCollisionOnTenThousandRandomPathsIn2d) {
  std::size_t pulled = 0;
  check_random_paths<2>(10'000, 0, pulled);
  EXPECT_GT(pulled, 1000u);
}
TEST(BSpline, IsFreeOfCollisionOnTenThousandRandomPathsIn3d) {
  std::size_t pulled = 0;
  check_random_paths<3>(10'000, 0, pulled);
  EXPECT_GT(pulled, 1000u);
}
TEST(BSpline, KeepsABodyFreeIn2d) {
  std::size_t pulled = 0;
  for (const double radius : {0.5, 0.75, 1.3}) check_random_paths<2>(700, radius, pulled);
  EXPECT_GT(pulled, 30u);
}
TEST(BSpline, KeepsABodyFreeIn3d) {
  std::size_t pulled = 0;
  for (const double radius : {0.5, 0.8}) check_random_paths<3>(400, radius, pulled);
  EXPECT_GT(pulled, 30u);
}

Path over(const Grid2& grid, std::initializer_list<Cell> cells) {
  std::vector<NodeId> nodes;
  for (const Cell cell : cells) nodes.push_back(grid.node(cell));
  return Path(grid.box(), std::move(nodes));
}

TEST(BSpline, LeavesStraightWaysStraight) {
  const Grid2 grid({30, 30});
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
    std::vector<NodeId> nodes;
    for (int i = 0; i < 20; ++i) nodes.push_back(grid.node(Cell{2 + i * x, 2 + i * y}));
    const Path curve = BSpline::apply(grid, Path(grid.box(), nodes), {});
    EXPECT_EQ(path_figures(grid, curve).turns, 0);
    EXPECT_NEAR(path_length(curve), 19 * std::sqrt(x + y), 1e-9);
    EXPECT_TRUE(curve.spline->pulled_in.empty());
  }
}

TEST(BSpline, PassesACornerAtASixthOfItsNeighbours) {
  const Grid2 grid({9, 9});
  const Path curve = BSpline::apply(grid, over(grid, {{1, 1}, {4, 1}, {4, 4}}), settings_of(4, false));
  ASSERT_EQ(curve.size(), 9u);                    // two spans of four pieces
  EXPECT_EQ(curve.point(4), (Point{4, 2, 0.5}));  // (P0 + 4 P1 + P2) / 6
  EXPECT_EQ(curve.spline->control, (std::vector<Point>{{1.5, 1.5, 0.5}, {4.5, 1.5, 0.5}, {4.5, 4.5, 0.5}}));
  const Path sharp = over(grid, {{1, 1}, {4, 1}, {4, 4}});
  EXPECT_LT(path_figures(grid, curve).greatest_curvature, path_figures(grid, sharp).greatest_curvature / 2);
  EXPECT_LT(path_length(curve), path_length(sharp));
}

/// An obstacle on the inner side of a wide turn: named, and gone round along the legs.
TEST(BSpline, IsPulledInWhereItWouldHitSomething) {
  Grid2 grid({12, 12});
  const CellEdit edit{grid.node(Cell{7, 3}), true};
  grid.apply({&edit, 1});
  const Path path = over(grid, {{1, 2}, {8, 2}, {8, 9}});
  const Path curve = BSpline::apply(grid, path, {});
  ASSERT_TRUE(curve.spline);
  ASSERT_EQ(curve.spline->pulled_in.size(), 1u);
  EXPECT_EQ(curve.spline->pulled_in[0].cell, (Cell{7, 3}));
  EXPECT_GT(curve.spline->control.size(), 3u);
  for (const Point& control : curve.spline->control) EXPECT_LT(distance_to(path, control), 1e-4);
  EXPECT_TRUE(path_is_free(grid, curve));
}

/// Between two obstacles that touch at a corner there is one way, through the corner: the path's own leg.
TEST(BSpline, EndsAtWorstAsThePathItself) {
  MoveRules rules;
  rules.corners = CornerRule::any;
  Grid2 grid({6, 6}, rules);
  const CellEdit walls[] = {{grid.node(Cell{3, 2}), true}, {grid.node(Cell{2, 3}), true}};
  grid.apply(walls);
  const Path path = over(grid, {{2, 1}, {2, 2}, {3, 3}, {3, 4}});
  const Path curve = BSpline::apply(grid, path, {});
  ASSERT_TRUE(curve.spline);
  EXPECT_TRUE(path_is_free(grid, curve));
  EXPECT_LT(distance_to(curve, {3, 3, 0.5}), 1e-12);
}

TEST(BSpline, LeavesAPathAloneWhoseLegsAreNotFree) {
  Grid2 grid({8, 5});
  const CellEdit edit{grid.node(Cell{2, 1}), true};
  grid.apply({&edit, 1});
  const Path path(grid.box(), {grid.node(Cell{0, 1}), grid.node(Cell{5, 2}), grid.node(Cell{7, 2})},
                  SightRule::bresenham);
  EXPECT_EQ(BSpline::apply(grid, path, {}), path);
}

}  // namespace
}  // namespace replan::test::bspline_test
