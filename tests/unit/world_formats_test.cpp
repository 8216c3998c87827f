// Map formats but MovingAI's: what they read, write back, lose and refuse.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/world/formats/ascii_map.hpp"
#include "core/world/formats/pnm.hpp"
#include "core/world/formats/ros_map.hpp"
#include "core/world/formats/sbpl_cfg.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::world_formats_test {
namespace {

using Cells = std::vector<std::uint8_t>;

/// A world with all that a map can have: every kind of cell, an origin, a start and a goal.
MapFile full_world() {
  MapFile world{GridMap(5, 3), Cell{0, 0}, Cell{4, 2}};
  world.map.blocked = {0, 1, 0, 2, 0,  //
                       0, 1, 0, 0, 0,  //
                       0, 0, 0, 1, 0};
  world.map.resolution = 0.05;
  world.map.origin = {-10.5, 3, 0.25};
  return world;
}

/// The same with what `format` cannot hold taken out.
MapFile as_held(MapFile world, const MapFormat& format) {
  if (!format.unmapped) world.map.blocked = with_unmapped_as(world.map.blocked, kObstacle);
  if (!format.resolution) world.map.resolution = 1;
  if (!format.resolution) world.map.origin = {};
  if (!format.ends) world.start = world.goal = std::nullopt;
  return world;
}

std::string error_of(const auto& result) {
  return result.ok() ? "" : result.error();
}

TEST(MapFormats, EachReadsBackWhatItHolds) {
  const test::TemporaryFolder folder;
  for (const MapFormat& format : map_formats()) {
    const std::string path = folder.file("world" + std::string(format.extension));
    const auto written = write_map_file(full_world(), path);
    EXPECT_EQ(written.ok(), format.write != nullptr) << format.extension << " " << error_of(written);
    if (!written) continue;
    const MapReading reading{.image = {},
                             .unknown = format.unknown ? UnknownCells::unmapped : UnknownCells::blocked};
    const auto back = read_map_file(path, reading);
    ASSERT_TRUE(back.ok()) << back.error();
    EXPECT_EQ(*back, as_held(full_world(), format)) << format.extension;
    EXPECT_TRUE(back->found.notes.empty());
  }
  EXPECT_EQ(
      error_of(write_map({2, 2}, "a.jpg")),
      "cannot write a map to 'a.jpg': its name must end in .map, .yaml, .yml, .cfg, .txt, .3dmap, .png, "
      ".bmp, .tga or .pgm");
}

TEST(MapFormats, SayWhatTheyLose) {
  const auto lost = lost_in(".map", full_world());
  EXPECT_EQ(lost, (std::vector<std::string>{
                      ".map cannot hold the resolution (0.05 a cell)",
                      ".map cannot hold the origin (-10.5, 3, 0.25)",
                      ".map cannot hold that 1 obstacle is unmapped: there they are plain obstacles",
                      ".map cannot hold the start (0, 0)", ".map cannot hold the goal (4, 2)"}));
  EXPECT_EQ(lost_in(".png", full_world()).size(), 5u);
  EXPECT_EQ(lost_in(".cfg", full_world()).size(), 3u);
  EXPECT_EQ(lost_in(".txt", full_world()).size(), 2u);
  EXPECT_EQ(lost_in(".yaml", full_world()).size(), 3u);  // the ends, and how to have the unmapped cells back
  for (const MapFormat& format : map_formats())
    EXPECT_TRUE(lost_in(format.extension, MapFile{GridMap(3, 3), std::nullopt, std::nullopt}).empty());
  MapFile hidden = full_world();
  hidden.start = Cell{1, 0};
  EXPECT_NE(lost_in(".txt", hidden).back().find("the start (1, 0), which lies in an obstacle"),
            std::string::npos);
  hidden.start = hidden.goal;
  EXPECT_EQ(lost_in(".txt", hidden).back(), ".txt cannot hold the goal, which is the start");
}

TEST(MapFormats, SayWhatTheyLoseOfAScenario) {
  Scenario scenario;
  scenario.map = GridMap(3, 3);
  scenario.planners = {{"astar", {}}};
  scenario.surprises.assign(2, {});
  EXPECT_TRUE(lost_in(".json", scenario).empty());
  EXPECT_EQ(lost_in(".txt", scenario),
            (std::vector<std::string>{".txt cannot hold the goal, which is the start",
                                      ".txt cannot hold 2 surprises, the planner and the robot"}));
  scenario.name = "n";
  EXPECT_EQ(lost_in(".map", scenario).back(), ".map cannot hold name, caption and view");
}

TEST(MapFormats, RefuseOptionsWithoutAMeaning) {
  const test::TemporaryFolder folder;
  const std::string map = folder.with("a.map", "type octile\nheight 1\nwidth 1\nmap\n.\n");
  EXPECT_TRUE(read_map(map).ok());
  EXPECT_EQ(error_of(read_map(map, {.image = {.threshold = 3}, .unknown = {}})),
            "threshold and inversion are for pictures; '" + map + "' is none");
  EXPECT_EQ(error_of(read_map(map, {.image = {}, .unknown = UnknownCells::free})),
            "only a ROS map (.yaml) has unknown cells; '" + map + "' is none");
}

TEST(Pnm, ReadsPlainAndRawWithComments) {
  const Cells expected = {0, 255, 128, 85};
  const std::string raw16 = std::string("P5 4 1 65535\n") + std::string("\0\0\xFF\xFF\x80\x00\x55\x55", 8);
  for (const std::string& text :
       {std::string("P2\n# by hand\n4 1\n255\n0 255 128 85\n"), std::string("P2 4 1 3 0 3 # two\n 2 1"),
        std::string("P5\n4#w\n1\n255\n\x00\xFF\x80\x55", 17),
        std::string("P5\r\n4 1\r255\n\x00\xFF\x80\x55", 16), raw16}) {
    const auto picture = decode_pnm(text, "p.pgm");
    ASSERT_TRUE(picture.ok()) << picture.error() << "\n" << text;
    EXPECT_EQ(picture->channels, 1);
    if (text.find(" 3 ") == std::string::npos)
      EXPECT_EQ(picture->values, expected) << text;
    else
      EXPECT_EQ(picture->values, (Cells{0, 255, 170, 85}));
  }
  const auto colours = decode_pnm("P3 1 1 255 1 2 3", "p.ppm");
  ASSERT_TRUE(colours.ok());
  EXPECT_EQ(colours->values, (Cells{1, 2, 3}));
  EXPECT_EQ(decode_pnm("P6 1 1 255\nabc", "p.ppm")->values, (Cells{'a', 'b', 'c'}));
}

TEST(Pnm, ReadsBits) {
  const Cells expected = {0, 255, 255, 0, 255, 0, 255, 0, 0, 255};  // 1 is black
  for (const std::string& text : {std::string("P1\n# c\n5 2\n1 0 0 1 0\n1 0 1 1 0\n"),
                                  std::string("P1 5 2 1001010110"), std::string("P4\n5 2\n\x90\xB7", 9)}) {
    const auto picture = decode_pnm(text, "p.pbm");
    ASSERT_TRUE(picture.ok()) << picture.error() << "\n" << text;
    EXPECT_EQ(picture->width, 5);
    EXPECT_EQ(picture->values, expected) << text;
  }
  EXPECT_EQ(error_of(decode_pnm("P1 2 1\n12", "p.pbm")),
            "p.pbm:2: a value must be a whole number from 0 to 1, not '2'");
  EXPECT_EQ(error_of(decode_pnm("P1 2 1\n1", "p.pbm")), "p.pbm:2: the file ends after 1 of 2 values");
  EXPECT_EQ(error_of(decode_pnm("P4 9 2\nabc", "p.pbm")), "p.pbm: the file ends after 1 of 2 rows");
}

TEST(Pnm, RefusesBrokenOnes) {
  const auto error = [](const std::string& text) { return error_of(decode_pnm(text, "p.pgm")); };
  EXPECT_EQ(error("P7 1 1 "), "p.pgm:1: not a PBM, PGM or PPM picture: it must begin with P1, P2, ... or P6");
  EXPECT_EQ(error("P5\n# c\nx 1 255\n"),
            "p.pgm:3: the picture's width must be a whole number from 1, not 'x'");
  EXPECT_EQ(error("P5\n4"), "p.pgm:2: the picture's height must be a whole number from 1, not ''");
  EXPECT_EQ(error("P5\n0 1 255\n"), "p.pgm:2: the picture's width must be a whole number from 1, not '0'");
  EXPECT_EQ(error("P5\n1 1 65536\n"),
            "p.pgm:2: the picture's largest value must be a whole number from 1 to 65535, not '65536'");
  EXPECT_NE(error("P5\n9000 9000 255\n").find("too large: 9000 x 9000 pixels"), std::string::npos);
  EXPECT_NE(error("P5\n1000000000 1000000000 255\n").find("too large: 1000000000 x 1000000000 pixels"),
            std::string::npos);
  EXPECT_EQ(error("P5\n8192 8192 255\nabc"), "p.pgm: the file ends after 3 of 67108864 values");
  EXPECT_EQ(error("P2\n8192 8192 255\n1 2"), "p.pgm:3: the file ends after 2 of 67108864 values");
  EXPECT_EQ(error("P2\n1 1 9\n10"), "p.pgm:3: a value must be a whole number from 0 to 9, not '10'");
  EXPECT_EQ(error("P5\n1 1 9\n\x0A"), "p.pgm: value 1 is 10, more than the largest value 9 of the header");
  EXPECT_EQ(error("P5\n1 1 255"), "p.pgm: the file ends after 0 of 1 values");
}

const std::string kYaml =
    "image: a.pgm\nresolution: 0.050000\norigin: [-10.000000, 2, 0.5]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string yaml_error(const std::string& text) {
  return error_of(parse_ros_yaml(text, "a.yaml"));
}
/// kYaml with one piece replaced.
std::string with(std::string from, const std::string& to) {
  std::string text = kYaml;
  return text.replace(text.find(from), from.size(), to);
}

TEST(RosMap, ReadsTheYaml) {
  const auto info = parse_ros_yaml(kYaml, "a.yaml");
  ASSERT_TRUE(info.ok()) << info.error();
  EXPECT_EQ(info->image, "a.pgm");
  EXPECT_EQ(info->resolution, 0.05);
  EXPECT_EQ(info->origin, (std::array<double, 3>{-10, 2, 0.5}));
  EXPECT_FALSE(info->negate);
  EXPECT_EQ(info->mode, RosMapInfo::Mode::trinary);
  EXPECT_TRUE(info->notes.empty());
  const auto more = parse_ros_yaml("# c\n" + kYaml + "mode: scale\nframe: map\n", "a.yaml");
  ASSERT_TRUE(more.ok()) << more.error();
  EXPECT_EQ(more->mode, RosMapInfo::Mode::scale);
  EXPECT_EQ(more->notes, std::vector<std::string>{
                             "a.yaml:9: the key 'frame' is not one of map_server's and was passed over"});
  EXPECT_TRUE(parse_ros_yaml(with("negate: 0", "negate: true"), "a.yaml")->negate);
  RosMapInfo odd = *info;
  odd.image = "a \"b\": #c\xC3\xA4.pgm";
  odd.resolution = 1.0 / 3;
  EXPECT_EQ(*parse_ros_yaml(ros_yaml_text(odd), "a.yaml"), odd);
}

TEST(RosMap, RefusesBrokenYaml) {
  EXPECT_EQ(yaml_error(""), "a.yaml:1: not a map_server map: lines such as 'image: map.pgm' belong here");
  EXPECT_EQ(yaml_error("just words"), yaml_error(""));
  EXPECT_EQ(yaml_error("a: [1,\nb: }").rfind("a.yaml:2: not YAML: ", 0), 0u) << yaml_error("a: [1,\nb: }");
  EXPECT_EQ(yaml_error(with("image: a.pgm\n", "")), "a.yaml: the key 'image' is missing");
  EXPECT_EQ(yaml_error(with("occupied_thresh", "occupied_tresh")),
            "a.yaml: the key 'occupied_thresh' is missing; is 'occupied_tresh' a slip of it?");
  EXPECT_EQ(yaml_error(with("0.050000", "0")),
            "a.yaml:2: 'resolution' must be a number from 1e-06 to 1000000, not '0'");
  EXPECT_EQ(yaml_error(with("0.050000", "[1]")),
            "a.yaml:2: 'resolution' must be a number from 1e-06 to 1000000, not a list or a group");
  EXPECT_EQ(yaml_error(with("0.65", ".nan")),
            "a.yaml:5: 'occupied_thresh' must be a number from 0 to 1, not '.nan'");
  EXPECT_EQ(yaml_error(with("[-10.000000, 2, 0.5]", "[1, 2]")),
            "a.yaml:3: 'origin' must be a pose [x, y, yaw] of three numbers");
  EXPECT_EQ(yaml_error(with("0.196", "0.7")),
            "a.yaml:6: 'free_thresh' must not be more than 'occupied_thresh'");
  EXPECT_EQ(yaml_error(with("negate: 0", "negate: 2")),
            "a.yaml:4: 'negate' must be 0 or 1, yes or no, not '2'");
  EXPECT_EQ(yaml_error(kYaml + "negate: 1\n"), "a.yaml:7: 'negate' is there twice");
  EXPECT_NE(yaml_error(kYaml + "mode: raw\n").find("a.yaml:7: 'mode' is raw: "), std::string::npos);
  EXPECT_EQ(yaml_error(kYaml + "mode: x\n"), "a.yaml:7: 'mode' must be trinary or scale, not 'x'");
  EXPECT_NE(yaml_error(std::string(5000, '[')), "");
}

TEST(RosMap, CellsFollowTheThresholds) {
  RosMapInfo info;
  info.free_thresh = 0.196;
  // p = 1, 0.658.., 0.6509.., 0.6471.., 0.19608, 0.19216, 0
  const Picture shades{7, 1, 1, {0, 87, 89, 90, 205, 206, 255}};
  EXPECT_EQ(ros_cells(shades, info, UnknownCells::unmapped).blocked, (Cells{1, 1, 1, 2, 2, 0, 0}));
  EXPECT_EQ(ros_cells(shades, info, UnknownCells::blocked).blocked, (Cells{1, 1, 1, 1, 1, 0, 0}));
  EXPECT_EQ(ros_cells(shades, info, UnknownCells::free).blocked, (Cells{1, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(count_ros_cells(shades, info), (RosCounts{2, 3, 2}));
  info.negate = true;
  EXPECT_EQ(ros_cells(shades, info, UnknownCells::unmapped).blocked, (Cells{0, 2, 2, 2, 1, 1, 1}));
}

TEST(RosMap, TransparencyIsUnknownInScaleModeAndAColourInTrinary) {
  RosMapInfo info;
  const Picture picture{3, 1, 2, {255, 255, 255, 0, 0, 254}};  // white, white seen through, black not quite
  EXPECT_EQ(ros_cells(picture, info, UnknownCells::unmapped).blocked, (Cells{0, 2, 2}));
  info.mode = RosMapInfo::Mode::scale;
  EXPECT_EQ(ros_cells(picture, info, UnknownCells::unmapped).blocked, (Cells{0, 2, 2}));
  const Picture solid{1, 1, 2, {0, 255}};
  EXPECT_EQ(ros_cells(solid, info, UnknownCells::unmapped).blocked, (Cells{1}));
  info.mode = RosMapInfo::Mode::trinary;
  EXPECT_EQ(ros_cells(solid, info, UnknownCells::unmapped).blocked, (Cells{2}));
}

TEST(RosMap, FindsItsPictureBesideIt) {
  const test::TemporaryFolder folder;
  const std::string yaml = folder.with("a.yaml", kYaml);
  EXPECT_EQ(error_of(read_map(yaml)),
            yaml + ": its image: cannot read '" + folder.file("a.pgm") + "': No such file or directory");
  folder.with("a.pgm", "P5\n2 1\n255\n\xFE");
  EXPECT_EQ(error_of(read_map(yaml)),
            yaml + ": its image: " + folder.file("a.pgm") + ": the file ends after 1 of 2 values");
  folder.with("a.pgm", std::string("P5\n2 1\n255\n\xFE\x00", 13));
  const auto map = read_map(yaml);
  ASSERT_TRUE(map.ok()) << map.error();
  EXPECT_EQ(map->blocked, (Cells{0, 1}));
  EXPECT_EQ(map->resolution, 0.05);
  EXPECT_EQ(map->origin, (std::array<double, 3>{-10, 2, 0.5}));
  EXPECT_FALSE(write_map(*map, folder.file("no/a.yaml")).ok());
  EXPECT_EQ(folder.entries(), 2);
}

TEST(RosShared, CountsAreThePublishedOnes) {
  REPLAN_NEED_SHARED_DATA();
  const std::map<std::string, RosCounts> published = {{"turtlebot3_world", {7939, 795, 138722}},
                                                      {"depot", {179481, 5947, 0}},
                                                      {"willow-2010-02-18-0.10", {109207, 544, 234377}},
                                                      {"lse_arena", {4455, 345, 0}}};
  for (const auto& [name, counts] : published) {
    const std::string path = (test::shared_data() / "ros" / (name + ".yaml")).string();
    const auto info = parse_ros_yaml(*read_file(path), path);
    ASSERT_TRUE(info.ok()) << info.error();
    const auto picture = read_picture((test::shared_data() / "ros" / info->image).string());
    ASSERT_TRUE(picture.ok()) << picture.error();
    EXPECT_EQ(count_ros_cells(*picture, *info), counts) << name;
    const auto map = read_map(path, {.image = {}, .unknown = UnknownCells::unmapped});
    ASSERT_TRUE(map.ok()) << map.error();
    EXPECT_EQ(std::count(map->blocked.begin(), map->blocked.end(), kUnmapped), counts.unknown);
    const test::TemporaryFolder folder;
    ASSERT_TRUE(write_map(*map, folder.file("a.yaml")).ok());
    EXPECT_EQ(*read_map(folder.file("a.yaml"), {.image = {}, .unknown = UnknownCells::unmapped}), *map);
  }
}

const std::string kCfg =
    "discretization(cells): 3 2\nobsthresh: 2\nstart(cells): 0 0\nend(cells): 2 1\nenvironment:\n"
    "0 1 2  \n255 0 0\n";

std::string cfg_error(std::string from, const std::string& to) {
  std::string text = kCfg;
  return error_of(parse_sbpl_cfg(text.replace(text.find(from), from.size(), to), "e.cfg"));
}

TEST(SbplCfg, ReadsCostsStartAndEnd) {
  for (const std::string& text :
       {kCfg, std::string("discretization(cells):\t3 2 obsthresh: 2\r\nstart(cells): 0 0 end(cells): 2\n1 "
                          "environment: 0 1 2 255\n0\n\n0")}) {
    const auto world = parse_sbpl_cfg(text, "e.cfg");
    ASSERT_TRUE(world.ok()) << world.error();
    EXPECT_EQ(world->map.width, 3);
    EXPECT_EQ(world->map.height, 2);
    EXPECT_EQ(world->map.blocked, (Cells{0, 0, 1, 1, 0, 0}));
    EXPECT_EQ(world->start, (Cell{0, 0}));
    EXPECT_EQ(world->goal, (Cell{2, 1}));
    EXPECT_EQ(
        world->found.notes,
        std::vector<std::string>{"e.cfg: the costs of 1 free cells are lost: here all cells cost the same"});
    EXPECT_EQ(*parse_sbpl_cfg(sbpl_cfg_text(*world), "e.cfg"), *world);
  }
  const test::TemporaryFolder folder;
  EXPECT_EQ(error_of(write_map(GridMap(2, 2), folder.file("a.cfg"))),
            "cannot write '" + folder.file("a.cfg") + "': a .cfg needs start and goal; give both");
}

/// As SBPL's env_examples/nav3d have it: (x, y, theta) in metres and radians.
const std::string kPoses =
    "discretization(cells): 4 2\nobsthresh: 1\ncost_inscribed_thresh: 1\n"
    "cost_possibly_circumscribed_thresh: 0\ncellsize(meters): 0.025\nnominalvel(mpersecs): 1.0\n"
    "timetoturn45degsinplace(secs): 2.0\nstart(meters,rads): 0.01 0.03 0\nend(meters,rads): 0.08 0.01 1.57\n"
    "environment:\n0 1 0 0\n0 0 0 1\n";

TEST(SbplCfg, ReadsTheGridOfPoses) {
  std::string more = kPoses;
  more.insert(more.find("obsthresh"), "NumThetaDirs: 16\n");
  for (const std::string& text : {kPoses, more}) {
    const auto world = parse_sbpl_cfg(text, "e.cfg");
    ASSERT_TRUE(world.ok()) << world.error();
    EXPECT_EQ(ascii_text(*world), ".@.G\nS..@\n");
    EXPECT_EQ(world->map.resolution, 0.025);
    EXPECT_EQ(world->found.notes.size(), 1u);
  }
  const auto error = [](std::string from, const std::string& to) {
    std::string text = kPoses;
    return error_of(parse_sbpl_cfg(text.replace(text.find(from), from.size(), to), "e.cfg"));
  };
  EXPECT_EQ(error("0.08 0.01", "0.11 0.01"),
            "e.cfg:9: 'end(meters,rads):' lies outside the map of 4 x 2 cells of 0.025 m");
  EXPECT_EQ(error("0.01 0.03", "-0.01 0.03"),
            "e.cfg:8: 'start(meters,rads):' lies outside the map of 4 x 2 cells of 0.025 m");
  EXPECT_EQ(error("0.025", "0"),
            "e.cfg:5: a number of 'cellsize(meters):' must be from 1e-06 to 1000000, not '0'");
  EXPECT_EQ(
      error("cellsize(meters): 0.025\n", ""),
      "e.cfg:5: 'cellsize(meters):' belongs here, not 'nominalvel(mpersecs):'; SBPL's environments of cells "
      "(nav2d) and of (x, y, theta) are read");
  EXPECT_EQ(
      error(" 1.57", ""),
      "e.cfg:9: a number of 'end(meters,rads):' must be from -1000000000 to 1000000000, not 'environment:'");
}

TEST(SbplCfg, RefusesBrokenOnes) {
  EXPECT_EQ(error_of(parse_sbpl_cfg("", "e.cfg")),
            "e.cfg:0: 'discretization(cells):' belongs here, not ''; SBPL's environments of cells (nav2d) "
            "and of (x, y, theta) are read");
  EXPECT_EQ(
      cfg_error("start(cells):", "cellsize(meters):"),
      "e.cfg:3: 'start(cells):' belongs here, not 'cellsize(meters):'; SBPL's environments of cells (nav2d) "
      "and of (x, y, theta) are read");
  EXPECT_EQ(
      cfg_error("3 2", "1000000000 1000000000"),
      "e.cfg:1: a number of 'discretization(cells):' must be whole, from 1 to 67108864, not '1000000000'");
  EXPECT_NE(cfg_error("3 2", "9000 9000").find("e.cfg:1: the map is too large"), std::string::npos);
  EXPECT_EQ(cfg_error("3 2", "8192 8192"), "e.cfg:7: the file ends after 6 of 67108864 costs");
  EXPECT_EQ(cfg_error(": 2 1", ": 3 1"),
            "e.cfg:4: a number of 'end(cells):' must be whole, from 0 to 2, not '3'");
  EXPECT_EQ(cfg_error("255 0 0", "255 0"), "e.cfg:7: the file ends after 5 of 6 costs");
  EXPECT_EQ(cfg_error("255 0 0", "255 0 0 0"), "e.cfg:7: the file goes on after its 6 costs: '0'");
  EXPECT_EQ(cfg_error("255", "256"), "e.cfg:7: a cost must be a whole number from 0 to 255, not '256'");
  EXPECT_EQ(cfg_error("255", "-1"), "e.cfg:7: a cost must be a whole number from 0 to 255, not '-1'");
}

TEST(SbplShared, ReadsTheDemoWorlds) {
  REPLAN_NEED_SHARED_DATA();
  for (const auto& [name, goal] :
       {std::pair{"nav2d_env1", Cell{14, 14}}, std::pair{"nav2d_env2", Cell{99, 999}}}) {
    const auto world = read_map_file((test::shared_data() / "sbpl" / (std::string(name) + ".cfg")).string());
    ASSERT_TRUE(world.ok()) << world.error();
    EXPECT_EQ(world->start, (Cell{0, 0}));
    EXPECT_EQ(world->goal, goal);
    EXPECT_TRUE(world->found.notes.empty());
    EXPECT_FALSE(world->map.at(goal));
    EXPECT_EQ(*parse_sbpl_cfg(sbpl_cfg_text(*world), name), *world);
  }
}

TEST(AsciiMap, ReadsEveryLetter) {
  const auto world = parse_ascii_map("\n\r\n.0-_ \n@#Xx1\r\nS?G..\n\n", "a.txt");
  ASSERT_TRUE(world.ok()) << world.error();
  EXPECT_EQ(world->map.width, 5);
  EXPECT_EQ(world->map.height, 3);
  EXPECT_EQ(world->map.blocked, (Cells{0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 0, 2, 0, 0, 0}));
  EXPECT_EQ(world->start, (Cell{0, 2}));
  EXPECT_EQ(world->goal, (Cell{2, 2}));
  EXPECT_EQ(ascii_text(*world), ".....\n@@@@@\nS?G..\n");
  EXPECT_EQ(ascii_text(*world, {{-3, 1}, {0, 100}}), "@\nS\n");
  EXPECT_EQ(ascii_text(*world, {{1, 2}, {2'000'000'000, 2}}), "?G..\n");
  EXPECT_EQ(ascii_text(*world, {{5, 0}, {5, 0}}), "");
}

TEST(AsciiMap, HasLayersPartedByEmptyLines) {
  const std::string text = "S.@\n...\n\n@@@\n..@\n\n.@.\n..G\n";
  const auto world = parse_ascii_map(text, "a.txt");
  ASSERT_TRUE(world.ok()) << world.error();
  EXPECT_EQ(world->map.box(), Box(3, 2, 3));
  EXPECT_EQ(world->start, (Cell{0, 0, 0}));
  EXPECT_EQ(world->goal, (Cell{2, 1, 2}));
  EXPECT_TRUE(world->map.at({2, 1, 1}));
  EXPECT_FALSE(world->map.at({2, 1, 2}));
  EXPECT_EQ(ascii_text(*world), text);
  EXPECT_EQ(ascii_text(*world, {{1, 0, 1}, {2, 1, 9}}), "@@\n.@\n\n@.\n.G\n");
}

TEST(AsciiMap, RefusesWhatItCannotMean) {
  const auto error = [](const std::string& text) { return error_of(parse_ascii_map(text, "a.txt")); };
  EXPECT_EQ(error(""), "a.txt: there is no row of cells in it");
  EXPECT_EQ(error("\n\n"), error(""));
  EXPECT_EQ(
      error("...\n..\n"),
      "a.txt:2: the row has 2 cells, the rows before it have 3: make them equally long (blanks at the end "
      "count as free cells)");
  EXPECT_EQ(error("..\n..\n\n..\n"),
            "a.txt:5: empty lines part layers, and the one before this has 1 row, the first 2: make them "
            "equally high, or leave out the empty lines");
  EXPECT_EQ(error("..\n\n..\n..\n\n..\n").rfind("a.txt:6: empty lines part layers", 0), 0u);
  EXPECT_EQ(error("..\n.S\nS.\n"), "a.txt:3: column 1: a second S: there can be only one start");
  EXPECT_EQ(error("GG"), "a.txt:1: column 2: a second G: there can be only one goal");
  EXPECT_EQ(error(".\n%").rfind("a.txt:2: column 1: unknown cell letter '%'; known are ", 0), 0u);
}

TEST(SharedData, EveryMapIsReadAndWrittenByEveryFormat) {
  REPLAN_NEED_SHARED_DATA();
  std::map<std::string, int> counts;
  const test::TemporaryFolder folder;
  for (const MapFormat& format : map_formats())
    for (const auto& file : test::files_below(test::shared_data(), std::string(format.extension))) {
      if (file.stem() == "LICENSE") continue;
      const auto world = read_map_file(file.string());
      ASSERT_TRUE(world.ok()) << world.error();
      ++counts[std::string(format.extension)];
      if (world->map.blocked.size() > 300'000) continue;  // the larger ones tell nothing more
      MapFile plain{world->map, Cell{0, 0}, Cell{world->map.width - 1, world->map.height - 1}};
      for (const char* extension : {".map", ".png", ".tga", ".cfg", ".yaml"}) {
        const std::string copy = folder.file("copy" + std::string(extension));
        ASSERT_TRUE(write_map_file(plain, copy).ok());
        EXPECT_EQ(read_map(copy)->blocked, world->map.blocked) << file << extension;
      }
    }
  EXPECT_EQ(counts, (std::map<std::string, int>{
                        {".map", 233}, {".yaml", 4}, {".pgm", 4}, {".cfg", 2}, {".3dmap", 2}, {".asc", 1}}));
}

}  // namespace
}  // namespace replan::world_formats_test
