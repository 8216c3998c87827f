// Parts of random experiments, made on any number of threads, give the bytes of the whole.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/base/random.hpp"
#include "core/experiment/results_folder.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/generators/generators.hpp"
#include "tests/support/experiments.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::experiment_property_test {
namespace {

std::string cell_text_of(Random& random, int side) {
  return "[" + std::to_string(random.between(0, side - 1)) + ", " +
         std::to_string(random.between(0, side - 1)) + "]";
}

/// Some planners, robots, worlds, surprises and seeds.
std::string random_experiment(Random& random, const test::TemporaryFolder& folder) {
  constexpr int kSide = 24;
  std::string worlds, planners, robots = R"("own")", surprises = R"("none")";
  const int maps = random.between(1, 3);
  for (int i = 0; i < maps; ++i) {
    const std::string name = "m" + std::to_string(i) + ".map";
    folder.with(name, movingai_map_text(random_cells({kSide, kSide}, 0.2, random.next()).value()));
    worlds += (i > 0 ? "," : "") + std::string(R"({"file": ")") + name + R"(", "start": )" +
              cell_text_of(random, kSide) + R"(, "goal": )" + cell_text_of(random, kSide) + "}";
  }
  const bool drive = random.chance(0.5);
  const std::vector<std::string> all = {R"({"id": "astar"})",
                                        R"({"id": "weighted-astar", "settings": {"weight": [1, 1.5, 3]}})",
                                        R"({"id": "dstar-lite"})",
                                        R"({"id": "theta-star"})",
                                        R"({"id": "rrt-star", "settings": {"samples": [50, 200]}})",
                                        R"({"id": "jps"})"};
  for (const std::string& planner : all)
    if (random.chance(0.5)) planners += (planners.empty() ? "" : ",") + planner;
  if (planners.empty()) planners = all.front();
  if (random.chance(0.5)) robots += R"(, {"knowledge": "nothing"})";
  if (drive && random.chance(0.7)) surprises += R"(, {"blocks": 2, "side": 2, "ahead": 5})";
  return R"({"format": "replan experiment", "version": 1, "drive": )" +
         std::string(drive ? "true" : "false") + R"(, "planners": [)" + planners + R"(], "worlds": [)" +
         worlds + R"(], "robots": [)" + robots + R"(], "surprises": [)" + surprises +
         R"(], "seeds": {"from": 1, "count": )" + std::to_string(random.between(1, 3)) + R"(}, "repeat": )" +
         std::to_string(random.between(1, 2)) + "}";
}

std::string bytes_of(const std::string& path) {
  const auto bytes = read_file(path);
  return bytes ? *bytes : bytes.error();
}

TEST(ExperimentProperty, PartsMergeToTheBytesOfTheWhole) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const test::TemporaryFolder folder;
    const std::string text = random_experiment(random, folder);
    auto experiment = parse_experiment(text, "e.json", folder.path());
    ASSERT_TRUE(experiment) << experiment.error();
    const auto list = RunList::load(std::move(experiment.value()));
    ASSERT_TRUE(list) << list.error();
    const auto make = [&](const std::string& name, const Shard& shard) {
      auto opened = ResultsFolder::open(folder.file(name), *list, shard);
      ASSERT_TRUE(opened) << opened.error();
      const auto jobs = static_cast<std::size_t>(random.between(1, 4));
      for (RunResult& result : test::results_of(*list, opened->missing(), jobs))
        ASSERT_TRUE(opened->add(std::move(result)));
      ASSERT_TRUE(opened->write_results());
    };
    make("whole", {});
    const std::int64_t parts = random.between(1, 7);
    std::vector<std::string> folders;
    for (std::int64_t part = 0; part < parts; ++part) {
      make("part" + std::to_string(part), {part, parts});
      folders.push_back(folder.file("part" + std::to_string(part)));
    }
    std::reverse(folders.begin(), folders.end());
    const auto merged = merge_results(folders, folder.file("merged"));
    ASSERT_TRUE(merged) << merged.error();
    for (const char* file : {"/results.csv", "/results.json"})
      EXPECT_EQ(bytes_of(folder.file("merged") + file), bytes_of(folder.file("whole") + file))
          << seed << file;
  }
}

}  // namespace
}  // namespace replan::experiment_property_test
