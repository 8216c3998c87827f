// The laws of core/lattice/lattice.hpp, for every lattice under every rule.
#include <bit>

#include <gtest/gtest.h>

#include "core/lattice/lattice.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::lattice_laws_test {
namespace {

constexpr Heuristic kBounds[] = {Heuristic::octile, Heuristic::euclidean, Heuristic::chebyshev,
                                 Heuristic::manhattan, Heuristic::zero};

static_assert(Lattice<Grid2> && Lattice<Voxel3>);

std::vector<MoveRules> all_rules() {
  std::vector<MoveRules> rules;
  for (const CornerRule corners : {CornerRule::none, CornerRule::one, CornerRule::any})
    for (const bool diagonals : {true, false}) rules.push_back({corners, diagonals});
  return rules;
}

template <int D>
std::vector<typename BoxLattice<D>::Coordinates> sizes() {
  if constexpr (D == 2)
    return {{1, 1}, {2, 2}, {1, 2}, {2, 1}, {1, 9}, {9, 1}, {3, 3}, {7, 5}, {12, 9}};
  else
    return {{1, 1, 1}, {2, 2, 2}, {1, 1, 6}, {1, 6, 1}, {6, 1, 1}, {3, 3, 3}, {1, 5, 4}, {5, 4, 6}};
}

template <int D>
class LatticeLaws : public ::testing::Test {
 protected:
  /// Runs a check on random worlds of all sizes under all rules.
  template <class Check>
  void everywhere(int worlds, Check&& check) {
    for (const MoveRules rules : all_rules())
      for (const auto& size : sizes<D>())
        for (int seed = 0; seed < worlds; ++seed) {
          Random random(static_cast<std::uint64_t>(seed));
          SCOPED_TRACE("corners " + std::to_string(static_cast<int>(rules.corners)) + ", diagonals " +
                       std::to_string(rules.diagonals) + ", seed " + std::to_string(seed));
          TwinWorld<D> world(size, random_cells<D>(random, size), rules);
          check(world, rules, random);
        }
  }
};

/// Nodes that the moves of n lead to, in the order of the directions.
template <int D>
std::vector<std::size_t> moves_of(const BoxLattice<D>& lattice, NodeId n) {
  std::vector<std::size_t> result;
  for (std::uint32_t rest = lattice.moves(n); rest != 0; rest &= rest - 1)
    result.push_back(lattice.neighbour(n, std::countr_zero(rest)));
  return result;
}

template <int D>
void check_moves(const TwinWorld<D>& world, MoveRules rules) {
  for (NodeId n = 0; n < world.lattice.node_count(); ++n) {
    const auto moves = moves_of(world.lattice, n);
    ASSERT_TRUE(std::is_sorted(moves.begin(), moves.end())) << "law 2, node " << n;
    ASSERT_EQ(moves, oracle::neighbours(world.plain, rules, n)) << "law 1 and 4, node " << n;
  }
}

template <int D>
void check_undirected(const TwinWorld<D>& world) {
  using L = BoxLattice<D>;
  for (NodeId n = 0; n < world.lattice.node_count(); ++n)
    for (std::uint32_t rest = world.lattice.moves(n); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId m = world.lattice.neighbour(n, d);
      ASSERT_LT(m, world.lattice.node_count());
      ASSERT_EQ(world.lattice.neighbour(m, L::reverse(d)), n);
      ASSERT_NE(world.lattice.moves(m) >> L::reverse(d) & 1u, 0u);
      ASSERT_EQ(L::step_cost(d), L::step_cost(L::reverse(d)));
      ASSERT_EQ(L::step_cost(d).raw, oracle::step_between(world.plain, n, m));
    }
}

using Grid2Laws = LatticeLaws<2>;
using Voxel3Laws = LatticeLaws<3>;

TEST_F(Grid2Laws, movesAreThoseOfTheCornerRuleInOrderOfIndex) {
  everywhere(6, [](auto& world, MoveRules rules, Random&) { check_moves<2>(world, rules); });
}
TEST_F(Voxel3Laws, movesAreThoseOfTheCornerRuleInOrderOfIndex) {
  everywhere(6, [](auto& world, MoveRules rules, Random&) { check_moves<3>(world, rules); });
}
TEST_F(Grid2Laws, movesAreUndirectedAndCostTheSameBothWays) {
  everywhere(6, [](auto& world, MoveRules, Random&) { check_undirected<2>(world); });
}
TEST_F(Voxel3Laws, movesAreUndirectedAndCostTheSameBothWays) {
  everywhere(6, [](auto& world, MoveRules, Random&) { check_undirected<3>(world); });
}

/// Law 8; edits may name a cell twice or change nothing.
template <int D>
void check_apply(TwinWorld<D>& world, MoveRules rules, Random& random) {
  for (int round = 0; round < 6; ++round) {
    std::vector<std::uint32_t> before;
    for (NodeId n = 0; n < world.lattice.node_count(); ++n) before.push_back(world.lattice.moves(n));
    auto edits = random_edits<D>(random, world.plain, 6);
    edits.push_back({edits[0].node, random.chance(0.5)});
    edits.push_back({0, world.plain.blocked[0] != 0});
    const auto changes = world.apply(edits);
    std::vector<int> reported(before.size());
    for (const auto& change : changes) {
      ++reported[change.node];
      ASSERT_EQ(change.before, before[change.node]);
    }
    const BoxLattice<D> fresh(world.lattice.size(), world.plain.blocked, rules);
    for (NodeId n = 0; n < before.size(); ++n) {
      ASSERT_EQ(world.lattice.blocked(n), world.plain.blocked[n] != 0);
      ASSERT_EQ(world.lattice.moves(n), fresh.moves(n)) << "node " << n;
      ASSERT_EQ(reported[n], world.lattice.moves(n) != before[n] ? 1 : 0) << "node " << n;
    }
  }
}

TEST_F(Grid2Laws, applyEqualsALatticeBuiltAfreshAndReportsExactlyWhatChanged) {
  everywhere(8, [](auto& world, MoveRules rules, Random& random) { check_apply<2>(world, rules, random); });
}
TEST_F(Voxel3Laws, applyEqualsALatticeBuiltAfreshAndReportsExactlyWhatChanged) {
  everywhere(8, [](auto& world, MoveRules rules, Random& random) { check_apply<3>(world, rules, random); });
}

TEST(LatticeRules, setRulesEqualsALatticeBuiltUnderThem) {
  Random random(3);
  const auto cells = random_cells<2>(random, {9, 8});
  Grid2 lattice({9, 8}, cells);
  for (const MoveRules rules : all_rules()) {
    lattice.set_rules(rules);
    const Grid2 fresh({9, 8}, cells, rules);
    EXPECT_EQ(lattice.rules(), rules);
    for (NodeId n = 0; n < cells.size(); ++n) ASSERT_EQ(lattice.moves(n), fresh.moves(n));
  }
}

/// Laws 5 and 6 on an open lattice. Manhattan promises nothing where diagonals are allowed.
template <int D>
void check_bounds(const typename BoxLattice<D>::Coordinates& size, MoveRules rules) {
  const TwinWorld<D> world(size, std::vector<std::uint8_t>(cell_count<D>(size)), rules);
  const auto& lattice = world.lattice;
  const auto count = static_cast<NodeId>(lattice.node_count());
  for (const Heuristic h : kBounds) {
    if (h == Heuristic::manhattan && rules.diagonals) continue;
    for (NodeId a = 0; a < count; ++a)
      for (NodeId c = 0; c < count; ++c) {
        const Cost whole = lattice.bound(h, a, c);
        ASSERT_EQ(whole.raw, oracle::estimate(world.plain, rules, h, a, c));
        ASSERT_EQ(whole, lattice.bound(h, c, a));
        for (std::uint32_t rest = lattice.moves(a); rest != 0; rest &= rest - 1) {
          const int d = std::countr_zero(rest);
          ASSERT_LE(whole, BoxLattice<D>::step_cost(d) + lattice.bound(h, lattice.neighbour(a, d), c));
        }
        for (NodeId b = 0; b < count; ++b)
          ASSERT_LE(whole, lattice.bound_up(h, a, b) + lattice.bound(h, b, c));
      }
  }
}

TEST_F(Grid2Laws, boundsAreConsistentOverStepsAndKeepTheTriangleWithBoundUp) {
  for (const bool diagonals : {true, false})
    for (const auto& size : sizes<2>()) check_bounds<2>(size, {.diagonals = diagonals});
}
TEST_F(Voxel3Laws, boundsAreConsistentOverStepsAndKeepTheTriangleWithBoundUp) {
  for (const bool diagonals : {true, false})
    for (const auto& size : sizes<3>()) check_bounds<3>(size, {.diagonals = diagonals});
}

TEST(LatticeBounds, areConsistentAcrossLargeLattices) {
  const Grid2 wide({4096, 128});
  const Voxel3 deep({40, 41, 39});
  Random random(11);
  const auto check = [&random](const auto& lattice) {
    const auto count = static_cast<std::uint32_t>(lattice.node_count());
    for (int i = 0; i < 20'000; ++i) {
      const NodeId a = random.below(count), b = random.below(count), c = random.below(count);
      for (const Heuristic h : {Heuristic::octile, Heuristic::euclidean, Heuristic::chebyshev}) {
        ASSERT_LE(lattice.bound(h, a, c), lattice.bound_up(h, a, b) + lattice.bound(h, b, c));
        ASSERT_LE(lattice.bound(h, a, c), lattice.bound_up(h, a, c));
      }
      const std::uint32_t moves = lattice.moves(a);
      for (std::uint32_t rest = moves; rest != 0; rest &= rest - 1) {
        const int d = std::countr_zero(rest);
        for (const Heuristic h : {Heuristic::octile, Heuristic::euclidean, Heuristic::chebyshev})
          ASSERT_LE(lattice.bound(h, a, c),
                    lattice.step_cost(d) + lattice.bound(h, lattice.neighbour(a, d), c));
      }
    }
  };
  check(wide);
  check(deep);
}

TEST(EuclideanBound, isTheExactFloorAndCeiling) {
  for (std::int64_t n = 0; n < 20'000; ++n) {
    const oracle::Raw down = oracle::root_floor(n);
    __extension__ using Wide = unsigned __int128;
    const bool whole = static_cast<Wide>(down) * static_cast<Wide>(down) == static_cast<Wide>(n) << 60;
    ASSERT_EQ(euclidean_floor(n).raw, down) << n;
    ASSERT_EQ(euclidean_ceil(n).raw, down + (whole ? 0 : 1)) << n;
  }
  Random random(5);
  for (int i = 0; i < 200'000; ++i) {
    const auto n = static_cast<std::int64_t>(random.next() >> (14 + random.below(50)));
    ASSERT_EQ(euclidean_floor(n).raw, oracle::root_floor(n)) << n;
  }
  for (int axes = 1; axes <= 3; ++axes) EXPECT_EQ(kStepCost[axes].raw, oracle::step(axes));
}

/// coordinates() multiplies instead of dividing; it must be the division.
void check_coordinates(const Grid2& lattice, NodeId n) {
  const auto width = static_cast<NodeId>(lattice.width());
  const auto at = lattice.coordinates(n);
  ASSERT_EQ(at[0], static_cast<int>(n % width)) << n;
  ASSERT_EQ(at[1], static_cast<int>(n / width)) << n;
  ASSERT_EQ(lattice.node(at), n);
  ASSERT_EQ(lattice.node(lattice.position(n)), n);
}

TEST(Coordinates, areExactUpToTheLargestWidths) {
  Random random(1);
  std::vector<int> widths = {1, 2, 3, 7, 10, 49, 1000, 4095, 4096, 4097, 65521, 1'000'003};
  widths.insert(widths.end(), {(1 << 22) - 1, 1 << 26});
  for (const int width : widths) {
    const int height =
        std::max(1, static_cast<int>(std::min<std::int64_t>(kMaxCells / width, 200'000 / width + 1)));
    const Grid2 lattice({width, height});
    const auto count = static_cast<std::uint32_t>(lattice.node_count());
    for (int row = 0; row < std::min(height, 2000);
         ++row) {  // the rows' ends are where a quotient turns over
      const auto first = static_cast<NodeId>(row) * static_cast<NodeId>(width);
      check_coordinates(lattice, first);
      check_coordinates(lattice, first + static_cast<NodeId>(width) - 1);
    }
    check_coordinates(lattice, count - 1);
    for (int i = 0; i < 5'000; ++i) check_coordinates(lattice, random.below(count));
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "width " << width;
  }
}

TEST(Coordinates, areExactOnTallAndDeepLattices) {
  for (const auto& size : {std::array{500, 499, 1}, std::array{3, 1 << 16, 1}, std::array{1, 7, 1 << 15},
                           std::array{50, 51, 52}}) {
    const Voxel3 lattice(size);
    Random random(2);
    const auto count = static_cast<std::uint32_t>(lattice.node_count());
    for (int i = 0; i < 50'000; ++i) {
      const NodeId n = i == 0 ? count - 1 : random.below(count);
      const auto x = static_cast<NodeId>(size[0]), y = static_cast<NodeId>(size[1]);
      const std::array<int, 3> expected = {static_cast<int>(n % x), static_cast<int>(n / x % y),
                                           static_cast<int>(n / x / y)};
      ASSERT_EQ(lattice.coordinates(n), expected) << n;
    }
  }
}

template <int D>
void check_directions() {
  for (int d = 0; d < Directions<D>::kCount; ++d) {
    const auto offset = Directions<D>::offset(d);
    auto mirrored = offset;
    for (int& part : mirrored) part = -part;
    EXPECT_EQ(Directions<D>::index(offset), d);
    EXPECT_EQ(Directions<D>::index(mirrored), BoxLattice<D>::reverse(d));
    EXPECT_EQ(std::popcount(Directions<D>::squeezed(d)), (1 << Directions<D>::axes(d)) - 2);
  }
}

TEST(Directions, areNumberedByOffsetAndMirrored) {
  check_directions<2>();
  check_directions<3>();
}

}  // namespace
}  // namespace replan::test::lattice_laws_test
