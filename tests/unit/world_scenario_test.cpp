#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/world/choices.hpp"
#include "core/world/scenario.hpp"
#include "tests/support/schema_check.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::world_scenario_test {
namespace {

using nlohmann::json;

const std::string kSource = REPLAN_SOURCE_DIR;

/// A scenario in which every key of the format occurs, in two documents' worth of alternatives.
json full_document() {
  return json::parse(R"doc({
    "replan": 1, "name": "n", "caption": "c",
    "map": {"rows": ["....", ".@..", "...?"], "resolution": 0.05, "origin": [-10, 2.5, 0.1]},
    "start": [0, 0], "goal": [3, 2],
    "planners": [{"id": "dld-star-lite", "settings": {"heuristic": "euclidean", "range": 2.5, "border": true}},
                 {"id": "dstar-lite", "stages": [{"id": "collinear", "settings": {}}]}],
    "robot": {"knowledge": "nothing", "sensor_radius": 4.5, "sensor_angle": 120, "sensor_blocked": true, "radius": 1.25,
              "motion": "smooth", "speed": 2.5, "patience": 10,
              "unreachable_goal": "nearest", "robot_cell_blocks": true, "kind": "cells", "settings": {}},
    "surprises": [
      {"at": {"move": 12}, "add": {"cells": [[2, 0]], "rectangles": [[2, 1, 2, 2]]}, "announced": true},
      {"at": {"move": 0}, "remove": {"cells": [[1, 1]]}},
      {"at": {"near": [1, 0], "within": 5}, "add": {"rectangles": []}, "remove": {"rectangles": [[0, 0, 1, 1]]}},
      {"at": {"move": 20}, "goal": [0, 2], "robot": [3, 0]}],
    "movers": [{"way": [[0, 0], [3, 1]], "size": [2, 1], "speed": 0.5, "at_end": "loop", "from": 3}],
    "view": {"overlays": ["g", "path"], "theme": "light", "camera": {"x": 1.5, "y": 2, "zoom": 14}},
    "debug": {"breakpoints": [{"condition": "g(0, 0) > 1 || taken", "enabled": false}, {"condition": "km > 5"}],
              "watches": ["size(U)", "rhs(0, 0)"]},
    "seed": 18446744073709551615
})doc");
}

Result<Scenario> parse(const json& document) {
  return parse_scenario(document.dump(), "s.json", ".");
}
std::string error_of(const json& document) {
  const auto scenario = parse(document);
  return scenario.ok() ? "" : scenario.error();
}
/// The error of the full document with the value at a JSON pointer replaced.
std::string error_with(const std::string& pointer, const json& value) {
  json document = full_document();
  document[json::json_pointer(pointer)] = value;
  return error_of(document);
}
json schema() {
  return json::parse(*read_file(kSource + "/assets/scenario.schema.json"));
}

TEST(Scenario, ReadsEveryKey) {
  const auto scenario = parse(full_document());
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(scenario->name, "n");
  EXPECT_EQ(scenario->caption, "c");
  EXPECT_EQ(scenario->map.width, 4);
  EXPECT_EQ(scenario->map.height, 3);
  EXPECT_TRUE(scenario->map.at({1, 1}));
  EXPECT_EQ(scenario->map.resolution, 0.05);
  EXPECT_EQ(scenario->goal, (Cell{3, 2}));
  ASSERT_EQ(scenario->planners.size(), 2u);
  EXPECT_EQ(scenario->planners[0].settings.get("range", 0), 2.5);
  EXPECT_EQ(scenario->planners[0].settings.get("heuristic", 0), 1);
  EXPECT_EQ(scenario->planners[0].settings.get("border", 0), 1);
  EXPECT_EQ(scenario->planners[1].stages, (std::vector<StageChoice>{{"collinear", {}}}));
  EXPECT_EQ(scenario->map.blocked[scenario->map.index({3, 2})], kUnmapped);
  EXPECT_EQ(scenario->map.origin, (std::array{-10.0, 2.5, 0.1}));
  EXPECT_EQ(scenario->robot, (RobotSetup{Knowledge::nothing, 4.5, true, 120, Motion::smooth, 2.5, 10,
                                         UnreachableGoal::nearest, true, 1.25}));
  ASSERT_EQ(scenario->surprises.size(), 4u);
  EXPECT_EQ(scenario->surprises[3].goal, (Cell{0, 2}));
  EXPECT_EQ(scenario->surprises[3].robot, (Cell{3, 0}));
  EXPECT_EQ(scenario->movers, (std::vector<MovingObstacle>{{.way = {{0, 0}, {3, 1}},
                                                            .width = 2,
                                                            .height = 1,
                                                            .speed = 0.5,
                                                            .at_end = WayEnd::loop,
                                                            .from = 3}}));
  EXPECT_EQ(scenario->surprises[0].at.move, 12);
  EXPECT_TRUE(scenario->surprises[0].announced);
  const std::vector<CellChange> cells = {
      {{2, 0}, true}, {{2, 1}, true}, {{3, 1}, true}, {{2, 2}, true}, {{3, 2}, true}};
  EXPECT_EQ(scenario->surprises[0].cells, cells);
  EXPECT_EQ(scenario->surprises[1].at.move, 0);
  EXPECT_EQ(scenario->surprises[1].cells, (std::vector<CellChange>{{{1, 1}, false}}));
  EXPECT_EQ(scenario->surprises[2].at.near, (Cell{1, 0}));
  EXPECT_EQ(scenario->surprises[2].at.within, 5);
  EXPECT_EQ(scenario->view.theme, "light");
  EXPECT_EQ(scenario->view.camera, (ViewSetup::Camera{1.5, 2, 14}));
  EXPECT_EQ(scenario->debug.breakpoints,
            (std::vector<Breakpoint>{{"g(0, 0) > 1 || taken", false}, {"km > 5", true}}));
  EXPECT_EQ(scenario->debug.watches, (std::vector<std::string>{"size(U)", "rhs(0, 0)"}));
  EXPECT_EQ(scenario->seed, 18446744073709551615ull);
}

/// A world may have been larger when they were written, or had layers: they are kept, and the window says what is wrong.
TEST(Scenario, BreakpointsAndWatchesOfAnotherWorldStay) {
  for (const char* condition : {"g(4, 0) > 1", "g(1, 1, 2) > 1"}) {
    json document = full_document();
    document["debug"]["breakpoints"][1]["condition"] = condition;
    document["debug"]["watches"][0] = "rhs(100, 100)";
    const auto scenario = parse(document);
    ASSERT_TRUE(scenario.ok()) << scenario.error();
    EXPECT_EQ(scenario->debug.breakpoints[1].condition, condition);
    EXPECT_EQ(scenario->debug.watches[0], "rhs(100, 100)");
  }
}

TEST(Scenario, BreakpointsAndWatchesMustReadOnSomeWorld) {
  EXPECT_NE(
      error_with("/debug/breakpoints/1/condition", "km").find("character 1: a breakpoint needs a truth"),
      std::string::npos);
  EXPECT_NE(
      error_with("/debug/watches/0", "size(V)").find("character 1: 'size' is told of the open list only"),
      std::string::npos);
  EXPECT_NE(
      error_with("/debug/watches", std::vector<std::string>(17, "km")).find("a list of at most 16 watches"),
      std::string::npos);
}

TEST(Scenario, TextIsReadBackEqual) {
  const auto full = parse(full_document());
  ASSERT_TRUE(full.ok()) << full.error();
  Scenario bare;
  bare.map = GridMap(150, 2);  // rows longer than a line of text
  bare.planners = {{"astar", {}}};
  Scenario empty_surprise = bare;
  empty_surprise.surprises.emplace_back().at.move = 0;
  empty_surprise.movers = {{.way = {{1, 1}}}};
  empty_surprise.name = "quotes \" and \\ and \n and \xC3\xA4";
  for (const Scenario& scenario : {*full, bare, empty_surprise}) {
    const std::string text = scenario_text(scenario);
    const auto back = parse_scenario(text, "s.json", ".");
    ASSERT_TRUE(back.ok()) << back.error() << "\n" << text;
    EXPECT_EQ(*back, scenario) << text;
    EXPECT_EQ(scenario_text(*back), text);
    EXPECT_EQ(test::SchemaCheck(schema()).check(json::parse(text)), "");
  }
}

TEST(Scenario, TextIsReadable) {
  const auto full = parse(full_document());
  const std::string text = scenario_text(*full);
  EXPECT_NE(text.find("\"start\": [0, 0],\n"), std::string::npos) << text;
  EXPECT_NE(text.find("{\"rectangles\": [[2, 0, 1, 3], [3, 1, 1, 2]]}"), std::string::npos) << text;
}

/// A world of rectangles, as the papers on sampling have them.
TEST(Scenario, ReadsAMapByItsSizeAndItsObstacles) {
  json document = full_document();
  document.erase("surprises");
  document["map"] = {{"size", {4, 3}},
                     {"obstacles", {{"rectangles", {{1, 0, 1, 2}, {1, 1, 2, 1}}}, {"cells", {{3, 2}}}}},
                     {"resolution", 0.01}};
  const auto read = parse(document);
  ASSERT_TRUE(read.ok()) << read.error();
  EXPECT_EQ(read->map.width, 4);
  EXPECT_EQ(read->map.resolution, 0.01);
  EXPECT_EQ(read->map.blocked.plain(), (std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(test::SchemaCheck(schema()).check(document), "");

  const auto error = [&](const char* pointer, const json& value) {
    json changed = document;
    changed[json::json_pointer(pointer)] = value;
    return error_of(changed);
  };
  EXPECT_NE(error("/map/obstacles/rectangles/0", {1, 0, 4, 1}).find("from 1 to 3, not 4"), std::string::npos);
  EXPECT_NE(error("/map/obstacles/boxes", json::array()).find("the map is a plane"), std::string::npos);
  for (const json& outside : {json{9, 9}, json{-1, 0}, json{2000000000, 0}})
    EXPECT_NE(error("/map/obstacles/cells/0", outside).find("outside the map"), std::string::npos);
  EXPECT_NE(error("/map/size", {4, 0}).find("from 1"), std::string::npos);
  EXPECT_NE(error("/map/size", {4}).find("a size [width, height]"), std::string::npos);
  EXPECT_NE(error("/map/size", {100000, 100000}).find("too large"), std::string::npos);
  document["map"].erase("obstacles");
  EXPECT_NE(error_of(document).find("'size' and 'obstacles' go together"), std::string::npos);
}

/// Rows of hundreds of cells are no text to read where a few rectangles say the same.
TEST(Scenario, ALargeMapOfFewBoxesIsWrittenByThem) {
  Scenario scenario;
  scenario.planners = {{"astar", {}}};
  const auto text_of = [&] {
    std::string text = scenario_text(scenario);
    const auto back = parse_scenario(text, "s.json", ".");
    EXPECT_TRUE(back.ok()) << back.error();
    if (back) {
      EXPECT_EQ(*back, scenario);
    }
    return text;
  };
  scenario.map = GridMap(900, 700);
  EXPECT_NE(text_of().find("\"size\": [900, 700]"), std::string::npos);
  for (int y = 100; y < 300; ++y)
    for (int x = 200; x < 260; ++x) scenario.map.set({x, y, 0}, true);
  EXPECT_NE(text_of().find("\"rectangles\": [[200, 100, 60, 200]]"), std::string::npos);
  scenario.map.blocked[0] = kUnmapped;  // which rectangles have no word for
  EXPECT_EQ(text_of().find("\"size\""), std::string::npos);
  scenario.map = GridMap(200, 200);
  for (int y = 0; y < 200; ++y)
    for (int x = y % 2; x < 200; x += 2) scenario.map.set({x, y, 0}, true);
  EXPECT_EQ(text_of().find("\"size\""), std::string::npos);
  scenario.map = GridMap(1200, 1200);  // one corner, and as many boxes as rows
  for (int y = 0; y < 1200; ++y)
    for (int x = 0; x <= y && x < 300; ++x) scenario.map.set({x, y, 0}, true);
  for (int y = 300; y < 1200; ++y) scenario.map.set({300 + (y * 7) % 800, y, 0}, true);
  EXPECT_EQ(text_of().find("\"size\""), std::string::npos);
  scenario.map = GridMap(40, 30, 20);
  scenario.map.set({5, 6, 7}, true);
  EXPECT_NE(text_of().find("\"size\": [40, 30, 20]"), std::string::npos);
}

TEST(Scenario, EverySettingOfEveryPlannerIsReadBack) {
  for (const PlannerInfo& info : choices()) {
    Scenario scenario;
    scenario.map = GridMap(2, 2);
    scenario.planners = {{std::string(info.id), {}}};
    for (const Parameter& parameter : info.parameters) {
      const bool number = parameter.type == ParameterType::real || parameter.type == ParameterType::whole;
      scenario.planners[0].settings.set(parameter.key,
                                        number ? parameter.high
                                        : parameter.type == ParameterType::toggle
                                            ? 1.0
                                            : static_cast<double>(parameter.choices.size() - 1));
    }
    const auto back = parse_scenario(scenario_text(scenario), "s.json", ".");
    ASSERT_TRUE(back.ok()) << back.error();
    EXPECT_EQ(*back, scenario);
  }
}

TEST(Scenario, ReadsMapFilesBesideIt) {
  const test::TemporaryFolder folder;
  folder.with("x.map", "type octile\nheight 1\nwidth 3\nmap\n.@.\n");
  json document = full_document();
  document["map"] = {{"file", "x.map"}};
  document["goal"] = {2, 0};
  document["surprises"] = document["movers"] = json::array();
  const std::string path = folder.with("s.json", document.dump());
  const auto scenario = read_scenario(path);
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(scenario->map_file, "x.map");
  EXPECT_TRUE(scenario->map.at({1, 0}));
  ASSERT_TRUE(write_scenario(*scenario, folder.file("copy.json")).ok());
  EXPECT_EQ(*read_scenario(folder.file("copy.json")), *scenario);
  folder.with("x.map", "type octile\nheight 1\nwidth 3\nmap\n.@\n");
  EXPECT_NE(read_scenario(path).error().find("x.map:5: the row has 2 columns"), std::string::npos);
  EXPECT_NE(error_with("/map", {{"file", "absent.map"}}).find("No such file"), std::string::npos);
  EXPECT_NE(error_with("/map", {{"file", "absent.doc"}}).find("must end in .map"), std::string::npos);
}

TEST(Scenario, KeepsHowItsMapFileIsRead) {
  const test::TemporaryFolder folder;
  folder.with("x.pgm", std::string("P5\n4 1\n255\n\x00\x40\x60\xFF", 15));
  folder.with("x.yaml",
              "image: x.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: "
              "0.9\nfree_thresh: 0.1\n");
  const auto parse_here = [&](const json& map) {
    json document = full_document();
    document["map"] = map;
    document["goal"] = {2, 0};
    document["surprises"] = document["movers"] = json::array();
    return parse_scenario(document.dump(), "s.json", folder.path());
  };
  const json picture = {{"file", "x.pgm"}, {"threshold", 80}, {"invert", true}};
  const json ros = {{"file", "x.yaml"}, {"unknown", "unmapped"}};
  folder.with("x.txt", "0120\n");
  const json numbers = {{"file", "x.txt"}, {"occupied", 2}};
  for (const json& map : {picture, ros, numbers}) {
    const auto scenario = parse_here(map);
    ASSERT_TRUE(scenario.ok()) << scenario.error();
    const json text = json::parse(scenario_text(*scenario));
    EXPECT_EQ(text["map"], map);
    EXPECT_EQ(test::SchemaCheck(schema()).check(text), "");
    EXPECT_EQ(*parse_scenario(text.dump(), "s.json", folder.path()), *scenario);
  }
  EXPECT_EQ(parse_here(picture)->map.blocked, (std::vector<std::uint8_t>{0, 0, 1, 1}));
  EXPECT_EQ(parse_here(ros)->map.blocked, (std::vector<std::uint8_t>{1, 2, 2, 0}));
  EXPECT_EQ(parse_here(numbers)->map.blocked, (std::vector<std::uint8_t>{0, 0, 1, 0}));
  EXPECT_EQ(parse_here(ros)->map.origin, (std::array<double, 3>{1, 2, 0}));
  const auto refused = [&](const json& map, const std::string& why) {
    const auto scenario = parse_here(map);
    ASSERT_FALSE(scenario.ok()) << map;
    EXPECT_NE(scenario.error().find(why), std::string::npos) << scenario.error();
  };
  refused({{"file", "x.pgm"}, {"threshold", 0}}, "from 1 to 255, not 0");
  refused({{"file", "x.pgm"}, {"threshold", 256}}, "from 1 to 255, not 256");
  refused({{"file", "x.pgm"}, {"invert", 1}}, "true or false");
  refused({{"file", "x.yaml"}, {"unknown", "occupied"}}, "must be one of: blocked, free, unmapped");
  refused({{"file", "x.pgm"}, {"unknown", "free"}}, "only a ROS map");
  refused({{"file", "x.yaml"}, {"threshold", 3}}, "are for pictures");
  refused({{"rows", {"...."}}, {"threshold", 3}}, "goes with 'file'");
  refused({{"rows", {"...."}}, {"occupied", 3}}, "goes with 'file'");
  refused({{"file", "x.txt"}}, "which one is the obstacle");
  refused({{"file", "x.yaml"}, {"occupied", 3}}, "only in a file of numbers");
  refused({{"file", "x.txt"}, {"occupied", "2"}}, "must be a number from ");
}

TEST(Scenario, SyntaxErrorsNameLineAndColumn) {
  const auto broken = [](const std::string& text) { return parse_scenario(text, "s.json", ".").error(); };
  EXPECT_EQ(broken("{\n  \"replan\": 1,\n  \"name\" \"x\"\n}").rfind("s.json:3:12: not JSON: ", 0), 0u)
      << broken("{\n  \"replan\": 1,\n  \"name\" \"x\"\n}");
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("{\"replan\": 1"), std::string("\xFF\xFE"),
        std::string("{\"replan\": 1e999}"), std::string("[1, 2"), std::string("{\"name\": \"\xC3\x28\"}"),
        std::string(1, '\0'), std::string(100'000, '['), std::string("nul")}) {
    const std::string error = broken(text);
    EXPECT_EQ(error.rfind("s.json:", 0), 0u) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    EXPECT_LT(error.size(), 300u);
  }
  EXPECT_EQ(broken("{\"replan\": 1,\n\"seed\": 1,\n\"seed\": 2}"), "s.json:3: the key 'seed' is given twice");
  const std::string two_lines = broken("{\"replan\": 1, \"a\\nb\": 1, \"a\\nb\": 2}");
  EXPECT_EQ(two_lines.find('\n'), std::string::npos) << two_lines;
  const std::string whole = full_document().dump(1);
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(parse_scenario(whole.substr(0, length), "s.json", ".").ok()) << length;
}

TEST(Scenario, ErrorsNameLinePlaceAndMend) {
  const std::string text = full_document().dump(1);
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    const auto line =
        std::count(changed.begin(), changed.begin() + static_cast<std::ptrdiff_t>(changed.find(to)), '\n');
    const std::string error = parse_scenario(changed, "s.json", ".").error(),
                      place = "s.json:" + std::to_string(line + 1);
    EXPECT_EQ(error.rfind(place + ": ", 0), 0u) << error << " is not at " << place;
    return error.substr(std::min(error.size(), place.size() + 2));
  };
  EXPECT_EQ(replaced("\"caption\"", "\"captoin\""), "captoin: unknown key; did you mean 'caption'?");
  // An error is one line, whatever the key is made of.
  EXPECT_EQ(replaced("\"caption\"", "\"cap\\ntion\""), "cap?tion: unknown key; did you mean 'caption'?");
  EXPECT_EQ(replaced("\"sensor_radius\": 4.5", "\"sensor_radius\": -1"),
            "robot.sensor_radius: must be a number from 0 to 10000, not -1");
  for (const char* wrong : {"0", "360.5", "\"wide\""})
    EXPECT_EQ(replaced("\"sensor_angle\": 120", std::string("\"sensor_angle\": ") + wrong),
              std::string("robot.sensor_angle: must be a number from 1 to 360, not ") + wrong);
  for (const char* wrong : {"-0.5", "32.5", "\"1 m\"", "true"})
    EXPECT_EQ(replaced("\"radius\": 1.25", std::string("\"radius\": ") + wrong),
              std::string("robot.radius: must be a number from 0 to 32, not ") + wrong);
  EXPECT_EQ(replaced("\"nothing\"", "\"some\""),
            "robot.knowledge: must be one of: all, map, nothing; not \"some\"");
  EXPECT_EQ(replaced("\"dstar-lite\"", "\"dstar-light\""),
            "planners[1].id: unknown planner 'dstar-light'; did you mean 'dstar-lite'?");
  EXPECT_EQ(replaced("\"range\": 2.5", "\"range\": 0")
                .rfind("planners[0].settings.range: 'range' cannot be '0': give a number from 1 to ", 0),
            0u);
  EXPECT_EQ(replaced("\"heuristic\"", "\"huristic\""),
            "planners[0].settings.huristic: unknown setting 'huristic'; did you mean 'heuristic'?");
  EXPECT_EQ(replaced("\"border\": true", "\"border\": \"yes\""),
            "planners[0].settings.border: must be true or false, not \"yes\"");
  EXPECT_EQ(replaced(".@..", ".@"), "map.rows[1]: has 2 cells, the first row has 4");
  EXPECT_EQ(
      replaced(".@..", ".x.."),
      "map.rows[1]: column 2: unknown cell letter 'x'; known are . G S (free), @ O T W (obstacle) and ? (an "
      "obstacle that is on nobody's map)");
}

TEST(Scenario, RefusesWhatIsOutOfPlace) {
  EXPECT_NE(error_with("/start", {4, 0})
                .find("start: (4, 0) is outside the map: x goes from 0 to 3, y from 0 to 2"),
            std::string::npos);
  EXPECT_NE(error_with("/goal", {0, -1}).find("goal: (0, -1) is outside the map"), std::string::npos);
  EXPECT_EQ(error_with("/start", {1, 1}), "");  // on an obstacle: an outcome of planning, not an error
  EXPECT_NE(error_with("/start", {1}).find("must be a cell [x, y], not a list of 1"), std::string::npos);
  EXPECT_NE(error_with("/goal", {0.5, 1}).find("must be a whole number"), std::string::npos);
  EXPECT_NE(error_with("/replan", 2).find("replan: must be 1, the only version"), std::string::npos);
  EXPECT_NE(error_with("/planners", json::array()).find("must be a list of 1 to 16 planners"),
            std::string::npos);
  EXPECT_NE(
      error_with("/map", json::object()).find("needs exactly one of 'file', 'rows', 'layers' and 'size'"),
      std::string::npos);
  EXPECT_NE(error_with("/map/file", "x.map").find("needs exactly one of 'file', 'rows', 'layers' and 'size'"),
            std::string::npos);
  EXPECT_NE(error_with("/map/rows", json::array()).find("must be a list of rows"), std::string::npos);
  EXPECT_NE(error_with("/map/rows/0", "").find("at least one cell"), std::string::npos);
  EXPECT_NE(error_with("/surprises/0/at", json::object()).find("needs exactly one of"), std::string::npos);
  EXPECT_NE(error_with("/surprises/0/at/near", {1, 0}).find("needs exactly one of"), std::string::npos);
  EXPECT_NE(error_with("/surprises/0/at/within", 5).find("goes only with 'near'"), std::string::npos);
  EXPECT_NE(error_with("/surprises/2/at", {{"near", {0, 0}}}).find("'within' is missing"), std::string::npos);
  EXPECT_NE(error_with("/surprises/0/add/rectangles/0", {2, 1, 3, 1}).find("from 1 to 2, not 3"),
            std::string::npos);
  EXPECT_NE(error_with("/surprises/0/remove", {{"cells", {{2, 0}}}}).find("(2, 0) is both added and removed"),
            std::string::npos);
  EXPECT_NE(error_with("/surprises/1", {{"at", {{"move", 1}}}}).find("changes nothing"), std::string::npos);
  EXPECT_NE(error_with("/seed", -1).find("seed: must be a whole number from 0 to 18446744073709551615"),
            std::string::npos);
  EXPECT_EQ(error_of(json::array()),
            "s.json:1: not a Replan scenario: the key \"replan\" with the value 1 is missing");
  // What else the program writes as JSON says what to do with it.
  const std::string experiment = error_of({{"format", "replan experiment"}, {"version", 1}});
  EXPECT_NE(experiment.find("'replan batch' runs it"), std::string::npos) << experiment;
  EXPECT_NE(experiment.find("Run > Batch"), std::string::npos) << experiment;
  EXPECT_NE(error_of({{"format", "replan batch"}}).find("the results of a batch"), std::string::npos);
  for (const char* key : {"map", "start", "goal", "planners"}) {
    json document = full_document();
    document.erase(key);
    EXPECT_EQ(error_of(document), "s.json:1: the key '" + std::string(key) + "' is missing");
  }
}

TEST(Scenario, SurprisesCannotAskForEndlessMemory) {
  json document = full_document();
  document["map"] = {{"rows", json::array()}};
  for (int i = 0; i < 2100; ++i) document["map"]["rows"].push_back(std::string(2000, '.'));
  document["surprises"] = {{{"at", {{"move", 0}}}, {"add", {{"rectangles", {{0, 0, 2000, 2000}}}}}}};
  EXPECT_EQ(error_of(document), "");
  document["surprises"][0]["add"]["rectangles"].push_back({0, 0, 2000, 2000});
  EXPECT_NE(error_of(document).find("more than 4194304 cells are listed"), std::string::npos);
}

/// Walks a document and its schema side by side and calls `visit` for each part that the schema describes.
template <class Visit>
void walk(const json& value, const json& given, const test::SchemaCheck& schemas, const std::string& pointer,
          const Visit& visit) {
  const json& rule = schemas.resolve(given);
  visit(pointer, rule);
  if (value.is_object() && rule.contains("properties"))
    for (const auto& [key, part] : value.items())
      if (rule["properties"].contains(key))
        walk(part, rule["properties"][key], schemas, pointer + "/" + key, visit);
  if (value.is_array() && rule.contains("items"))
    for (std::size_t i = 0; i < value.size(); ++i)
      walk(value[i], rule["items"], schemas, pointer + "/" + std::to_string(i), visit);
}

/// How many kinds of objects a schema describes.
std::size_t count_levels(const json& rule) {
  std::size_t count =
      rule.is_object() && rule.contains("properties") && rule["properties"].is_object() ? 1 : 0;
  if (rule.is_structured())
    for (const json& part : rule) count += count_levels(part);
  return count;
}

TEST(ScenarioSchema, AcceptsTheFullDocument) {
  const json rules = schema();
  EXPECT_EQ(test::SchemaCheck(rules).check(full_document()), "");
}

TEST(ScenarioSchema, HasTheReadersKeysAtEveryLevel) {
  const json rules = schema();
  const test::SchemaCheck schemas(rules);
  std::set<const json*> met;
  const auto look_at = [&](const json& document, const std::string& pointer, const json& rule) {
    if (!rule.contains("properties")) return;
    EXPECT_EQ(rule.value("additionalProperties", json()), false) << pointer;
    met.insert(&rule);
    std::set<std::string> keys;
    for (const auto& [key, part] : rule["properties"].items()) {
      keys.insert(key);
      EXPECT_TRUE(part.contains("description") || schemas.resolve(part).contains("description"))
          << pointer << " " << key;
    }
    json changed = document;
    changed[json::json_pointer(pointer + "/zzzzzzzzzzzz")] = 1;
    const std::string error = error_of(changed), mark = "known here: ";
    ASSERT_NE(error.find(mark), std::string::npos) << pointer << ": " << error;
    std::set<std::string> known;
    std::string list = error.substr(error.find(mark) + mark.size()) + ", ";
    for (std::size_t end; (end = list.find(", ")) != std::string::npos; list.erase(0, end + 2))
      known.insert(list.substr(0, end));
    EXPECT_EQ(keys, known) << pointer;
  };
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder.file("two.asc"), "ncols 2\nnrows 1\n-9 -5\n").ok());
  // How a file is read has no place beside rows.
  const json of_file = {{"replan", 1},
                        {"map", {{"file", folder.file("two.asc")}, {"heights", {{"layers", 3}}}}},
                        {"start", {0, 0, 2}},
                        {"goal", {1, 0, 2}},
                        {"planners", {{{"id", "astar"}}}}};
  EXPECT_EQ(error_of(of_file), "");
  for (const json& document : {full_document(), of_file})
    walk(document, rules, schemas, "",
         [&](const std::string& pointer, const json& rule) { look_at(document, pointer, rule); });
  EXPECT_EQ(met.size(), count_levels(rules)) << "the full document does not have every object of the format";
}

TEST(ScenarioSchema, HasTheReadersRangesAndTypes) {
  const json rules = schema();
  const test::SchemaCheck schemas(rules);
  walk(full_document(), rules, schemas, "", [&](const std::string& pointer, const json& rule) {
    const auto both = [&](const json& value, bool good) {
      json document = full_document();
      document[json::json_pointer(pointer)] = value;
      EXPECT_EQ(schemas.check(document).empty(), good)
          << pointer << " = " << value << ": " << schemas.check(document);
      EXPECT_EQ(error_of(document).empty(), good) << pointer << " = " << value << ": " << error_of(document);
    };
    if (pointer.empty()) return;
    both(nullptr, false);
    if (rule.contains("enum"))
      for (const json& choice : rule["enum"]) both(choice, true);
    if (!rule.contains("maximum")) return;
    for (const char* end : {"minimum", "maximum"}) both(rule[end], true);
    both(rule["minimum"].get<double>() - 1, false);
    both(rule["maximum"].get<double>() * 2, false);
  });
}

TEST(ScenarioSchema, ShippedScenariosPass) {
  const json rules = schema();
  const auto files = test::files_below(kSource + "/maps", ".json");
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    EXPECT_EQ(test::SchemaCheck(rules).check(json::parse(*read_file(file.string()))), "") << file;
    const auto scenario = read_scenario(file.string());
    ASSERT_TRUE(scenario.ok()) << scenario.error();
    EXPECT_FALSE(scenario->name.empty()) << file;
    EXPECT_FALSE(scenario->map.at(scenario->start)) << file;
    EXPECT_FALSE(scenario->map.at(scenario->goal)) << file;
    EXPECT_EQ(*parse_scenario(scenario_text(*scenario), file.string(), file.parent_path().string()),
              *scenario);
  }
}

}  // namespace
}  // namespace replan::world_scenario_test
