// The contract of 'replan study'.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/child.hpp"

namespace replan::test::study_command_test {
namespace {

/// Whole pictures and diagrams of one study, and a page.
TEST(StudyCommand, LeavesAReportInItsFolder) {
  const TemporaryFolder folder;
  const std::string out = folder.file("results");
  const Outcome outcome = run_program({"study", "astar-table1", "--seeds", "1", "--out", out});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("## What the paper claims"), std::string::npos) << outcome.out;
  EXPECT_EQ(whole_file(out + "/astar-table1.md"), outcome.out);
  EXPECT_TRUE(
      whole_file(out + "/astar-table1.csv").starts_with("world,planner,seed,found,nodes,length [cells],"));
  EXPECT_EQ(nlohmann::json::parse(whole_file(out + "/astar-table1.json"))["runs"].size(), 60u);
  EXPECT_TRUE(whole_file(out + "/astar-table1-turns.svg").ends_with("</svg>\n\n")) << "gnuplot's";
  EXPECT_TRUE(whole_file(out + "/astar-table1-turns.png").starts_with("\x89PNG"));
  EXPECT_TRUE(whole_file(out + "/astar-table1-paths.png").starts_with("\x89PNG"));
  EXPECT_TRUE(whole_file(out + "/astar-table1-paths-2.svg").ends_with("</svg>\n"));
  const std::string page = whole_file(out + "/report.html");
  EXPECT_NE(page.find("The improved A* against plain A*"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);
  // What the picture shows opens as a scenario.
  EXPECT_EQ(run_program({"run", out + "/astar-table1-paths.json"}).code, 0);
}

/// Without gnuplot all else is there, and it says what is missing.
TEST(StudyCommand, DoesWithoutGnuplot) {
  const TemporaryFolder folder, empty;
  const std::string out = folder.file("results");
  const std::string before = std::getenv("PATH");
  setenv("PATH", empty.path().c_str(), 1);
  const Outcome outcome = run_program({"study", "astar-table1", "--seeds", "1", "--out", out});
  setenv("PATH", before.c_str(), 1);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("gnuplot is not installed"), std::string::npos) << outcome.err;
  EXPECT_NE(whole_file(out + "/astar-table1-turns.gp").find("plot "), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out + "/astar-table1-turns.svg"));
  EXPECT_NE(whole_file(out + "/report.html").find("gnuplot is not installed"), std::string::npos);
}

TEST(StudyCommand, PrintsItsRunsForPrograms) {
  const Outcome outcome = run_program({"study", "astar-table1", "--seeds", "1", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["study"], "astar-table1");
  EXPECT_TRUE(json.contains("machine"));
  EXPECT_GE(json["claims"].size(), 4u);
}

TEST(StudyCommand, RefusesWhatItDoesNotKnow) {
  const Outcome name = run_program({"study", "dld-tabel1"});
  EXPECT_EQ(name.code, 2);
  EXPECT_NE(name.err.find("did you mean 'dld-table1'?"), std::string::npos) << name.err;
  const Outcome seeds = run_program({"study", "auv", "--seeds", "0"});
  EXPECT_EQ(seeds.code, 2);
  const Outcome barn = run_program({"study", "fusion", "--seeds", "1", "--barn", "/nowhere"});
  EXPECT_EQ(barn.code, 2);
  EXPECT_NE(barn.err.find("/nowhere"), std::string::npos) << barn.err;
}

}  // namespace
}  // namespace replan::test::study_command_test
