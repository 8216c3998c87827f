// Scenarios in worlds of more than one layer: read, written and read again, and what is said of wrong ones.
#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/world/ends.hpp"
#include "core/world/formats/voxel_map.hpp"
#include "core/world/scenario.hpp"
#include "tests/support/schema_check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::voxel_scenario_test {
namespace {

using nlohmann::json;

/// 4 x 3 x 2 with something of every kind in it.
json document() {
  return json::parse(R"doc({
    "replan": 1,
    "map": {"layers": [["....", ".@..", "...?"], ["....", "....", "@@.."]], "resolution": 0.5},
    "start": [0, 0, 0], "goal": [3, 1, 1],
    "planners": [{"id": "dstar-lite"}],
    "surprises": [
      {"at": {"move": 2}, "add": {"cells": [[2, 0, 1]], "boxes": [[1, 0, 0, 2, 1, 2]]}},
      {"at": {"near": [2, 2, 1], "within": 3}, "remove": {"boxes": [[1, 1, 0, 1, 1, 1]]},
       "goal": [0, 2, 0], "robot": [1, 1, 1]}],
    "movers": [{"way": [[0, 2, 0], [3, 0, 1]], "size": [2, 1, 2]}, {"way": [[1, 1, 1]]}],
    "debug": {"breakpoints": [{"condition": "g(3, 1, 1) > 2 && taken(0, 0, 0)"}], "watches": ["rhs(0, 1, 1)"]}
})doc");
}

Result<Scenario> parse(const json& value, const std::string& folder = ".") {
  return parse_scenario(value.dump(), "s.json", folder);
}
/// The error of the document with the value at a JSON pointer replaced.
std::string error_with(const std::string& pointer, const json& value) {
  json changed = document();
  changed[json::json_pointer(pointer)] = value;
  const auto scenario = parse(changed);
  return scenario.ok() ? "" : scenario.error();
}
json schema() {
  return json::parse(*read_file(REPLAN_SOURCE_DIR "/assets/scenario.schema.json"));
}

TEST(VoxelScenario, ReadsLayersAndPlacesOfThreeCoordinates) {
  const auto scenario = parse(document());
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(scenario->map.box(), Box(4, 3, 2));
  EXPECT_EQ(scenario->map.resolution, 0.5);
  EXPECT_TRUE(scenario->map.at({1, 1, 0}) && scenario->map.at({0, 2, 1}) && scenario->map.at({1, 2, 1}));
  EXPECT_EQ(scenario->map.blocked[scenario->map.index({3, 2, 0})], kUnmapped);
  EXPECT_EQ(scenario->goal, (Cell{3, 1, 1}));
  const std::vector<CellChange> cells = {
      {{1, 0, 0}, true}, {{2, 0, 0}, true}, {{1, 0, 1}, true}, {{2, 0, 1}, true}};
  EXPECT_EQ(scenario->surprises[0].cells, cells);
  EXPECT_EQ(scenario->surprises[1].at.near, (Cell{2, 2, 1}));
  EXPECT_EQ(scenario->surprises[1].goal, (Cell{0, 2, 0}));
  EXPECT_EQ(scenario->surprises[1].robot, (Cell{1, 1, 1}));
  EXPECT_EQ(scenario->movers[0],
            (MovingObstacle{.way = {{0, 2, 0}, {3, 0, 1}}, .width = 2, .height = 1, .depth = 2}));
}

TEST(VoxelScenario, TextIsReadBackEqual) {
  const auto scenario = parse(document());
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  const std::string text = scenario_text(*scenario);
  const auto back = parse_scenario(text, "s.json", ".");
  ASSERT_TRUE(back.ok()) << back.error() << "\n" << text;
  EXPECT_EQ(*back, *scenario) << text;
  EXPECT_EQ(scenario_text(*back), text);
  EXPECT_EQ(test::SchemaCheck(schema()).check(json::parse(text)), "");
  EXPECT_EQ(test::SchemaCheck(schema()).check(document()), "");
}

TEST(VoxelScenario, CellsAreWrittenAsFewBoxes) {
  auto scenario = parse(document());
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  const json surprises = json::parse(scenario_text(*scenario))["surprises"];
  EXPECT_EQ(surprises[0]["add"], json({{"boxes", {{1, 0, 0, 2, 1, 2}}}}));
  EXPECT_EQ(surprises[1]["remove"], json({{"cells", {{1, 1, 0}}}}));
  EXPECT_EQ(json::parse(scenario_text(*scenario))["movers"][0]["size"], json({2, 1, 2}));
  EXPECT_FALSE(json::parse(scenario_text(*scenario))["movers"][1].contains("size"));
}

TEST(VoxelScenario, AMapOfOneLayerIsAPlane) {
  json plane = document();
  plane["map"] = {{"layers", {{"....", ".@..", "...."}}}};
  plane["start"] = {0, 0};
  plane["goal"] = {3, 1};
  plane["surprises"] = {{{"at", {{"move", 2}}}, {"add", {{"rectangles", {{0, 1, 1, 2}}}}}}};
  plane["movers"] = {{{"way", {{0, 2}}}, {"size", {2, 1}}}};
  plane.erase("debug");
  const auto scenario = parse(plane);
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(json::parse(scenario_text(*scenario))["map"], json({{"rows", {"....", ".@..", "...."}}}));
}

TEST(VoxelScenario, NamesAMapFileOfVoxels) {
  const test::TemporaryFolder folder;
  const auto layers = parse(document());
  ASSERT_TRUE(layers.ok()) << layers.error();
  GridMap map = layers->map;
  map.resolution = 1;
  map.blocked = with_unmapped_as(map.blocked, kObstacle);
  ASSERT_TRUE(write_voxel_map(map, folder.file("x.3dmap")).ok());
  json named = document();
  named["map"] = {{"file", "x.3dmap"}};
  const auto scenario = parse(named, folder.path());
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(scenario->map, map);
  EXPECT_EQ(json::parse(scenario_text(*scenario))["map"], named["map"]);
  EXPECT_EQ(*parse_scenario(scenario_text(*scenario), "s.json", folder.path()), *scenario);
}

TEST(VoxelScenario, ErrorsNamePlaceAndMend) {
  EXPECT_EQ(error_with("/start", {1, 2}),
            "s.json:1: start: must be a cell [x, y, z] (the map has more than one layer), not a list of 2");
  EXPECT_EQ(error_with("/goal", {1, 2, 2}),
            "s.json:1: goal: (1, 2, 2) is outside the map: x goes from 0 to 3, y from 0 to 2, z from 0 to 1");
  EXPECT_EQ(error_with("/surprises/0/add", {{"rectangles", {{1, 0, 1, 1}}}}),
            "s.json:1: surprises[0].add.rectangles: the map has more than one layer: give 'boxes', each "
            "[x, y, z, width, height, depth]");
  EXPECT_EQ(
      error_with("/surprises/0/add/boxes/0", {1, 0, 1, 1}),
      "s.json:1: surprises[0].add.boxes[0]: must be a box [x, y, z, width, height, depth], not a list of 4");
  EXPECT_NE(error_with("/surprises/0/add/boxes/0", {1, 0, 1, 1, 1, 2}).find("from 1 to 1, not 2"),
            std::string::npos);
  EXPECT_EQ(error_with("/surprises/0/remove", {{"cells", {{2, 0, 1}}}}),
            "s.json:1: surprises[0]: cell (2, 0, 1) is both added and removed");
  EXPECT_NE(error_with("/movers/0/size", {2, 1}).find("must be a size [width, height, depth]"),
            std::string::npos);
  EXPECT_NE(error_with("/movers/0/way/1", {3, 0}).find("movers[0].way[1]: must be a cell [x, y, z]"),
            std::string::npos);
  // Of a world with other layers they stay; what is a word in none does not.
  EXPECT_NE(error_with("/debug/watches/0", "rsh(0, 1, 1)").find("character 1: unknown name 'rsh'"),
            std::string::npos);
}

TEST(VoxelScenario, LayersAreOfOneSize) {
  EXPECT_EQ(error_with("/map/layers/1", {"....", "...."}),
            "s.json:1: map.layers[1]: has 2 rows, the first layer has 3");
  EXPECT_EQ(error_with("/map/layers/1/2", "@@"),
            "s.json:1: map.layers[1][2]: has 2 cells, the first row has 4");
  EXPECT_NE(error_with("/map/layers/1/2", "@@x.").find("map.layers[1][2]: column 3: unknown cell letter 'x'"),
            std::string::npos);
  EXPECT_NE(error_with("/map/layers", json::array()).find("must be a list of layers"), std::string::npos);
  EXPECT_NE(error_with("/map/layers/0", json::array()).find("must be a list of rows"), std::string::npos);
  EXPECT_NE(
      error_with("/map/rows", {"...."}).find("needs exactly one of 'file', 'rows', 'layers' and 'size'"),
      std::string::npos);
  EXPECT_NE(error_with("/map", {{"layers", {{"...."}}}, {"invert", true}}).find("goes with 'file'"),
            std::string::npos);
}

TEST(VoxelScenario, EndsAreFoundInAllLayersOfTheLargestRegion) {
  Scenario scenario;
  scenario.map = GridMap(3, 3, 4);
  for (NodeId node = 0; node < 9; ++node) scenario.map.set(scenario.map.box().position(2 * 9 + node), true);
  scenario.map.set({0, 0, 0}, true);
  place_ends(scenario);
  EXPECT_EQ(scenario.start, (Cell{1, 0, 0}));
  EXPECT_EQ(scenario.goal, (Cell{2, 2, 1})) << "the third layer parts the world, and the two below are more";
}

TEST(Ends, AreFarApartWhereOnlyOnePlaceHasRoom) {
  Scenario scenario;
  scenario.map = GridMap(40, 9);
  for (int x = 9; x < 40; ++x)
    for (int y = 0; y < 9; ++y) scenario.map.set({x, y}, y != 4);  // a corridor that leads out of a room
  place_ends(scenario);
  EXPECT_EQ(scenario.start, (Cell{0, 0}));
  EXPECT_EQ(scenario.goal, (Cell{39, 4}));
  scenario.map = GridMap(7, 7);
  place_ends(scenario);
  EXPECT_NE(scenario.start, scenario.goal) << "one cell alone has room";
  scenario.map = GridMap(40, 9);
  place_ends(scenario);
  EXPECT_EQ(scenario.start, (Cell{3, 3})) << "free cells around it";
  EXPECT_EQ(scenario.goal, (Cell{36, 5}));
}

TEST(VoxelScenario, APlaneHasNoBoxes) {
  json plane = document();
  plane["map"] = {{"rows", {"....", "....", "...."}}};
  plane["start"] = {0, 0};
  plane["goal"] = {3, 1};
  EXPECT_NE(parse(plane).error().find("surprises[0].add.boxes: the map is a plane: give 'rectangles', each "
                                      "[x, y, width, height]"),
            std::string::npos)
      << parse(plane).error();
  plane["start"] = {0, 0, 0};
  EXPECT_NE(parse(plane).error().find("start: must be a cell [x, y], not a list of 3"), std::string::npos);
}

}  // namespace
}  // namespace replan::voxel_scenario_test
