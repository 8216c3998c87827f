// Lengths that others published, in space: the Warframe boxes of the shared benchmark data.
#include <string>

#include <gtest/gtest.h>

#include "core/experiment/batch_report.hpp"
#include "core/world/formats/voxel_map.hpp"
#include "tests/support/shared_data.hpp"

namespace replan::test::published_voxel_lengths_test {
namespace {

/// Every problem of an even sample of so many (0: of all) has its listed length.
void expect_listed_lengths(const std::string& name, std::size_t limit, const char* planner) {
  const std::string path = (shared_data() / "voxels" / (name + ".3dmap")).string();
  const auto map = read_voxel_map(path);
  ASSERT_TRUE(map.ok()) << map.error();
  const auto scen = read_scen(path + ".3dscen");
  ASSERT_TRUE(scen.ok()) << scen.error();
  ASSERT_TRUE(lengths_apply({planner, {}}));
  const auto problems = even_sample(scen->problems, limit);
  const BatchReport report = solve_problems(*map, scen->lengths, problems, {planner, {}});
  std::printf("%s, %s: %lld of %zu problems solved, %lld with another length, %lld expansions, %.0f ms\n",
              name.c_str(), planner, static_cast<long long>(report.found), problems.size(),
              static_cast<long long>(report.mismatches), static_cast<long long>(report.expansions),
              report.total_ms);
  EXPECT_EQ(report.problems, static_cast<std::int64_t>(limit == 0 ? scen->problems.size() : limit));
  EXPECT_EQ(report.skipped, 0);
  EXPECT_EQ(report.found, report.problems);
  EXPECT_EQ(report.mismatches, 0) << "line "
                                  << (report.first_mismatches.empty() ? 0 : report.first_mismatches[0].line);
}

class PublishedVoxelLengths : public ::testing::TestWithParam<const char*> {};

TEST_P(PublishedVoxelLengths, OfASampleAreFound) {
  REPLAN_NEED_SHARED_DATA();
  expect_listed_lengths("Simple", 200, GetParam());
  expect_listed_lengths("Complex", 20, GetParam());
}

// A quarter of a minute: what is called HugeWorld the long run alone takes.
TEST_P(PublishedVoxelLengths, HugeWorldsAreSolvedAsListed) {
  REPLAN_NEED_SHARED_DATA();
  expect_listed_lengths("Simple", 0, GetParam());
  expect_listed_lengths("Complex", 500, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Planners, PublishedVoxelLengths, ::testing::Values("astar", "dstar-lite"),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace replan::test::published_voxel_lengths_test
