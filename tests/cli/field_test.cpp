// Files as they come in the field, through the program: what is guessed is told, on stderr where stdout is
// data.
#include "core/world/map_file.hpp"
#include "core/world/scenario.hpp"
#include "tests/cli/child.hpp"

namespace replan::test::field_test {
namespace {

using Arguments = std::vector<std::string>;

class FieldFiles : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string spaced_ = folder_.with("spaced.txt", "S 0 0\n1 1 1\nG 0 0\n");
  std::string parted_ = "every second column is blank, so blanks part the cells: 3 x 3 of them\n";

  /// A ROS map of one row: free, two unknown cells, free.
  std::string ros_map() const {
    folder_.with("u.pgm", std::string("P5\n4 1\n255\n\xFE\xCD\xCD\xFE", 15));
    return folder_.with("u.yaml",
                        "image: u.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: no\noccupied_thresh: 0.65\n"
                        "free_thresh: 0.196\nmode: Trinary\n");
  }
};

TEST_F(FieldFiles, whatPartsTheCellsIsTold) {
  const Outcome run = run_program({"run", "--map", spaced_, "--planner", "astar", "--json"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.json()["runs"][0]["status"], "no-path");
  EXPECT_EQ(run.err, "note: " + spaced_ + ": " + parted_);
  const Outcome show = run_program({"show", "--map", spaced_, "--planner", "astar"});
  EXPECT_EQ(show.err, run.err);
  const std::string json =
      folder_.with("s.json",
                   "{\"replan\": 1, \"map\": {\"file\": \"spaced.txt\"}, \"start\": [0, 0], "
                   "\"goal\": [2, 0], \"planners\": [{\"id\": \"astar\"}]}");
  EXPECT_NE(run_program({"run", json}).err.find(parted_), std::string::npos) << "a scenario's map file too";
  const Outcome convert = run_program({"convert", spaced_, folder_.file("o.map")});
  EXPECT_NE(convert.out.find("note: " + spaced_ + ": " + parted_), std::string::npos);
  EXPECT_EQ(whole_file(folder_.file("o.map")), "type octile\nheight 3\nwidth 3\nmap\n...\n@@@\n...\n");
}

TEST_F(FieldFiles, occupiedIsKnownToEveryCommandThatReadsAMap) {
  const std::string matrix = folder_.with("m.txt", "2 1 0\n2 2 0\n");
  const Arguments ends = {"--start", "1,0", "--goal", "2,1", "--planner", "astar"};
  const auto with_ends = [&](Arguments arguments) {
    arguments.insert(arguments.end(), ends.begin(), ends.end());
    return arguments;
  };
  EXPECT_EQ(run_program(with_ends({"run", "--map", matrix, "--occupied", "2"})).code, 0);
  EXPECT_EQ(run_program(with_ends({"show", "--map", matrix, "--occupied", "2"})).code, 0);
  EXPECT_EQ(
      run_program(with_ends({"render", "--map", matrix, "--occupied", "2", "-o", folder_.file("a.svg")}))
          .code,
      0);
  expect_complaint(with_ends({"run", "--map", matrix}), {matrix, "numbers 0, 1 and 2", "--occupied VALUE"});
  const std::string out = folder_.file("o.txt");
  EXPECT_EQ(run_program({"convert", matrix, out, "--occupied", "1"}).code, 0);
  EXPECT_EQ(whole_file(out), ".@.\n...\n");
  const std::string scen = folder_.with("p.scen", "version 1\n0\tm.txt\t3\t2\t1\t0\t2\t1\t2.00000000\n");
  EXPECT_EQ(run_program({"batch", scen, "--planner", "astar", "--occupied", "2"}).code, 0);
  expect_complaint({"convert", matrix, out, "--occupied", "two"}, {"--occupied cannot be 'two'"});
  expect_complaint({"convert", ros_map(), out, "--occupied", "2"}, {"only in a file of numbers"});
}

TEST_F(FieldFiles, anUnknownStartIsCalledUnknown) {
  const Arguments ends = {"--start", "1,0", "--goal", "3,0", "--planner", "astar"};
  Arguments run = {"run", "--map", ros_map()};
  run.insert(run.end(), ends.begin(), ends.end());
  const Outcome blocked = run_program(run);
  EXPECT_EQ(blocked.code, 1);
  EXPECT_NE(blocked.out.find("The start is unknown on the map"), std::string::npos) << blocked.out;
  EXPECT_NE(blocked.out.find("--unknown free"), std::string::npos);
  run.insert(run.end(), {"--unknown", "free"});
  EXPECT_EQ(run_program(run).code, 0);
}

TEST_F(FieldFiles, unknownCellsAreKeptOrTold) {
  const std::string yaml = ros_map();
  for (const auto& [unknown, become] :
       {std::pair{"blocked", "obstacles"}, {"free", "free cells"}, {"unmapped", "unmapped obstacles"}}) {
    const std::string out = folder_.file("o.yaml"), text = folder_.file("o.txt"),
                      json = folder_.file("o.json");
    EXPECT_EQ(
        run_program({"convert", yaml, out, "--unknown", unknown}).out,
        "wrote " + out + ": 4 x 1 cells, " + (unknown == std::string("free") ? "0" : "2") + " obstacles\n");
    EXPECT_EQ(whole_file(folder_.file("o.pgm")), whole_file(folder_.file("u.pgm")));
    const std::string note =
        " cannot hold that 2 cells are unknown on the map: there they are " + std::string(become);
    EXPECT_NE(run_program({"convert", yaml, text, "--unknown", unknown}).out.find("note: .txt" + note),
              std::string::npos);
    EXPECT_NE(run_program({"convert", yaml, json, "--unknown", unknown, "--start", "0,0", "--goal", "3,0"})
                  .out.find("note: .json" + note),
              std::string::npos);
  }
  const std::string named =
      folder_.with("n.json",
                   "{\"replan\": 1, \"map\": {\"file\": \"u.yaml\"}, \"start\": [0, 0], \"goal\": [3, 0], "
                   "\"planners\": [{\"id\": \"astar\"}]}");
  EXPECT_EQ(run_program({"convert", named, folder_.file("n.yaml")}).code, 0);
  EXPECT_EQ(whole_file(folder_.file("n.pgm")), whole_file(folder_.file("u.pgm"))) << "through a scenario too";
}

TEST_F(FieldFiles, aMapsNameMayHoldBlanks) {
  const std::string map = folder_.with("two words.map", "type octile\nheight 1\nwidth 3\nmap\n...\n");
  const std::string scen = folder_.file("two words.map.scen");
  EXPECT_EQ(run_program({"convert", map, scen, "--start", "0,0", "--goal", "2,0"}).code, 0);
  EXPECT_EQ(whole_file(scen), "version 1\n0\ttwo words.map\t3\t1\t0\t0\t2\t0\t2.00000000\n");
  EXPECT_EQ(run_program({"batch", scen, "--planner", "astar"}).code, 0);
}

}  // namespace
}  // namespace replan::test::field_test
