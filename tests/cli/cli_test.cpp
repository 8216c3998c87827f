// The contracts of 'replan run', 'list' and 'convert': output, exit codes, JSON.
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "core/scene/view.hpp"
#include "core/world/choices.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"
#include "tests/cli/child.hpp"

namespace replan::test::cli_test {
namespace {

using Arguments = std::vector<std::string>;
using nlohmann::json;

// A wall with a gap; the room at the lower right is closed.
constexpr const char* kMap =
    "type octile\nheight 6\nwidth 8\nmap\n"
    "........\n"
    "...@....\n"
    "...@....\n"
    "...@.@@@\n"
    "...@.@.@\n"
    ".....@@@\n";

constexpr const char* kScenario = R"({
  "replan": 1, "name": "Gap",
  "map": {"rows": ["........", "...@....", "...@....", "...@....", "........"]},
  "start": [0, 2], "goal": [7, 2],
  "planners": [{"id": "dstar-lite"}, {"id": "astar", "settings": {"heuristic": "zero"}}],
  "robot": {"knowledge": "map", "sensor_radius": 2},
  "surprises": [{"at": {"move": 1}, "add": {"cells": [[3, 0]]}}]
})";

const std::set<std::string> kFigures = {
    "nodes",         "length",           "turns",        "turning_angle_deg", "greatest_curvature",
    "min_clearance", "mean_clearance",   "plan_ms",      "replan_ms",         "replans",
    "expansions",    "queue_operations", "sight_checks", "memory_bytes"};

void expect_all_numbers(const json& object) {
  for (const auto& [key, value] : object.items()) EXPECT_TRUE(value.is_number()) << key << ": " << value;
}

class CommandLine : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string map_ = folder_.with("room.map", kMap);
  std::string scenario_ = folder_.with("gap.json", kScenario);

  [[nodiscard]] Arguments plan(const std::string& start, const std::string& goal,
                               const Arguments& more) const {
    Arguments arguments = {"run", "--map", map_, "--start", start, "--goal", goal};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

TEST_F(CommandLine, runPrintsEachPlanAsJson) {
  const Outcome outcome = run_program(plan("0,2", "7,2", {"--planner", "astar,dld-star-lite", "--json"}));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  const json document = outcome.json();
  EXPECT_EQ(keys(document), std::set<std::string>{"runs"});
  ASSERT_EQ(document["runs"].size(), 2u);
  EXPECT_EQ(document["runs"][0]["planner"], "astar");
  EXPECT_EQ(document["runs"][1]["planner"], "dld-star-lite");
  for (const json& run : document["runs"]) {
    EXPECT_EQ(keys(run), (std::set<std::string>{"planner", "status", "path", "figures"}));
    EXPECT_EQ(run["status"], "found");
    EXPECT_EQ(run["path"].front(), json({0, 2}));
    EXPECT_EQ(run["path"].back(), json({7, 2}));
    EXPECT_EQ(keys(run["figures"]), kFigures);
    expect_all_numbers(run["figures"]);
    EXPECT_EQ(run["figures"]["nodes"], run["path"].size());
  }
  // Up to the top row, past the wall's end on straight moves, and down: four diagonals.
  EXPECT_NEAR(document["runs"][0]["figures"]["length"].get<double>(), 3 + 4 * std::sqrt(2.0), 1e-9);
}

TEST_F(CommandLine, runWithoutAPathHasNoPathZerosAndExitCodeOne) {
  for (const auto& [goal, status] : {std::pair{"6,4", "no-path"}, {"3,1", "goal-blocked"}}) {
    const Outcome outcome = run_program(plan("0,0", goal, {"--planner", "all", "--json"}));
    EXPECT_EQ(outcome.code, 1);
    const json document = outcome.json();
    EXPECT_EQ(document["runs"].size(), sound_planners().size());
    for (const json& run : document["runs"]) {
      // That there is none is more than chance can tell.
      const bool by_chance = find_planner(run["planner"].get<std::string>())->can_miss();
      const std::string expected = by_chance && status == std::string("no-path") ? "none-found" : status;
      EXPECT_EQ(run["status"], expected);
      EXPECT_EQ(run["path"], json::array());
      expect_all_numbers(run["figures"]);
      for (const char* key : {"nodes", "length", "turns", "turning_angle_deg", "greatest_curvature",
                              "min_clearance", "mean_clearance"})
        EXPECT_EQ(run["figures"][key], 0) << key;
    }
  }
}

TEST_F(CommandLine, whoTouchesObstaclesIsRefusedForARobotWithASizeAndIsNotAmongAll) {
  const std::string why = "'visibility-graph' plans for a robot without a size alone, since its paths touch";
  const auto sized = [this](const char* planner) {
    return plan("0,2", "7,2", {"--planner", planner, "--radius", "0.4", "--json"});
  };
  EXPECT_EQ(run_program(plan("0,2", "7,2", {"--planner", "visibility-graph"})).code, 0);
  for (const char* planner : {"visibility-graph", "all,visibility-graph"}) {
    const Outcome refused = run_program(sized(planner));
    EXPECT_NE(refused.code, 0);
    EXPECT_NE(refused.err.find(why), std::string::npos) << refused.err;
  }
  EXPECT_EQ(run_program(sized("all")).json()["runs"].size(), sound_planners().size() - 1);
}

TEST_F(CommandLine, runSaysInWordsWhyThereIsNoPath) {
  const Outcome blocked = run_program(plan("3,1", "7,2", {"--planner", "astar"}));
  EXPECT_EQ(blocked.code, 1);
  EXPECT_NE(blocked.out.find("start-blocked"), std::string::npos);
  EXPECT_NE(blocked.out.find("The start is inside an obstacle"), std::string::npos);
  EXPECT_EQ(blocked.err, "");
}

TEST_F(CommandLine, runDrivesAScenariosRobot) {
  const Outcome outcome = run_program({"run", scenario_, "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json document = outcome.json();
  ASSERT_EQ(document["runs"].size(), 2u);
  for (const json& run : document["runs"]) {
    const json& robot = run["robot"];
    EXPECT_EQ(keys(run), (std::set<std::string>{"planner", "status", "path", "figures", "robot"}));
    for (const char* key : {"moves", "travelled", "collisions", "replans"})
      EXPECT_TRUE(robot[key].is_number()) << key;
    EXPECT_EQ(robot["reached"], true);
    EXPECT_EQ(robot["ending"], "arrived");
    EXPECT_EQ(robot["collisions"], 0);
    EXPECT_EQ(robot["replans"], run["figures"]["replans"]);
    EXPECT_EQ(run["path"].front(), json({0, 2}));
    EXPECT_EQ(run["path"].back(), json({7, 2}));
    expect_all_numbers(run["figures"]);
  }
}

TEST_F(CommandLine, aRobotThatCannotArriveIsExitCodeOne) {
  std::string closed = kScenario;
  closed.replace(closed.find("[[3, 0]]"), 8, "[[3, 0], [3, 4]]");
  const Outcome outcome = run_program({"run", folder_.with("closed.json", closed), "--json"});
  EXPECT_EQ(outcome.code, 1);
  const json document = outcome.json();
  for (const json& run : document["runs"]) {
    EXPECT_EQ(run["robot"]["reached"], false);
    EXPECT_EQ(run["robot"]["ending"], "no-path");
  }
}

TEST_F(CommandLine, aRobotIsToldOfByNameWhoseCellIsBlocked) {
  const std::string rest = R"("map": {"rows": [".......", "......."]}, "start": [0, 0], "goal": [6, 0],
 "planners": [{"id": "astar"}, {"id": "dstar-lite"}],
 "surprises": [{"at": {"move": 2}, "add": {"cells": [[2, 0]]}}]})";
  const auto free = folder_.with("free.json", "{\"replan\": 1, " + rest);
  EXPECT_EQ(run_program({"run", free}).code, 0) << "it drives out";
  EXPECT_NE(run_program({"show", free, "--at", "replan:1"}).out.find("S.@R..G"), std::string::npos);
  const auto held =
      folder_.with("held.json", "{\"replan\": 1, \"robot\": {\"robot_cell_blocks\": true}, " + rest);
  const Outcome told = run_program({"run", held});
  EXPECT_EQ(told.code, 1);
  for (const char* planner : {"astar", "dstar-lite"})
    EXPECT_NE(told.out.find(std::string(planner) + ": The robot did not arrive: its own cell is an obstacle"),
              std::string::npos)
        << told.out;
  EXPECT_EQ(run_program({"run", held, "--json"}).json()["runs"][0]["robot"]["last_status"], "start-blocked");
  const Outcome shown = run_program({"show", held, "--at", "end"});
  EXPECT_NE(shown.out.find("an obstacle stands on the robot's cell and keeps it there"), std::string::npos);
  EXPECT_NE(shown.out.find("S.X...G"), std::string::npos) << shown.out;
}

TEST_F(CommandLine, unreachableGoalSaysHowNearTheRobotComes) {
  const auto closed = folder_.with("shut.json", R"({"replan": 1,
 "map": {"rows": ["....@..", "....@.."]}, "start": [0, 0], "goal": [6, 0], "planners": [{"id": "astar"}]})");
  EXPECT_EQ(run_program({"run", closed, "--json"}).json()["runs"][0]["status"], "no-path");
  const Outcome near = run_program({"run", closed, "--unreachable-goal", "nearest", "--json"});
  EXPECT_EQ(near.code, 1) << "the goal was not reached";
  const json run = near.json()["runs"][0];
  EXPECT_EQ(run["status"], "found-nearest");
  EXPECT_EQ(run["path"].back(), json({3, 0}));
  EXPECT_EQ(run["robot"]["ending"], "nearest");
  EXPECT_EQ(run["robot"]["short_of_goal"], 3);
  const std::string text = run_program({"run", closed, "--unreachable-goal", "nearest"}).out;
  EXPECT_NE(
      text.find("astar: The goal cannot be reached: the robot stands on the reachable cell nearest to it, "
                "3.000 cells away."),
      std::string::npos)
      << text;
  EXPECT_NE(run_program({"show", closed, "--at", "replan:1", "--unreachable-goal", "nearest"})
                .out.find("it makes for (3, 0)"),
            std::string::npos);
  const std::string planned =
      run_program(plan("0,0", "3,1", {"--planner", "astar", "--unreachable-goal", "nearest"})).out;
  EXPECT_NE(planned.find("the path leads to ("), std::string::npos) << planned;
  EXPECT_EQ(run_program({"run", closed, "--unreachable-goal", "nearst"}).err,
            "replan: --unreachable-goal cannot be 'nearst'; did you mean 'nearest'?\n");
}

TEST_F(CommandLine, radiusGivesTheRobotASize) {
  const auto gap = folder_.with("gap.json", R"({"replan": 1,
 "map": {"rows": [".......", "...@...", ".......", ".......", ".......", "...@...", "...@..."]},
 "start": [0, 3], "goal": [6, 3], "planners": [{"id": "astar"}, {"id": "dld-star-lite"}]})");
  for (const char* radius : {"0", "1.5"}) EXPECT_EQ(run_program({"run", gap, "--radius", radius}).code, 0);
  EXPECT_EQ(run_program({"run", gap, "--radius", "1.51", "--json"}).json()["runs"][0]["status"], "no-path");
  const Outcome told = run_program({"run", gap, "--radius", "1.25"});
  EXPECT_NE(told.out.find("astar: clearance of the edge of a robot of radius 1.25: min 0.25, mean "),
            std::string::npos)
      << told.out;
  EXPECT_EQ(run_program({"run", gap}).out.find("edge"), std::string::npos);
  const json figures = run_program({"run", gap, "--radius", "1.25", "--json"}).json()["runs"][1]["figures"];
  EXPECT_EQ(figures["min_edge_clearance"].get<double>(), figures["min_clearance"].get<double>() - 1.25);
  const auto start = folder_.with("near.json", R"({"replan": 1, "map": {"rows": [".....", "..@..", "....."]},
 "start": [0, 0], "goal": [2, 0], "planners": [{"id": "astar"}], "robot": {"radius": 1}})");
  EXPECT_NE(run_program({"run", start})
                .out.find("The goal is inside an obstacle, or nearer to one than the robot's "
                          "radius: move it, clear cells, or make the radius smaller."),
            std::string::npos);
  EXPECT_EQ(
      run_program({"run", gap, "--radius=1m"}).err,
      "replan: --radius 1m is in metres, but the map does not say how large its cells are: give a number of "
      "cells\n");
  for (const char* wrong : {"-1", "33", "wide"})
    EXPECT_EQ(
        run_program({"run", gap, std::string("--radius=") + wrong}).err,
        std::string("replan: --radius cannot be '") + wrong + "': give a number of cells from 0 to 32\n");
}

TEST_F(CommandLine, setGoesToEachPlannerThatHasTheSetting) {
  const auto length = [](const json& run) { return run["figures"]["length"].get<double>(); };
  const json all =
      run_program(plan("0,2", "7,2", {"--planner", "astar,dstar-lite", "--set", "moves=4", "--json"})).json();
  EXPECT_EQ(length(all["runs"][0]), 11);
  EXPECT_EQ(length(all["runs"][1]), 11);
  const json one =
      run_program(plan("0,2", "7,2", {"--planner", "astar,dstar-lite", "--set", "astar.moves=4", "--json"}))
          .json();
  EXPECT_EQ(length(one["runs"][0]), 11);
  EXPECT_LT(length(one["runs"][1]), 10);
}

TEST_F(CommandLine, setGoesToStagesToo) {
  expect_complaint({"run", scenario_, "--set", "distance=2"}, {"distance", "these have", "floyd"});
  expect_complaint({"run", scenario_, "--set", "floyd.distance=2"}, {"stage 'floyd'", "--stage"});
  expect_complaint({"run", scenario_, "--stage", "floyd", "--set", "distance=1m"},
                   {"--set distance=1m", "does not say how large its cells are"});
  EXPECT_EQ(run_program({"run", scenario_, "--stage", "floyd", "--set", "distance=2"}).code, 0);
}

TEST_F(CommandLine, plannerReplacesAScenariosOwnAndKeepsTheirSettings) {
  const json own = run_program({"run", scenario_, "--json"}).json();
  const json named = run_program({"run", scenario_, "--planner", "astar", "--json"}).json();
  ASSERT_EQ(named["runs"].size(), 1u);
  EXPECT_EQ(named["runs"][0]["figures"]["expansions"], own["runs"][1]["figures"]["expansions"]);
}

TEST_F(CommandLine, runWritesCsv) {
  const Outcome outcome = run_program({"run", scenario_, "--csv", "-"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.out.starts_with("planner,status,nodes,length,turns,turning_angle_deg,")) << outcome.out;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 3);
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  std::istringstream lines(outcome.out);
  std::string names, line;
  std::getline(lines, names);
  while (std::getline(lines, line)) EXPECT_EQ(commas(line), commas(names)) << line;
  EXPECT_EQ(run_program({"run", scenario_, "--csv", folder_.file("out.csv")}).code, 0);
  EXPECT_TRUE(whole_file(folder_.file("out.csv")).starts_with(names));
}

TEST_F(CommandLine, aMapThatSaysHowLargeItsCellsAreIsInMetres) {
  folder_.with("room.pgm", "P2\n6 4\n255\n" + std::string("255 255 255 255 255 255\n") +
                               "255 255 255 255 255 255\n255 255 0 255 255 255\n255 255 0 255 255 255\n");
  const std::string ros = folder_.with("room.yaml",
                                       "image: room.pgm\nresolution: 0.5\norigin: [-1, 2, 0]\nnegate: 0\n"
                                       "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const auto run = [&](const Arguments& more) {
    Arguments arguments = {"run", "--map", ros, "--planner", "astar"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  };
  const Outcome metres = run({"--start", "-0.8m,2.1m", "--goal", "5,3", "--json"});
  ASSERT_EQ(metres.code, 0) << metres.err;
  const json first = metres.json()["runs"][0];
  EXPECT_EQ(first["path"].front(), json({0, 3}));
  EXPECT_EQ(first["path_m"].front(), json({-0.75, 2.25}));
  EXPECT_EQ(first["path_m"].back(), json({1.75, 2.25}));
  EXPECT_DOUBLE_EQ(first["figures"]["length_m"].get<double>(),
                   0.5 * first["figures"]["length"].get<double>());
  EXPECT_NE(run({"--start", "0,3", "--goal", "5,3"}).out.find("length m"), std::string::npos);
  const Outcome cells = run({"--start", "0,3", "--goal", "5,3", "--cells"});
  EXPECT_EQ(cells.out.find("length m"), std::string::npos) << cells.out;
  const Outcome outside = run({"--start", "9m,2.1m", "--goal", "5,3"});
  EXPECT_EQ(outside.code, 2);
  EXPECT_NE(outside.err.find("(-1.000, 2.000) m to (2.000, 4.000) m"), std::string::npos) << outside.err;
  const auto smoothed = [&](const std::string& set) {
    return run({"--start", "0,3", "--goal", "5,3", "--stage", "floyd", "--set", set, "--json"})
        .json()["runs"][0];
  };
  EXPECT_EQ(smoothed("floyd.distance=1m")["path"], smoothed("distance=2")["path"]);
  EXPECT_NE(smoothed("floyd.distance=1m")["path"], smoothed("distance=0.8")["path"]);
  const Outcome none = run_program(plan("0.5m,1m", "7,0", {"--planner", "astar"}));
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("does not say how large its cells are"), std::string::npos) << none.err;
}

TEST_F(CommandLine, runWritesTablesForPapers) {
  const Outcome markdown = run_program({"run", scenario_, "--markdown", "-"});
  EXPECT_EQ(markdown.code, 0);
  EXPECT_TRUE(markdown.out.starts_with("| figure ")) << markdown.out;
  EXPECT_NE(markdown.out.find("| nodes "), std::string::npos);
  const std::string file = folder_.file("table.tex");
  EXPECT_EQ(run_program({"run", scenario_, "--latex", file}).code, 0);
  EXPECT_NE(whole_file(file).find("\\begin{tabular}{lrr}"), std::string::npos);
  expect_complaint({"run", scenario_, "--json", "--latex", "-"}, {"--json", "--latex", "file name"});
  expect_complaint({"run", scenario_, "--markdown", "-", "--csv", "-"}, {"--csv", "--markdown", "file name"});
}

TEST_F(CommandLine, badInputIsOneLineThatNamesTheMend) {
  const std::string start = "--start", goal = "--goal", planner = "--planner";
  expect_complaint({"run"}, {"give a scenario file, or --map FILE"});
  expect_complaint({"run", scenario_, "--map", map_}, {"not both"});
  expect_complaint({"run", folder_.file("none.json")}, {"none.json", "No such file"});
  expect_complaint({"run", map_}, {map_, "--map"});
  expect_complaint({folder_.file("none.json")}, {"none.json", "no such file"});
  expect_complaint({"run", "--map", folder_.file("none.map"), start, "0,0", goal, "1,1", planner, "astar"},
                   {"none.map"});
  expect_complaint({"run", "--map", map_, goal, "1,1", planner, "astar"},
                   {"--start is missing", "x from 0 to 7"});
  expect_complaint(plan("8,0", "1,1", {planner, "astar"}),
                   {"--start 8,0", "outside", "x from 0 to 7, y from 0 to 5"});
  expect_complaint(plan("-1,0", "1,1", {planner, "astar"}), {"--start -1,0", "outside"});
  expect_complaint(plan("0", "1,1", {planner, "astar"}), {"--start cannot be '0'", "X,Y"});
  expect_complaint(plan("0,0", "1,1x", {planner, "astar"}), {"--goal cannot be '1,1x'"});
  expect_complaint(plan("0,0", "99999999999,1", {planner, "astar"}), {"--goal cannot be"});
  expect_complaint(plan("0,0", "1,1", {}), {"--planner", "replan list planners"});
  expect_complaint(plan("0,0", "1,1", {planner, "astr"}),
                   {"unknown planner 'astr'", "did you mean 'astar'?"});
  expect_complaint(plan("0,0", "1,1", {planner, "astar", "--set", "heuristc=zero"}),
                   {"did you mean 'heuristic'?"});
  expect_complaint(plan("0,0", "1,1", {planner, "astar", "--set", "heuristic=none"}), {"one of: octile"});
  expect_complaint(plan("0,0", "1,1", {planner, "astar", "--set", "heuristic"}), {"KEY=VALUE"});
  expect_complaint(plan("0,0", "1,1", {planner, "astar", "--set", "range=3"}), {"dld-star-lite"});
  expect_complaint(plan("0,0", "1,1", {planner, "dld-star-lite", "--set", "range=nan"}), {"from 1 to 12"});
  expect_complaint(plan("0,0", "1,1", {planner, "astar", "--set", "dstar-lite.moves=4"}),
                   {"add it with --planner"});
  expect_complaint(plan("0,0", "1,1", {planner, "astar", "--set", "dstr-lite.moves=4"}),
                   {"did you mean 'dstar-lite'?"});
  expect_complaint({"run", scenario_, "--csv", folder_.file("no/such/x.csv")}, {"x.csv"});
}

TEST_F(CommandLine, badFilesAreNamedWithTheLine) {
  std::string torn = kMap;
  torn.replace(torn.find("...@.@@@"), 8, "...@.?@@");
  const std::string torn_map = folder_.with("torn.map", torn);
  expect_complaint({"run", "--map", torn_map, "--start", "0,0", "--goal", "1,1", "--planner", "astar"},
                   {torn_map + ":8: ", "unknown cell letter '?'"});
  std::string typo = kScenario;
  typo.replace(typo.find("sensor_radius"), 13, "sensor_radios");
  const std::string typo_file = folder_.with("typo.json", typo);
  expect_complaint({"run", typo_file}, {typo_file + ":6: ", "sensor_radius"});
  const std::string scen = folder_.with("a.scen", "version 1\n0\troom.map\t8\t6\t0\t0\t1\n");
  expect_complaint({"batch", scen, "--planner", "astar"}, {scen + ":2: "});
}

TEST_F(CommandLine, unknownWordsGetASuggestion) {
  expect_complaint({"rnu"}, {"did you mean 'run'?"});
  expect_complaint({"rnu", "--map", "x"}, {"did you mean 'run'?"});
  expect_complaint({"run", "--mapp", "x"}, {"'--mapp'", "did you mean '--map'?"});
  expect_complaint({"run", scenario_, "more"}, {"'more'", "replan run --help"});
  expect_complaint({"run", "--start"}, {"--start", "replan run --help"});
  expect_complaint({"list", "planer"}, {"did you mean 'planners'?"});
  expect_complaint({"list"}, {"WHAT is required"});
  expect_complaint({"batch"}, {"FILE is required"});
}

TEST_F(CommandLine, outputThatCannotBeWritten) {
  const int full = open("/dev/full", O_WRONLY);
  if (full < 0) GTEST_SKIP() << "There is no /dev/full here.";
  EXPECT_EQ(run_into({"list", "planners"}, full, folder_.file("err")), 2);
  EXPECT_NE(whole_file(folder_.file("err")).find("No space left"), std::string::npos);
  close(full);
}

TEST_F(CommandLine, aReaderThatGoesAwayIsNoError) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  EXPECT_EQ(run_into({"list", "planners"}, ends[1], folder_.file("err")), 0);
  EXPECT_EQ(whole_file(folder_.file("err")), "");
  close(ends[1]);
}

TEST_F(CommandLine, listNamesAllThereIs) {
  const Outcome text = run_program({"list", "planners"});
  EXPECT_EQ(text.code, 0);
  const json list = run_program({"list", "planners", "--json"}).json()["planners"];
  ASSERT_EQ(list.size(), choices().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const PlannerInfo& info = choices()[i];
    EXPECT_EQ(list[i]["id"], info.id);
    EXPECT_EQ(list[i]["drives"], find_pilot(info.id) != nullptr);
    EXPECT_EQ(list[i]["settings"].size(), info.parameters.size());
    EXPECT_NE(text.out.find("\n" + std::string(info.id) + " "), std::string::npos);
  }
  const json drawn = run_program({"list", "overlays", "--json"}).json()["overlays"];
  EXPECT_EQ(drawn.size(), overlays().size());
  bool demo = false;
  const json worlds = run_program({"list", "maps", "--json"}).json();
  for (const json& map : worlds["maps"]) demo |= map["path"].get<std::string>().ends_with("maps/demo.json");
  EXPECT_TRUE(demo);
}

/// The paper's boxes with the same weights: the planner is what leads through.
TEST_F(CommandLine, runDrivesPilotsBesidePlanners) {
  const std::string boxes = std::string(REPLAN_SOURCE_DIR) + "/maps/fusion-boxes.json";
  const std::string trace = folder_.file("boxes.jsonl");
  const Outcome outcome = run_program({"run", boxes, "--planner", "fusion,dwa,dstar-lite", "--set",
                                       "fusion.global=lpa-star", "--trace", trace, "--json"});
  EXPECT_EQ(outcome.code, 1) << "one does not arrive";
  const json runs = outcome.json()["runs"];
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[0]["planner"], "fusion");
  EXPECT_EQ(runs[0]["robot"]["ending"], "arrived");
  EXPECT_EQ(runs[1]["planner"], "dwa");
  EXPECT_EQ(runs[1]["robot"]["ending"], "stuck");
  EXPECT_EQ(runs[1]["path"], json::parse("[[1, 1], [28, 28]]"));
  const std::string text = whole_file(folder_.file("boxes.fusion.jsonl"));
  const json head = json::parse(text.substr(0, text.find('\n')));
  EXPECT_EQ(head["planner"], "fusion");
  EXPECT_EQ(head["settings"]["global"], "lpa-star");
  EXPECT_EQ(head["settings"]["w_max"], 1) << "as the scenario's robot has it";
  EXPECT_EQ(head["settings"]["heuristic"], "octile") << "that of what plans";
  EXPECT_EQ(run_program({"run", boxes, "--planner", "fusion,dwa", "--check"}).code, 0);
}

/// There is nothing to one but its drive, so that it drives on a map alone too, and all beside it.
TEST_F(CommandLine, runDrivesOnAMapWhereAPilotIsAmongThePlanners) {
  const json runs = run_program(plan("0,2", "7,2", {"--planner", "astar,fusion", "--json"})).json()["runs"];
  for (const json& run : runs) EXPECT_EQ(run["robot"]["ending"], "arrived") << run["planner"];
  EXPECT_FALSE(
      run_program(plan("0,2", "7,2", {"--planner", "astar", "--json"})).json()["runs"][0].contains("robot"));
  const Outcome wrong = run_program(plan("0,2", "7,2", {"--planner", "fusion", "--set", "global=dwa"}));
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.err.find("adaptive-astar"), std::string::npos) << wrong.err;
}

TEST_F(CommandLine, convertKeepsTheCells) {
  const std::string png = folder_.file("room.png"), back = folder_.file("back.map"),
                    json_file = folder_.file("room.json");
  EXPECT_EQ(run_program({"convert", map_, png}).code, 0);
  EXPECT_EQ(run_program({"convert", png, back}).code, 0);
  EXPECT_EQ(
      run_program({"convert", back, json_file, "--start", "0,2", "--goal", "7,2", "--planner", "astar"}).code,
      0);
  const auto map = read_map(map_), returned = read_map(back);
  ASSERT_TRUE(map.ok() && returned.ok());
  EXPECT_EQ(*map, *returned);
  const auto scenario = read_scenario(json_file);
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(scenario->map.blocked, map->blocked);
  EXPECT_EQ(scenario->goal, (Cell{7, 2}));
  EXPECT_EQ(run_program({"convert", scenario_, folder_.file("gap.map")}).code, 0);
  expect_complaint({"convert", map_, json_file}, {"--start is missing"});
  expect_complaint({"convert", map_, folder_.file("x.gif")}, {"x.gif", ".map, .yaml"});
  expect_complaint({"convert", map_, folder_.file("no/x.png")}, {"no/x.png"});
}

}  // namespace
}  // namespace replan::test::cli_test
