// The any-angle optimum against a visibility graph by brute force on random small maps, against published and computed
// lengths on large ones, and as the lower bound of every planner's path.
#include "core/plan/any_angle.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/world/formats/movingai.hpp"
#include "tests/support/brute_visibility.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::any_angle_test {
namespace {

TEST(AnyAngle, IsWhatABruteForceVisibilityGraphFinds) {
  int found = 0, bent = 0, none = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const auto size = random_size<2>(random, {1, 1}, {9, 8});
    const auto corners = static_cast<CornerRule>(seed % 3);
    const TwinWorld<2> world(size, random_cells<2>(random, size), {corners, true});
    AnyAngle optimum(world.lattice);
    BruteVisibility brute(world.plain, corners);
    for (int k = 0; k < 3; ++k) {
      const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
      const HalfPoint a = half_centre(world.lattice.position(start)),
                      b = half_centre(world.lattice.position(goal));
      const Squares squares(world.lattice);
      ASSERT_EQ(squares.clear(a, b, corners), squares.clear(b, a, corners)) << "seed " << seed;
      ASSERT_EQ(squares.clear(a, b, corners), a == b || brute.sees(a, b)) << "seed " << seed;
      const Path path = optimum.shortest(a, b);
      const double right = brute.length(a, b);
      ASSERT_EQ(path.empty(), right == HUGE_VAL) << "seed " << seed;
      if (path.empty()) {
        ++none;
        continue;
      }
      ASSERT_NEAR(path_length(path), right, 1e-9) << "seed " << seed;
      ASSERT_EQ(path.point(0), (Point{a.x / 2.0, a.y / 2.0, 0.5}));
      ++found;
      bent += path.size() > 2 ? 1 : 0;
    }
  }
  std::printf("any-angle optimum: %d ways, %d of them bent, %d times none\n", found, bent, none);
  EXPECT_GT(found, 4000);
  EXPECT_GT(bent, 500);
  EXPECT_GT(none, 100);
}

TEST(AnyAngle, IsThereExactlyIfTheLatticeHasAWayAndIsNeverLongerThanAnyPlanners) {
  std::int64_t held = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    const auto size = random_size<2>(random, {2, 2}, {30, 24});
    const MoveRules rules{static_cast<CornerRule>(seed % 3), true};
    const TwinWorld<2> world(size, random_cells<2>(random, size), rules);
    const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
    AnyAngle optimum(world.lattice);
    const Path path = optimum.shortest(half_centre(world.lattice.position(start)),
                                       half_centre(world.lattice.position(goal)));
    for (const PlannerInfo& info : sound_planners()) {
      NoTrace nobody;
      Settings settings;
      settings.set("corners", static_cast<double>(rules.corners));
      settings.set("samples", kFewSamples);
      const auto planner = make_planner(info, world.lattice, settings, nobody);
      planner->begin(start, goal);
      const PlanStatus status = finish(*planner),
                       right = path.empty() ? PlanStatus::no_path : PlanStatus::found;
      ASSERT_TRUE(is_right(info, status, right)) << info.id << ", seed " << seed;
      if (status != PlanStatus::found) continue;
      ASSERT_GE(path_length(planner->path()), path_length(path) - 1e-9) << info.id << ", seed " << seed;
      ++held;
    }
  }
  EXPECT_GT(held, 2000);
}

/// A map of the shared data, and the optimum on it.
struct Ground {
  Grid2 lattice;
  AnyAngle optimum{lattice};

  explicit Ground(const GridMap& map) : lattice({map.width, map.height}, map.blocked.plain()) {}
  double length(HalfPoint a, HalfPoint b) { return path_length(optimum.shortest(a, b)); }
};

TEST(AnyAngle, HasTheLengthsThatThePlanningCompetitionPublished) {
  REPLAN_NEED_SHARED_DATA();
  const auto folder = shared_data() / "anyangle";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "The any-angle lengths are absent.";
  const auto map = read_movingai_map((folder / "AcrosstheCape.map").string());
  ASSERT_TRUE(map.ok()) << map.error();
  Ground ground(*map);
  std::ifstream in(folder / "AcrosstheCape.map.scen");
  int agreed = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string bucket, name;
    int width = 0, height = 0, sx = 0, sy = 0, gx = 0, gy = 0;
    double length = 0;
    if (!(fields >> bucket >> name >> width >> height >> sx >> sy >> gx >> gy >> length)) continue;
    ASSERT_NEAR(ground.length({2 * sx, 2 * sy}, {2 * gx, 2 * gy}), length, 1e-8) << line;
    ++agreed;
  }
  std::printf("AcrosstheCape: %d published lengths agree\n", agreed);
  EXPECT_EQ(agreed, 101);
}

TEST(AnyAngle, HasTheLengthsThatAnotherProgramComputed) {
  REPLAN_NEED_SHARED_DATA();
  std::ifstream in(shared_data() / "anyangle" / "computed.tsv");
  if (!in) GTEST_SKIP() << "The any-angle lengths are absent.";
  std::string open_map;
  std::unique_ptr<Ground> ground;
  int agreed = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string name;
    int sx = 0, sy = 0, gx = 0, gy = 0;
    double by_corners = 0, by_centres = 0;
    if (!(fields >> name >> sx >> sy >> gx >> gy >> by_corners >> by_centres)) continue;
    if (name != open_map) {
      const auto map = read_movingai_map((shared_data() / "movingai" / (name + ".map")).string());
      ASSERT_TRUE(map.ok()) << map.error();
      ground = std::make_unique<Ground>(*map);
      open_map = name;
    }
    ASSERT_NEAR(ground->length(half_corner({sx, sy}), half_corner({gx, gy})), by_corners, 1e-8) << line;
    ASSERT_NEAR(ground->length(half_centre({sx, sy}), half_centre({gx, gy})), by_centres, 1e-8) << line;
    ++agreed;
  }
  std::printf("%d computed lengths agree, both ways\n", agreed);
  EXPECT_EQ(agreed, 1602);
}

}  // namespace
}  // namespace replan::test::any_angle_test
