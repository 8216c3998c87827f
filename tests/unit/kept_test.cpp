// What a replan keeps and loses of a tree or a population, read out of its log, and what is drawn of it.
#include "core/debug/kept.hpp"

#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "core/plan/population_values.hpp"
#include "core/plan/tree_values.hpp"
#include "core/scene/scene.hpp"
#include "core/session/run.hpp"

namespace replan::kept_test {
namespace {

/// A field on which a wall falls in the robot's way; the goal is put elsewhere besides, if so.
std::unique_ptr<replan::Run> finished(std::string planner, bool new_goal = false) {
  auto scenario = std::make_shared<Scenario>();
  scenario->map = GridMap(40, 30);
  scenario->start = {3, 15};
  scenario->goal = {36, 15};
  scenario->planners = {{std::move(planner), {}}};
  Surprise surprise;
  surprise.at.move = 3;
  for (int y = 8; y < 23; ++y) surprise.cells.push_back({{18, y}, true});
  if (new_goal) surprise.goal = Cell{36, 4};
  scenario->surprises = {surprise};
  scenario->robot.sensor_radius = 30;
  auto run = std::make_unique<replan::Run>(scenario, 0);
  run->finish(Target::end());
  return run;
}

/// The first replan's events: of its `plan_begin`, and past its `plan_end`.
std::pair<std::size_t, std::size_t> first_replan(const replan::Run& run) {
  std::size_t begin = 0;
  for (const Milestone& each : run.milestones()) {
    if (each.kind == EventKind::plan_begin && each.payload > 0 && begin == 0) begin = each.event;
    if (each.kind == EventKind::plan_end && begin > 0) return {begin, each.event + 1};
  }
  return {0, 0};
}

KeptInReplan kept_of(const replan::Run& run) {
  const auto [begin, end] = first_replan(run);
  KeptInReplan kept;
  kept.follow(run.log_view(), run.log_id(), begin, end);
  return kept;
}

std::set<std::uint32_t> vertices_in_tree(const SearchState& state) {
  std::set<std::uint32_t> all;
  for (std::uint32_t v = 0; v < vertex_count(state); ++v)
    if (!vertex_cost(state, v).is_infinite()) all.insert(v);
  return all;
}

/// At every position: what was in the tree when the replan began is kept, or is named as cut off.
TEST(Kept, ATreeIsPartedIntoWhatIsKeptAndWhatIsCutOff) {
  for (const char* planner :
       {"rrt", "rrt-connect", "rrt-star", "informed-rrt-star", "greedy-informed-rrt-star"}) {
    const auto run = finished(planner);
    const auto [begin, end] = first_replan(*run);
    ASSERT_GT(begin, 0u) << planner;
    const KeptInReplan kept = kept_of(*run);
    const std::set<std::uint32_t> before = vertices_in_tree(run->timeline().state_at(begin));
    for (const std::size_t position : {end, (begin + end) / 2, begin + 40, begin}) {
      const std::set<std::uint32_t> now = vertices_in_tree(run->timeline().state_at(position));
      std::set<std::uint32_t> cut;
      for (const std::uint32_t v : before)
        if (!now.contains(v)) cut.insert(v);
      std::set<std::uint32_t> named;
      for (const Lost& lost : kept.lost_before(position)) named.insert(lost.number);
      EXPECT_EQ(named, cut) << planner << " at " << position;
      const KeptCounts counts = kept.counts_before(position);
      EXPECT_EQ(counts.lost, static_cast<std::int64_t>(cut.size())) << planner;
      EXPECT_EQ(counts.kept, static_cast<std::int64_t>(before.size() - cut.size())) << planner;
      EXPECT_FALSE(counts.anew);
    }
    EXPECT_GT(kept.counts_before(end).lost, 0) << planner;
    EXPECT_GT(kept.counts_before(end).kept, 0) << planner;
  }
}

TEST(Kept, WhatIsCutOffIsToldAsItWas) {
  const auto run = finished("rrt-star");
  const auto [begin, end] = first_replan(*run);
  const SearchState before = run->timeline().state_at(begin);
  const KeptInReplan kept = kept_of(*run);
  for (const Lost& lost : kept.lost_before(end)) {
    EXPECT_EQ(lost.hung_on, vertex_parent(before, lost.number));
    EXPECT_EQ(lost.cost, vertex_cost(before, lost.number));
    if (lost.hung_on == kNoNode) continue;
    ASSERT_EQ(lost.way.size(), 2u);
    EXPECT_EQ(lost.way[1], point_of(vertex_place(before, lost.number, false)));
  }
}

TEST(Kept, ANewGoalForgetsTheWholeTree) {
  const auto run = finished("rrt-star", true);
  const auto [begin, end] = first_replan(*run);
  const KeptCounts counts = kept_of(*run).counts_before(end);
  EXPECT_TRUE(counts.anew);
  EXPECT_EQ(counts.kept, 0);
  EXPECT_EQ(counts.lost, static_cast<std::int64_t>(vertices_in_tree(run->timeline().state_at(begin)).size()));
}

/// A path that is as it was, from the cell on that the robot is joined to, is not lost; and all are one or the other.
TEST(Kept, APopulationIsPartedIntoKeptJoinedAndLost) {
  const auto run = finished("improved-ga");
  const auto [begin, end] = first_replan(*run);
  ASSERT_GT(begin, 0u);
  const KeptInReplan kept = kept_of(*run);
  const SearchState before = run->timeline().state_at(begin);
  std::size_t searched = begin;
  while (run->timeline().event(searched).kind != EventKind::pop) ++searched;
  const SearchState after = run->timeline().state_at(searched);
  const KeptCounts counts = kept.counts_before(end);
  EXPECT_EQ(counts.all(), static_cast<std::int64_t>(path_count(before)) - 1);
  EXPECT_GT(counts.lost, 0);
  std::set<std::uint32_t> lost;
  for (const Lost& each : kept.lost_before(end)) lost.insert(each.number);
  std::int64_t same = 0;
  for (std::uint32_t i = 0; i < path_count(before); ++i) {
    if (i == path_named(before, Scalar::child) || lost.contains(i)) continue;
    const BredPath was = bred_path(before, i), is = bred_path(after, i);
    ASSERT_GE(is.size(), 2u);
    bool cells_alike = was.size() == is.size();
    for (std::size_t k = 0; k < std::min(was.size(), is.size()); ++k)
      cells_alike = cells_alike && was[k].cell == is[k].cell;
    same += cells_alike ? 1 : 0;
    EXPECT_EQ(was.back().cell, is.back().cell);
  }
  EXPECT_EQ(counts.kept, same);
}

/// What the scene draws of it follows the cursor to and fro.
TEST(Kept, WhatIsLostIsDrawnAndSteppingBackIsExact) {
  for (const char* planner : {"rrt-star", "improved-ga"}) {
    const auto run = finished(planner);
    const auto [begin, end] = first_replan(*run);
    View view;
    view.overlays = {};
    view.overlays.set(Overlay::repair, true);
    static const Palette palette;
    SceneMemory memory;
    const auto scene_at = [&](std::size_t position) {
      run->timeline().seek(position);
      return build_scene(*run, view, {800, 600}, palette, memory);
    };
    const Sign sign = run->info().values.breeds() ? Sign::path_lost : Sign::cut_off;
    const Scene later = scene_at(end);
    EXPECT_TRUE(later.shows(sign)) << planner;
    EXPECT_FALSE(later.shows(Sign::repair)) << planner;
    EXPECT_FALSE(scene_at(begin).shows(sign)) << planner;
    const Scene again = scene_at(end);
    EXPECT_EQ(again.shapes.size(), later.shapes.size());
    EXPECT_EQ(memory.repair(*run, end).kept->lost, kept_of(*run).counts_before(end).lost);
  }
}

}  // namespace
}  // namespace replan::kept_test
