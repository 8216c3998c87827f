// Sea floors and terrain: grids of heights and height-map pictures as worlds of layers.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/base/random.hpp"
#include "core/world/formats/esri_grid.hpp"
#include "core/world/formats/image_map.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::height_map_test {
namespace {

constexpr const char* kSea =
    "ncols 3\nnrows 2\nxllcorner 10\nyllcorner -5.5\ncellsize 2\nNODATA_value -9999\n-40 -20 -30\n-9999 5 "
    "0\n";

constexpr const char* kNoneHasAHeight =
    "g.asc: no column has a height, since every number in it stands for no data: mend NODATA_value in its "
    "header (-9999 if that says nothing), or take another file";

std::string grid_error(const std::string& text) {
  const auto grid = parse_esri_grid(text, "g.asc");
  return grid.ok() ? "" : grid.error();
}

/// How many layers of a column are obstacles, from the bottom.
int floor_of(const GridMap& map, int x, int y) {
  int layers = 0;
  while (layers < map.depth && map.at({x, y, layers})) ++layers;
  return layers;
}

TEST(EsriGrid, IsReadWhateverItsCaseAndLines) {
  const HeightGrid sea = *parse_esri_grid(kSea, "g.asc");
  EXPECT_EQ(sea.width, 3);
  EXPECT_EQ(sea.height, 2);
  EXPECT_EQ(sea.heights, (std::vector<float>{-40, -20, -30, HeightGrid::kNoHeight, 5, 0}));
  const HeightGrid odd = *parse_esri_grid(
      "\xEF\xBB\xBFNROWS 2\r\n\r\nNcols\t3\r\nXLLCENTER 1e1\r\nyllcenter 0\r\nDX 1\r\ndy 2\r\nnodata_VALUE "
      "-9999\r\n-40\r\n"
      "-20 -30 -9999\r\n5\t0\r\n\r\n",
      "g.asc");
  EXPECT_EQ(odd.heights, sea.heights);
  ASSERT_EQ(odd.notes.size(), 1u);
  EXPECT_EQ(
      odd.notes[0],
      "where the grid lies (its south-west corner at 9.5, -1) and how large its cells are (1 x 2) is not "
      "kept, since "
      "it does not say in which unit");
}

TEST(EsriGrid, NoDataIsWhatTheHeaderSaysOrMinus9999) {
  const auto heights = [](const std::string& line) {
    return parse_esri_grid("ncols 3\nnrows 1\n" + line + "-9999 nan -7\n", "g.asc")->heights;
  };
  constexpr float kNone = HeightGrid::kNoHeight;
  EXPECT_EQ(heights(""), (std::vector<float>{kNone, kNone, -7}));
  EXPECT_EQ(heights("NODATA_value -7\n"), (std::vector<float>{-9999, kNone, kNone}));
  EXPECT_EQ(heights("NODATA_value nan\n"), (std::vector<float>{-9999, kNone, -7}));
  EXPECT_EQ(grid_error("ncols 1\nnrows 1\nNODATA_value inf\n1\n"),
            "g.asc:3: after 'NODATA_value' there must be one number");
  EXPECT_EQ(grid_error("ncols 1\nnrows 1\ncellsize nan\n1\n"),
            "g.asc:3: after 'cellsize' there must be one number");
}

TEST(EsriGrid, ErrorsNameTheLine) {
  EXPECT_EQ(grid_error(""), "g.asc:1: not a grid of heights: the header has no ncols");
  EXPECT_EQ(grid_error("ncols 2\n1 2\n"), "g.asc:2: not a grid of heights: the header has no nrows");
  EXPECT_EQ(grid_error("ncols 2\nrows 1\n1 2\n"),
            "g.asc:2: not a grid of heights: a line of the header must be ncols, nrows, xllcorner, "
            "yllcorner, cellsize or "
            "NODATA_value and a number, not 'rows 1'");
  EXPECT_EQ(grid_error("ncols 2\nncols 2\n"), "g.asc:2: 'ncols' stands there twice");
  EXPECT_EQ(grid_error("ncols two\n"), "g.asc:1: after 'ncols' there must be one number");
  EXPECT_EQ(grid_error("ncols 1.5\nnrows 1\n1\n"),
            "g.asc:3: ncols must be a whole number from 1 to 67108864");
  EXPECT_EQ(grid_error("ncols 9999\nnrows 9999\n1\n"),
            "g.asc:3: the grid is too large: at most 67108864 heights are read");
  EXPECT_EQ(grid_error("ncols 2\nnrows 2\n1 2\n3\n"), "g.asc:4: the file ends after 3 of 4 heights");
  EXPECT_EQ(grid_error("ncols 2\nnrows 1\n1 2\n3\n"),
            "g.asc:4: there are more than the 2 heights that ncols and nrows announce");
  EXPECT_EQ(grid_error("ncols 2\nnrows 1\n1 x\n"),
            "g.asc:3: a height must be a number from -1000000000 to 1000000000, not 'x'");
  EXPECT_EQ(grid_error("ncols 2\nnrows 1\n1 inf\n").find("g.asc:3: a height must be"), 0u);
}

TEST(HeightMap, TheSeaEndsAtItsLevel) {
  const auto file = world_over(*parse_esri_grid(kSea, "g.asc"), {.layers = 4}, "g.asc");
  ASSERT_TRUE(file.ok()) << file.error();
  const GridMap& map = file->map;
  EXPECT_EQ(map.box(), Box(3, 2, 4));
  EXPECT_EQ(floor_of(map, 0, 0), 0);  // the deepest place
  EXPECT_EQ(floor_of(map, 1, 0), 2);
  EXPECT_EQ(floor_of(map, 2, 0), 1);
  EXPECT_EQ(floor_of(map, 0, 1), 4);  // no height
  EXPECT_EQ(floor_of(map, 1, 1), 4);  // land
  EXPECT_EQ(floor_of(map, 2, 1), 4);  // the shore
  EXPECT_EQ(file->found.notes, (std::vector<std::string>{
                                   "heights go from -40 to 5; the 4 layers reach from -40 up to 0, 10 each",
                                   "1 column rises above 0 and is an obstacle in all layers",
                                   "1 column has no height and is an obstacle in all layers",
                                   "where the grid lies (its south-west corner at 10, -5.5) and how large "
                                   "its cells are (2 x 2) is not kept, "
                                   "since it does not say in which unit"}));
}

TEST(HeightMap, LandEndsAtItsPeak) {
  const auto file = world_over({2, 1, {100, 300}}, {.layers = 8}, "g.asc");
  ASSERT_TRUE(file.ok()) << file.error();
  EXPECT_EQ(floor_of(file->map, 0, 0), 0);
  EXPECT_EQ(floor_of(file->map, 1, 0), 8);
  const auto sky = world_over({2, 1, {100, 300}}, {.layers = 8, .low = 0, .high = 400}, "g.asc");
  EXPECT_EQ(floor_of(sky->map, 0, 0), 2);
  EXPECT_EQ(floor_of(sky->map, 1, 0), 6);
}

TEST(HeightMap, WhatMakesNoWorldIsRefused) {
  const auto error = [](const HeightGrid& grid, const HeightReading& reading) {
    const auto file = world_over(grid, reading, "g.asc");
    return file.ok() ? "" : file.error();
  };
  EXPECT_EQ(error({2, 1, {5, 5}}, {}),
            "g.asc: no layers fit between the heights 5 and 5: give a lowest and a highest height");
  EXPECT_EQ(error({1, 1, {HeightGrid::kNoHeight}}, {}), kNoneHasAHeight);
  EXPECT_EQ(
      error({1, 1, {-3}}, {.low = 1, .high = -2}),
      "g.asc: no layers fit between the heights 1 and -2: give a lowest height that is below the highest");
  EXPECT_EQ(error({1, 1, {-3}}, {.low = 1}),
            "g.asc: no layers fit between the heights 1 and 0: give a lowest height below 0, or a highest "
            "above 1");
  EXPECT_EQ(error({1, 1, {-3}}, {.high = -8.5}),
            "g.asc: no layers fit between the heights -3 and -8.5: give a highest height above -3, or a "
            "lowest below -8.5");
  const HeightGrid large{2000, 1000, std::vector<float>(2'000'000, -1)};
  EXPECT_EQ(error(large, {.layers = 100, .reduce = 1}),
            "g.asc: 2000 x 1000 columns in 100 layers are more than 134217728 voxels: give fewer layers, or "
            "let every 2 "
            "columns each way be one");
  const auto fitted = world_over(large, {.layers = 100}, "g.asc");
  ASSERT_TRUE(fitted.ok());
  EXPECT_EQ(fitted->map.box(), Box(1000, 500, 100));
  EXPECT_EQ(fitted->found.notes.front(),
            "every 2 x 2 columns of the file are one of the world, as high as the highest of them, and "
            "without a height only if none of them has one");
}

TEST(HeightMap, AReducedGridKeepsItsHeightsAndCountsColumnsOfTheWorld) {
  constexpr float kNone = HeightGrid::kNoHeight;
  const auto file = world_over({5, 2, {-40, kNone, kNone, kNone, 3, -10, -20, kNone, kNone, kNone}},
                               {.layers = 4, .reduce = 2}, "g.asc");
  ASSERT_TRUE(file.ok()) << file.error();
  EXPECT_EQ(floor_of(file->map, 0, 0), 3);  // as high as -10
  EXPECT_EQ(floor_of(file->map, 1, 0), 4);  // no height
  EXPECT_EQ(floor_of(file->map, 2, 0), 4);  // land
  EXPECT_EQ(file->found.heights->low, -40);
  EXPECT_EQ(file->found.heights->high, 3);
  EXPECT_EQ(file->found.notes,
            (std::vector<std::string>{
                "every 2 x 2 columns of the file are one of the world, as high as the highest of them, and "
                "without a height only if none of them has one",
                "heights go from -40 to 3; the 4 layers reach from -40 up to 0, 10 each",
                "1 column of the world rises above 0 and is an obstacle in all layers",
                "1 column of the world has no height and is an obstacle in all layers"}));
}

TEST(HeightMap, FineLayersAreToldWithTwoDigits) {
  const auto note = [](float low, float high) {
    return world_over({2, 1, {low, high}}, {.layers = 64}, "g.asc")->found.notes.front();
  };
  EXPECT_EQ(note(0, 0.5), "heights go from 0 to 0.5; the 64 layers reach from 0 up to 0.5, 0.0078 each");
  EXPECT_EQ(note(0, 0.0625),
            "heights go from 0 to 0.063; the 64 layers reach from 0 up to 0.063, 0.00098 each");
  EXPECT_EQ(note(0, 6400), "heights go from 0 to 6400; the 64 layers reach from 0 up to 6400, 100 each");
}

/// A voxel is an obstacle if its bottom lies below the highest of the heights that are its column, or if there is none.
TEST(HeightMap, EveryVoxelIsWhatItsHeightSays) {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    HeightGrid grid{random.between(1, 9), random.between(1, 9), {}};
    for (int i = 0; i < grid.width * grid.height; ++i)
      grid.heights.push_back(random.chance(0.1) ? HeightGrid::kNoHeight
                                                : static_cast<float>(random.between(-400, 100)) / 4);
    const HeightReading reading{
        .layers = 1 << random.between(1, 5), .low = -64, .high = 64, .reduce = random.between(1, 3)};
    const auto file = world_over(grid, reading, "g.asc");
    if (!file) {
      EXPECT_EQ(file.error(), kNoneHasAHeight);
      continue;
    }
    const GridMap& map = file->map;
    for (int z = 0; z < map.depth; ++z)
      for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
          std::optional<float> highest;
          for (int row = 0; row < grid.height; ++row)
            for (int column = 0; column < grid.width; ++column)
              if (row / reading.reduce == y && column / reading.reduce == x &&
                  grid.at(column, row) != HeightGrid::kNoHeight)
                highest = std::max(highest.value_or(-1000), grid.at(column, row));
          const float bottom = -64 + static_cast<float>(z) * 128 / static_cast<float>(map.depth);
          ASSERT_EQ(map.at({x, y, z}), !highest || bottom < *highest)
              << round << ": " << x << ", " << y << ", " << z;
        }
  }
}

TEST(HeightPicture, WhiteIsHighToTheLastOfItsBits) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("h.pgm");
  // Sixteen bits: two shades that are the same in eight.
  ASSERT_TRUE(write_file_atomically(
                  path, std::string("P5\n3 1\n65535\n") + '\0' + '\0' + '\x80' + '\x01' + '\x80' + '\x40')
                  .ok());
  const auto file =
      read_map_file(path, {.image = {}, .heights = HeightReading{.layers = 512, .low = 127, .high = 129}});
  ASSERT_TRUE(file.ok()) << file.error();
  EXPECT_EQ(floor_of(file->map, 0, 0), 0);
  EXPECT_LT(floor_of(file->map, 1, 0), floor_of(file->map, 2, 0));
  const auto usual = read_map_file(path, {.image = {}, .heights = HeightReading{}});
  EXPECT_EQ(floor_of(usual->map, 0, 0), 0);
  EXPECT_EQ(floor_of(usual->map, 2, 0), 64);
  const auto turned = read_map_file(path, {.image = {.invert = true}, .heights = HeightReading{}});
  EXPECT_EQ(floor_of(turned->map, 0, 0), 64);
  EXPECT_EQ(floor_of(turned->map, 2, 0), 0);
  EXPECT_EQ(read_map_file(path)->map.depth,
            1);  // a picture is a map of the plane unless somebody says otherwise
}

TEST(HeightPicture, PngsOfEightAndSixteenBitsAreTheSame) {
  Picture picture{2, 2, 1, {0, 77, 128, 255}};
  for (const char* extension : {".png", ".bmp", ".tga", ".pgm"}) {
    const auto deep = decode_deep_picture(*encode_grey(picture, extension), "p");
    ASSERT_TRUE(deep.ok()) << deep.error();
    const HeightGrid grid = image_heights(*deep);
    EXPECT_EQ(grid.heights, (std::vector<float>{0, 77, 128, 255})) << extension;
  }
}

TEST(HeightReadings, AreChoicesOfTheirFormatsAlone) {
  const auto error = [](const char* path, const MapReading& reading) {
    const auto checked = check_reading(path, reading);
    return checked.ok() ? "" : checked.error();
  };
  const HeightReading heights;
  EXPECT_EQ(error("a.map", {.image = {}, .heights = heights}),
            "heights and layers are for a grid of heights (.asc) or a picture; 'a.map' is none");
  EXPECT_EQ(error("a.png", {.image = {.threshold = 9}, .heights = heights}),
            "a picture that is read as heights has no threshold: 'a.png'");
  EXPECT_EQ(error("a.asc", {.image = {.threshold = 9}}),
            "threshold and inversion are for pictures; 'a.asc' is none");
  EXPECT_EQ(error("a.png", {.image = {}, .heights = heights}), "");
  EXPECT_EQ(error("a.asc", {.image = {}, .heights = heights}), "");
}

TEST(HeightReadings, ScenariosKeepThem) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder.file("sea.asc"), kSea).ok());
  const std::string text =
      R"({"replan": 1, "map": {"file": "sea.asc", "heights": {"layers": 8, "low": -50.5, "high": -2, "reduce": 2}},
          "start": [0, 0, 7], "goal": [1, 0, 7], "planners": [{"id": "astar"}]})";
  const auto scenario = parse_scenario(text, "s.json", folder.path());
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(scenario->map.box(), Box(2, 1, 8));
  EXPECT_EQ(scenario->map_reading.heights,
            (HeightReading{.layers = 8, .low = -50.5, .high = -2, .reduce = 2}));
  const auto again = parse_scenario(scenario_text(*scenario), "s.json", folder.path());
  ASSERT_TRUE(again.ok()) << again.error();
  EXPECT_EQ(*again, *scenario);
  const auto wrong = parse_scenario(
      R"({"replan": 1, "map": {"file": "sea.asc", "heights": {"layers": 1}}, "start": [0, 0], "goal": [1, 0]})",
      "s.json", folder.path());
  EXPECT_NE(wrong.error().find("from 2 to 512"), std::string::npos) << wrong.error();
  const auto upside_down = parse_scenario(
      R"({"replan": 1, "map": {"file": "sea.asc", "heights": {"low": 5, "high": 1}}, "start": [0, 0], "goal": [1, 0]})",
      "s.json", folder.path());
  EXPECT_NE(
      upside_down.error().find("between the heights 5 and 1: give a lowest height that is below the highest"),
      std::string::npos)
      << upside_down.error();
}

/// Mauna Kea's and the deep's places, from the data's README: north is up, and the first column is west.
TEST(HeightMap, HawaiiLiesAsOnAMap) {
  REPLAN_NEED_SHARED_DATA();
  const auto file = read_map_file((test::shared_data() / "bathymetry" / "hawaii.asc").string());
  ASSERT_TRUE(file.ok()) << file.error();
  const GridMap& map = file->map;
  EXPECT_EQ(map.box(), Box(299, 209, 64));
  EXPECT_EQ(file->found.notes.front(),
            "heights go from -6134 to 4000; the 64 layers reach from -6134 up to 0, 95.84 each");
  const auto column = [](double longitude) {
    return static_cast<int>(std::lround((longitude + 162.9633) / 0.03331));
  };
  const auto row = [](double latitude) {
    return static_cast<int>(std::lround((23.9633 - latitude) / 0.0333));
  };
  const std::array<std::pair<double, double>, 4> islands = {
      {{-155.47, 19.82}, {-156.25, 20.71}, {-158.0, 21.5}, {-159.5, 22.05}}};  // Hawaii, Maui, Oahu, Kauai
  for (const auto& [longitude, latitude] : islands)
    EXPECT_EQ(floor_of(map, column(longitude), row(latitude)), 64) << longitude;
  std::size_t up_to_the_top = 0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) up_to_the_top += floor_of(map, x, y) == 64 ? 1 : 0;
  const HeightGrid grid =
      *parse_esri_grid(*read_file((test::shared_data() / "bathymetry" / "hawaii.asc").string()), "h");
  // The bottom of the highest layer lies that far down.
  const auto reaching =
      std::count_if(grid.heights.begin(), grid.heights.end(), [](float h) { return h > -6134.0f / 64; });
  EXPECT_EQ(up_to_the_top, static_cast<std::size_t>(reaching));
  const auto land = std::count_if(grid.heights.begin(), grid.heights.end(), [](float h) { return h >= 0; });
  EXPECT_EQ(land, 62491 - 61176);
}

}  // namespace
}  // namespace replan::height_map_test
