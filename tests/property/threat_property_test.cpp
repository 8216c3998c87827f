// Planners that pay the AUV paper's threat, after any sequence of edits, moves and replans: their cost equals that of a
// fresh plan by brute force, exactly, and all of them pay the same.
#include <cstdio>
#include <memory>

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace replan::test::threat_property_test {
namespace {

constexpr const char* kPaying[] = {"threat-astar", "dist-dstar-lite", "dld-star-lite"};

/// Of all of them the same: c, both radii, impassable or not, the border, and which moves there are.
Settings threat_settings(Random& random) {
  constexpr double kMost[] = {0.1, 1, 5, 20}, kRadii[] = {0, 1, 1.5, 2, 3, 4};
  Settings settings;
  settings.set("penalty", 1);
  settings.set("c", kMost[random.below(4)]);
  settings.set("r_min", kRadii[random.below(4)]);
  settings.set("r_max", kRadii[1 + random.below(5)]);
  settings.set("impassable", random.chance(0.2) ? 1 : 0);
  settings.set("border", random.below(2));
  settings.set("corners", random.below(3));
  settings.set("moves", random.chance(0.2) ? 1 : 0);
  settings.set("heuristic", random.below(3));
  return settings;
}

template <int D>
class Trial {
 public:
  explicit Trial(std::uint64_t seed)
      : random_(seed),
        settings_(threat_settings(random_)),
        size_(random_size<D>(random_, low(), high())),
        world_(size_, random_cells<D>(random_, size_), move_rules(settings_)),
        start_(random_free(random_, world_.plain)),
        goal_(random_free(random_, world_.plain)) {
    for (const char* id : kPaying) {
      planners_.push_back(make_planner(*find_planner(id), world_.lattice, settings_, trace_));
      planners_.back()->begin(start_, goal_);
    }
  }

  /// What is wrong with any of the plans, or empty.
  std::string plan() {
    std::string faults;
    for (std::size_t i = 0; i < planners_.size(); ++i) {
      finish(*planners_[i]);
      const std::string fault =
          fault_of_plan<D>(*find_planner(kPaying[i]), settings_, world_.plain, start_, goal_, *planners_[i]);
      if (!fault.empty()) faults += std::string(kPaying[i]) + ": " + fault + ". ";
    }
    return faults;
  }
  void change() {
    const auto edits = random_edits<D>(random_, world_.plain, 6);
    const auto moves = world_.apply(edits);
    if (random_.chance(0.5)) start_ = random_free(random_, world_.plain);
    for (const auto& planner : planners_) planner->update({.cells = edits, .moves = moves}, start_);
  }
  [[nodiscard]] bool found() const { return planners_.front()->status() == PlanStatus::found; }
  [[nodiscard]] std::string describe() const {
    return describe_settings(*find_planner("threat-astar"), settings_);
  }

 private:
  static typename BoxLattice<D>::Coordinates low() {
    if constexpr (D == 2)
      return {8, 8};
    else
      return {5, 4, 4};
  }
  static typename BoxLattice<D>::Coordinates high() {
    if constexpr (D == 2)
      return {20, 16};
    else
      return {8, 7, 6};
  }

  Random random_;
  Settings settings_;
  typename BoxLattice<D>::Coordinates size_;
  TwinWorld<D> world_;
  NodeId start_, goal_;
  NoTrace trace_;
  std::vector<std::unique_ptr<Planner<BoxLattice<D>>>> planners_;
};

template <int D>
void check(std::uint64_t worlds, int replans) {
  int done = 0, found = 0;
  for (std::uint64_t seed = 0; seed < worlds; ++seed) {
    Trial<D> trial(seed);
    ASSERT_EQ(trial.plan(), "") << trial.describe() << ", seed " << seed;
    for (int i = 0; i < replans; ++i, ++done) {
      trial.change();
      ASSERT_EQ(trial.plan(), "") << trial.describe() << ", seed " << seed << ", replan " << i;
      found += trial.found() ? 1 : 0;
    }
  }
  std::printf("%dD: %d replans of each planner, %d with a path\n", D, done, found);
  EXPECT_GT(found, done / 3);
}

TEST(Threat, CostsOfRepairedPlansAreThoseOfFreshOnesIn2d) {
  check<2>(200, 25);
}
TEST(Threat, CostsOfRepairedPlansAreThoseOfFreshOnesIn3d) {
  check<3>(200, 25);
}

/// A corridor three cells wide beside a wide hall: the threat is worth the detour, plain A* is not told.
TEST(Threat, BendsAPathAway) {
  Grid2 lattice({30, 20});
  std::vector<CellEdit> walls;
  for (int x = 5; x < 25; ++x) {
    walls.push_back({lattice.node(Cell{x, 3}), true});
    walls.push_back({lattice.node(Cell{x, 7}), true});
  }
  lattice.apply(walls);
  NoTrace nobody;
  Settings settings;
  settings.set("penalty", 1);
  const auto least = [&](const char* id) {
    const auto planner = make_planner(*find_planner(id), lattice, settings, nobody);
    planner->begin(lattice.node(Cell{1, 5}), lattice.node(Cell{28, 5}));
    finish(*planner);
    const Path path = planner->path();
    int nearest = 100;
    for (const NodeId node : path.nodes())
      for (const CellEdit& wall : walls)
        nearest = std::min(nearest, static_cast<int>(lattice.squared_distance(node, wall.node)));
    return nearest;
  };
  EXPECT_EQ(least("astar"), 4);  // straight through the corridor
  for (const char* id : kPaying) EXPECT_GE(least(id), 9) << id;
}

}  // namespace
}  // namespace replan::test::threat_property_test
