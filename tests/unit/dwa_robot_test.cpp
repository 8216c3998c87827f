// A robot that drives by the dynamic window approach: what its log says of it, and that the reasons that are worked out
// later are those by which it drove.
#include <bit>
#include <memory>

#include <gtest/gtest.h>

#include "core/base/hash.hpp"
#include "core/robots/drive_sense.hpp"
#include "core/session/run.hpp"

namespace replan::dwa_robot_test {
namespace {

std::shared_ptr<const Scenario> boxes() {
  return std::make_shared<const Scenario>(
      std::move(read_scenario(REPLAN_SOURCE_DIR "/maps/fusion-boxes.json").value()));
}

TEST(DwaRobot, DrivesTheFusionPapersBoxesWithEveryPlannerOfTheWorld) {
  const auto scenario = boxes();
  for (std::size_t pane = 0; pane < scenario->planners.size(); ++pane) {
    replan::Run run(scenario, pane);
    run.finish(Target::end());
    const Decision& end = run.decisions().back();
    EXPECT_EQ(end.state, MissionState::arrived) << pane;
    EXPECT_EQ(end.figures.collisions, 0);
    EXPECT_GT(end.figures.replans, 3) << "it has met what is on no map";
  }
}

TEST(DwaRobot, HasInItsPastTheReasonsByWhichItDrove) {
  const auto scenario = boxes();
  replan::Run run(scenario, 0);
  run.finish(Target::end());
  const auto decisions = run.decisions();
  int driven = 0, told = 0;
  for (std::size_t i = 0; i + 1 < decisions.size(); ++i) {
    const Decision &now = decisions[i], &next = decisions[i + 1];
    if (next.figures.moves != now.figures.moves + 1) continue;  // it learnt something, or planned again
    run.timeline().seek(now.event);
    const SearchState& state = run.timeline().state();
    ++driven;
    const auto why = why_it_drives(*scenario, run.choice(), now, state);
    if (!why) continue;  // it sets out
    ++told;
    EXPECT_EQ(why->explanation.decision.motion, next.drive.state.motion) << "decision " << i;
    const auto is = [&state](Scalar scalar, double value) {
      return state.scalar(scalar) == std::bit_cast<std::uint64_t>(value);
    };
    EXPECT_TRUE(is(Scalar::x, now.drive.state.pose.x) && is(Scalar::y, now.drive.state.pose.y) &&
                is(Scalar::heading, now.drive.state.pose.heading) &&
                is(Scalar::speed, now.drive.state.motion.v) && is(Scalar::turning, now.drive.state.motion.w));
  }
  EXPECT_GT(told, 400);
  EXPECT_LE(driven - told, 1);
}

/// The same bits by every compiler and at every level of optimisation.
TEST(DwaRobot, DrivesTheSameWayEverywhere) {
  replan::Run run(boxes(), 0);
  run.finish(Target::end());
  std::uint64_t hash = run.timeline().size();
  for (std::size_t i = 0; i < run.timeline().size(); ++i) {
    const Event& event = run.timeline().event(i);
    hash = hash_combine(hash_combine(hash, event.delta), event.node);
  }
  EXPECT_EQ(hash, 14226166963801692733u);
}

TEST(DwaRobot, IsForWorldsOfOneLayer) {
  const auto refused = parse_scenario(
      R"({"replan": 1, "map": {"layers": [["..", ".."], ["..", ".."]]}, "start": [0, 0, 0], "goal": [1, 1, 1],
          "planners": [{"id": "astar"}], "robot": {"kind": "dwa"}})",
      "deck.json", "");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().find("drives in a plane"), std::string::npos) << refused.error();
}

}  // namespace
}  // namespace replan::dwa_robot_test
