// Worlds of more than one layer on the command line: run, show, convert and render, and what they say of mistakes.
#include <sstream>

#include "tests/cli/child.hpp"

namespace replan::test::voxel_test {
namespace {

using nlohmann::json;

/// A wall with two gaps in its layers, and a surprise that shuts the near one.
constexpr const char* kScenario = R"({
  "replan": 1, "name": "Gaps",
  "map": {"layers": [["......", "...@..", "...@..", "...@.."], ["...@..", "...@..", "...@..", "...@.."],
                     ["...@..", "......", "...@..", "...@.."]]},
  "start": [0, 1, 0], "goal": [5, 1, 0],
  "planners": [{"id": "dstar-lite"}, {"id": "astar"}],
  "robot": {"knowledge": "map", "sensor_radius": 2},
  "surprises": [{"at": {"move": 1}, "add": {"cells": [[3, 0, 0]]}}],
  "movers": [{"way": [[1, 3, 0], [1, 3, 2]], "size": [1, 1, 2]}]
})";

class Voxels : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string scenario_ = folder_.with("gaps.json", kScenario);
  std::string map_ = folder_.with("box.3dmap", "voxel 4 3 2\n1 0 0\n1 1 0\n1 2 0\n");
};

TEST_F(Voxels, runDrivesThroughTheLayers) {
  const Outcome outcome = run_program({"run", scenario_, "--planner", "all"});
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("6 x 4 x 3 voxels, from (0, 1, 0) to (5, 1, 0)"), std::string::npos)
      << outcome.out;
  const json runs = run_program({"run", scenario_, "--json"}).json()["runs"];
  for (const json& run : runs) {
    EXPECT_EQ(run["robot"]["ending"], "arrived") << run;
    EXPECT_GE(run["robot"]["replans"], 1) << run;
    EXPECT_EQ(run["path"].front(), json({0, 1, 0}));
  }
}

TEST_F(Voxels, whoPlansInThePlaneAloneIsRefusedByNameAndIsNotAmongAll) {
  const std::string why = "'jps' plans in the plane alone, and this world has 3 layers";
  expect_complaint({"run", scenario_, "--planner", "jps"}, {"--planner: " + why});
  expect_complaint({"run", scenario_, "--planner", "all,jps"}, {"--planner: " + why});
  const json runs = run_program({"run", scenario_, "--planner", "all", "--json"}).json()["runs"];
  EXPECT_GT(runs.size(), 5u);
  for (const json& run : runs) EXPECT_NE(run["planner"], "jps");
  std::string named = kScenario;
  named.replace(named.find("astar"), 5, "jps");
  expect_complaint({"run", folder_.with("named.json", named)}, {"named.json", why});
}

TEST_F(Voxels, runTakesAMapWithEndsOfThreeCoordinates) {
  const Outcome outcome = run_program(
      {"run", "--map", map_, "--start", "0,0,0", "--goal", "3,0,0", "--planner", "dld-star-lite", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  bool above = false;
  const json path = outcome.json()["runs"][0]["path"];
  for (const json& point : path) above |= point[2] == 1;
  EXPECT_TRUE(above) << "the wall is one layer high";
  expect_complaint(
      {"run", "--map", map_, "--start", "0,0", "--goal", "3,0,0", "--planner", "astar"},
      {"--start cannot be '0,0': give a cell as X,Y,Z in whole numbers, for example --start 3,4,0"});
  expect_complaint({"run", "--map", map_, "--start", "0,0,0", "--goal", "3,0,2", "--planner", "astar"},
                   {"--goal 3,0,2 is outside the map", "give x from 0 to 3, y from 0 to 2, z from 0 to 1"});
  expect_complaint({"run", "--map", map_, "--start", "0,0,0", "--planner", "astar"},
                   {"--goal is missing: give --goal X,Y,Z with x from 0 to 3, y from 0 to 2, z from 0 to 1"});
  for (const char* cell : {"1,2,", "1,2,3,4", ",1,2", "1,,2", "a,b,c", "1;2;3"})
    expect_complaint({"run", scenario_, "--start", cell}, {"give a cell as X,Y,Z"});
}

TEST_F(Voxels, checkHoldsEveryPlannerToItsLawsAndToTheOracle) {
  const Outcome outcome = run_program({"run", scenario_, "--planner", "all", "--check", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  const json checks = outcome.json()["checks"];
  ASSERT_FALSE(checks.empty());
  for (const json& each : checks) {
    EXPECT_TRUE(each["laws"]["hold"]) << each;
    EXPECT_TRUE(each["oracle"]["agrees"]) << each;
    EXPECT_GE(each["oracle"]["plans"], 2) << each;
  }
  const std::string decks = REPLAN_SOURCE_DIR "/maps/decks.json";
  const json broken =
      run_program({"run", decks, "--planner", "broken-dstar-lite", "--check", "--json"}).json()["checks"];
  ASSERT_FALSE(broken[0]["laws"]["first"].is_null()) << broken;
  EXPECT_EQ(broken[0]["laws"]["first"]["cell"].size(), 3u);
}

TEST_F(Voxels, breakReadsCellsOfThreeCoordinates) {
  const Outcome outcome = run_program({"run", scenario_, "--planner", "dstar-lite", "--break",
                                       "changed(rhs(2, 1, 1)) && event(replan) || taken(2, 1, 1)", "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.json()["stops"][0]["stopped"]) << outcome.out;
  const json robot = run_program({"run", scenario_, "--planner", "dstar-lite", "--break",
                                  "robot == (1, 1, 0) || robot == (1, 0, 0)", "--json"})
                         .json()["stops"][0];
  EXPECT_EQ(robot["values"]["robot"].size(), 3u) << robot;
  expect_complaint(
      {"run", scenario_, "--break", "g(1, 2) > 3"},
      {"--break 'g(1, 2) > 3': character 2: 'g' needs a cell with whole-number coordinates: g(x, y, z)"});
}

TEST_F(Voxels, tracesAreJsonLinesAndNotPosthoc) {
  const std::string file = folder_.file("run.jsonl");
  const Outcome outcome = run_program({"run", scenario_, "--planner", "dstar-lite", "--trace", file});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(whole_file(file));
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(json::parse(line)["depth"], 3);
  EXPECT_EQ(json::parse(line)["goal"], json({5, 1, 0}));
  for (const char* name : {"run.trace.yaml", "run.trace.json"})
    expect_complaint({"run", scenario_, "--trace", folder_.file(name)},
                     {"--trace: Posthoc draws planes, and this world has 3 layers", ".jsonl"});
  expect_complaint({"run", scenario_, "--trace", file, "--trace-map", folder_.file("m.map")},
                   {"--trace-map goes with a Posthoc trace, which is of a plane"});
}

TEST_F(Voxels, tablesAreWrittenAsEver) {
  const Outcome csv = run_program({"run", scenario_, "--csv", "-"});
  EXPECT_EQ(csv.code, 0) << csv.err;
  EXPECT_NE(csv.out.find("dstar-lite,found,"), std::string::npos) << csv.out;
  for (const char* format : {"--markdown", "--latex"})
    EXPECT_EQ(run_program({"run", scenario_, format, "-"}).code, 0) << format;
}

TEST_F(Voxels, showListsLayersAndTheCellsAroundOne) {
  const Outcome outcome = run_program({"show", scenario_, "--at", "end", "--cell", "3,1,2"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("layer     2\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("around (3, 1, 2)"), std::string::npos) << outcome.out;
  expect_complaint({"show", scenario_, "--cell", "3,1"}, {"--cell cannot be '3,1'", "X,Y,Z"});
  expect_complaint({"show", scenario_, "--cell", "3,1,3"}, {"--cell 3,1,3 is outside the world"});
}

TEST_F(Voxels, convertGoesBothWaysAndTakesALayer) {
  const std::string world = folder_.file("world.json"), back = folder_.file("back.3dmap"),
                    layer = folder_.file("layer.txt");
  EXPECT_EQ(run_program({"convert", map_, world, "--start", "0,0,0", "--goal", "3,0,0"}).code, 0);
  EXPECT_EQ(run_program({"run", world}).code, 0);
  EXPECT_EQ(run_program({"convert", world, back}).code, 0);
  EXPECT_EQ(whole_file(back), whole_file(map_));
  EXPECT_EQ(run_program({"convert", world, layer, "--slice", "0"}).code, 0);
  EXPECT_EQ(whole_file(layer), ".@..\n.@..\n.@..\n");
  expect_complaint({"convert", world, layer}, {"three dimensions", "--slice Z with Z from 0 to 1"});
  expect_complaint({"convert", world, layer, "--slice", "2"}, {"z goes from 0 to 1"});
  expect_complaint({"convert", world, layer, "--slice", "0", "--layers", "4"},
                   {"a scenario says itself how its map is read"});
}

TEST_F(Voxels, renderShowsOneLayer) {
  std::vector<std::string> pictures;
  for (const std::vector<std::string>& slice :
       {std::vector<std::string>{}, {"--slice", "0"}, {"--slice", "1"}, {"--slice", "2"}}) {
    const std::string file = folder_.file("slice.png");
    std::vector<std::string> arguments = {"render", scenario_, "-o",           file,
                                          "--size", "320x240", "--canvas-only"};
    arguments.insert(arguments.end(), slice.begin(), slice.end());
    const Outcome outcome = run_program(arguments);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    pictures.push_back(whole_file(file));
  }
  EXPECT_TRUE(pictures[0] == pictures[1]) << "without --slice it is the layer of the start";
  EXPECT_FALSE(pictures[1] == pictures[2] || pictures[2] == pictures[3] || pictures[1] == pictures[3]);
  const auto drawing = [&](const char* slice) {
    const std::string file = folder_.file("drawn.svg");
    EXPECT_EQ(run_program({"render", scenario_, "-o", file, "--slice", slice}).code, 0);
    return whole_file(file);
  };
  EXPECT_FALSE(drawing("1") == drawing("2"));
  EXPECT_FALSE(drawing("1") == drawing("y=1"));
  for (const std::string name : {"slice.svg", "frames/"}) {
    const Outcome outcome = run_program(
        {"render", scenario_, "-o", folder_.file(name), "--size", "64x48", "--canvas-only", "--slice", "2"});
    EXPECT_EQ(outcome.code, 0) << name << ": " << outcome.err;
  }
}

/// Across another axis, and from outside.
TEST_F(Voxels, renderShowsTheWorldFromEverySide) {
  std::vector<std::string> pictures;
  for (const std::vector<std::string>& view : {std::vector<std::string>{"--slice", "z=1"},
                                               {"--slice", "x=1"},
                                               {"--slice", "y=1"},
                                               {"--orbit", "30,35"},
                                               {"--orbit", "30,35", "--slice", "x=1", "--cut"},
                                               {"--orbit", "30,35", "--glass"},
                                               {"--orbit", "30,35,6,3,2,1"},
                                               {"--orbit", "-120,80"}}) {
    const std::string file = folder_.file("view.png");
    std::vector<std::string> arguments = {"render", scenario_, "-o",           file,
                                          "--size", "320x240", "--canvas-only"};
    arguments.insert(arguments.end(), view.begin(), view.end());
    const Outcome outcome = run_program(arguments);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const std::string& other : pictures) EXPECT_FALSE(other == whole_file(file)) << view[1];
    pictures.push_back(whole_file(file));
  }
  EXPECT_EQ(run_program({"render", scenario_, "-o", folder_.file("frames/"), "--size", "64x48",
                         "--canvas-only", "--slice", "robot", "--orbit", "10,20"})
                .code,
            0);
  const std::string out = folder_.file("x.png");
  expect_complaint({"render", scenario_, "-o", out, "--orbit", "30"},
                   {"--orbit cannot be '30': give YAW,PITCH"});
  expect_complaint({"render", scenario_, "-o", out, "--orbit", "30,95"}, {"at most 89"});
  expect_complaint({"render", scenario_, "-o", out, "--orbit", "30,35,0,1,1,1"}, {"how many cells away"});
  for (const std::string endless : {"nan,35", "30,nan", "inf,35", "30,35,inf,1,1,1", "30,35,9,1,nan,1"})
    expect_complaint({"render", scenario_, "-o", out, "--orbit", endless},
                     {"--orbit cannot be '" + endless + "': give YAW,PITCH"});
  expect_complaint({"render", scenario_, "-o", out, "--glass"},
                   {"--glass is for a world from outside: add --orbit"});
  expect_complaint({"render", scenario_, "-o", out, "--cut"},
                   {"--cut is for a world from outside: add --orbit"});
  expect_complaint({"render", scenario_, "-o", folder_.file("x.svg"), "--orbit", "30,35"},
                   {"--orbit is not for .svg"});
  expect_complaint({"render", REPLAN_SOURCE_DIR "/maps/demo.json", "-o", out, "--orbit", "30,35"},
                   {"--orbit is for a world of more than one layer", "is a plane: leave it out"});
}

TEST_F(Voxels, renderSaysWhatASliceCanBe) {
  const std::string out = folder_.file("x.png");
  for (const char* slice : {"3", "-1", "one", "99999999999"})
    expect_complaint({"render", scenario_, "-o", out, "--slice", slice},
                     {"--slice cannot be '" + std::string(slice) +
                      "': give a layer from 0 to 2, with x= or y= before it"});
  expect_complaint({"render", REPLAN_SOURCE_DIR "/maps/demo.json", "-o", out, "--slice", "0"},
                   {"--slice is for a world of more than one layer", "is a plane: leave it out"});
  expect_complaint({"render", scenario_, "-o", out, "--pin", "1,2,3"},
                   {"--pin 1,2,3 is outside the world of 6 x 4 x 3 voxels"});
}

}  // namespace
}  // namespace replan::test::voxel_test
