// The contract of 'replan barn': the table, the lines, and what it complains of.
#include <gtest/gtest.h>

#include "tests/cli/child.hpp"

namespace replan::test::barn_test {
namespace {

constexpr const char* kIndex = R"({
  "common": {"resolution": 0.15, "cylinder_radius": 0.075, "start": {"x": 2.25, "y": 3.0, "heading": 1.57},
             "goal": {"x": 2.25, "y": 8.0}, "goal_tolerance": 1.0, "timeout": 100.0},
  "worlds": [{"world": 0, "file": "free.map", "optimal_time": 2.5},
             {"world": 7, "file": "wall.map", "optimal_time": 2.5}]})";

/// 30 x 60 cells; with a wall at half the way that is open at its right end.
std::string map_text(bool wall) {
  std::string text = "type octile\nheight 60\nwidth 30\nmap\n";
  for (int y = 0; y < 60; ++y)
    text += wall && y == 36 ? std::string(20, '@') + "..........\n" : std::string(30, '.') + "\n";
  return text;
}

class BarnCommand : public ::testing::Test {
 protected:
  BarnCommand() {
    folder_.with("index.json", kIndex);
    folder_.with("free.map", map_text(false));
    folder_.with("wall.map", map_text(true));
  }
  TemporaryFolder folder_;
};

TEST_F(BarnCommand, printsATableAndWritesALineForEachDrive) {
  const std::string csv = folder_.file("drives.csv");
  const Outcome outcome = run_program({"barn", folder_.path(), "--global", "none,astar", "--csv", csv});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("| dwa | 2 | "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("| fusion with astar | 2 | 1.000 | 0.000 | 0.000 | "), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("published"), std::string::npos);
  const std::string lines = whole_file(csv);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 5);
  EXPECT_NE(lines.find("\nfusion with astar,7,success,"), std::string::npos) << lines;
}

TEST_F(BarnCommand, drivesTheSameEachTime) {
  const std::vector<std::string> command = {"barn", folder_.path(), "--global", "dstar-lite", "--world", "7"};
  EXPECT_EQ(run_program(command).out, run_program(command).out);
}

TEST_F(BarnCommand, complainsOfWhatItCannotUse) {
  expect_complaint({"barn", folder_.file("none")}, {"index.json"});
  expect_complaint({"barn", folder_.path(), "--world", "3"}, {"no world 3"});
  expect_complaint({"barn", folder_.path(), "--global", "astr"}, {"astr", "astar"});
  expect_complaint({"barn", folder_.path(), "--set", "horizn=2"}, {"horizn", "horizon"});
  expect_complaint({"barn", folder_.path(), "--set", "horizon"}, {"KEY=VALUE"});
  folder_.with("index.json", "{}");
  expect_complaint({"barn", folder_.path()}, {"index.json"});
}

}  // namespace
}  // namespace replan::test::barn_test
