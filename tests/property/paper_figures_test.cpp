// The figures that the DLD* Lite paper reports (Huang & Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, Fig. 5):
// ten random worlds of 200 x 200 cells, (15, 15) to (175, 175), mean node counts D* Lite 182.7 and DLD*
// Lite 31.2, lengths about equal. With the paper's heuristic (Euclidean) and its line of sight (Bresenham).
#include <array>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "core/plan/figures.hpp"
#include "core/plan/registry.hpp"
#include "core/world/generators/generators.hpp"

namespace replan::paper_figures_test {
namespace {

struct Means {
  double nodes = 0, length = 0, turns = 0, clearance = 0, expansions = 0, sight_checks = 0;
};

Means means_of(const char* id) {
  constexpr int kWorlds = 10;
  const PlannerInfo& info = *find_planner(id);
  const std::array<Cell, 2> ends = {Cell{15, 15}, Cell{175, 175}};
  Settings settings;
  EXPECT_TRUE(set_from_text(settings, info.parameters, "heuristic", "euclidean").ok());
  if (info.sight) {
    EXPECT_TRUE(set_from_text(settings, info.parameters, "sight", "bresenham").ok());
  }
  Means sum;
  for (std::uint64_t seed = 1; seed <= kWorlds; ++seed) {
    const GridMap map = *random_rectangles(200, 200, 0.17, 5, 15, seed, ends);
    const Grid2 lattice({map.width, map.height}, map.blocked.plain(), move_rules(settings));
    NoTrace tracer;
    const auto planner = make_planner(info, lattice, settings, tracer);
    planner->begin(lattice.node(ends[0]), lattice.node(ends[1]));
    EXPECT_EQ(finish(*planner), PlanStatus::found);
    const PathFigures figures = path_figures(lattice, planner->path());
    sum.nodes += static_cast<double>(figures.nodes) / kWorlds;
    sum.length += figures.length / kWorlds;
    sum.turns += static_cast<double>(figures.turns) / kWorlds;
    sum.clearance += figures.min_clearance / kWorlds;
    sum.expansions += static_cast<double>(planner->counters().expansions) / kWorlds;
    sum.sight_checks += static_cast<double>(planner->counters().sight_checks) / kWorlds;
  }
  std::printf("| %-15s | %6.1f | %8.3f | %5.1f | %5.2f | %6.0f | %6.0f |\n", id, sum.nodes, sum.length,
              sum.turns, sum.clearance, sum.expansions, sum.sight_checks);
  return sum;
}

TEST(PaperFigures, NodeCountsOnTenRandomWorldsAreNearThePapers) {
  std::printf("| planner         |  nodes |   length | turns | clear |    exp | sights |\n");
  std::map<std::string, Means> means;
  for (const char* id : {"dstar-lite", "los-dstar-lite", "dist-dstar-lite", "dld-star-lite"})
    means[id] = means_of(id);
  EXPECT_NEAR(means["dstar-lite"].nodes, 182.7, 5);
  EXPECT_NEAR(means["dld-star-lite"].nodes, 31.2, 6);
  EXPECT_GT(means["dist-dstar-lite"].nodes, means["dstar-lite"].nodes);
  EXPECT_LT(means["dld-star-lite"].length, means["dstar-lite"].length);
  EXPECT_LT(means["los-dstar-lite"].length, means["dld-star-lite"].length);
  EXPECT_GT(means["dld-star-lite"].clearance, means["los-dstar-lite"].clearance);
}

}  // namespace
}  // namespace replan::paper_figures_test
