// A box of voxels as large as the largest published ones: read, solved, and within the memory of a desktop.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/experiment/batch_report.hpp"
#include "core/world/formats/voxel_map.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::test::large_voxels_test {
namespace {

constexpr int kWidth = 485, kHeight = 294, kDepth = 616;  // 87.8 million voxels
constexpr Voxel kStart{242, 230, 220}, kGoal{242, 230, 400}, kGap{242, 290, 308};

/// The shortest way in an empty box.
double straight(Voxel a, Voxel b) {
  std::array<int, 3> d = {std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)};
  std::sort(d.begin(), d.end());
  return d[0] * std::sqrt(3.0) + (d[1] - d[0]) * std::sqrt(2.0) + (d[2] - d[1]);
}

/// A wall across the box with one hole in it, straight through which the way must go.
GridMap wall_with_a_hole() {
  GridMap map(kWidth, kHeight, kDepth);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) map.blocked[map.index({x, y, kGap.z})] = kObstacle;
  map.blocked[map.index(kGap)] = kFree;
  return map;
}

TEST(LargeVoxels, AreReadAndSolvedWithinTheMemoryOfADesktop) {
  const TemporaryFolder folder;
  const std::string path = folder.file("large.3dmap");
  ASSERT_TRUE(write_voxel_map(wall_with_a_hole(), path).ok());
  const auto map = read_voxel_map(path);
  ASSERT_TRUE(map.ok()) << map.error();
  ASSERT_EQ(map->blocked.size(), std::size_t{kWidth} * kHeight * kDepth);
  const Voxel before{kGap.x, kGap.y, kGap.z - 1}, behind{kGap.x, kGap.y, kGap.z + 1};
  ScenFile scen;
  scen.map_name = "large.3dmap";
  scen.solid = true;
  char length[32];
  std::snprintf(length, sizeof length, "%.8f", straight(kStart, before) + 2 + straight(behind, kGoal));
  scen.problems = {{.start = kStart, .goal = kGoal, .printed = length, .printed_ratio = "1"}};
  const auto read = parse_voxel_scen(scen_text(scen), "large.3dscen");
  ASSERT_TRUE(read.ok()) << read.error();
  const BatchReport report = solve_problems(*map, read->lengths, read->problems, {"astar", {}});
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  std::printf("%lld expansions, %.0f ms, %.2f GiB\n", static_cast<long long>(report.expansions),
              report.total_ms, static_cast<double>(used.ru_maxrss) / (1 << 20));
  EXPECT_EQ(report.found, 1);
  EXPECT_EQ(report.mismatches, 0) << "listed " << length << ", found "
                                  << (report.first_mismatches.empty() ? 0 : report.first_mismatches[0].found);
  EXPECT_LT(used.ru_maxrss, 24L << 20);
}

}  // namespace
}  // namespace replan::test::large_voxels_test
