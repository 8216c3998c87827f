// What a folder of results holds, and what the files of batches are.
#include "core/experiment/held_results.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "tests/support/experiments.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::held_results_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExperiment =
    R"({"format": "replan experiment", "version": 1, "name": "Room", "worlds": ["room.map.scen"],
        "planners": [{"id": "astar"}, {"id": "rrt"}], "seeds": [1, 2, 3]})";

class HeldResultsTest : public ::testing::Test {
 protected:
  HeldResultsTest() {
    folder_.with("room.map", test::kRoomMap);
    folder_.with("room.map.scen", test::kRoomProblems);
    file_ = folder_.with("room.json", kExperiment);
  }

  [[nodiscard]] RunList list() const { return *RunList::load(*read_experiment(file_)); }
  /// Keeps so many runs of a part in that folder.
  void make(const std::string& folder, std::size_t runs, const Shard& shard = {}) {
    const RunList all = list();
    auto results = ResultsFolder::open(folder, all, shard);
    ASSERT_TRUE(results) << results.error();
    std::vector<std::int64_t> numbers = results->missing();
    numbers.resize(std::min(numbers.size(), runs));
    for (const RunResult& each : test::results_of(all, numbers)) ASSERT_TRUE(results->add(each));
    if (results->missing().empty()) {
      ASSERT_TRUE(results->write_results());
    }
  }

  test::TemporaryFolder folder_;
  std::string file_;
};

TEST_F(HeldResultsTest, AreNoneWhereThereIsNoBatch) {
  const auto held = held_results(folder_.path());
  ASSERT_TRUE(held) << held.error();
  EXPECT_FALSE(*held);
  EXPECT_FALSE(*held_results(folder_.file("not there")));
}

TEST_F(HeldResultsTest, SayHowManyRunsAreDoneAndWhereTheirExperimentIs) {
  const std::string folder = folder_.file("out");
  make(folder, 5);
  for (const std::string& given : {folder, folder + "/"}) {
    const auto held = held_results(given);
    ASSERT_TRUE(held) << held.error();
    ASSERT_TRUE(*held);
    EXPECT_EQ((*held)->name, "Room");
    EXPECT_EQ((*held)->done, 5);
    EXPECT_EQ((*held)->runs, list().count());
    EXPECT_TRUE((*held)->whole());
    EXPECT_FALSE((*held)->complete());
    EXPECT_TRUE(fs::equivalent((*held)->file, file_)) << (*held)->file;
  }
  make(folder, 1000);
  EXPECT_TRUE((*held_results(folder))->complete());
}

TEST_F(HeldResultsTest, DoNotCountALineThatWasCutOff) {
  make(folder_.file("out"), 3);
  const auto journal = read_file(folder_.file("out/runs.jsonl"));
  ASSERT_TRUE(write_file_atomically(folder_.file("out/runs.jsonl"), journal->substr(0, journal->size() - 4)));
  EXPECT_EQ((*held_results(folder_.file("out")))->done, 2);
}

TEST_F(HeldResultsTest, OfAPartTellThePart) {
  const Shard shard{1, 4};
  make(folder_.file("part"), 1000, shard);
  const auto held = held_results(folder_.file("part"));
  ASSERT_TRUE(held && *held);
  EXPECT_EQ((*held)->shard, shard);
  EXPECT_FALSE((*held)->whole());
  std::int64_t runs = 0;
  for (std::int64_t run = 0; run < list().count(); ++run) runs += shard.has(run) ? 1 : 0;
  EXPECT_EQ((*held)->runs, runs);
  EXPECT_TRUE((*held)->complete());
}

TEST_F(HeldResultsTest, DoNotTakeAnotherExperimentForTheirs) {
  make(folder_.file("out"), 2);
  folder_.with("room.json",
               std::string(kExperiment).replace(std::string(kExperiment).find("[1, 2, 3]"), 9, "[1, 2]"));
  const auto held = held_results(folder_.file("out"));
  ASSERT_TRUE(held && *held);
  EXPECT_EQ((*held)->file, "");
}

TEST_F(HeldResultsTest, OfABatchThatCannotBeReadSayWhy) {
  folder_.with("batch.json", R"({"format": "something else"})");
  const auto held = held_results(folder_.path());
  ASSERT_FALSE(held);
  EXPECT_NE(held.error().find("batch.json"), std::string::npos) << held.error();
}

TEST_F(HeldResultsTest, FilesOfBatchesAreKnownByTheirWords) {
  make(folder_.file("out"), 1000);
  EXPECT_EQ(batch_paper(file_), BatchPaper::experiment);
  EXPECT_EQ(batch_paper(folder_.file("out/batch.json")), BatchPaper::results);
  EXPECT_EQ(batch_paper(folder_.file("out/results.json")), BatchPaper::results);
  EXPECT_EQ(batch_paper(folder_.file("room.map")), BatchPaper::none);
  EXPECT_EQ(batch_paper(folder_.file("not there.json")), BatchPaper::none);
  EXPECT_EQ(batch_paper(folder_.path()), BatchPaper::none);
  // An experiment with an error is one all the same; a scenario of that name is none.
  EXPECT_EQ(batch_paper(folder_.with("wrong.json", R"({"planners": 3, "format": "replan experiment"})")),
            BatchPaper::experiment);
  EXPECT_EQ(batch_paper(folder_.with("world.json", R"({"replan": 1, "name": "\"replan experiment\""})")),
            BatchPaper::none);
  EXPECT_EQ(batch_paper(folder_.with("named.json", R"({"replan": 1, "name": "replan experiment"})")),
            BatchPaper::none);
  EXPECT_EQ(batch_paper(folder_.with("broken.json", R"({"format": "replan experiment")")), BatchPaper::none);
}

}  // namespace
}  // namespace replan::held_results_test
