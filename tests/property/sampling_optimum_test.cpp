// Planners that sample, on worlds whose shortest way is known: what they find is never shorter, becomes shorter all the time
// and comes within 2 % of it.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/lattice/box_lattice.hpp"
#include "core/plan/registry.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/scenario.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/worlds.hpp"

namespace replan::test::sampling_optimum_test {
namespace {

constexpr double kWithin = 1.02;

/// A question whose shortest way is known.
struct Problem {
  std::string name;
  std::unique_ptr<Grid2> world;
  Cell start, goal;
  double optimum = 0;  ///< cells
};

struct Rectangle {
  double left, top, right, bottom;
};

/// A square world, `side` long, whose cells' centres are the multiples of 1 / scale: so start and goal are such centres. A
/// cell is an obstacle if any of its square is, so that no way is shorter than the shortest one of the world itself.
class Drawing {
 public:
  Drawing(double side, int scale) : scale_(scale), cells_(static_cast<int>(std::lround(side * scale)) + 1) {
    blocked_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_), 0);
  }
  void draw(const Rectangle& box) {
    each([&](double x, double y, double half) {
      return x + half > box.left && x - half < box.right && y + half > box.top && y - half < box.bottom;
    });
  }
  void draw_disc(double x0, double y0, double radius) {
    each([&](double x, double y, double half) {
      const double dx = std::max(0.0, std::abs(x - x0) - half), dy = std::max(0.0, std::abs(y - y0) - half);
      return std::hypot(dx, dy) < radius;
    });
  }
  [[nodiscard]] Problem ask(std::string name, Point start, Point goal, double optimum) const {
    const auto cell = [this](const Point& at) {
      return Cell{static_cast<int>(std::lround(at.x * scale_)), static_cast<int>(std::lround(at.y * scale_)),
                  0};
    };
    return {std::move(name),
            std::make_unique<Grid2>(Grid2::Coordinates{cells_, cells_}, blocked_, MoveRules{}), cell(start),
            cell(goal), optimum * scale_};
  }

 private:
  template <class Covers>
  void each(Covers&& covers) {
    for (int y = 0; y < cells_; ++y)
      for (int x = 0; x < cells_; ++x)
        if (covers(static_cast<double>(x) / scale_, static_cast<double>(y) / scale_, 0.5 / scale_))
          blocked_[static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_) +
                   static_cast<std::size_t>(x)] = 1;
  }

  int scale_, cells_;
  std::vector<std::uint8_t> blocked_;
};

/// The toy worlds of Gammell, Srinivasa & Barfoot 2014 and the disc of OMPL's demonstration.
std::vector<Problem> toys() {
  std::vector<Problem> problems;
  Drawing square(100, 10);
  square.draw({45, 45, 55, 55});
  problems.push_back(square.ask("toy-square(10)", {10, 50, 0}, {90, 50, 0}, 80.710678));
  Drawing gap(100, 10);
  gap.draw({45, 25, 55, 55});
  gap.draw({45, 57.5, 55, 75});
  problems.push_back(gap.ask("toy-gap(2.5)", {10, 50, 0}, {90, 50, 0}, 80.710678));
  Drawing disc(1, 500);
  disc.draw_disc(0.5, 0.5, 0.25);
  problems.push_back(disc.ask("ompl-circle", {0, 0, 0}, {1, 1, 0}, 1.503559217));
  return problems;
}

std::vector<Problem> rectangle_worlds() {
  std::vector<Problem> problems;
  std::ifstream in(shared_data() / "sampling" / "rects.json");
  for (const auto& read : nlohmann::json::parse(in)) {
    Drawing world(100, 10);
    for (const auto& box : read["rects"]) world.draw({box[0], box[1], box[2], box[3]});
    const auto point = [](const nlohmann::json& at) { return Point{at[0], at[1], 0}; };
    problems.push_back(world.ask("rects " + std::to_string(read["seed"].get<int>()), point(read["start"]),
                                 point(read["goal"]), read["optimal_length"]));
  }
  return problems;
}

/// The longest question of each of these maps.
std::vector<Problem> map_questions() {
  std::map<std::string, Problem> longest;
  for (const char* name : {"dao/arena", "cities/Berlin_0_256", "mapf/random-32-32-20", "mapf/maze-32-32-4"})
    longest[name].name = name;
  std::ifstream in(shared_data() / "anyangle" / "computed.tsv");
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string name;
    Cell start, goal;
    double between_corners = 0, between_centres = 0;
    if (!(words >> name >> start.x >> start.y >> goal.x >> goal.y >> between_corners >> between_centres))
      continue;
    const auto found = longest.find(name);
    if (found == longest.end() || found->second.optimum >= between_centres) continue;
    found->second.start = start, found->second.goal = goal;
    found->second.optimum = between_centres;
  }
  std::vector<Problem> problems;
  for (auto& [name, problem] : longest) {
    const auto map = read_movingai_map((shared_data() / "movingai" / (name + ".map")).string());
    EXPECT_TRUE(map.ok()) << map.error();
    if (!map) continue;
    problem.world =
        std::make_unique<Grid2>(Grid2::Coordinates{map->width, map->height}, map->blocked.plain());
    problems.push_back(std::move(problem));
  }
  return problems;
}

/// Steps of a fifth of the diagonal, which is where OMPL begins too.
Settings settings_for(const Problem& problem, int samples) {
  Settings settings;
  const double step = 0.2 * std::hypot(problem.world->size()[0], problem.world->size()[1]);
  settings.set("step", step);
  settings.set("goal_reach", step);
  settings.set("ball", 1);
  settings.set("samples", samples);
  return settings;
}

/// The world's own optimum: where gaps between rectangles are narrower than its cells it is above the one that was published.
double shortest(const Problem& problem) {
  NoTrace trace;
  const auto planner = make_planner(*find_planner("visibility-graph"), *problem.world, {}, trace);
  planner->begin(problem.world->node(problem.start), problem.world->node(problem.goal));
  EXPECT_EQ(finish(*planner), PlanStatus::found);
  return planner->cost().to_double();
}

/// The costs of the path, each time that it becomes another one, until one is below `enough`; they are never higher than
/// before.
std::vector<double> costs(const PlannerInfo& info, const Problem& problem, const Settings& settings,
                          double enough = 0) {
  NoTrace trace;
  const auto planner = make_planner(info, *problem.world, settings, trace);
  planner->begin(problem.world->node(problem.start), problem.world->node(problem.goal));
  std::vector<double> all;
  for (bool done = false; !done && (all.empty() || all.back() >= enough);) {
    done = planner->advance(1);
    const Cost cost = planner->best_so_far();
    if (cost.is_infinite() || (!all.empty() && cost.to_double() == all.back())) continue;
    EXPECT_TRUE(all.empty() || cost.to_double() < all.back());
    all.push_back(cost.to_double());
  }
  return all;
}

void expect_within(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems) {
    const double optimum = shortest(problem);
    ASSERT_GT(optimum, problem.optimum * (1 - 1e-8)) << problem.name;
    for (const char* id : {"rrt-star", "informed-rrt-star"}) {
      SCOPED_TRACE(problem.name + " by " + id);
      const auto found = costs(*find_planner(id), problem, settings_for(problem, 60000), 1.01 * optimum);
      ASSERT_FALSE(found.empty());
      std::printf("%-24s %-18s optimum %.4f of the published one; first path %.4f, last %.4f of it\n",
                  problem.name.c_str(), id, optimum / problem.optimum, found.front() / optimum,
                  found.back() / optimum);
      EXPECT_GT(found.back(), optimum * (1 - 1e-8));
      EXPECT_LT(found.back(), optimum * kWithin);
    }
  }
}

TEST(SamplingOptimum, IsComeNearOnToyWorlds) {
  expect_within(toys());
}
TEST(SamplingOptimum, IsComeNearAmongRectangles) {
  REPLAN_NEED_SHARED_DATA();
  expect_within(rectangle_worlds());
}
TEST(SamplingOptimum, IsComeNearOnMaps) {
  REPLAN_NEED_SHARED_DATA();
  expect_within(map_questions());
}

/// The way round the wall is 96.02 long, the one through its gap 80.71: a path that is found first round the wall is given up
/// for one of another kind.
TEST(SamplingOptimum, TheGapIsFoundAfterTheWayRoundTheWall) {
  const auto problems = toys();
  const Problem& gap = problems[1];
  const PlannerInfo& info = *find_planner("informed-rrt-star");
  int round_first = 0;
  for (int seed = 1; seed <= 5; ++seed) {
    Settings settings = settings_for(gap, 20000);
    settings.set("seed", seed);
    const auto found = costs(info, gap, settings);
    ASSERT_FALSE(found.empty());
    const bool round = [&] {
      for (const double cost : found)
        if (cost < 960.2 * kWithin && cost > 960.2) return true;
      return false;
    }();
    round_first += round ? 1 : 0;
    EXPECT_LT(found.back(), gap.optimum * kWithin) << seed;
  }
  EXPECT_GE(round_first, 1);
}

/// A wall of one cell with a gap of one: no edge through the wall, the last one to the goal included.
TEST(SamplingOptimum, AThinWallIsPassedThroughItsGapAlone) {
  REPLAN_NEED_SHARED_DATA();
  const auto file = shared_data().parent_path() / "field" / "thin-wall-gap.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "The file is absent.";
  const auto read = read_scenario(file.string());
  ASSERT_TRUE(read.ok()) << read.error();
  const GridMap& map = read->map;
  const Problem problem{
      "thin wall", std::make_unique<Grid2>(Grid2::Coordinates{map.width, map.height}, map.blocked.plain()),
      read->start, read->goal, 19.364};
  for (const PlannerInfo& info : sound_planners()) {
    if (!info.can_miss()) continue;
    SCOPED_TRACE(info.id);
    for (int seed = 1; seed <= 6; ++seed) {
      Settings settings;
      settings.set("samples", 4000);
      settings.set("seed", seed);
      const auto found = costs(info, problem, settings);
      ASSERT_FALSE(found.empty());
      EXPECT_GE(found.back(), problem.optimum);
    }
  }
}

}  // namespace
}  // namespace replan::test::sampling_optimum_test
