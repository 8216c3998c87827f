// What a search has in hand is read out of its log alone, whatever planner wrote it.
#include "core/debug/in_hand.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/session/session.hpp"

namespace replan::in_hand_test {
namespace {

/// A door that closes when the robot has made two steps.
Scenario world(std::string_view planner) {
  Scenario scenario;
  scenario.map = GridMap(12, 9);
  for (int y = 0; y < 9; ++y)
    if (y != 1 && y != 7) scenario.map.set({6, y}, true);
  scenario.start = {1, 6};
  scenario.goal = {10, 6};
  scenario.planners = {{std::string(planner), {}}};
  Surprise surprise;
  surprise.at.move = 2;
  surprise.cells = {{{6, 7}, true}};
  surprise.announced = true;
  scenario.surprises = {surprise};
  return scenario;
}

class InHandOf : public testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override {
    run_ = std::make_unique<replan::Run>(std::make_shared<const Scenario>(world(GetParam())), 0);
    run_->finish(Target::end());
  }
  InHand at(std::size_t position) {
    run_->timeline().seek(position);
    return in_hand(run_->log_view());
  }
  [[nodiscard]] const Timeline& log() const { return run_->timeline(); }

  std::unique_ptr<replan::Run> run_;
};

TEST_P(InHandOf, TheVertexIsTheOneTakenLast) {
  std::optional<NodeId> taken;
  std::size_t seen = 0;
  for (std::size_t p = 1; p <= log().size(); ++p) {
    const Event event = log().event(p - 1);
    if (event.kind == EventKind::pop) taken = event.node;
    if (kMilestones.has(event.kind) || event.kind == EventKind::epoch) taken.reset();
    ASSERT_EQ(at(p).vertex, taken) << "at " << p;
    seen += taken.has_value() ? 1 : 0;
  }
  EXPECT_GT(seen, 50u);
}

TEST_P(InHandOf, WhatWasWrittenLastIsWhatTheEventSays) {
  std::size_t written = 0;
  for (std::size_t p = 1; p <= log().size(); ++p) {
    const Event event = log().event(p - 1);
    const InHand hand = at(p);
    if (hand.written) {
      ++written;
      EXPECT_EQ(hand.written->event, event);
      EXPECT_EQ(hand.written->after, log().state().value(event.kind, event.node));
      EXPECT_EQ(hand.written->before, hand.written->after ^ event.delta);
    } else {
      EXPECT_FALSE(event.kind == EventKind::g || event.kind == EventKind::rhs ||
                   event.kind == EventKind::lp || event.kind == EventKind::queue ||
                   event.kind == EventKind::known)
          << "at " << p;
    }
  }
  EXPECT_GT(written, 50u);
}

TEST_P(InHandOf, ASettledVertexTriesAllItsNeighboursAndTheTakenOnesHaveItsSum) {
  std::size_t taken = 0;
  for (std::size_t p = 1; p <= log().size(); ++p) {
    const InHand hand = at(p);
    const SearchState& state = log().state();
    for (const Trial& trial : hand.trials) {
      const Offer& offer = trial.offer;
      EXPECT_EQ(offer.sum, offer.step + offer.g + offer.dist);
      EXPECT_FALSE(state.known_blocked(offer.node));
      const Cell a = run_->lattice().position(hand.centre), b = run_->lattice().position(offer.node);
      EXPECT_LE(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), 1);
      if (!trial.taken || hand.centre != hand.vertex) continue;
      ++taken;
      EXPECT_EQ(offer.g, state.g(*hand.vertex));
      const Cost value = run_->info().values.lookahead() ? state.rhs(offer.node) : state.g(offer.node);
      EXPECT_EQ(value, offer.sum);
    }
  }
  EXPECT_GT(taken, 20u);
}

TEST_P(InHandOf, NothingIsInHandOncePlansStandAndWhileTheRobotDrives) {
  std::size_t looked = 0;
  for (const Milestone& milestone : run_->milestones()) {
    if (milestone.kind != EventKind::plan_end && milestone.kind != EventKind::move) continue;
    ++looked;
    EXPECT_TRUE(at(milestone.event + 1).empty());
  }
  EXPECT_GT(looked, 5u);
  EXPECT_TRUE(at(0).empty());
}

INSTANTIATE_TEST_SUITE_P(Planners, InHandOf,
                         testing::Values("astar", "dijkstra", "dstar-lite", "dist-dstar-lite",
                                         "dld-star-lite"),
                         [](const auto& planner) {
                           std::string name(planner.param);
                           std::erase(name, '-');
                           return name;
                         });

/// Where a vertex was raised, each neighbour that had relied on it looks about: its successors are tried.
TEST(InHand, AVertexThatLooksAboutTriesItsSuccessors) {
  replan::Run run(std::make_shared<const Scenario>(world("dstar-lite")), 0);
  run.finish(Target::end());
  const Timeline& log = run.timeline();
  std::size_t looked = 0;
  for (std::size_t p = 1; p <= log.size(); ++p) {
    if (log.event(p - 1).kind != EventKind::rhs) continue;
    run.timeline().seek(p);
    const InHand hand = in_hand(run.log_view());
    if (hand.trials.empty() || hand.centre == hand.vertex) continue;
    ++looked;
    const Cost rhs = log.state().rhs(hand.centre);
    EXPECT_EQ(hand.centre, log.event(p - 1).node);
    EXPECT_EQ(hand.trials.front().offer.sum, rhs) << "rhs is the least sum";
    EXPECT_TRUE(hand.trials.front().taken || rhs.is_infinite());
  }
  EXPECT_GT(looked, 0u);
}

}  // namespace
}  // namespace replan::in_hand_test
