// A remote parent goes stale when the map changes after its sight was checked. Taken as printed, the DLD*
// Lite paper's main loop then sends the robot through an obstacle or round in a circle; checked when used, it
// never does.
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace replan::test::remote_parents_test {
namespace {

constexpr int kSide = 60;
constexpr int kTrials = 300;

struct Faults {
  int crossings = 0, loops = 0, longer = 0, replanned = 0;
};

/// How a leap is known to be clear.
enum class Way : std::uint8_t { printed, checked, along_path };

/// Axis-parallel rectangles with sides 3 to 8 until 17 % is covered: the paper's world, smaller.
std::vector<std::uint8_t> rectangles(Random& random, NodeId start, NodeId goal) {
  std::vector<std::uint8_t> cells(kSide * kSide);
  const auto covered = [&cells] { return std::count(cells.begin(), cells.end(), 1); };
  while (covered() < kSide * kSide * 17 / 100) {
    const int left = random.between(0, kSide - 1), top = random.between(0, kSide - 1);
    const int right = std::min(kSide, left + random.between(3, 8)),
              bottom = std::min(kSide, top + random.between(3, 8));
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) cells[static_cast<std::size_t>(y * kSide + x)] = 1;
  }
  cells[start] = cells[goal] = 0;
  return cells;
}

/// The cells of a 5x5 block round a cell, start and goal spared.
std::vector<CellEdit> block_on(const Grid2& lattice, NodeId middle, NodeId start, NodeId goal) {
  const Cell at = lattice.position(middle);
  std::vector<CellEdit> edits;
  for (int y = at.y - 2; y <= at.y + 2; ++y)
    for (int x = at.x - 2; x <= at.x + 2; ++x) {
      if (!lattice.contains(Cell{x, y})) continue;
      const NodeId n = lattice.node(Cell{x, y});
      if (n != start && n != goal && !lattice.blocked(n)) edits.push_back({n, true});
    }
  return edits;
}

/// Cells of the path ahead that such a block may be dropped on without walling in the robot or the goal.
std::vector<NodeId> cells_ahead(const oracle::World& world, std::span<const NodeId> path, NodeId goal) {
  const auto apart = [&world](std::size_t a, std::size_t b) {
    const auto p = world.place(a), q = world.place(b);
    return std::max(std::abs(p[0] - q[0]), std::abs(p[1] - q[1]));
  };
  std::vector<NodeId> result;
  for (std::size_t i = 1; i < path.size(); ++i)
    for (const std::size_t cell : oracle::crossed_cells(world, path[i - 1], path[i]))
      if (apart(cell, path.front()) >= 4 && apart(cell, path.front()) <= 15 && apart(cell, goal) >= 4)
        result.push_back(static_cast<NodeId>(cell));
  return result;
}

bool crosses(const oracle::World& world, const Path& path, SightRule sight) {
  for (std::size_t i = 1; i < path.nodes().size(); ++i)
    if (!oracle::sees(world, world.blocked, CornerRule::none, sight, path.nodes()[i - 1], path.nodes()[i]))
      return true;
  return false;
}

/// Plans, drives a little, has a block dropped on the path ahead and replans.
void surprise(const PlannerInfo& info, Way way, std::uint64_t seed, Faults& faults) {
  Random random(seed);
  Settings settings;
  settings.set("remote_parents", way == Way::printed ? 1 : 0);
  settings.set("sight_checks", way == Way::along_path ? 1 : 0);
  settings.set("heuristic", 1);  // Euclidean, as in the paper
  settings.set("sight", static_cast<double>(SightRule::bresenham));
  NodeId start = 5 * kSide + 5;
  const NodeId goal = 54 * kSide + 54;
  TwinWorld<2> world({kSide, kSide}, rectangles(random, start, goal), {});
  NoTrace trace;
  const auto planner = make_planner(info, world.lattice, settings, trace);
  const auto twin = make_planner(lattice_twin(info), world.lattice, settings, trace);
  planner->begin(start, goal);
  twin->begin(start, goal);
  finish(*twin);
  if (finish(*planner) != PlanStatus::found) return;
  const Path before = planner->path();
  if (before.loops || before.nodes().size() < 4) return;
  const std::size_t here = before.nodes().size() / 4;
  start = before.nodes()[here];
  const auto ahead = cells_ahead(world.plain, before.nodes().subspan(here), goal);
  if (ahead.empty()) return;
  const NodeId on_path = ahead[random.below(static_cast<std::uint32_t>(ahead.size()))];
  const auto edits = block_on(world.lattice, on_path, start, goal);
  const auto moves = world.apply(edits);
  planner->update({.cells = edits, .moves = moves}, start);
  twin->update({.cells = edits, .moves = moves}, start);
  finish(*twin);
  if (finish(*planner) != PlanStatus::found) return;
  const Path path = planner->path();
  ++faults.replanned;
  faults.crossings += crosses(world.plain, path, SightRule::bresenham) ? 1 : 0;
  faults.loops += path.loops ? 1 : 0;
  faults.longer += !path.loops && !fault_of_length(world.plain, path, twin->path()).empty() ? 1 : 0;
}

Faults surprises(const char* id, Way way) {
  constexpr const char* kWays[] = {"remote parents as printed", "remote parents checked",
                                   "sight along the path"};
  Faults faults;
  for (std::uint64_t seed = 1; seed <= kTrials; ++seed) surprise(*find_planner(id), way, seed, faults);
  std::printf(
      "%s, %s: %d replans, %d paths crossed an obstacle, %d looped, %d were longer than the lattice's\n", id,
      kWays[static_cast<std::size_t>(way)], faults.replanned, faults.crossings, faults.loops, faults.longer);
  return faults;
}

class RemoteParents : public ::testing::TestWithParam<const char*> {};

TEST_P(RemoteParents, printedOnesCrossObstaclesOrLoopInSomeSurprises) {
  const Faults faults = surprises(GetParam(), Way::printed);
  EXPECT_GT(faults.replanned, kTrials / 2);
  EXPECT_GT(faults.crossings + faults.loops, 0);
}

TEST_P(RemoteParents, checkedOrAlongThePathNeverCrossAnObstacleLoopOrGoALongerWay) {
  for (const Way way : {Way::checked, Way::along_path}) {
    const Faults faults = surprises(GetParam(), way);
    EXPECT_GT(faults.replanned, kTrials / 2);
    EXPECT_EQ(faults.crossings, 0);
    EXPECT_EQ(faults.loops, 0);
    EXPECT_EQ(faults.longer, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Family, RemoteParents, ::testing::Values("los-dstar-lite", "dld-star-lite"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace replan::test::remote_parents_test
