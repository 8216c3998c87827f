// The cells of a segment between any two points.
#include "core/lattice/segment.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/random.hpp"
#include "core/lattice/sight.hpp"

namespace replan::segment_test {
namespace {

std::vector<NodeId> cells_of(const Box& box, const Point& from, const Point& to) {
  std::vector<NodeId> cells;
  EXPECT_TRUE(walk_segment(box, from, to, [&](NodeId node) {
    cells.push_back(node);
    return true;
  }));
  return cells;
}

NodeId random_node(Random& random, const Box& box) {
  return random.below(static_cast<std::uint32_t>(box.node_count()));
}

TEST(Segment, BetweenCentresPassesTheCellsOfASupercover) {
  Random random(3);
  for (const Box& box : {Box(40, 23), Box(1, 60), Box(13, 9, 11)})
    for (int i = 0; i < 4000; ++i) {
      const NodeId from = random_node(random, box), to = random_node(random, box);
      std::vector<NodeId> expected;
      walk_supercover(box, from, to, [&](NodeId node) {
        expected.push_back(node);
        return true;
      });
      ASSERT_EQ(cells_of(box, centre_of(box.position(from)), centre_of(box.position(to))), expected)
          << from << " to " << to;
    }
}

/// A point of the box, often on the border of a cell or at its corner.
Point random_point(Random& random, const Box& box) {
  const auto along = [&random](int size) {
    const double at = random.unit() * size * 0.999;
    return random.chance(0.2) ? std::floor(at) : random.chance(0.2) ? std::floor(at) + 0.5 : at;
  };
  return {along(box.width()), along(box.height()), along(box.depth())};
}

/// How far the cell's cube is from the segment, sampled.
double gap(const Point& a, const Point& b, Cell cell) {
  double nearest = 1e9;
  for (int i = 0; i <= 2000; ++i) {
    const double t = i / 2000.0;
    const auto off = [t](double from, double to, int low) {
      const double at = from + t * (to - from);
      return std::max({low - at, at - (low + 1.0), 0.0});
    };
    const double x = off(a.x, b.x, cell.x), y = off(a.y, b.y, cell.y), z = off(a.z, b.z, cell.z);
    nearest = std::min(nearest, std::sqrt(x * x + y * y + z * z));
  }
  return nearest;
}

TEST(Segment, IsAChainOfCellsThatItTouchesFromTheFirstToTheLast) {
  Random random(5);
  for (const Box& box : {Box(20, 14), Box(7, 9, 6)})
    for (int i = 0; i < 400; ++i) {
      const Point a = random_point(random, box), b = random_point(random, box);
      Cell before = cell_of(a);
      std::vector<NodeId> cells = cells_of(box, a, b);
      for (const NodeId node : cells) {
        const Cell cell = box.position(node);
        ASSERT_LE(squared_distance(before, cell), 3);
        ASSERT_NE(before, cell);
        ASSERT_LT(gap(a, b, cell), 0.01);
        before = cell;
      }
      ASSERT_EQ(before, cell_of(b));
      // Whatever point of it is looked at, and is not as good as on a border, lies in one of them.
      cells.push_back(box.node(cell_of(a)));
      for (int sample = 0; sample < 50; ++sample) {
        const double t = random.unit();
        const Point at = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
        const auto inside = [](double x) { return std::abs(x - std::round(x)) > 1e-3; };
        if (!inside(at.x) || !inside(at.y) || !inside(at.z)) continue;
        ASSERT_NE(std::find(cells.begin(), cells.end(), box.node(cell_of(at))), cells.end());
      }
    }
}

TEST(Segment, StopsWhenItIsToldTo) {
  int entered = 0;
  EXPECT_FALSE(
      walk_segment(Box(9, 9), {0.5, 0.5, 0.5}, {8.5, 3.5, 0.5}, [&](NodeId) { return ++entered < 3; }));
  EXPECT_EQ(entered, 3);
}

}  // namespace
}  // namespace replan::segment_test
