// LPA* after 100 000 random changes in the plane and as many in space, none skipped: its cost is that of a fresh A*.
#include <cstdio>

#include "tests/support/repairs.hpp"
#include "tests/support/trials.hpp"

namespace replan::test::lpa_star_property_test {
namespace {

template <int D>
void check(int shard) {
  const RepairTally tally = check_repairs<D>(
      *find_planner("lpa-star"), 1'000'000u * static_cast<std::uint64_t>(shard + 1), trials(50'000));
  std::printf(
      "lpa-star, %dD: %lld changes, %lld with a path, %lld with another start; %lld expansions where A* has "
      "%lld\n",
      D, static_cast<long long>(tally.repairs), static_cast<long long>(tally.found),
      static_cast<long long>(tally.moved), static_cast<long long>(tally.expansions),
      static_cast<long long>(tally.afresh));
  EXPECT_GE(tally.repairs, trials(50'000));
  EXPECT_GT(tally.found, tally.repairs / 2);
}

class LpaStarRepairs : public ::testing::TestWithParam<int> {};

TEST_P(LpaStarRepairs, costWhatAFreshAStarCostsIn2d) {
  check<2>(GetParam());
}
TEST_P(LpaStarRepairs, costWhatAFreshAStarCostsIn3d) {
  check<3>(GetParam());
}
INSTANTIATE_TEST_SUITE_P(Shards, LpaStarRepairs, ::testing::Values(0, 1));

}  // namespace
}  // namespace replan::test::lpa_star_property_test
