// 'replan convert': what it reads and writes, what it says is lost, and bad input, each once.
#include <algorithm>

#include <sys/resource.h>
#include <sys/stat.h>

#include "core/world/formats/movingai.hpp"
#include "core/world/formats/voxel_map.hpp"
#include "core/world/generators/list.hpp"
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"
#include "tests/cli/child.hpp"

namespace replan::test::convert_test {
namespace {

using Arguments = std::vector<std::string>;

constexpr const char* kMap = "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n";
constexpr const char* kCfg =
    "discretization(cells): 3 2\nobsthresh: 2\nstart(cells): 0 0\nend(cells): 2 1\nenvironment:\n0 1 2\n0 0 "
    "0\n";
constexpr const char* kYaml =
    "image: a.pgm\nresolution: 0.05\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: "
    "0.196\n";

class Convert : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string map_ = folder_.with("a.map", kMap);

  /// Converts, and expects it to go well with these notes.
  void expect_notes(const Arguments& rest, const std::vector<std::string>& notes) const {
    Arguments arguments = {"convert"};
    arguments.insert(arguments.end(), rest.begin(), rest.end());
    const Outcome outcome = run_program(arguments);
    SCOPED_TRACE(rest[0] + " " + rest[1]);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(outcome.out.starts_with("wrote " + rest[1] + ": ")) << outcome.out;
    std::string expected;
    for (const std::string& note : notes) expected += "note: " + note + "\n";
    EXPECT_EQ(outcome.out.substr(outcome.out.find('\n') + 1), expected);
  }
};

TEST_F(Convert, keepsTheCellsThroughEveryFormat) {
  std::string from = map_;
  for (const char* extension : {".yaml", ".bmp", ".tga", ".pgm", ".txt", ".3dmap"}) {
    const std::string to = folder_.file("b" + std::string(extension));
    EXPECT_EQ(run_program({"convert", from, to}).code, 0) << extension;
    from = to;
  }
  const std::string back = folder_.file("back.map");
  EXPECT_EQ(run_program({"convert", from, back, "--slice", "0"}).code, 0);
  EXPECT_EQ(whole_file(back), kMap);
}

TEST_F(Convert, readsPicturesAndRosMapsAsTold) {
  const std::string pgm = folder_.with("a.pgm", std::string("P5\n4 1\n255\n\x00\x40\xCD\xFF", 15));
  const std::string yaml = folder_.with("a.yaml", kYaml), out = folder_.file("o.txt");
  const auto converted = [&](Arguments arguments) {
    arguments.insert(arguments.begin(), "convert");
    EXPECT_EQ(run_program(arguments).code, 0);
    return whole_file(out);
  };
  EXPECT_EQ(converted({pgm, out}), "@@..\n");
  EXPECT_EQ(converted({pgm, out, "--threshold", "64"}), "@...\n");
  EXPECT_EQ(converted({pgm, out, "--invert"}), "..@@\n");
  EXPECT_EQ(converted({yaml, out}), "@@@.\n");
  EXPECT_EQ(converted({yaml, out, "--unknown", "free"}), "@@..\n");
  EXPECT_EQ(converted({yaml, out, "--unknown", "unmapped"}), "@@?.\n");
  expect_complaint({"convert", pgm, out, "--threshold", "0"}, {"--threshold cannot be '0'", "1 to 255"});
  expect_complaint({"convert", yaml, out, "--unknown", "fre"}, {"did you mean 'free'?"});
  expect_complaint({"convert", yaml, out, "--invert"}, {"are for pictures"});
  expect_complaint({"convert", map_, out, "--unknown", "free"}, {"only a ROS map"});
  expect_complaint({"run", folder_.with("s.json", "{}"), "--invert"}, {"a scenario says itself"});
}

TEST_F(Convert, saysWhatIsLost) {
  folder_.with("a.pgm", std::string("P5\n2 1\n255\n\x00\xCD", 13));
  const std::string yaml = folder_.with("a.yaml", std::string(kYaml) + "site: here\n"),
                    out = folder_.file("o.map");
  expect_notes({yaml, out, "--unknown", "unmapped"},
               {yaml + ":7: the key 'site' is not one of map_server's and was passed over",
                ".map cannot hold the resolution (0.05 a cell)", ".map cannot hold the origin (1, 2, 0)",
                ".map cannot hold that 1 cell is unknown on the map: there it is an obstacle"});
  const std::string cfg = folder_.with("e.cfg", kCfg);
  expect_notes({cfg, folder_.file("o.png")},
               {cfg + ": the costs of 1 free cells are lost: here all cells cost the same",
                ".png cannot hold the start (0, 0)", ".png cannot hold the goal (2, 1)"});
  expect_notes({cfg, folder_.file("o.txt")},
               {cfg + ": the costs of 1 free cells are lost: here all cells cost the same"});
  EXPECT_EQ(whole_file(folder_.file("o.txt")), "S.@\n..G\n");
  expect_notes({map_, folder_.file("o.3dmap"), "--start", "0,0"}, {".3dmap cannot hold the start (0, 0)"});
}

TEST_F(Convert, startAndGoalBecomeTheScenarios) {
  const std::string cfg = folder_.with("e.cfg", kCfg), json = folder_.file("e.json");
  EXPECT_EQ(run_program({"convert", cfg, json}).code, 0);
  auto scenario = read_scenario(json);
  ASSERT_TRUE(scenario.ok()) << scenario.error();
  EXPECT_EQ(scenario->start, (Cell{0, 0}));
  EXPECT_EQ(scenario->goal, (Cell{2, 1}));
  ASSERT_EQ(scenario->planners.size(), 1u);
  EXPECT_EQ(scenario->planners[0].id, "dstar-lite");
  EXPECT_EQ(run_program({"convert", cfg, json, "--goal", "1,0", "--planner", "astar"}).code, 0);
  scenario = read_scenario(json);
  EXPECT_EQ(scenario->goal, (Cell{1, 0}));
  EXPECT_EQ(scenario->planners[0].id, "astar");
  EXPECT_EQ(run_program({"run", "--map", cfg, "--planner", "astar"}).code, 0);
  EXPECT_EQ(run_program({"convert", json, folder_.file("back.cfg")}).code, 0);
  EXPECT_EQ(read_map_file(folder_.file("back.cfg"))->goal, (Cell{1, 0}));
}

TEST_F(Convert, writesAProblemWithItsOptimalLength) {
  const std::string scen = folder_.file("a.map.scen");
  EXPECT_EQ(run_program({"convert", map_, scen, "--start", "0,1", "--goal", "3,1"}).code, 0);
  EXPECT_EQ(whole_file(scen), "version 1\n1\ta.map\t4\t3\t0\t1\t3\t1\t5.00000000\n");
  EXPECT_EQ(run_program({"batch", scen, "--planner", "astar,dstar-lite"}).code, 0);
  const std::string wall = folder_.with("w.txt", "S@G\n");
  EXPECT_EQ(run_program({"convert", wall, folder_.file("w.scen")}).code, 1);
  const std::string json = folder_.file("s.json");
  EXPECT_EQ(run_program({"convert", map_, json, "--start", "0,0", "--goal", "3,2"}).code, 0);
  expect_notes({json, folder_.file("b.map.scen")},
               {".scen cannot hold the planner and the robot", ".scen cannot hold name, caption and view"});
  expect_complaint({"convert", json, folder_.file("b.scen")}, {"call it NAME.map.scen"});
  expect_complaint({"convert", map_, scen}, {"give --start X,Y and --goal X,Y"});
  expect_complaint({"convert", scen, map_}, {"list of problems"});
}

TEST_F(Convert, makesMaps) {
  const std::string spec = "generator:rooms?width=40&height=30&seed=5", out = folder_.file("r.map");
  EXPECT_EQ(run_program({"convert", spec, out}).code, 0);
  EXPECT_EQ(*read_map(out), *generate_from_spec(spec));
  EXPECT_EQ(
      run_program({"run", "--map", spec, "--start", "0,0", "--goal", "39,29", "--planner", "astar"}).code, 0);
  expect_complaint({"convert", "generator:mase", out}, {"did you mean 'maze'?"});
  expect_complaint({"convert", "generator:maze?braid=7", out}, {"'braid' cannot be '7'", "from 0 to 1"});
  const nlohmann::json listed = run_program({"list", "generators", "--json"}).json();
  ASSERT_EQ(listed["generators"].size(), generators().size());
  EXPECT_EQ(listed["all"].size(), 3u);
  const std::string text = run_program({"list", "generators"}).out;
  for (std::size_t i = 0; i < generators().size(); ++i) {
    EXPECT_EQ(listed["generators"][i]["id"], generators()[i].id);
    EXPECT_EQ(listed["generators"][i]["settings"].size(), generators()[i].parameters.size());
    for (const Parameter& parameter : generators()[i].parameters)
      EXPECT_NE(text.find("    " + std::string(parameter.key) + "="), std::string::npos);
  }
}

TEST_F(Convert, makesWorldsOfLayersOfHeights) {
  const std::string sea = folder_.with("sea.asc",
                                       "NCOLS 3\nnrows 1\ncellsize 1\nnodata_value -99\n-40 -20 -99\n"),
                    grey = folder_.with("grey.pgm", std::string("P5\n2 1\n255\n\x00\xFF", 13)),
                    out = folder_.file("o.3dmap"), text = folder_.file("o.txt");
  expect_notes({sea, out, "--layers", "4"},
               {"heights go from -40 to -20; the 4 layers reach from -40 up to 0, 10 each",
                "1 column has no height and is an obstacle in all layers",
                "where the grid lies (its south-west corner at nothing, nothing) and how large its cells are "
                "(1 x 1) is "
                "not kept, since it does not say in which unit"});
  EXPECT_EQ(whole_file(out), "voxel 3 1 4\n1 0 0\n1 0 1\n2 0 0\n2 0 1\n2 0 2\n2 0 3\n");
  EXPECT_EQ(run_program({"convert", sea, text, "--layers", "4", "--slice", "1"}).code, 0);
  EXPECT_EQ(whole_file(text), ".@@\n");
  EXPECT_EQ(run_program({"convert", sea, text, "--heights", "-60,-10", "--layers", "5", "--slice", "1"}).code,
            0);
  EXPECT_EQ(whole_file(text), "@@@\n");
  EXPECT_EQ(run_program({"convert", grey, text}).code, 0);
  EXPECT_EQ(whole_file(text), "@.\n");
  EXPECT_EQ(run_program({"convert", grey, text, "--height-map", "--slice", "63"}).code, 0);
  EXPECT_EQ(whole_file(text), ".@\n");
  EXPECT_EQ(run_program({"convert", grey, text, "--height-map", "--invert", "--slice", "63"}).code, 0);
  EXPECT_EQ(whole_file(text), "@.\n");
  const Outcome run =
      run_program({"run", "--map", sea, "--start", "0,0,0", "--goal", "1,0,63", "--planner", "astar"});
  EXPECT_EQ(run.code, 0) << run.err;
  expect_complaint({"convert", sea, out, "--layers", "1"}, {"--layers cannot be '1'", "from 2 to 512"});
  expect_complaint({"convert", sea, out, "--heights", "5"}, {"--heights cannot be '5'", "-4000,0"});
  expect_complaint({"convert", sea, out, "--heights", "5,-5"}, {"--heights cannot be '5,-5'"});
  expect_complaint({"convert", sea, out, "--reduce", "0"}, {"--reduce cannot be '0'", "from 1 to 1024"});
  for (const auto& option :
       {std::vector<std::string>{"--layers", "4"}, {"--heights", "0,9"}, {"--reduce", "2"}}) {
    std::vector<std::string> arguments = {"convert", grey, out};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_complaint(arguments, {"is a picture", "only with --height-map"});
  }
  expect_complaint({"convert", map_, out, "--height-map"}, {"heights and layers are for", "a.map' is none"});
  expect_complaint({"convert", sea, text}, {"three dimensions", "--slice Z with Z from 0 to 63"});
}

TEST_F(Convert, makesWorldsInSpace) {
  const std::string spec = "generator:pillars?width=20&height=15&layers=6&seed=5",
                    out = folder_.file("p.3dmap");
  EXPECT_EQ(run_program({"convert", spec, out}).code, 0);
  EXPECT_EQ(*read_map(out), *generate_from_spec(spec));
  EXPECT_EQ(
      run_program({"run", "--map", spec, "--start", "0,0,0", "--goal", "19,14,5", "--planner", "astar"}).code,
      0);
  const std::string slice = folder_.file("s.map");
  EXPECT_EQ(run_program({"convert", spec, slice, "--slice", "2"}).code, 0);
  EXPECT_EQ(*read_map(slice), *voxel_slice(*read_map(out), 2));
  expect_complaint({"convert", spec, out, "--layers", "4"},
                   {"how a map is read", "--layers", "say layers=4 in the generator"});
  expect_complaint({"convert", "generator:pillars?seed=5", out, "--layers", "4"},
                   {"say &layers=4 in the generator"});
  expect_complaint({"convert", "generator:pillars", slice, "--layers", "4", "--slice", "2"},
                   {"say ?layers=4 in the generator"});
  for (const std::vector<std::string>& option :
       {std::vector<std::string>{"--heights", "-4,0"}, {"--reduce", "2"}, {"--height-map"}, {"--invert"}}) {
    std::vector<std::string> arguments = {"convert", spec, out};
    arguments.insert(arguments.end(), option.begin(), option.end());
    expect_complaint(arguments, {"a generator has settings of its own: leave them out"});
  }
  expect_complaint({"run", "--map", spec, "--start", "0,0,0", "--goal", "19,14,5", "--reduce", "2"},
                   {"a generator has settings of its own"});
}

TEST_F(Convert, slicesVoxels) {
  const std::string box = folder_.with("b.3dmap", "voxel 3 2 4\n2 1 3\n0 0 0\n"), out = folder_.file("o.txt");
  EXPECT_EQ(run_program({"convert", box, out, "--slice", "3"}).code, 0);
  EXPECT_EQ(whole_file(out), "...\n..@\n");
  const std::string copy = folder_.file("c.3dmap");
  EXPECT_EQ(run_program({"convert", box, copy}).code, 0);
  EXPECT_EQ(*read_voxel_map(copy), *read_voxel_map(box));
  expect_complaint({"convert", box, out}, {"three dimensions", "--slice Z with Z from 0 to 3"});
  expect_complaint({"convert", box, out, "--slice", "4"}, {"z goes from 0 to 3"});
  expect_complaint({"convert", box, out, "--slice", "-1"}, {"--slice cannot be '-1'"});
  expect_complaint({"convert", box, out, "--slice", "99999999999"}, {"z goes from 0 to 3"});
  expect_complaint({"convert", map_, out, "--slice", "0"}, {"--slice is for a world of several layers"});
}

TEST_F(Convert, brokenFilesAreNamedWithTheirPlace) {
  const std::string out = folder_.file("o.png");
  const auto refused = [&](const std::string& name, const std::string& bytes, const std::string& place,
                           const std::string& why) {
    const std::string path = folder_.with(name, bytes);
    expect_complaint({"convert", path, out}, {path + place, why});
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  refused("t.map", "type octile\nheight 3\nwidth 4\nmap\n....\n", ":5", "ends after 1 of 3 rows");
  refused("h.map", "type hex\nheight 1\nwidth 1\nmap\n.\n", ":1", "only 'type octile'");
  refused("l.map", "type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.x\r\n", ":5", "unknown cell letter 'x'");
  refused("b.png", "\x89PNG\r\n\x1A\n broken", "", "not a picture");
  refused("b.pgm", "P5\n2 2\n255\nab", "", "ends after 2 of 4 values");
  refused("b.yaml", "image: [\n", ":2", "not YAML");
  refused("k.yaml", "resolution: 1\n", "", "the key 'image' is missing");
  refused("b.json", "{\"replan\": 1,", ":1", "not JSON");
  refused("k.json", "{\"replan\": 1, \"sed\": 1}", ":1", "seed");
  refused("r.json", "{\"replan\": 1, \"map\": {\"file\": \"a.map\", \"threshold\": 999}}", ":1", "1 to 255");
  refused(
      "o.json",
      "{\"replan\": 1, \"map\": {\"file\": \"a.map\"}, \"start\": [9, 0], \"goal\": [0, 0], \"planners\": "
      "[{\"id\": \"astar\"}]}",
      ":1", "(9, 0) is outside the map");
  refused("b.cfg", "discretization(cells): 1\n", ":1", "must be whole");
  refused("b.txt", "..\n.\n", ":2", "equally long");
  refused("b.3dmap", "voxel 1 1\n", ":1", "not a voxel map");
}

TEST_F(Convert, hugeHeadersTakeNoMemory) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  rlimit tight = before;
  tight.rlim_cur = std::min<rlim_t>(before.rlim_max, rlim_t{1} << 30);  // of which the libraries take a part
  ASSERT_EQ(setrlimit(RLIMIT_AS, &tight), 0);
  const std::string big = "1000000000", out = folder_.file("o.png");
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"h.map",
                                            "type octile\nheight " + big + "\nwidth " + big + "\nmap\n.\n"},
        {"h.3dmap", "voxel " + big + " " + big + " " + big + "\n"},
        {"h.pgm", "P5\n" + big + " " + big + "\n255\n"},
        {"h.cfg", "discretization(cells): " + big + " " + big + "\n"}})
    expect_complaint({"convert", folder_.with(name, text), out},
                     {name, std::to_string(name == "h.3dmap" ? kMaxVoxels : kMaxCells)});
  EXPECT_EQ(setrlimit(RLIMIT_AS, &before), 0);
}

TEST_F(Convert, aFileWithoutItsLastLineEndIsWhole) {
  const std::string path = folder_.with("n.map", "type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.@");
  EXPECT_EQ(run_program({"convert", path, folder_.file("o.txt")}).code, 0);
  EXPECT_EQ(whole_file(folder_.file("o.txt")), ".@\n");
}

TEST_F(Convert, outputThatCannotBeWrittenLosesNothing) {
  expect_complaint({"convert", map_, folder_.file("no/x.map")}, {"no/x.map", "No such file"});
  expect_complaint({"convert", map_, folder_.path()}, {"its name must end in .map, .yaml"});
  expect_complaint({"convert", map_, folder_.file("a.jpg")}, {"a.jpg", "must end in"});
  expect_complaint({"convert", map_, folder_.file("a.cfg")}, {"needs start and goal"});
  expect_complaint({"convert", map_, folder_.file("a.json")}, {"--start is missing"});
  expect_complaint({"convert", map_, folder_.file("b.map"), "--planner", "astar"}, {"are for a scenario"});
  const std::string old = folder_.with("old.map", "old");
  std::filesystem::create_directory(folder_.file("old.txt"));
  expect_complaint({"convert", map_, folder_.file("old.txt")}, {"old.txt", "folder"});
  if (access("/dev/full", W_OK) != 0) GTEST_SKIP() << "There is no /dev/full here.";
  // A full disk, reached through a name that tells the format.
  std::filesystem::create_symlink("/dev/full", folder_.file("full.map"));
  expect_complaint({"convert", map_, folder_.file("full.map")}, {"No space left"});
  EXPECT_EQ(whole_file(old), "old");
}

TEST_F(Convert, aMapThatChangedOnDiskIsSeen) {
  const std::string json =
      folder_.with("s.json",
                   "{\"replan\": 1, \"map\": {\"file\": \"a.map\"}, \"start\": [0, 0], \"goal\": "
                   "[3, 2], \"planners\": [{\"id\": \"astar\"}]}");
  EXPECT_EQ(run_program({"run", json}).code, 0);
  folder_.with("a.map", "type octile\nheight 2\nwidth 4\nmap\n....\n....\n");
  expect_complaint({"run", json}, {json + ":1: goal: (3, 2) is outside the map"});
  folder_.with("a.map", "type octile\nheight 2\n");
  expect_complaint({"run", json}, {"a.map:2: the file ends before the line 'map'"});
  std::filesystem::remove(map_);
  expect_complaint({"run", json}, {"a.map", "No such file"});
}

}  // namespace
}  // namespace replan::test::convert_test
