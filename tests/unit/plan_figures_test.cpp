#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/plan/figures.hpp"
#include "core/plan/planner.hpp"

namespace replan::plan_figures_test {
namespace {

const double kRoot2 = std::sqrt(2.0);

Path path_over(const Grid2& grid, const std::vector<Cell>& cells) {
  std::vector<NodeId> path;
  for (const Cell cell : cells) path.push_back(grid.node(cell));
  return Path(grid.box(), std::move(path));
}

template <int D>
double distance_to(const BoxLattice<D>& lattice, NodeId cell, const std::array<double, D>& point) {
  const auto at = lattice.coordinates(cell);
  double sum = 0;
  for (std::size_t axis = 0; axis < D; ++axis) {
    const double off = std::max(std::abs(point[axis] - at[axis]) - 0.5, 0.0);
    sum += off * off;
  }
  return std::sqrt(sum);
}

/// Minimum and mean clearance straight from the definition.
template <int D>
std::pair<double, double> clearance(const BoxLattice<D>& lattice, const std::vector<NodeId>& path) {
  std::vector<std::array<double, D>> samples;
  double travelled = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const auto a = lattice.coordinates(path[i - 1]), b = lattice.coordinates(path[i]);
    const double length = std::sqrt(static_cast<double>(lattice.squared_distance(path[i - 1], path[i])));
    while (0.1 * static_cast<double>(samples.size()) < travelled + length) {
      const double part = (0.1 * static_cast<double>(samples.size()) - travelled) / length;
      std::array<double, D> point{};
      for (std::size_t axis = 0; axis < D; ++axis) point[axis] = a[axis] + part * (b[axis] - a[axis]);
      samples.push_back(point);
    }
    travelled += length;
  }
  std::array<double, D> end{};
  for (std::size_t axis = 0; axis < D; ++axis) end[axis] = lattice.coordinates(path.back())[axis];
  samples.push_back(end);
  double smallest = 1e9, sum = 0;
  for (const auto& point : samples) {
    double nearest = 1e9;
    for (NodeId cell = 0; cell < lattice.node_count(); ++cell)
      if (lattice.blocked(cell)) nearest = std::min(nearest, distance_to<D>(lattice, cell, point));
    smallest = std::min(smallest, nearest);
    sum += nearest;
  }
  return {smallest, sum / static_cast<double>(samples.size())};
}

TEST(PathFigures, OfNoPathAndOfAPointAreDefined) {
  Grid2 grid({5, 4});
  const PathFigures none = path_figures(grid, {});
  EXPECT_EQ(none.nodes, 0);
  EXPECT_EQ(none.length, 0);
  EXPECT_EQ(none.min_clearance, 0);
  const PathFigures point = path_figures(grid, path_over(grid, {{1, 1}}));
  EXPECT_EQ(point.nodes, 1);
  EXPECT_EQ(point.length, 0);
  EXPECT_TRUE(std::isinf(point.min_clearance)) << "there is no obstacle to be near to";
  EXPECT_TRUE(std::isinf(point.mean_clearance));
}

TEST(PathFigures, CountsLengthTurnsAndAngles) {
  Grid2 grid({20, 20});
  const auto path = path_over(grid, {{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 2}, {4, 3}, {3, 3}, {4, 3}});
  const PathFigures figures = path_figures(grid, path);
  EXPECT_EQ(figures.nodes, 8);
  EXPECT_NEAR(figures.length, 5 + 2 * kRoot2, 1e-12);
  EXPECT_EQ(figures.turns, 4);
  EXPECT_NEAR(figures.turning_angle_deg, 45 + 45 + 90 + 180, 1e-9);
  EXPECT_NEAR(path_length(path), figures.length, 1e-12);
  // Collinear in any direction is no turn, and standing still neither.
  EXPECT_EQ(path_figures(grid, path_over(grid, {{0, 0}, {3, 7}, {3, 7}, {6, 14}})).turns, 0);
}

/// The top curvature: pi at a corner of a right angle, 2 pi where the way turns back, one over the radius of a circle.
TEST(PathFigures, TellHowSharplyAPathBends) {
  const Grid2 grid({30, 30});
  const auto top = [&](const Path& path) { return path_figures(grid, path).greatest_curvature; };
  EXPECT_EQ(top(path_over(grid, {{1, 1}, {9, 1}})), 0);
  EXPECT_NEAR(top(path_over(grid, {{1, 1}, {9, 1}, {9, 9}})), std::numbers::pi, 1e-9);
  EXPECT_NEAR(top(path_over(grid, {{1, 1}, {9, 1}, {4, 1}})), 2 * std::numbers::pi, 1e-9);
  for (const double radius : {1.0, 4.0, 10.0}) {
    std::vector<Point> circle;
    for (int i = 0; i <= 400; ++i)
      circle.push_back({15 + radius * std::cos(i * 0.01), 15 + radius * std::sin(i * 0.01), 0.5});
    EXPECT_NEAR(top(Path(circle)), 1 / radius, 0.03 / radius) << radius;
  }
}

TEST(PathFigures, MeasuresTheSquareNotItsCentre) {
  Grid2 grid({9, 9});
  const CellEdit wall[] = {{grid.node(Cell{4, 3}), true}};
  grid.apply(wall);
  const PathFigures beside = path_figures(grid, path_over(grid, {{0, 4}, {8, 4}}));
  EXPECT_DOUBLE_EQ(beside.min_clearance, 0.5);
  const PathFigures corner = path_figures(grid, path_over(grid, {{5, 4}}));
  EXPECT_DOUBLE_EQ(corner.min_clearance, kRoot2 / 2);
  const PathFigures through = path_figures(grid, path_over(grid, {{4, 0}, {4, 8}}));
  EXPECT_EQ(through.min_clearance, 0);
  EXPECT_GT(through.mean_clearance, 0);
}

template <int D>
void compare_with_the_definition(std::array<int, D> size, double density, std::uint64_t seed) {
  BoxLattice<D> lattice(size);
  Random random(seed);
  std::vector<CellEdit> edits;
  for (NodeId node = 0; node < lattice.node_count(); ++node)
    if (random.chance(density)) edits.push_back({node, true});
  if (edits.empty()) edits.push_back({random.below(static_cast<std::uint32_t>(lattice.node_count())), true});
  lattice.apply(edits);
  std::vector<NodeId> path;
  for (int i = 0; i < 5; ++i) path.push_back(random.below(static_cast<std::uint32_t>(lattice.node_count())));
  const PathFigures figures = path_figures(lattice, Path(lattice.box(), path));
  const auto [smallest, mean] = clearance<D>(lattice, path);
  ASSERT_NEAR(figures.min_clearance, smallest, 1e-9) << seed;
  ASSERT_NEAR(figures.mean_clearance, mean, 1e-9) << seed;
}

TEST(PathFigures, ClearanceEqualsItsDefinition) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const double density = seed % 3 == 0 ? 0 : seed % 3 == 1 ? 0.01 : 0.2;
    compare_with_the_definition<2>({23, 17}, density, seed);
    compare_with_the_definition<2>({1, 40}, density, seed);
    compare_with_the_definition<3>({7, 9, 5}, density, seed);
  }
}

TEST(PathIsFree, AllowsMovesAndLinesOfSight) {
  Grid2 grid({6, 6});
  const CellEdit wall[] = {{grid.node(Cell{2, 2}), true}};
  grid.apply(wall);
  const auto free = [&](const std::vector<Cell>& cells) {
    return path_is_free(grid, path_over(grid, cells));
  };
  EXPECT_TRUE(free({}));
  EXPECT_TRUE(free({{0, 0}}));
  EXPECT_FALSE(free({{2, 2}}));
  EXPECT_TRUE(free({{0, 0}, {5, 0}, {5, 5}}));
  EXPECT_FALSE(free({{0, 0}, {5, 5}}));
  EXPECT_FALSE(free({{1, 2}, {2, 1}}));  // squeezes past the corner
  EXPECT_TRUE(free({{1, 2}, {1, 1}, {2, 1}}));
  EXPECT_TRUE(free({{0, 0}, {0, 0}}));
  grid.set_rules({.corners = CornerRule::any});
  EXPECT_TRUE(free({{1, 2}, {2, 1}}));
}

TEST(Status, HasANameAndASentenceEach) {
  EXPECT_STREQ(status_name(PlanStatus::searching), "searching");
  EXPECT_STREQ(status_name(PlanStatus::found), "found");
  EXPECT_STREQ(status_name(PlanStatus::no_path), "no-path");
  EXPECT_STREQ(status_name(PlanStatus::start_blocked), "start-blocked");
  EXPECT_STREQ(status_name(PlanStatus::goal_blocked), "goal-blocked");
  EXPECT_STREQ(status_name(PlanStatus::found_nearest), "found-nearest");
  for (int i = 0; i <= 4; ++i)
    EXPECT_GT(std::string(status_sentence(static_cast<PlanStatus>(i))).size(), 10u);
}

}  // namespace
}  // namespace replan::plan_figures_test
