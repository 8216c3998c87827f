// Folders of results: what survives, what is refused; parts put together; results held against each other.
#include "core/experiment/results_folder.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/experiment/compare_results.hpp"
#include "tests/support/experiments.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::results_folder_test {
namespace {

using test::kRoomMap;
using test::kRoomProblems;
using test::results_of;

constexpr const char* kKeys =
    R"({"format": "replan experiment", "version": 1, "worlds": ["room.map.scen"],
        "planners": [{"id": "astar"}, {"id": "rrt"}], "seeds": [1, 2, 3]})";

std::string bytes_of(const std::string& path) {
  const auto bytes = read_file(path);
  return bytes ? *bytes : bytes.error();
}

class ResultsFolders : public ::testing::Test {
 protected:
  ResultsFolders() {
    folder_.with("room.map", kRoomMap);
    folder_.with("room.map.scen", kRoomProblems);
  }

  [[nodiscard]] RunList list(const std::string& text = kKeys) const {
    auto read = parse_experiment(text, "x.json", folder_.path());
    auto loaded = RunList::load(std::move(read.value()));
    return std::move(loaded.value());
  }
  /// Makes what is missing there, but no more than `most` runs.
  void make(const std::string& name, const Shard& shard = {}, std::size_t most = 1000) const {
    const RunList runs = list();
    auto opened = ResultsFolder::open(folder_.file(name), runs, shard);
    ASSERT_TRUE(opened) << opened.error();
    auto missing = opened->missing();
    if (missing.size() > most) missing.resize(most);
    for (RunResult& result : results_of(runs, missing)) ASSERT_TRUE(opened->add(std::move(result)));
    ASSERT_TRUE(opened->write_results());
  }
  [[nodiscard]] std::string bytes(const std::string& name) const { return bytes_of(folder_.file(name)); }

  test::TemporaryFolder folder_;
};

TEST_F(ResultsFolders, GoOnWhereTheyWereAndDropATornLine) {
  make("whole");
  make("halted", {}, 5);
  const std::string journal = folder_.file("halted/runs.jsonl");
  std::ofstream(journal, std::ios::app) << R"({"run": 5, "world": "room)";
  {
    const RunList runs = list();
    const auto opened = ResultsFolder::open(folder_.file("halted"), runs, {});
    ASSERT_TRUE(opened) << opened.error();
    EXPECT_EQ(opened->done(), 5u);
    EXPECT_EQ(opened->missing().front(), 5);
  }
  EXPECT_EQ(bytes("halted/runs.jsonl").find("{\"run\": 5"), std::string::npos);
  make("halted");
  for (const char* file : {"/results.csv", "/results.json"})
    EXPECT_EQ(bytes(std::string("halted") + file), bytes(std::string("whole") + file)) << file;
}

TEST_F(ResultsFolders, SayWhichLineIsNoResult) {
  make("broken", {}, 2);
  std::ofstream(folder_.file("broken/runs.jsonl"), std::ios::app) << "nonsense\n";
  const RunList runs = list();
  const auto opened = ResultsFolder::open(folder_.file("broken"), runs, {});
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().find("line 3 of '"), std::string::npos) << opened.error();
}

TEST_F(ResultsFolders, RefuseAnotherExperimentAChangedMapAnotherPartAndAnotherProcess) {
  make("kept");
  const auto refused = [&](const RunList& runs, const Shard& shard) {
    const auto opened = ResultsFolder::open(folder_.file("kept"), runs, shard);
    return opened ? "" : opened.error();
  };
  const std::string other = "has results of another experiment";
  EXPECT_NE(refused(list(R"({"format": "replan experiment", "version": 1, "worlds": ["room.map.scen"],
                             "planners": [{"id": "astar"}]})"),
                    {})
                .find(other),
            std::string::npos);
  EXPECT_NE(refused(list(), {0, 2}).find("part 1 of 1"), std::string::npos);
  {
    const RunList runs = list();
    const auto first = ResultsFolder::open(folder_.file("kept"), runs, {});
    ASSERT_TRUE(first);
    EXPECT_NE(refused(runs, {}).find("another process is at work"), std::string::npos);
  }
  EXPECT_EQ(refused(list(), {}), "");
  std::string map = kRoomMap;
  map[map.find('@')] = '.';
  folder_.with("room.map", map);
  EXPECT_NE(refused(list(), {}).find(other), std::string::npos);
}

TEST_F(ResultsFolders, SayWhyTheyCannotBeLocked) {
  std::filesystem::create_directories(folder_.file("odd/lock"));
  const RunList runs = list();
  const auto opened = ResultsFolder::open(folder_.file("odd"), runs, {});
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().find("its file 'lock' cannot be made: Is a directory; give a folder"),
            std::string::npos)
      << opened.error();
  EXPECT_EQ(opened.error().find("another process"), std::string::npos) << opened.error();
}

/// As an older version wrote it.
std::string without_newer_columns(std::string text) {
  for (const ResultColumn& column : result_columns()) {
    if (!column.newer) continue;
    const std::string key = ",\"" + std::string(column.name) + "\":";
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key))
      text.erase(at, text.find_first_of(",}", at + key.size()) - at);
  }
  return text;
}

TEST_F(ResultsFolders, OfAnOlderVersionAreReadWithoutItsColumns) {
  make("old");
  const std::string journal = bytes("old/runs.jsonl"), older = without_newer_columns(journal);
  ASSERT_NE(older, journal);
  std::ofstream(folder_.file("old/runs.jsonl")) << older;
  const auto kept = read_results_folder(folder_.file("old"));
  ASSERT_TRUE(kept) << kept.error();
  ASSERT_FALSE(kept->results.empty());
  for (const RunResult& result : kept->results) EXPECT_FALSE(result.figure("surprises_noticed"));
  const std::string json = without_newer_columns(bytes("old/results.json"));
  ASSERT_TRUE(parse_results(json, "old.json")) << parse_results(json, "old.json").error();
  const auto merged = merge_results(std::vector<std::string>{folder_.file("old")}, folder_.file("merged"));
  ASSERT_TRUE(merged) << merged.error();
  EXPECT_EQ(*merged, kept->results.size());
  std::string without_another = older;
  without_another.erase(without_another.find(",\"turns\":"), 13);
  std::ofstream(folder_.file("old/runs.jsonl")) << without_another;
  EXPECT_FALSE(read_results_folder(folder_.file("old"))) << "columns that have always been there";
}

TEST_F(ResultsFolders, AreWrittenBesideTheOldFilesAndReadBackRunByRun) {
  make("kept", {}, 5);
  const std::string before = bytes("kept/results.csv");
  const RunList runs = list();
  const auto opened = ResultsFolder::open(folder_.file("kept"), runs, {});
  ASSERT_TRUE(opened) << opened.error();
  std::vector<std::int64_t> shown;
  ASSERT_TRUE(opened->write_results([&](const RunResult& result) {
    shown.push_back(result.run);
    EXPECT_EQ(bytes("kept/results.csv"), before) << "until all is written";
  }));
  EXPECT_EQ(shown, (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
  std::filesystem::remove(folder_.file("kept/times.csv"));
  std::filesystem::create_directories(folder_.file("kept/times.csv"));
  const auto refused = opened->write_results();
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("it is a folder"), std::string::npos) << refused.error();
  EXPECT_EQ(bytes("kept/results.csv"), before);
  for (const auto& entry : std::filesystem::directory_iterator(folder_.file("kept")))
    EXPECT_EQ(entry.path().filename().string().find('-'), std::string::npos) << "nothing is left beside them";
}

TEST_F(ResultsFolders, ReadLinesOfAnyLengthInTheOrderOfTheirRuns) {
  const RunList runs = list();
  std::vector<RunResult> results = results_of(runs);
  std::reverse(results.begin(), results.end());
  // Longer than what is read at a time, and lines that lie across its bounds.
  results.front().plan_ms.assign(10'000, 0.123456789012345);
  results[2].plan_ms.assign(10'000, 0.987654321098765);
  results[2].replan_ms.assign(10'000, 1.98765432109876);
  {
    auto opened = ResultsFolder::open(folder_.file("long"), runs, {});
    ASSERT_TRUE(opened) << opened.error();
    for (const RunResult& result : results) ASSERT_TRUE(opened->add(result));
  }
  const auto again = ResultsFolder::open(folder_.file("long"), runs, {});
  ASSERT_TRUE(again) << again.error();
  EXPECT_TRUE(again->missing().empty());
  std::reverse(results.begin(), results.end());
  std::vector<RunResult> read;
  ASSERT_TRUE(again->each([&](const RunResult& result) { read.push_back(result); }));
  EXPECT_EQ(read, results);
}

TEST_F(ResultsFolders, AreMergedToTheSameBytesAndTellWhatIsMissingOrDoubled) {
  make("whole");
  make("first", {0, 3});
  make("second", {1, 3});
  make("third", {2, 3});
  const auto merge = [&](std::vector<std::string> names, const std::string& out) {
    for (std::string& name : names) name = folder_.file(name);
    const auto merged = merge_results(names, folder_.file(out));
    return merged ? "" : merged.error();
  };
  EXPECT_NE(merge({"first", "third"}, "gap").find("runs are missing: 1, 4, 7, 10, 13"), std::string::npos);
  EXPECT_NE(merge({"first", "second", "first", "third"}, "gap").find("runs are there twice: 0, 3, 6"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("gap/results.csv")));
  EXPECT_EQ(merge({"third", "first", "second"}, "merged"), "");
  for (const char* file : {"/results.csv", "/results.json", "/batch.json"})
    EXPECT_EQ(bytes(std::string("merged") + file), bytes(std::string("whole") + file)) << file;
  EXPECT_NE(merge({"first"}, "merged").find("has results already"), std::string::npos);
}

TEST_F(ResultsFolders, HaveOneFieldForEachColumnWhateverIsInAName) {
  RunResult odd;
  odd.name.world = "a, \"b\".map";
  odd.status = "found";
  const std::string text = results_csv(std::vector<RunResult>{odd});
  EXPECT_NE(text.find(",\"a, \"\"b\"\".map\","), std::string::npos) << text;
  EXPECT_EQ(text.find("run,world,problem_line,start,goal,planner,"), 0u);
}

TEST(NumbersText, TellsStretches) {
  EXPECT_EQ(numbers_text(std::vector<std::int64_t>{1, 2, 3, 7}), "1-3, 7");
  std::vector<std::int64_t> many;
  for (int i = 0; i < 40; i += 2) many.push_back(i);
  EXPECT_EQ(numbers_text(many), "0, 2, 4, 6, 8, 10, 12, 14 and 12 more");
}

/// Twelve runs of two planners, with expansions and lengths that are told to each.
std::vector<RunResult> made_up(double expansions, double length, int failures) {
  std::vector<RunResult> results;
  std::size_t at_expansions = 0, at_length = 0;
  for (std::size_t i = 0; i < result_columns().size(); ++i) {
    if (result_columns()[i].name == "expansions") at_expansions = i;
    if (result_columns()[i].name == "length_cells") at_length = i;
  }
  for (int i = 0; i < 24; ++i) {
    RunResult run;
    run.run = i;
    run.name = {.world = "w", .line = i % 12, .planner = i < 12 ? "astar" : "jps"};
    run.succeeded = i >= failures;
    run.status = run.succeeded ? "found" : "no-path";
    run.figures.resize(result_columns().size());
    run.figures[at_expansions] = 100 + i * (i < 12 ? expansions : 1);
    run.figures[at_length] = i < 12 ? length : 10;
    results.push_back(std::move(run));
  }
  return results;
}

const ComparedFigure& row_of(const Comparison& comparison, const std::string& planner,
                             const std::string& figure) {
  for (const ComparedFigure& row : comparison.rows)
    if (row.planner == planner && row.figure == figure) return row;
  ADD_FAILURE() << planner << " " << figure;
  return comparison.rows.front();
}

TEST(CompareResults, TellsBetterFromWorseAndFromTheSame) {
  const auto comparison = compare_results(made_up(2, 10, 0), made_up(3, 9, 0));
  EXPECT_EQ(comparison.pairs, 24);
  const ComparedFigure& expansions = row_of(comparison, "astar", "expansions");
  EXPECT_EQ(expansions.verdict, Trend::worse);
  EXPECT_EQ(expansions.worsened, 11);
  EXPECT_EQ(expansions.effect, 1);
  EXPECT_NEAR(expansions.p, 2 / 2048.0, 1e-12);
  EXPECT_NEAR(expansions.corrected, 2 / 2048.0, 1e-12) << "the less certain of two rows that differ";
  EXPECT_GT(expansions.loss().value_or(0), 0.04);
  EXPECT_LE(expansions.interval->low, *expansions.ratio);
  EXPECT_GE(expansions.interval->high, *expansions.ratio);
  const ComparedFigure& length = row_of(comparison, "astar", "length_cells");
  EXPECT_EQ(length.verdict, Trend::better);
  EXPECT_NEAR(length.corrected, 2 * 2 / 4096.0, 1e-12) << "the more certain one, for two";
  EXPECT_NEAR(*length.ratio, 0.9, 1e-12);
  EXPECT_FALSE(length.loss());
  EXPECT_EQ(row_of(comparison, "jps", "expansions").verdict, Trend::unchanged);
  const auto other_way = compare_results(made_up(3, 9, 0), made_up(2, 10, 0));
  EXPECT_EQ(row_of(other_way, "astar", "expansions").verdict, Trend::better);
}

TEST(CompareResults, CountsRunsThatSucceedByThemselves) {
  const auto comparison = compare_results(made_up(2, 10, 0), made_up(2, 10, 10));
  const ComparedFigure& row = row_of(comparison, "astar", "succeeded");
  EXPECT_EQ(row.worsened, 10);
  EXPECT_NEAR(row.p, 2 / 1024.0, 1e-12);
  EXPECT_EQ(row.verdict, Trend::worse);
  EXPECT_FALSE(row.interval) << "there is one ratio alone";
  EXPECT_EQ(row_of(comparison, "astar", "length_cells").pairs, 2) << "only where both succeeded";
}

TEST(CompareResults, PairsByNamesAndNotByNumbers) {
  auto after = made_up(2, 10, 0);
  std::reverse(after.begin(), after.end());
  for (std::size_t i = 0; i < after.size(); ++i) after[i].run = static_cast<std::int64_t>(i);
  after.pop_back();
  const auto comparison = compare_results(made_up(2, 10, 0), after);
  EXPECT_EQ(comparison.pairs, 23);
  EXPECT_EQ(comparison.only_before, 1);
  for (const ComparedFigure& row : comparison.rows) EXPECT_EQ(row.improved + row.worsened, 0) << row.figure;
}

TEST(CompareResults, PairsAPlannerWithItsOtherSettings) {
  auto before = made_up(2, 10, 0), after = before;
  std::erase_if(before, [](const RunResult& run) { return run.name.planner != "astar"; });
  after = before;
  for (RunResult& run : after) run.name.settings = "weight=3";
  EXPECT_EQ(compare_results(before, after).pairs, 0);
  ASSERT_TRUE(forget_settings(before).ok());
  ASSERT_TRUE(forget_settings(after).ok());
  EXPECT_EQ(compare_results(before, after).pairs, static_cast<std::int64_t>(before.size()));
  before.push_back(before.front());
  EXPECT_NE(forget_settings(before).error().find("with several settings"), std::string::npos);
}

}  // namespace
}  // namespace replan::results_folder_test
