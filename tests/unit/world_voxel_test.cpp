// Maps and problems in three dimensions.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/world/formats/voxel_map.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::world_voxel_test {
namespace {

std::string map_error(const std::string& text) {
  const auto map = parse_voxel_map(text, "m.3dmap");
  return map.ok() ? "" : map.error();
}
std::string scen_error(const std::string& text) {
  const auto scen = parse_voxel_scen(text, "m.3dscen");
  return scen.ok() ? "" : scen.error();
}

TEST(VoxelMap, ReadsAndWritesItsObstacles) {
  for (const char* text : {"voxel 3 2 4\n0 0 0\n2 1 3\n", "voxel 3 2 4\r\n2 1 3\r\n0\t0  0\r\n\r\n",
                           "voxel 3 2 4\n0 0 0\n0 0 0\n2 1 3"}) {
    const auto map = parse_voxel_map(text, "m.3dmap");
    ASSERT_TRUE(map.ok()) << map.error();
    EXPECT_EQ(map->blocked.size(), 24u);
    EXPECT_EQ(std::count(map->blocked.begin(), map->blocked.end(), kObstacle), 2);
    EXPECT_TRUE(map->at({0, 0, 0}));
    EXPECT_TRUE(map->at({2, 1, 3}));
    EXPECT_EQ(map->index({2, 1, 3}), 23u);
    EXPECT_EQ(voxel_map_text(*map), "voxel 3 2 4\n0 0 0\n2 1 3\n");
    const test::TemporaryFolder folder;
    ASSERT_TRUE(write_voxel_map(*map, folder.file("a.3dmap")).ok());
    EXPECT_EQ(*read_voxel_map(folder.file("a.3dmap")), *map);
    EXPECT_FALSE(write_voxel_map(*map, folder.file("no/a.3dmap")).ok());
  }
}

TEST(VoxelMap, RefusesBrokenOnes) {
  const std::string header =
      "m.3dmap:1: not a voxel map: the first line must be 'voxel X Y Z', three whole numbers from 1";
  for (const char* text : {"", "\n", "voxel", "voxel 1 1", "voxel 1 1 1 1", "voxel 0 1 1", "voxel 1 -1 1",
                           "voxel 1 1 1.5", "voxel 1 1 99999999999", "box 1 1 1"})
    EXPECT_EQ(map_error(text).substr(9), header.substr(9)) << text;
  EXPECT_EQ(map_error("voxel 1000000000 1000000000 1000000000\n"),
            "m.3dmap:1: the map is too large: at most 134217728 voxels are read");
  EXPECT_NE(map_error("voxel 513 512 512\n").find("too large"), std::string::npos);
  EXPECT_EQ(map_error("voxel 2 2 2\n0 0 0\n0 0 2\n"),
            "m.3dmap:3: voxel '0 0 2' lies outside the box of 2 x 2 x 2");
  for (const char* line : {"0 0", "0 0 0 0", "0 0 x", "-1 0 0", "0 0 1e0"})
    EXPECT_EQ(map_error(std::string("voxel 2 2 2\n") + line),
              "m.3dmap:2: a line must be three whole numbers from 0, x y z, not '" + std::string(line) + "'");
}

TEST(VoxelMap, SlicesAreMaps) {
  const auto map = parse_voxel_map("voxel 3 2 2\n0 0 0\n2 1 1\n1 0 1\n", "m.3dmap");
  ASSERT_TRUE(map.ok());
  const auto slice = voxel_slice(*map, 1);
  ASSERT_TRUE(slice.ok());
  EXPECT_EQ(slice->width, 3);
  EXPECT_EQ(slice->height, 2);
  EXPECT_EQ(slice->blocked, (std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(*voxel_slice(*slice, 0), *slice);
  for (const int z : {-1, 2})
    EXPECT_EQ(voxel_slice(*map, z).error(),
              "there is no slice " + std::to_string(z) + ": z goes from 0 to 1");
}

TEST(VoxelScen, ReadsAndWritesProblems) {
  const std::string text = "version 1\nSimple.3dmap\n56 76 52 48 85 45 15.31710829 1.054\n1 2 3 1 2 3 0 0\n";
  const auto scen = parse_voxel_scen(text, "m.3dscen");
  ASSERT_TRUE(scen.ok()) << scen.error();
  EXPECT_EQ(scen->map_name, "Simple.3dmap");
  ASSERT_EQ(scen->problems.size(), 2u);
  EXPECT_EQ(scen->problems[0].start, (Voxel{56, 76, 52}));
  EXPECT_EQ(scen->problems[0].goal, (Voxel{48, 85, 45}));
  EXPECT_EQ(scen->problems[0].length, 15.31710829);
  EXPECT_EQ(scen->problems[1].line, 4);
  EXPECT_EQ(scen_text(*scen), text);
  EXPECT_TRUE(check_scen_fits(*scen, GridMap(57, 86, 53), "b.3dmap").ok());
  EXPECT_EQ(check_scen_fits(*scen, GridMap(56, 86, 53), "b.3dmap").error(),
            "m.3dscen:3: (56, 76, 52) lies outside the box of 'b.3dmap': give the right map with --map");
}

TEST(VoxelScen, RefusesBrokenOnes) {
  EXPECT_EQ(scen_error("version 2\na\n"), "m.3dscen:1: scenario version '2' is not known: only 1 is");
  EXPECT_EQ(scen_error("a\n"), "m.3dscen:1: not a 3D scenario: the first line must be 'version 1'");
  EXPECT_EQ(scen_error("version 1\n"), "m.3dscen:1: the second line must name the map");
  EXPECT_EQ(scen_error("version 1\na b\n"), "");
  const std::string good = "version 1\na\n";
  EXPECT_EQ(scen_error(good), "");
  EXPECT_EQ(scen_error(good + "1 2 3 4 5\n"), "m.3dscen:3: the goal z must be a whole number from 0, not ''");
  EXPECT_EQ(scen_error(good + "1 2 3 4 5 -6 1 1\n"),
            "m.3dscen:3: the goal z must be a whole number from 0, not '-6'");
  for (const char* length : {"", "nan", "-1", "inf"})
    EXPECT_EQ(scen_error(good + "1 2 3 4 5 6 " + length + "\n"),
              "m.3dscen:3: the optimal length must be a number from 0, not '" + std::string(length) + "'");
  EXPECT_EQ(scen_error(good + "1 2 3 4 5 6 7 x\n"),
            "m.3dscen:3: the ratio of lengths must be a number from 0, not 'x'");
  EXPECT_EQ(scen_error(good + "1 2 3 4 5 6 7 8 9\n"), "m.3dscen:3: the line goes on after its 8 fields: '9'");
}

TEST(VoxelShared, ReadsThePublishedFiles) {
  REPLAN_NEED_SHARED_DATA();
  for (const auto& [name, count] : {std::pair{"Simple", 512}, std::pair{"Complex", 46'298}}) {
    const std::string path = (test::shared_data() / "voxels" / (std::string(name) + ".3dmap")).string();
    const auto map = read_voxel_map(path);
    ASSERT_TRUE(map.ok()) << map.error();
    EXPECT_EQ(std::count(map->blocked.begin(), map->blocked.end(), kObstacle), count);
    EXPECT_EQ(*parse_voxel_map(voxel_map_text(*map), name), *map);
    const auto scen = read_scen(path + ".3dscen");
    ASSERT_TRUE(scen.ok()) << scen.error();
    EXPECT_EQ(scen->problems.size(), 10'000u);
    EXPECT_TRUE(check_scen_fits(*scen, *map, path).ok());
    EXPECT_EQ(parse_voxel_scen(scen_text(*scen), name)->problems.size(), 10'000u);
    for (const ScenProblem& problem : scen->problems) {
      EXPECT_FALSE(map->at(problem.start));
      EXPECT_FALSE(map->at(problem.goal));
    }
  }
}

}  // namespace
}  // namespace replan::world_voxel_test
