// What a best-first search leaves open to a planner: its key, what expanding a vertex and relaxing an edge do, and
// what it remembers of a vertex.
#include "core/planners/best_first.hpp"

#include <gtest/gtest.h>

#include "core/lattice/sight.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::best_first_test {
namespace {

struct OwnSwitches {};
PlannerInfo describe(OwnSwitches) {
  PlannerInfo info;
  info.parameters = {parameters::kAnyHeuristic};
  return info;
}

/// Greedy best-first search: what lies nearest to the goal is taken first.
struct EstimateAlone {
  static constexpr const char* kLaw = "a key in the list is h";
  explicit EstimateAlone(const Settings&) {}
  Cost operator()(Cost, Cost h) const { return h; }
};
template <Lattice L, Tracer T>
using Greedy = BestFirst<L, T, EstimateAlone>;

struct AnyAngleNode : BestFirstNode {
  NodeId far_parent = kNoNode;
};

/// Theta* (Nash, Daniel, Koenig & Felner, AAAI 2007): an edge from u may as well come from u's parent, if that sees
/// its end. It counts its expansions.
template <Lattice L, Tracer T>
class ThetaStar final : public BestFirst<L, T, GPlusH, ThetaStar<L, T>, AnyAngleNode> {
  using Base = BestFirst<L, T, GPlusH, ThetaStar<L, T>, AnyAngleNode>;
  friend Base;

 public:
  using Base::Base;
  int expanded = 0;

 private:
  using Base::lattice_, Base::nodes_;
  using typename Base::Expanded;

  void expand(const Expanded& u) {
    ++expanded;
    Base::expand(u);
  }

  void relax(const Expanded& u, int d) {
    const NodeId s = lattice_.neighbour(u.node, d), far = parent_of(u.node);
    const auto bad = [this](NodeId c) { return lattice_.blocked(c); };
    const bool seen = far != kNoNode && line_of_sight(lattice_, SightRule::supercover, far, s, bad);
    const Cost sum =
        seen ? nodes_[far].g + euclidean_ceil(lattice_.squared_distance(far, s)) : u.g + L::step_cost(d);
    if (!(sum < nodes_[s].g)) return;
    this->reach(s, static_cast<std::uint32_t>(L::reverse(d)), sum, L::step(u.at, d));
    nodes_.held(s).far_parent = seen ? far : u.node;
  }

  [[nodiscard]] NodeId parent_of(NodeId s) const { return nodes_[s].far_parent; }
};

template <int D>
TwinWorld<D> random_world(Random& random) {
  typename BoxLattice<D>::Coordinates low{}, high{};
  low.fill(3);
  high.fill(D == 2 ? 16 : 7);
  const auto size = random_size<D>(random, low, high);
  return {size, random_cells<D>(random, size), {}};
}

/// Both planners plan, and after a change plan again; `check` looks at the answers, the shortest lattice path's cost
/// with them.
template <int D, template <class, class> class Kind, class Check>
void plan_in_random_worlds(Check&& check) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    auto world = random_world<D>(random);
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    NoTrace nobody;
    Kind<BoxLattice<D>, NoTrace> planner(world.lattice, {}, nobody, OwnSwitches{});
    planner.begin(start, goal);
    for (int round = 0; round < 2; ++round) {
      finish(planner);
      const bool enclosed = world.plain.blocked[start] != 0;
      const oracle::Raw shortest =
          enclosed ? oracle::kNever : oracle::costs_to(world.plain, {}, {}, goal)[start];
      ASSERT_EQ(planner.status(), right_status(world.plain, start, goal, shortest)) << "seed " << seed;
      if (planner.status() == PlanStatus::found) check(world.plain, planner, shortest);
      ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "seed " << seed << ", round " << round;
      const auto edits = random_edits<D>(random, world.plain, 5);
      const auto moves = world.apply(edits);
      planner.update({.cells = edits, .moves = moves}, start);
    }
  }
}

template <int D>
void check_greedy() {
  std::int64_t longer = 0;
  plan_in_random_worlds<D, Greedy>([&](const oracle::World& world, auto& planner, oracle::Raw shortest) {
    ASSERT_EQ(fault_of_segments({}, {}, world, planner.path().nodes().front(), planner.path().nodes().back(),
                                planner.path()),
              "");
    ASSERT_GE(planner.cost().raw, shortest);
    longer += planner.cost().raw > shortest ? 1 : 0;
  });
  EXPECT_GT(longer, 0) << "a key of its own leads to plans of its own";
}

TEST(BestFirst, GoesByTheKeyThatAPlannerBringsIn2d) {
  check_greedy<2>();
}
TEST(BestFirst, GoesByTheKeyThatAPlannerBringsIn3d) {
  check_greedy<3>();
}

template <int D>
void check_theta_star() {
  std::int64_t shorter = 0;
  plan_in_random_worlds<D, ThetaStar>([&](const oracle::World& world, auto& planner, oracle::Raw shortest) {
    const Path path = planner.path();
    PlannerInfo any_angle;
    any_angle.any_angle = true;
    ASSERT_EQ(fault_of_segments(any_angle, {}, world, path.nodes().front(), path.nodes().back(), path), "");
    ASSERT_LE(length_of(world, path), planner.cost().raw);
    shorter += planner.cost().raw < shortest ? 1 : 0;
    ASSERT_EQ(planner.expanded, planner.counters().expansions);
  });
  EXPECT_GT(shorter, 20) << "edges from parents that see the vertex shorten paths";
}

TEST(BestFirst, LetsAPlannerRelaxEdgesItsOwnWayIn2d) {
  check_theta_star<2>();
}
TEST(BestFirst, LetsAPlannerRelaxEdgesItsOwnWayIn3d) {
  check_theta_star<3>();
}

/// The same rule that the search goes by is what laws and the open list's order read of its log.
TEST(BestFirst, DeclaresItsKeyInOneText) {
  const KeyRule rule = key_rule<EstimateAlone>();
  EXPECT_STREQ(rule.law, "a key in the list is h");
  EXPECT_EQ(rule.f({})(Cost::cells(2), Cost::cells(3), Cost::cells(1)), Cost::cells(3));
  const PlannerInfo& astar = *find_planner("astar");
  EXPECT_EQ(astar.key.f({})(Cost::cells(2), Cost::cells(3), Cost::cells(1)), Cost::cells(5));
}

}  // namespace
}  // namespace replan::test::best_first_test
