// The any-angle optimum against a visibility graph by brute force on random small maps, against published and computed
// lengths on large ones, and as the lower bound of every planner's path.
#include "core/plan/any_angle.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/world/formats/movingai.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::any_angle_test {
namespace {

/// Every corner of cells is a point of the graph, and sight is a matter of squares that a segment cuts.
class BruteForce {
 public:
  BruteForce(const oracle::World& world, CornerRule corners) : world_(world), corners_(corners) {}

  /// Infinite if there is no way.
  double length(HalfPoint from, HalfPoint to) {
    if (buried(from) || buried(to)) return HUGE_VAL;
    std::vector<HalfPoint> points = {from, to};
    for (int y = 0; y <= world_.size[1]; ++y)
      for (int x = 0; x <= world_.size[0]; ++x) points.push_back({2 * x, 2 * y});
    std::vector<double> g(points.size(), HUGE_VAL);
    std::vector<bool> done(points.size());
    g[0] = 0;
    for (;;) {
      std::size_t u = points.size();
      for (std::size_t i = 0; i < points.size(); ++i)
        if (!done[i] && g[i] < HUGE_VAL && (u == points.size() || g[i] < g[u])) u = i;
      if (u == points.size()) return g[1];
      if (u == 1) return g[1];
      done[u] = true;
      for (std::size_t v = 0; v < points.size(); ++v) {
        const double x = points[u].x - points[v].x, y = points[u].y - points[v].y;
        const double sum = g[u] + std::sqrt(x * x + y * y) / 2;
        if (sum < g[v] && sees(points[u], points[v])) g[v] = sum;
      }
    }
  }

  /// Neither through the inside of an obstacle, nor between two, nor through (or out of) a place where two meet.
  [[nodiscard]] bool sees(HalfPoint a, HalfPoint b) const {
    for (int y = -1; y <= world_.size[1]; ++y)
      for (int x = -1; x <= world_.size[0]; ++x)
        if (bad(x, y) && cuts(a, b, x, y)) return false;
    for (int y = 0; y <= world_.size[1]; ++y)
      for (int x = 0; x <= world_.size[0]; ++x) {
        const HalfPoint corner{2 * x, 2 * y};
        if (corners_ != CornerRule::any && meets(x, y) && on_segment(a, b, corner)) return false;
        if (bad(x, y) && bad(x, y - 1) && along(a, b, corner, {2 * x + 2, 2 * y})) return false;
        if (bad(x, y) && bad(x - 1, y) && along(a, b, corner, {2 * x, 2 * y + 2})) return false;
      }
    return true;
  }

 private:
  [[nodiscard]] bool bad(int x, int y) const { return world_.bad({x, y, 0}); }
  [[nodiscard]] bool buried(HalfPoint p) const { return p.x % 2 != 0 && bad((p.x - 1) / 2, (p.y - 1) / 2); }
  [[nodiscard]] bool meets(int x, int y) const {
    return (bad(x, y) && bad(x - 1, y - 1) && !bad(x - 1, y) && !bad(x, y - 1)) ||
           (bad(x - 1, y) && bad(x, y - 1) && !bad(x, y) && !bad(x - 1, y - 1));
  }
  static std::int64_t side(HalfPoint a, HalfPoint b, HalfPoint p) {
    return std::int64_t{b.x - a.x} * (p.y - a.y) - std::int64_t{b.y - a.y} * (p.x - a.x);
  }
  /// Both ends count: who leaves a pinch chooses a side, and nobody turns in one.
  static bool on_segment(HalfPoint a, HalfPoint b, HalfPoint p) {
    return side(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
  }
  /// Whether the segment runs along that unit edge.
  static bool along(HalfPoint a, HalfPoint b, HalfPoint p, HalfPoint q) {
    if (a == b || side(a, b, p) != 0 || side(a, b, q) != 0) return false;
    const bool across = p.y == q.y;
    const int low = across ? std::min(a.x, b.x) : std::min(a.y, b.y);
    const int high = across ? std::max(a.x, b.x) : std::max(a.y, b.y);
    return low < (across ? q.x : q.y) && high > (across ? p.x : p.y);
  }
  /// Whether the segment passes through the inside of a square: clipped by its four sides, in fractions over a common
  /// denominator.
  static bool cuts(HalfPoint a, HalfPoint b, int x, int y) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
    const std::int64_t whole =
        std::max<std::int64_t>(std::abs(dx), 1) * std::max<std::int64_t>(std::abs(dy), 1);
    std::int64_t enter = 0, leave = whole;
    for (const auto& [from, by, low] : {std::tuple{std::int64_t{a.x}, dx, std::int64_t{2 * x}},
                                        std::tuple{std::int64_t{a.y}, dy, std::int64_t{2 * y}}}) {
      if (by == 0) {
        if (from <= low || from >= low + 2) return false;
        continue;
      }
      const std::int64_t unit = whole / std::abs(by);
      const std::int64_t t0 = (by > 0 ? low - from : from - low - 2) * unit;
      enter = std::max(enter, t0);
      leave = std::min(leave, t0 + 2 * unit);
    }
    return enter < leave;
  }

  const oracle::World& world_;
  CornerRule corners_;
};

TEST(AnyAngle, IsWhatABruteForceVisibilityGraphFinds) {
  int found = 0, bent = 0, none = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const auto size = random_size<2>(random, {1, 1}, {9, 8});
    const auto corners = static_cast<CornerRule>(seed % 3);
    const TwinWorld<2> world(size, random_cells<2>(random, size), {corners, true});
    AnyAngle optimum(world.lattice);
    BruteForce brute(world.plain, corners);
    for (int k = 0; k < 3; ++k) {
      const NodeId start = random_free(random, world.plain), goal = random_free(random, world.plain);
      const HalfPoint a = half_centre(world.lattice.position(start)),
                      b = half_centre(world.lattice.position(goal));
      ASSERT_EQ(optimum.sees(a, b), optimum.sees(b, a)) << "seed " << seed;
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
      const auto planner = make_planner(info, world.lattice, settings, nobody);
      planner->begin(start, goal);
      ASSERT_EQ(finish(*planner) == PlanStatus::found, !path.empty()) << info.id << ", seed " << seed;
      if (path.empty()) continue;
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
