// How a view lays out a world of several layers.
#include "core/lattice/seen_box.hpp"

#include <set>

#include <gtest/gtest.h>

namespace replan::seen_box_test {
namespace {

constexpr Axis kAxes[] = {Axis::x, Axis::y, Axis::z};

TEST(SeenBox, LeadsFromEveryCellToItsNodeAndBack) {
  const Box world(7, 5, 4);
  for (const Axis along : kAxes) {
    const SeenBox seen(world, along);
    std::set<NodeId> nodes;
    for (int layer = 0; layer < seen.depth(); ++layer)
      for (int row = 0; row < seen.height(); ++row)
        for (int column = 0; column < seen.width(); ++column) {
          const Cell at{column, row, layer};
          EXPECT_TRUE(seen.contains(at));
          EXPECT_EQ(seen.seen(seen.world(at)), at);
          EXPECT_EQ(seen.node(at), world.node(seen.world(at)));
          EXPECT_EQ(seen.position(seen.node(at)), at);
          EXPECT_EQ(seen.seen(centre_of(seen.world(at))), centre_of(at));
          EXPECT_EQ(seen.world(centre_of(at)), centre_of(seen.world(at)));
          nodes.insert(seen.node(at));
          if (column == 0) continue;
          EXPECT_EQ(seen.node(at) - seen.node({column - 1, row, layer}), seen.column_step());
        }
    EXPECT_EQ(nodes.size(), world.node_count());
    EXPECT_FALSE(seen.contains({seen.width(), 0, 0}));
    EXPECT_FALSE(seen.contains({0, -1, 0}));
    EXPECT_FALSE(seen.contains({0, 0, seen.depth()}));
  }
}

TEST(SeenBox, StandsUprightAlongXAndY) {
  const Box world(7, 5, 4);
  EXPECT_EQ(SeenBox(world, Axis::x).seen(Cell{6, 3, 0}), (Cell{3, 3, 6})) << "y to the right, z = 0 lowest";
  EXPECT_EQ(SeenBox(world, Axis::y).seen(Cell{6, 3, 3}), (Cell{6, 0, 3})) << "x to the right, z = 3 highest";
  EXPECT_EQ(SeenBox(world, Axis::z).seen(Cell{6, 3, 1}), (Cell{6, 3, 1}));
  EXPECT_EQ(SeenBox(world, Axis::x).turned({7, 5, 4}), (Cell{5, 4, 7}));
}

TEST(SeenBox, CountsTheColumnsOnAPage) {
  const Box world(7, 50, 4);
  for (const Axis along : kAxes) {
    const SeenBox seen(world, along);
    for (const std::size_t page : {16u, 64u})
      for (int layer : {0, 3})
        for (int first = 0; first < seen.width(); ++first) {
          const NodeId node = seen.node({first, 0, layer});
          int count = 1;
          for (NodeId next = node + seen.column_step(); next / page == node / page;
               next += seen.column_step())
            ++count;
          EXPECT_EQ(seen.columns_on_page(node, page), count);
        }
  }
}

TEST(Sheet, HasTheCellsOfItsLayer) {
  const Sheet sheet{SeenBox(Box(7, 5, 4), Axis::y), 2};
  EXPECT_EQ(sheet.cell(6, 0), (Cell{6, 2, 3}));
  EXPECT_TRUE(sheet.has({6, 2, 0}));
  EXPECT_FALSE(sheet.has({6, 3, 0}));
}

}  // namespace
}  // namespace replan::seen_box_test
