// Planners that sample and that evolve as the side panel tells of them: the vertex and the paths of a cell, the charts, what a
// replan kept, and what is offered to be typed.
#include <set>

#include <gtest/gtest.h>

#include "core/debug/fitness_curve.hpp"
#include "core/debug/path_gains.hpp"
#include "core/plan/population_values.hpp"
#include "core/plan/tree_values.hpp"
#include "tests/ui/panel_fixture.hpp"
#include "ui/shell/actions.hpp"
#include "ui/shell/conditions.hpp"
#include "ui/shell/dialogs.hpp"
#include "ui/tabs/cost_chart.hpp"
#include "ui/tabs/debug.hpp"
#include "ui/tabs/gain_chart.hpp"
#include "ui/tabs/open_list.hpp"

namespace replan::ui::samples_test {
namespace {

/// A field in which a wall falls in the robot's way.
Scenario scenario_of(const char* planner) {
  Scenario scenario;
  scenario.map = GridMap(40, 30);
  scenario.start = {3, 15};
  scenario.goal = {36, 15};
  scenario.planners = {{planner, {}}};
  if (find_planner(planner)->sampling) scenario.planners[0].settings.set("samples", 600);
  if (find_planner(planner)->evolving) scenario.planners[0].settings.set("generations", 20);
  scenario.robot.sensor_radius = 30;
  Surprise surprise;
  surprise.at.move = 3;
  for (int y = 8; y < 23; ++y) surprise.cells.push_back({{18, y}, true});
  scenario.surprises = {surprise};
  return scenario;
}

class SamplesTest : public PanelTest {
 protected:
  void seek(std::size_t position) {
    ASSERT_TRUE(session_->apply(Seek{position}).ok());
    frames(2);
  }
  /// Where clicks along the chart that the tab shows lead.
  std::set<std::size_t> sought_by_the_chart() {
    std::set<std::size_t> sought;
    for (float x = 20; x < 320; x += 20) {
      commands_.clear();
      click(x, 80);
      for (const Command& command : commands_)
        if (const Seek* each = std::get_if<Seek>(&command)) sought.insert(each->position);
    }
    return sought;
  }
  /// Past the n-th milestone of that kind.
  [[nodiscard]] std::size_t past(EventKind kind, int n = 0) const {
    for (const Milestone& each : run().milestones())
      if (each.kind == kind && n-- == 0) return each.event + 1;
    return 0;
  }
};

TEST_F(SamplesTest, TheVertexLeadsToWhereItCameAndCanBeStoppedAt) {
  open(scenario_of("rrt-star"), tab("cell"));
  view_.view.pinned = Cell{30, 15};
  seek(past(EventKind::plan_end));
  const SearchState& state = run().timeline().state();
  const std::uint32_t vertex = nearest_vertex(state, place_in(Cell{30, 15}), false);
  ASSERT_NE(vertex, kNoNode);
  const std::string number = "(" + std::to_string(vertex) + ")";
  const auto birth = birth_of(run().log_view(), vertex);
  ASSERT_TRUE(birth.has_value());
  std::set<std::string> conditions, watched;
  bool leads_to_birth = false;
  for (const float x : {60.0f, 130.0f, 240.0f})
    for (float y = 20; y < 760; y += 9) {
      commands_.clear();
      click(x, y);
      for (const Command& command : commands_) {
        if (const auto* stop = std::get_if<AddBreakpoint>(&command)) conditions.insert(stop->condition);
        if (const auto* watch = std::get_if<AddWatch>(&command)) watched.insert(watch->expression);
        const auto* seek = std::get_if<Seek>(&command);
        leads_to_birth |= seek != nullptr && seek->position == birth->event + 1;
      }
    }
  EXPECT_EQ(conditions, std::set<std::string>{"rewired" + number});
  EXPECT_EQ(watched, std::set<std::string>{"vertex_cost" + number});
  EXPECT_EQ(language_error(*session_, "rewired" + number, false), "");
  EXPECT_EQ(language_error(*session_, "vertex_cost" + number, true), "");
  EXPECT_TRUE(leads_to_birth);
}

/// Not to where it is found, when the vertex still hangs where it did.
TEST_F(SamplesTest, TheLinkOfARewiringLeadsToWhereItIsDone) {
  open(scenario_of("rrt-star"), tab("cell"));
  seek(past(EventKind::plan_end));
  const Timeline& log = run().timeline();
  std::size_t found = log.cursor();
  while (log.event(found - 1).kind != EventKind::rewired) --found;
  const auto vertex = static_cast<std::uint32_t>(log.event(found - 1).node);
  const Cost saved{static_cast<std::int64_t>(log.event(found - 1).delta)};
  view_.view.pinned = cell_of(point_of(vertex_place(log.state(), vertex, false)));
  ASSERT_EQ(nearest_vertex(log.state(), place_in(*view_.view.pinned), false), vertex);
  frames(2);
  std::set<std::size_t> sought;
  for (const float x : {130.0f, 180.0f, 240.0f})
    for (float y = 20; y < 760; y += 9) {
      commands_.clear();
      click(x, y);
      for (const Command& command : commands_)
        if (const auto* each = std::get_if<Seek>(&command); each != nullptr && each->position >= found)
          sought.insert(each->position);
    }
  // The event behind it is the parent's, and the next one that of the cost.
  const std::size_t done = found + 2;
  EXPECT_TRUE(sought.contains(done));
  seek(found);
  const Cost before = vertex_cost(run().timeline().state(), vertex);
  const NodeId parent_before = vertex_parent(run().timeline().state(), vertex);
  seek(done);
  EXPECT_EQ(vertex_cost(run().timeline().state(), vertex).raw, before.raw - saved.raw);
  EXPECT_NE(vertex_parent(run().timeline().state(), vertex), parent_before);
}

TEST_F(SamplesTest, TheGainChartLeadsToTheGains) {
  open(scenario_of("rrt-star"), tab("figures"));
  seek(past(EventKind::plan_end));
  PathGains gains;
  const std::size_t end = run().timeline().size();
  gains.follow(run().log_view(), run().log_id(), 0, end, SIZE_MAX);
  std::set<std::size_t> at;
  for (const PathGain& gain : gains.gains()) at.insert(gain.event + 1);
  ASSERT_GT(at.size(), 2u);
  const std::set<std::size_t> sought = sought_by_the_chart();
  EXPECT_GE(sought.size(), 2u);
  for (const std::size_t position : sought) EXPECT_TRUE(at.contains(position)) << position;
}

TEST_F(SamplesTest, TheFitnessChartLeadsToTheEndsOfGenerations) {
  open(scenario_of("improved-ga"), tab("figures"));
  seek(past(EventKind::plan_end));
  FitnessCurve curve;
  curve.follow(run().log_view(), run().log_id(), SIZE_MAX);
  std::set<std::size_t> at;
  for (const FitnessPoint& point : curve.points()) at.insert(point.event + 1);
  const std::set<std::size_t> sought = sought_by_the_chart();
  EXPECT_GE(sought.size(), 5u);
  for (const std::size_t position : sought) EXPECT_TRUE(at.contains(position)) << position;
}

TEST_F(SamplesTest, ARowOfWhatWasCutOffPinsItsCell) {
  open(scenario_of("rrt-star"), tab("open_list"));
  panels_.tabs.get<OpenListTab>().show_repair();
  seek(past(EventKind::plan_end, 1));
  const auto lost = panels_.kept.lost_before(run().timeline().cursor());
  ASSERT_GT(lost.size(), 3u);
  for (float y = 80; y < 220 && !view_.view.pinned; y += 8) click(60, y);
  ASSERT_TRUE(view_.view.pinned.has_value());
  const bool found = std::any_of(lost.begin(), lost.end(), [&](const Lost& each) {
    return !each.way.empty() && cell_of(each.way.back()) == *view_.view.pinned;
  });
  EXPECT_TRUE(found);
}

/// Examples are of the planner that leads, and can all be typed as they stand.
TEST_F(SamplesTest, WhatIsOfferedToBreakOnIsOfThePlanner) {
  for (const char* planner : {"rrt-star", "improved-ga"}) {
    open(scenario_of(planner), tab("debug"));
    seek(past(EventKind::plan_end));
    DebugTab& debug = panels_.tabs.get<DebugTab>();
    std::set<std::string> conditions, quantities;
    for (float y = 20; y < 400; y += 6) {
      debug.breakpoint.clear();
      debug.watch.clear();
      click(40, y);
      if (!debug.breakpoint.empty()) conditions.insert(debug.breakpoint);
      if (!debug.watch.empty()) quantities.insert(debug.watch);
    }
    EXPECT_TRUE(conditions.contains("event(first_path)")) << planner;
    EXPECT_GE(conditions.size(), 4u) << planner;
    EXPECT_TRUE(quantities.contains("best")) << planner;
    for (const std::string& each : conditions) {
      EXPECT_EQ(language_error(*session_, each, false), "") << each;
      EXPECT_EQ(each.find("km"), std::string::npos) << each;
    }
    for (const std::string& each : quantities) EXPECT_EQ(language_error(*session_, each, true), "") << each;
  }
}

/// Expansions and children are no samples: such panes have no curve among those over samples.
TEST_F(SamplesTest, TheCurveOverSamplesIsOfAPaneThatDrawsThem) {
  for (const auto& [leads, other, strong] : {std::tuple{"rrt-star", "dstar-lite", 0u},
                                             {"dstar-lite", "rrt-star", 1u},
                                             {"improved-ga", "rrt-connect", 1u}}) {
    Scenario scenario = scenario_of(leads);
    scenario.planners.push_back({other, {}});
    if (find_planner(other)->sampling) scenario.planners[1].settings.set("samples", 200);
    open(scenario, tab("figures"));
    EXPECT_EQ(gains_pane(*session_), strong) << leads;
    EXPECT_TRUE(has_gains(*session_));
  }
}

TEST_F(SamplesTest, AStepIsCalledAsThePlannerCallsIt) {
  const std::pair<const char*, const char*> kWords[] = {
      {"rrt", "Next sample"}, {"improved-ga", "Next child"}, {"dstar-lite", "Next expansion"}};
  for (const auto& [planner, words] : kWords) {
    open(scenario_of(planner), [](Frame&) {});
    Wish wish = Wish::none;
    const ActionContext context{*session_, view_, panels_, commands_, wish};
    EXPECT_EQ(action(ActionId::step_forward).words(context), words);
    EXPECT_FALSE(action(ActionId::step_forward).lesson(context).empty());
    // And so does the page of keys.
    EXPECT_EQ(words_on_keys_page(action(ActionId::step_forward).label, run().info().step), words);
    EXPECT_EQ(words_on_keys_page(action(ActionId::fit).label, run().info().step),
              action(ActionId::fit).label);
  }
}

TEST(CostAxes, TellCountsAndCostsOnBothScales) {
  for (const CostScale scale : {CostScale::linear, CostScale::logarithmic}) {
    CostAxes axes{.scale = scale, .min = {10, 20}, .max = {110, 120}};
    EXPECT_TRUE(axes.empty());
    axes.take(1);
    axes.take(100);
    axes.reach(50);
    EXPECT_FALSE(axes.empty());
    EXPECT_FLOAT_EQ(axes.y(1), 120);
    EXPECT_FLOAT_EQ(axes.y(100), 20);
    EXPECT_FLOAT_EQ(axes.y(10), scale == CostScale::logarithmic ? 70 : 120 - 100 * 9.0f / 99);
    EXPECT_FLOAT_EQ(axes.x(25), 60);
    for (const std::int64_t at : {0, 7, 50})
      EXPECT_NEAR(axes.count_at(axes.x(at)), static_cast<double>(at), 1e-3);
    EXPECT_EQ(axes.count_at(-1000), 0);
    EXPECT_EQ(axes.count_at(1000), 50);
  }
}

TEST(CostAxes, OneCostAloneLiesAtTheFoot) {
  CostAxes axes{.scale = CostScale::logarithmic, .min = {0, 0}, .max = {10, 10}};
  axes.take(5);
  EXPECT_FLOAT_EQ(axes.y(5), 10);
}

}  // namespace
}  // namespace replan::ui::samples_test
