// Experiments as a user runs them: kept through a kill and an interrupt, in parts, compared.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "tests/cli/child.hpp"

namespace replan::test::experiment_test {
namespace {

using nlohmann::json;

/// An open field as large as one run takes some milliseconds on.
std::string field_map() {
  std::string map = "type octile\nheight 200\nwidth 200\nmap\n";
  for (int y = 0; y < 200; ++y) map += std::string(200, '.') + "\n";
  return map;
}

class ExperimentCommand : public ::testing::Test {
 protected:
  ExperimentCommand() {
    folder_.with("field.map", field_map());
    std::string problems = "version 1\n";
    for (int i = 0; i < 60; ++i)
      problems += "0\tfield.map\t200\t200\t0\t0\t199\t" + std::to_string(i) + "\t" +
                  std::to_string(199 + i * 0.414213562373095) + "\n";
    folder_.with("field.map.scen", problems);
    experiment_ =
        with_planners(R"({"id": "dijkstra"}, {"id": "weighted-astar", "settings": {"weight": [1, 2]}})");
  }

  [[nodiscard]] std::string with_planners(const std::string& planners,
                                          const std::string& name = "e.json") const {
    return folder_.with(name, R"({"format": "replan experiment", "version": 1, "worlds": ["field.map.scen"],
                                  "planners": [)" +
                                  planners + "]}");
  }
  [[nodiscard]] std::string results(const std::string& name, const std::string& file = "results.csv") const {
    return whole_file(folder_.file(name + "/" + file));
  }
  [[nodiscard]] Outcome run(const std::string& name, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"batch", experiment_, "--out", folder_.file(name)});
    return run_program(more);
  }
  /// Begins the batch, sends the signal once some runs are done, and returns how it ended.
  [[nodiscard]] int run_until(const std::string& name, int signal) const {
    const int out = open("/dev/null", O_WRONLY),
              err = open(folder_.file("err").c_str(), O_WRONLY | O_CREAT, 0600);
    const pid_t child = fork();
    if (child == 0)
      become_program({"batch", experiment_, "--out", folder_.file(name), "--jobs", "2"}, out, err);
    close(out);
    close(err);
    const std::string journal = folder_.file(name + "/runs.jsonl");
    for (int i = 0; i < 2000 && whole_file(journal).size() < 2000; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    return exit_code(status);
  }

  TemporaryFolder folder_;
  std::string experiment_;
};

TEST_F(ExperimentCommand, goesOnAfterAKillToTheSameBytes) {
  ASSERT_EQ(run("whole").code, 0);
  EXPECT_EQ(run_until("killed", SIGKILL), 128 + SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("killed/results.csv")));
  const std::string kept = results("killed", "runs.jsonl");
  const Outcome again = run("killed", {"--jobs", "3"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.err, "") << "no progress in a pipe";
  EXPECT_TRUE(results("killed", "runs.jsonl").starts_with(kept.substr(0, kept.rfind('\n') + 1)))
      << "what was done is not done again";
  for (const char* file : {"results.csv", "results.json"})
    EXPECT_EQ(results("killed", file), results("whole", file)) << file;
  EXPECT_EQ(results("whole", "times.csv").substr(0, 19), "run,times,plan_ms,p");
}

TEST_F(ExperimentCommand, stopsAtAnInterruptAndSaysHowToGoOn) {
  EXPECT_EQ(run_until("stopped", SIGINT), 130);
  const std::string said = whole_file(folder_.file("err"));
  EXPECT_NE(said.find(" to go; the same command goes on"), std::string::npos) << said;
  EXPECT_EQ(run("stopped").code, 0);
  ASSERT_EQ(run("whole").code, 0);
  EXPECT_EQ(results("stopped"), results("whole"));
}

TEST_F(ExperimentCommand, isPutTogetherFromParts) {
  ASSERT_EQ(run("whole").code, 0);
  ASSERT_EQ(run("a", {"--shard", "1/2"}).code, 0);
  expect_complaint({"merge", folder_.file("a"), "-o", folder_.file("sum")},
                   {"runs are missing: 1, 3, 5", "--shard"});
  ASSERT_EQ(run("b", {"--shard", "2/2"}).code, 0);
  const Outcome merged =
      run_program({"merge", folder_.file("b"), folder_.file("a"), "-o", folder_.file("sum")});
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_NE(merged.out.find("180 runs of 2 parts"), std::string::npos) << merged.out;
  EXPECT_EQ(results("sum"), results("whole"));
  EXPECT_EQ(results("sum", "results.json"), results("whole", "results.json"));
  expect_complaint({"batch", experiment_, "--shard", "3/2", "--out", folder_.file("c")},
                   {"--shard cannot be '3/2'"});
  expect_complaint({"batch", experiment_, "--shard", "1/2"}, {"--out DIR"});
  expect_complaint({"batch", experiment_, "--out", folder_.file("a"), "--shard", "2/2"}, {"part 1 of 2"});
  expect_complaint({"batch", experiment_, "--planner", "astar"}, {"--planner goes with files of problems"});
}

TEST_F(ExperimentCommand, writesARunAsAScenario) {
  const std::string file = folder_.file("run.json");
  ASSERT_EQ(run_program({"batch", experiment_, "--scenario", "130", "-o", file}).code, 0);
  const json scenario = json::parse(whole_file(file));
  EXPECT_EQ(scenario["planners"][0]["id"], "weighted-astar");
  EXPECT_EQ(scenario["planners"][0]["settings"]["weight"], 2);
  EXPECT_EQ(scenario["goal"], json({199, 10}));
  EXPECT_EQ(run_program({"run", file}).code, 0);
  expect_complaint({"batch", experiment_, "--scenario", "180", "-o", file}, {"from 0 to 179"});
}

TEST_F(ExperimentCommand, opensARunThatThereIs) {
  expect_complaint({"batch", experiment_, "--open", "180"}, {"--open cannot be '180'", "from 0 to 179"});
  expect_complaint({"batch", experiment_, "--open", "-1"}, {"--open cannot be '-1'", "from 0 to 179"});
  expect_complaint({"batch", experiment_, "--open", "1", "--scenario", "1"}, {"--open", "--scenario"});
  expect_complaint({"batch", experiment_, "--open", "1", "-o", folder_.file("run.json")}, {"--open", "-o"});
}

TEST_F(ExperimentCommand, comparesTwoResults) {
  ASSERT_EQ(run("before").code, 0);
  ASSERT_EQ(run("after").code, 0);
  const Outcome same =
      run_program({"compare", folder_.file("before"), folder_.file("after"), "--fail-on-loss"});
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_NE(same.out.find("180 runs in both"), std::string::npos) << same.out;
  EXPECT_EQ(same.out.find("WORSE"), std::string::npos) << same.out;
  // The same results, but one planner expands twice as much.
  json worse = json::parse(results("after", "results.json"));
  for (json& one : worse["runs"])
    if (one["planner"] == "dijkstra") one["expansions"] = 2 * one["expansions"].get<int>();
  const std::string file = folder_.with("worse.json", worse.dump());
  const std::string before = folder_.file("before/results.json");
  const Outcome lost = run_program({"compare", before, file, "--fail-on-loss"});
  EXPECT_EQ(lost.code, 1);
  EXPECT_NE(lost.out.find("WORSE"), std::string::npos) << lost.out;
  EXPECT_EQ(run_program({"compare", before, file}).code, 0);
  EXPECT_EQ(run_program({"compare", before, file, "--fail-on-loss", "--tolerate", "150"}).code, 0);
  EXPECT_EQ(run_program({"compare", file, before, "--fail-on-loss"}).code, 0) << "better is no loss";
  const json rows = run_program({"compare", before, file, "--json"}).json()["rows"];
  EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const json& row) {
    return row["figure"] == "expansions" && row["verdict"] == "worse" && row["median_ratio"] == 2;
  }));
  const Outcome times =
      run_program({"compare", folder_.file("before"), folder_.file("after"), "--times", "--all"});
  EXPECT_NE(times.out.find("plan_ms"), std::string::npos) << times.out;
  expect_complaint({"compare", before, file, "--times"}, {"needs folders"});
  expect_complaint({"compare", before, experiment_}, {"not results of a batch"});
  expect_complaint({"compare", before, file, "--alpha", "2"}, {"--alpha cannot be '2'"});
}

}  // namespace
}  // namespace replan::test::experiment_test
