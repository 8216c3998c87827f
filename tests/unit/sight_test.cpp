// Lines of sight against brute force in whole numbers, over all pairs of cells of small worlds.
#include "core/lattice/sight.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace replan::test::sight_test {
namespace {

constexpr CornerRule kCorners[] = {CornerRule::none, CornerRule::one, CornerRule::any};
constexpr SightRule kSights[] = {SightRule::supercover, SightRule::bresenham};

template <int D>
void check_all_pairs(typename BoxLattice<D>::Coordinates size, CornerRule corners, SightRule rule,
                     double density, std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed) + ", corners " + std::to_string(static_cast<int>(corners)) +
               (rule == SightRule::supercover ? ", supercover" : ", bresenham"));
  Random random(seed);
  std::vector<std::uint8_t> cells(cell_count<D>(size));
  for (std::uint8_t& cell : cells) cell = random.chance(density) ? 1 : 0;
  const TwinWorld<D> world(size, cells, {.corners = corners});
  const auto bad = [&](NodeId n) { return cells[n] != 0; };
  const SightMap<D> map(world.lattice, bad);
  for (NodeId a = 0; a < cells.size(); ++a)
    for (NodeId b = 0; b < cells.size(); ++b) {
      const bool seen = line_of_sight(world.lattice, rule, a, b, bad);
      ASSERT_EQ(seen, line_of_sight(world.lattice, rule, b, a, bad))
          << a << " and " << b << ": not symmetric";
      ASSERT_EQ(seen, line_of_sight(world.lattice, rule, a, b, bad, map))
          << a << " to " << b << " by the map";
      ASSERT_EQ(seen, oracle::sees(world.plain, cells, corners, rule, a, b)) << a << " to " << b;
    }
}

TEST(LineOfSight, isThatOfBruteForceAndSymmetricIn2d) {
  for (const CornerRule corners : kCorners)
    for (const SightRule rule : kSights)
      for (std::uint64_t seed = 0; seed < 24; ++seed)
        check_all_pairs<2>({13, 10}, corners, rule, 0.02 + 0.02 * static_cast<double>(seed % 12), seed);
}

TEST(LineOfSight, isThatOfBruteForceAndSymmetricIn3d) {
  for (const CornerRule corners : kCorners)
    for (const SightRule rule : kSights)
      for (std::uint64_t seed = 0; seed < 12; ++seed)
        check_all_pairs<3>({6, 5, 4}, corners, rule, 0.02 + 0.02 * static_cast<double>(seed % 12), seed);
}

/// Long rays over open ground: leaps over tiles and runs over many words say what a walk cell by cell does.
TEST(LineOfSight, byTheMapIsThatOfEveryCellOverLongDistances) {
  std::size_t checks = 0, clear = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    Random random(seed);
    constexpr int kShapes[][4] = {{100, 900, 100, 700}, {1, 9, 300, 5000}, {300, 5000, 1, 80}};
    const auto& shape = kShapes[seed % 3];
    const Grid2::Coordinates size{random.between(shape[0], shape[1]), random.between(shape[2], shape[3])};
    std::vector<std::uint8_t> cells(cell_count<2>(size));
    const auto any = [&] { return random.below(static_cast<std::uint32_t>(cells.size())); };
    for (int few = random.between(0, 40); few > 0; --few) cells[any()] = 1;
    const Grid2 lattice(size, cells, {.corners = kCorners[random.below(3)]});
    const auto bad = [&](NodeId n) { return cells[n] != 0; };
    SightMap<2> map(lattice, bad);
    for (int edits = 0; edits < 30; ++edits) {
      const NodeId n = any();
      cells[n] ^= 1;
      map.change(lattice.coordinates(n), cells[n] != 0);
    }
    for (int ray = 0; ray < 1000; ++ray) {
      const NodeId a = any();
      auto there = lattice.coordinates(any());
      if (random.chance(0.3)) {  // through corners
        const int far = random.between(1, 300);
        there = lattice.coordinates(a);
        there[0] += far;
        there[1] += random.chance(0.5) ? far : -far;
      }
      const NodeId b = lattice.contains(there) ? lattice.node(there) : any();
      for (const SightRule rule : kSights) {
        const bool seen = line_of_sight(lattice, rule, a, b, bad);
        ASSERT_EQ(seen, line_of_sight(lattice, rule, a, b, bad, map))
            << a << " to " << b << ", seed " << seed;
        ASSERT_EQ(seen, line_of_sight(lattice, rule, b, a, bad, map))
            << b << " to " << a << ", seed " << seed;
        ++checks;
        clear += seen ? 1 : 0;
      }
    }
  }
  EXPECT_GT(clear, checks / 4);
  EXPECT_LT(clear, checks * 3 / 4);
}

TEST(LineOfSight, holdsOnLatticesOfOneRowColumnOrCell) {
  for (const CornerRule corners : kCorners)
    for (const SightRule rule : kSights)
      for (std::uint64_t seed = 0; seed < 10; ++seed) {
        check_all_pairs<2>({12, 1}, corners, rule, 0.15, seed);
        check_all_pairs<2>({1, 12}, corners, rule, 0.15, seed);
        check_all_pairs<2>({1, 1}, corners, rule, 0.5, seed);
        check_all_pairs<3>({1, 1, 12}, corners, rule, 0.15, seed);
        check_all_pairs<3>({7, 1, 6}, corners, rule, 0.1, seed);
      }
}

TEST(LineOfSight, betweenNeighboursIsTheMoveRule) {
  for (const CornerRule corners : kCorners)
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Random random(seed);
      const auto cells = random_cells<3>(random, {5, 5, 5});
      const TwinWorld<3> world({5, 5, 5}, cells, {.corners = corners});
      for (NodeId n = 0; n < cells.size(); ++n)
        for (NodeId m = 0; m < cells.size(); ++m) {
          if (n == m || world.lattice.squared_distance(n, m) > 3) continue;
          const auto p = world.lattice.coordinates(n), q = world.lattice.coordinates(m);
          if (std::abs(p[0] - q[0]) > 1 || std::abs(p[1] - q[1]) > 1 || std::abs(p[2] - q[2]) > 1) continue;
          const auto near = oracle::neighbours(world.plain, {.corners = corners}, n);
          const bool move = std::binary_search(near.begin(), near.end(), std::size_t{m});
          for (const SightRule rule : kSights)
            ASSERT_EQ(line_of_sight(world.lattice, rule, n, m, [&](NodeId c) { return cells[c] != 0; }),
                      move);
        }
    }
}

/// The cells a walk enters, its first cell put in front, sorted; each direction leads from one to the next.
template <int D, class Walk>
std::vector<std::size_t> walked(const BoxLattice<D>& lattice, NodeId from, Walk&& walk) {
  std::vector<std::size_t> cells{from};
  NodeId at = from;
  walk([&](NodeId node, int direction) {
    EXPECT_EQ(node, lattice.neighbour(at, direction));
    EXPECT_LE(lattice.squared_distance(at, node), D);
    at = node;
    cells.push_back(node);
    return true;
  });
  std::sort(cells.begin(), cells.end());
  return cells;
}

template <int D>
void check_walks(typename BoxLattice<D>::Coordinates size) {
  const TwinWorld<D> world(size, std::vector<std::uint8_t>(cell_count<D>(size)), {});
  for (NodeId a = 0; a < world.lattice.node_count(); ++a)
    for (NodeId b = 0; b < world.lattice.node_count(); ++b) {
      const auto cells = walked(world.lattice, a,
                                [&](auto step) { EXPECT_TRUE(walk_supercover(world.lattice, a, b, step)); });
      ASSERT_EQ(cells, oracle::crossed_cells(world.plain, a, b)) << a << " to " << b;
      std::size_t last = a;
      int steps = 0;
      walk_bresenham(world.lattice, a, b, [&](NodeId node, int) {
        last = node;
        return ++steps > 0;
      });
      ASSERT_EQ(last, b);
      const auto p = world.lattice.coordinates(a), q = world.lattice.coordinates(b);
      int longest = 0;
      for (std::size_t axis = 0; axis < D; ++axis) longest = std::max(longest, std::abs(p[axis] - q[axis]));
      ASSERT_EQ(steps, longest);
    }
}

TEST(WalkSupercover, entersExactlyTheCellsThatTheSegmentPassesThrough) {
  check_walks<2>({14, 11});
  check_walks<3>({6, 5, 7});
  check_walks<2>({1, 9});
  check_walks<3>({9, 1, 1});
}

TEST(WalkSupercover, isExactOverLongSegments) {
  const Grid2 wide({8192, 64});
  const NodeId from = wide.node(Cell{0, 1}), to = wide.node(Cell{8191, 62});
  std::int64_t entered = 0;
  EXPECT_TRUE(walk_supercover(wide, from, to, [&](NodeId, int) { return ++entered > 0; }));
  EXPECT_EQ(entered, 8191 + 61 - 1);  // both odd and without a common divisor: one corner, half way
  const Voxel3 deep({40, 40, 40});
  entered = 0;
  EXPECT_TRUE(walk_supercover(deep, 0, 40 * 40 * 40 - 1, [&](NodeId, int) { return ++entered > 0; }));
  EXPECT_EQ(entered, 39);  // along the diagonal, from corner to corner
}

TEST(WalkSupercover, stopsWhenTold) {
  const Grid2 lattice({9, 9});
  int entered = 0;
  EXPECT_FALSE(walk_supercover(lattice, 0, 80, [&](NodeId, int) { return ++entered < 3; }));
  EXPECT_EQ(entered, 3);
  EXPECT_FALSE(walk_bresenham(lattice, 0, 80, [&](NodeId, int) { return ++entered < 6; }));
  EXPECT_EQ(entered, 6);
}

}  // namespace
}  // namespace replan::test::sight_test
