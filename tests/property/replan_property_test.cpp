// The bar of the D* Lite family: after any sequence of edits, moves and replans the cost equals that of a
// fresh plan, exactly, and the path is one that can be driven. 100 000 replans in 2D and 100 000 in 3D, none
// skipped, in shards that run beside each other.
#include "tests/support/replan_trials.hpp"
#include "tests/support/trials.hpp"

namespace replan::test::replan_property_test {
namespace {

constexpr int kReplansPerShard = 12'500;  // x 2 shards x 4 planners = 100 000 for each dimension
constexpr const char* kFamily[] = {"dstar-lite", "los-dstar-lite", "dist-dstar-lite", "dld-star-lite"};

class ReplanEqualsFreshPlan : public ::testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(ReplanEqualsFreshPlan, in2d) {
  check_replans<2>(std::get<0>(GetParam()), std::get<1>(GetParam()), trials(kReplansPerShard));
}
TEST_P(ReplanEqualsFreshPlan, in3d) {
  check_replans<3>(std::get<0>(GetParam()), std::get<1>(GetParam()), trials(kReplansPerShard));
}

INSTANTIATE_TEST_SUITE_P(Family, ReplanEqualsFreshPlan,
                         ::testing::Combine(::testing::ValuesIn(kFamily), ::testing::Values(0, 1)),
                         [](const auto& param) {
                           std::string name = std::get<0>(param.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name + "_" + std::to_string(std::get<1>(param.param));
                         });

}  // namespace
}  // namespace replan::test::replan_property_test
