// The bar of the D* family: after any sequence of edits, moves and replans the cost equals that of a fresh plan by brute
// force, exactly, and the path is one that can be driven. 100 000 replans of each planner in 2D and as many in 3D, none
// skipped, in shards that run beside each other.
#include "tests/support/replan_trials.hpp"
#include "tests/support/trials.hpp"

namespace replan::test::dstar_property_test {
namespace {

constexpr int kReplansPerShard = 50'000;  // x 2 shards, of each planner and dimension
constexpr const char* kFamily[] = {"dstar", "focused-dstar", "threat-dstar"};

class DStarEqualsFreshPlan : public ::testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(DStarEqualsFreshPlan, in2d) {
  check_replans<2>(std::get<0>(GetParam()), std::get<1>(GetParam()), trials(kReplansPerShard));
}
TEST_P(DStarEqualsFreshPlan, in3d) {
  check_replans<3>(std::get<0>(GetParam()), std::get<1>(GetParam()), trials(kReplansPerShard));
}

INSTANTIATE_TEST_SUITE_P(Family, DStarEqualsFreshPlan,
                         ::testing::Combine(::testing::ValuesIn(kFamily), ::testing::Values(0, 1)),
                         [](const auto& param) {
                           std::string name = std::get<0>(param.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name + "_" + std::to_string(std::get<1>(param.param));
                         });

}  // namespace
}  // namespace replan::test::dstar_property_test
