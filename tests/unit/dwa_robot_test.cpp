// A robot that drives by the dynamic window approach: what its log says of it, and that the reasons that are worked out
// later are those by which it drove.
#include <bit>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/hash.hpp"
#include "core/debug/probe.hpp"
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

TEST(DwaRobot, HasTheFiguresOfTheWayThatItsPosesTell) {
  const auto scenario = boxes();
  replan::Run run(scenario, 0);
  run.finish(Target::end());
  const auto decisions = run.decisions();
  const Path& first = *decisions.front().plan->path;
  double way = 0, turned = 0, bent = 0, top = 0, most = 0, sum = 0;
  for (std::size_t i = 0; i + 1 < decisions.size(); ++i) {
    const Drive& to = decisions[i + 1].drive;
    Pose from = decisions[i].drive.state.pose;
    if (!decisions[i].drive.begun) from = {1.5, 1.5, 0};  // where it sets out
    if (!to.begun || to.state.pose == from) continue;
    const double angle = std::abs(wrapped_angle(to.state.pose.heading - from.heading));
    const double chord = distance(from.spot(), to.state.pose.spot());
    const double part = angle > 1e-9 ? chord * (angle / 2) / std::sin(angle / 2) : chord;  // of the arc
    // The nearest of many points of the polyline, in cells of a metre.
    double away = 1e9;
    for (std::size_t k = 1; k < first.size(); ++k)
      for (int t = 0; t <= 2000; ++t) {
        const Point a = first.point(k - 1), b = first.point(k);
        away = std::min(away, std::hypot(a.x + (b.x - a.x) * t / 2000 - to.state.pose.x,
                                         a.y + (b.y - a.y) * t / 2000 - to.state.pose.y));
      }
    way += part;
    turned += angle;
    bent += to.state.motion.v > 0 ? angle : 0;
    top = std::max(top, to.state.motion.v);
    most = std::max(most, away);
    sum += away * part;
  }
  const DriveFigures& told = decisions.back().figures.drive;
  EXPECT_NEAR(told.way, way, 1e-6);
  EXPECT_NEAR(told.way, decisions.back().figures.travelled, 1e-6) << "cells of a metre";
  EXPECT_NEAR(told.turned, turned, 1e-6);
  EXPECT_NEAR(told.mean_curvature(), bent / way, 1e-6);
  EXPECT_EQ(told.top_speed, top);
  EXPECT_NEAR(told.most_off_plan, most, 1e-4);
  EXPECT_NEAR(told.mean_off_plan(), sum / way, 1e-3);
}

/// What was decided at each step of a run, worked out once more from the robot's map and place there.
struct DecidedStep {
  std::size_t decision = 0;
  std::optional<DriveDecision> made;  // nothing where it found that it had lost its way, and planned again
  Cell sub_goal;
};

std::vector<DecidedStep> decided_steps(replan::Run& run) {
  std::vector<DecidedStep> steps;
  const auto decisions = run.decisions();
  for (std::size_t i = 0; i + 1 < decisions.size(); ++i) {
    const Decision &now = decisions[i], &next = decisions[i + 1];
    const bool moved = next.figures.moves == now.figures.moves + 1;
    if (!moved && next.drive.planned == now.drive.planned) continue;  // it learnt something
    run.timeline().seek(now.event);
    const auto why = why_it_drives(run.scenario(), run.choice(), now, run.timeline().state());
    if (!why) continue;
    steps.push_back({i, {}, why->frame.cell(why->goal)});
    if (moved) steps.back().made = why->explanation.decision;
  }
  return steps;
}

/// At which decisions a condition stops.
std::vector<std::size_t> stops_of(const replan::Run& run, const std::string& text) {
  auto condition = parse_condition(text, run.lattice());
  EXPECT_TRUE(condition.ok()) << text << ": " << condition.error();
  Probe probe(run.log_view(), std::move(*condition), 0);
  std::vector<std::size_t> found;
  while (const auto stop = probe.forwards(run.timeline().size()))
    found.push_back(static_cast<std::size_t>(run.decision_at(*stop) - run.decisions().data()));
  Probe back(run.log_view(), *parse_condition(text, run.lattice()), run.timeline().size());
  for (std::size_t i = found.size(); i-- > 0;) {
    const auto stop = back.backwards(0);
    EXPECT_TRUE(stop && run.decision_at(*stop) == &run.decisions()[found[i]]) << text << ", backwards";
  }
  return found;
}

TEST(DwaRobot, TellsItsLogWhatItHasDecided) {
  replan::Run run(boxes(), 0);
  run.finish(Target::end());
  const auto steps = decided_steps(run);
  EXPECT_GT(steps.size(), 400u);
  for (const DecidedStep& step : steps) {
    run.timeline().seek(run.decisions()[step.decision + 1].event);
    const SearchState& state = run.timeline().state();
    EXPECT_EQ(state.node(Scalar::sub_goal), run.lattice().node(step.sub_goal));
    if (!step.made) continue;
    EXPECT_EQ(state.scalar(Scalar::admissible), step.made->admissible + 1);
    EXPECT_EQ(state.scalar(Scalar::score), step.made->winner ? score_bits(step.made->score) : 0);
  }
}

TEST(DwaRobot, StopsAtConditionsOnItsDecisions) {
  replan::Run run(boxes(), 0);
  run.finish(Target::end());
  const auto steps = decided_steps(run);
  // Where something is true that was not true before.
  const auto becomes = [&](auto&& holds) {
    std::vector<std::size_t> found;
    bool before = false;
    for (const DecidedStep& step : steps) {
      if (!step.made) continue;
      const bool now = holds(*step.made);
      if (now && !before) found.push_back(step.decision);
      before = now;
    }
    return found;
  };
  for (const char* limit : {"0.3", "0.5", "0.6", "0.7", "0.8"}) {
    const auto low =
        becomes([&](const DriveDecision& made) { return made.winner && made.score < std::stod(limit); });
    EXPECT_EQ(stops_of(run, std::string("score(winner) < ") + limit), low) << limit;
    if (std::string_view(limit) == "0.7") {
      EXPECT_GT(low.size(), 3u);
    }
  }
  const auto none = becomes([](const DriveDecision& made) { return made.admissible == 0; });
  EXPECT_FALSE(none.empty());
  EXPECT_EQ(stops_of(run, "admissible == 0"), none);
  std::vector<std::size_t> turns;
  std::optional<Cell> before;
  for (const DecidedStep& step : steps)
    if (std::exchange(before, step.sub_goal) != step.sub_goal) turns.push_back(step.decision);
  EXPECT_GT(turns.size(), 4u);
  EXPECT_EQ(stops_of(run, "changed(sub_goal)"), turns);
}

TEST(DwaRobot, HasNoScoreWhereItGoesFromCellToCell) {
  auto scenario = std::move(read_scenario(REPLAN_SOURCE_DIR "/maps/demo.json").value());
  replan::Run run(std::make_shared<const Scenario>(std::move(scenario)), 0);
  run.finish(Target::end());
  for (const char* text :
       {"score(winner) < 1000", "admissible == 0", "changed(sub_goal)", "changed(score(winner))"})
    EXPECT_TRUE(stops_of(run, text).empty()) << text;
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
  EXPECT_EQ(hash, 15240351845107323234u);
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
