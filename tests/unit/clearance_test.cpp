// The clearance penalty: equal to the paper's two passes (or to brute force), and kept so, bit for bit, by
// local updates.
#include "core/field/clearance.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace replan::test::clearance_test {
namespace {

constexpr double kRanges[] = {1, 1.25, 1.4142135623730951, 1.5, 2, 2.5, 3, 3.7, 4, 5, 6.5, 8, 10, 11.9, 12};

std::vector<ClearanceRules> all_rules() {
  std::vector<ClearanceRules> rules;
  for (const double range : kRanges)
    for (const Transform transform : {Transform::chamfer, Transform::euclidean})
      for (const bool border : {false, true})
        rules.push_back({.range = range, .transform = transform, .border_is_obstacle = border});
  for (const double r_max : {1.0, 2.0, 3.0, 4.5, 12.0})
    for (const double r_min : {0.0, 0.5, 1.0, 1.4142135623730951, 2.0, 3.7})
      for (const bool impassable : {false, true})
        if (r_min <= r_max)
          rules.push_back({.range = r_max,
                           .transform = Transform::euclidean,
                           .border_is_obstacle = r_max == 2,
                           .threat = ThreatCurve{r_min == 0.5 ? 0.1 : 5, r_min, impassable}});
  return rules;
}

std::string describe(const ClearanceRules& rules) {
  return "range " + std::to_string(rules.range) +
         (rules.transform == Transform::chamfer ? " chamfer" : " euclidean") +
         (rules.border_is_obstacle ? " border" : "") +
         (rules.threat
              ? " threat " + std::to_string(rules.threat->c) + " up to " +
                    std::to_string(rules.threat->r_min) + (rules.threat->impassable ? " impassable" : "")
              : "");
}

template <int D>
void expect_equals_oracle(const ClearanceField<D>& field, const oracle::World& world,
                          const ClearanceRules& rules) {
  const auto expected = oracle::penalties(world, rules);
  for (NodeId n = 0; n < expected.size(); ++n) {
    ASSERT_EQ(field.penalty(n).raw, expected[n]) << describe(rules) << ", node " << n;
    ASSERT_EQ(field.near(n), expected[n] != 0);
  }
}

template <int D>
void check_full(typename BoxLattice<D>::Coordinates size, std::uint64_t seed) {
  Random random(seed);
  TwinWorld<D> world(size, random_cells<D>(random, size), {});
  for (const ClearanceRules& rules : all_rules())
    expect_equals_oracle(ClearanceField<D>(world.lattice, rules), world.plain, rules);
}

TEST(ClearanceField, equalsTheTwoPassTransformAndBruteForceIn2d) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) check_full<2>({23, 17}, seed);
  check_full<2>({1, 30}, 1);
  check_full<2>({30, 1}, 2);
  check_full<2>({1, 1}, 3);
  check_full<2>({2, 2}, 4);
  // Rows that are gathered many cells at a time, of a whole number of times and not.
  for (const int width : {31, 32, 33, 64, 97}) check_full<2>({width, 9}, static_cast<std::uint64_t>(width));
}

TEST(ClearanceField, equalsTheTwoPassTransformAndBruteForceIn3d) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) check_full<3>({9, 8, 7}, seed);
  check_full<3>({14, 14, 14}, 7);
  check_full<3>({1, 1, 20}, 8);
  check_full<3>({1, 20, 1}, 9);
  check_full<3>({1, 1, 1}, 10);
  check_full<3>({40, 6, 5}, 11);
}

TEST(ClearanceField, tellsAllDistancesApartThatOccurWithinTheLargestRange) {
  // One obstacle in a corner: every distance of a 13-cube occurs.
  std::vector<std::uint8_t> cells(13 * 13 * 13);
  cells[0] = 1;
  TwinWorld<3> world({13, 13, 13}, cells, {});
  for (const ClearanceRules& rules : all_rules())
    expect_equals_oracle(ClearanceField<3>(world.lattice, rules), world.plain, rules);
}

TEST(ClearanceField, hasThePapersValues) {
  Grid2 lattice({7, 7});
  const CellEdit edit{lattice.node(Cell{3, 3}), true};
  lattice.apply({&edit, 1});
  const ClearanceField<2> field(lattice, {.range = 2});
  const auto at = [&](int x, int y) { return field.penalty(lattice.node(Cell{x, y})).to_double(); };
  EXPECT_EQ(at(2, 3), 2);
  EXPECT_NEAR(at(2, 2), 1.586, 0.0005);
  EXPECT_EQ(at(1, 3), 1);
  EXPECT_EQ(at(3, 3), 3);
  EXPECT_EQ(at(0, 3), 0);
  EXPECT_EQ(at(1, 2), 0);  // octile distance 2.414
  EXPECT_EQ(at(1, 1), 0);
}

TEST(ClearanceField, hasTheThreatsThreeZones) {
  Grid2 lattice({11, 11});
  const CellEdit edit{lattice.node(Cell{5, 5}), true};
  lattice.apply({&edit, 1});
  ClearanceRules rules{.range = 3, .transform = Transform::euclidean, .threat = ThreatCurve{}};
  const ClearanceField<2> field(lattice, rules);
  const auto at = [&](int x, int y) { return field.penalty(lattice.node(Cell{x, y})).to_double(); };
  EXPECT_EQ(at(5, 5), 5);
  EXPECT_EQ(at(4, 5), 5);                                       // d = r_min
  EXPECT_NEAR(at(4, 4), 5 * std::exp(1 - std::sqrt(2)), 1e-8);  // 3.305
  EXPECT_NEAR(at(3, 5), 5 * std::exp(-1), 1e-8);                // 1.839
  EXPECT_NEAR(at(3, 3), 5 * std::exp(1 - std::sqrt(8)), 1e-8);  // 0.803
  EXPECT_NEAR(at(5, 8), 5 * std::exp(-2), 1e-8);                // d = r_max: 0.677
  EXPECT_EQ(at(4, 8), 0);                                       // d = 3.162
  rules.threat->impassable = true;
  const ClearanceField<2> walls(lattice, rules);
  EXPECT_TRUE(walls.penalty(lattice.node(Cell{4, 5})).is_infinite());
  EXPECT_EQ(walls.penalty(lattice.node(Cell{4, 4})), field.penalty(lattice.node(Cell{4, 4})));
}

/// The reported changes are exactly the nodes whose penalty changed, each once, with what it was.
void expect_changes(std::span<const ClearanceChange> changes, const std::vector<oracle::Raw>& before,
                    const std::vector<oracle::Raw>& after) {
  std::vector<int> times(before.size());
  for (const ClearanceChange& change : changes) {
    ASSERT_LT(change.node, before.size());
    ++times[change.node];
    ASSERT_EQ(change.before.raw, before[change.node]) << "node " << change.node;
  }
  for (std::size_t n = 0; n < before.size(); ++n)
    ASSERT_EQ(times[n], before[n] != after[n] ? 1 : 0) << "node " << n;
}

template <int D>
void check_updates(typename BoxLattice<D>::Coordinates size, const ClearanceRules& rules, std::uint64_t seed,
                   int rounds) {
  SCOPED_TRACE(describe(rules) + ", seed " + std::to_string(seed));
  Random random(seed);
  TwinWorld<D> world(size, random_cells<D>(random, size), {});
  ClearanceField<D> field(world.lattice, rules);
  auto before = oracle::penalties(world.plain, rules);
  for (int round = 0; round < rounds; ++round) {
    const auto edits = random_edits<D>(random, world.plain, 10);
    world.apply(edits);
    const auto changes = field.update(world.lattice, edits);
    const auto after = oracle::penalties(world.plain, rules);
    expect_changes(changes, before, after);
    expect_equals_oracle(field, world.plain, rules);
    const ClearanceField<D> fresh(world.lattice, rules);
    ASSERT_TRUE(std::ranges::equal(fresh.ranks(), field.ranks()));
    ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "round " << round;
    before = after;
  }
}

TEST(ClearanceField, localUpdateEqualsTheFullTransformIn2d) {
  for (const ClearanceRules& rules : all_rules())
    for (std::uint64_t seed = 0; seed < 6; ++seed) check_updates<2>({19, 15}, rules, seed, 20);
}

TEST(ClearanceField, localUpdateEqualsTheFullTransformIn3d) {
  for (const ClearanceRules& rules : all_rules())
    for (std::uint64_t seed = 0; seed < 2; ++seed) check_updates<3>({8, 7, 6}, rules, seed, 8);
}

TEST(ClearanceField, localUpdateTakesInEveryObstacleAtOnceAndItsRemoval) {
  for (const ClearanceRules& rules : all_rules()) {
    TwinWorld<2> world({9, 8}, std::vector<std::uint8_t>(72), {});
    ClearanceField<2> field(world.lattice, rules);
    for (const bool blocked : {true, false}) {
      std::vector<CellEdit> edits;
      for (NodeId n = 0; n < 72; ++n) edits.push_back({n, blocked});
      world.apply(edits);
      field.update(world.lattice, edits);
      expect_equals_oracle(field, world.plain, rules);
    }
  }
}

}  // namespace
}  // namespace replan::test::clearance_test
