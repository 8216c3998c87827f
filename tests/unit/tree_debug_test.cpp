// What the debugger tells of a tree of samples: why a vertex hangs where it does, what rewiring saved, conditions about
// vertices, and what is drawn of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "core/debug/cost_words.hpp"
#include "core/debug/path_gains.hpp"
#include "core/debug/probe.hpp"
#include "core/debug/sample_in_hand.hpp"
#include "core/scene/scene.hpp"
#include "core/session/lockstep.hpp"
#include "core/session/run.hpp"
#include "tests/support/growing_log.hpp"
#include "tests/support/log_places.hpp"

namespace replan::tree_debug_test {
namespace {

using test::after;

/// Two walls, each with a gap.
std::unique_ptr<replan::Run> finished(std::string planner) {
  auto scenario = std::make_shared<Scenario>();
  scenario->map = GridMap(40, 30);
  for (int y = 0; y < 30; ++y) {
    scenario->map.set({14, y}, y < 20 || y > 24);
    scenario->map.set({26, y}, y < 5 || y > 9);
  }
  scenario->start = {4, 15};
  scenario->goal = {35, 15};
  scenario->planners = {{std::move(planner), {}}};
  scenario->planners[0].settings.set("samples", 900);
  auto run = std::make_unique<replan::Run>(scenario, 0);
  run->finish(Target::end());
  return run;
}

std::vector<PathGain> gains_of(const replan::Run& run) {
  PathGains read;
  read.follow(run.log_view(), run.log_id(), 0, run.timeline().size(), SIZE_MAX);
  return {read.gains().begin(), read.gains().end()};
}

Scene scene_at(replan::Run& run, std::size_t position, std::optional<Cell> pinned = {}) {
  run.timeline().seek(position);
  View view;
  view.overlays = {};
  view.overlays.set(Overlay::tree, true);
  view.pinned = pinned;
  static const Palette palette;
  return build_scene(run, view, {800, 600}, palette);
}

Cost least_sum(const std::vector<SampleInHand::Candidate>& candidates) {
  Cost least = Cost::infinity();
  for (const auto& candidate : candidates) least = std::min(least, candidate.cost);
  return least;
}

/// Until it is rewired a vertex hangs on the candidate with the least sum, and that is what the way to it costs.
TEST(TreeDebug, AVertexHangsOnTheCandidateWithTheLeastSum) {
  const auto run = finished("rrt-star");
  Timeline& log = run->timeline();
  int told = 0;
  for (std::size_t n = 3; n < 400; n += 7) {
    const std::size_t pop = after(*run, EventKind::pop, n), next = after(*run, EventKind::pop, n + 1);
    log.seek(next - 1);
    const std::uint32_t grown = vertex_count(log.state()) - vertex_count(log.state_at(pop));
    if (grown != 1) continue;
    const std::uint32_t vertex = vertex_count(log.state()) - 1;
    const auto birth = birth_of(run->log_view(), vertex);
    ASSERT_TRUE(birth.has_value());
    ASSERT_FALSE(birth->candidates.empty());
    const auto winner =
        std::find_if(birth->candidates.begin(), birth->candidates.end(),
                     [&](const auto& candidate) { return candidate.cost == least_sum(birth->candidates); });
    EXPECT_EQ(winner->vertex, vertex_parent(log.state(), vertex));
    EXPECT_EQ(winner->cost, vertex_cost(log.state(), vertex));
    const SearchState then = log.state_at(birth->event);  // before it has made the way to any of them shorter
    for (const auto& candidate : birth->candidates)
      if (!candidate.cost.is_infinite()) {
        const Place from = vertex_place(log.state(), candidate.vertex, false),
                    to = vertex_place(log.state(), vertex, false);
        EXPECT_EQ(candidate.cost.raw, (vertex_cost(then, candidate.vertex) + length_between(from, to)).raw);
      }
    const auto hand = sample_in_hand(run->log_view());
    ASSERT_TRUE(hand.has_value());
    EXPECT_EQ(hand->added, vertex);
    EXPECT_EQ(hand->ball, 4);  // a step, the paper's way
    ++told;
  }
  EXPECT_GT(told, 15);
}

/// The goal's vertex comes by the same sample as another one, and has no candidates of its own.
TEST(TreeDebug, TheGoalIsNotToldTheCandidatesOfTheVertexThatItHangsOn) {
  const auto run = finished("rrt-star");
  Timeline& log = run->timeline();
  const auto gains = gains_of(*run);
  ASSERT_FALSE(gains.empty());
  log.seek(gains.front().event + 1);
  const std::uint32_t goal = goal_vertex(log.state());
  const auto birth = birth_of(run->log_view(), goal);
  ASSERT_TRUE(birth.has_value());
  EXPECT_TRUE(birth->candidates.empty());
  const auto hand = sample_in_hand(run->log_view());
  ASSERT_TRUE(hand.has_value());
  EXPECT_EQ(hand->added, vertex_parent(log.state(), goal));
}

TEST(TreeDebug, ARewiringSavesWhatItSays) {
  for (const char* planner : {"rrt-star", "informed-rrt-star"}) {
    const auto run = finished(planner);
    Timeline& log = run->timeline();
    int told = 0;
    for (std::size_t p = 0; p < log.size(); ++p) {
      const Event event = log.event(p);
      if (event.kind != EventKind::rewired || ++told > 40) continue;
      const auto written = log.next_event(event.node, {fields::kVertexCost.kind}, p);
      ASSERT_TRUE(written.has_value());
      const Cost before = vertex_cost(log.state_at(p), event.node),
                 now = vertex_cost(log.state_at(*written + 1), event.node);
      EXPECT_EQ(before.raw - now.raw, static_cast<std::int64_t>(event.delta)) << planner;
    }
    EXPECT_GT(told, 20) << planner;
  }
}

TEST(TreeDebug, ConditionsAskAboutVertices) {
  const auto run = finished("rrt-star");
  const Timeline& log = run->timeline();
  const std::size_t rewired = after(*run, EventKind::rewired, 5);
  ASSERT_GT(rewired, 0u);
  const std::string vertex = std::to_string(log.event(rewired - 1).node);
  const auto stop_of = [&](const std::string& text, std::size_t from) {
    const auto condition = parse_condition(text, run->lattice());
    EXPECT_TRUE(condition.ok()) << condition.error();
    return Probe(run->log_view(), *condition, from).forwards(log.size());
  };
  std::size_t first = 0;
  while (log.event(first).kind != EventKind::rewired || log.event(first).node != log.event(rewired - 1).node)
    ++first;
  EXPECT_EQ(stop_of("rewired(" + vertex + ")", 0), first + 1);
  const auto changed = stop_of("changed(vertex_cost(" + vertex + "))", rewired);
  ASSERT_TRUE(changed.has_value());
  EXPECT_EQ(log.event(*changed - 1).kind, fields::kVertexCost.kind);
  const auto cheap = stop_of("best < 50", 0);
  ASSERT_TRUE(cheap.has_value());
  EXPECT_LT((Cost{static_cast<std::int64_t>(log.state_at(*cheap).scalar(Scalar::best))}).to_double(), 50);
  const auto quantity = parse_quantity("vertex_parent(0)", run->lattice());
  ASSERT_TRUE(quantity.ok());
  EXPECT_TRUE(std::isinf(Probe(run->log_view(), *quantity, log.size() / 2).value().number)) << "the root";
}

TEST(TreeDebug, ConditionsAboutVerticesAreSpeltAndRefused) {
  const Box world(20, 10);
  for (const char* text : {"rewired(17)", "vertex_cost(3) < 20.5", "changed(vertex_parent(3))",
                           "vertex_x(3) > 4 && event(first_path)", "vertex_side(2) == 1"}) {
    const auto read = parse_condition(text, world);
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_EQ(expression_text(*read), text);
  }
  const auto error = [&](const char* text) { return parse_condition(text, world).error(); };
  EXPECT_EQ(error("rewired"), "character 1: 'rewired' needs what it is about: rewired(v)");
  EXPECT_EQ(error("rewired(-1)"), "character 1: 'rewired' needs the number of a vertex: rewired(17)");
  EXPECT_EQ(error("vertex_cost(1, 2) > 3"),
            "character 1: 'vertex_cost' needs the number of a vertex: vertex_cost(17)");
}

TEST(TreeDebug, TheTreeIsDrawnWithWhatIsInHand) {
  const auto run = finished("informed-rrt-star");
  const std::size_t rejected = after(*run, EventKind::rejected, 3),
                    candidate = after(*run, EventKind::candidate, 40),
                    rewired = after(*run, EventKind::rewired, 3);
  EXPECT_TRUE(scene_at(*run, rejected).shows(Sign::rejected));
  const Scene tried = scene_at(*run, candidate);
  for (const Sign sign : {Sign::tree, Sign::sample, Sign::tried, Sign::ball}) EXPECT_TRUE(tried.shows(sign));
  EXPECT_FALSE(tried.shows(Sign::way_to_vertex));
  EXPECT_TRUE(scene_at(*run, candidate, Cell{6, 15}).shows(Sign::way_to_vertex));
  EXPECT_TRUE(scene_at(*run, rewired).shows(Sign::rewired));
  const auto gains = gains_of(*run);
  ASSERT_GT(gains.size(), 1u);
  const Scene first = scene_at(*run, gains[0].event + 1), second = scene_at(*run, gains[1].event + 1);
  EXPECT_TRUE(first.shows(Sign::informed));
  EXPECT_FALSE(first.shows(Sign::first_path)) << "it is the best one still";
  EXPECT_TRUE(second.shows(Sign::first_path));
  EXPECT_FALSE(scene_at(*run, gains[0].event).shows(Sign::first_path));
}

/// A tree of many vertices: the goal is walled in, so that all samples are drawn.
std::unique_ptr<replan::Run> large_tree(int samples) {
  auto scenario = std::make_shared<Scenario>();
  scenario->map = GridMap(120, 90);
  for (int y = 39; y < 42; ++y)
    for (int x = 99; x < 102; ++x) scenario->map.set({x, y}, x != 100 || y != 40);
  scenario->start = {10, 15};
  scenario->goal = {100, 40};
  scenario->planners = {{"rrt", {}}};
  scenario->planners[0].settings.set("samples", samples);
  auto run = std::make_unique<replan::Run>(scenario, 0);
  run->finish(Target::end());
  return run;
}

/// The first position at which the tree has so many vertices.
std::size_t grown_to(const Timeline& log, std::uint32_t vertices) {
  std::size_t low = 0, high = log.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (vertex_count(log.state_at(middle)) < vertices)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

std::size_t lines_of(const Scene& scene) {
  return static_cast<std::size_t>(
      std::count_if(scene.shapes.begin(), scene.shapes.end(),
                    [](const Shape& shape) { return std::holds_alternative<Line>(shape); }));
}

/// Edges are left out only where more than 40 000 are in sight: all vertices but the root hang on one.
TEST(TreeDebug, OnlyMoreEdgesThanCanBeDrawnAreThinned) {
  const auto run = large_tree(60'000);
  Timeline& log = run->timeline();
  ASSERT_GT(vertex_count(log.head()), 45'000u);
  const Scene most = scene_at(*run, grown_to(log, 40'001) - 1);
  EXPECT_EQ(most.every_edge, 1);
  EXPECT_GE(lines_of(most), 39'999u);
  const Scene thinned = scene_at(*run, log.size());
  EXPECT_EQ(thinned.every_edge, 2);
  EXPECT_NEAR(static_cast<double>(lines_of(thinned)), vertex_count(log.state()) / 2.0, 10);
}

TEST(TreeDebug, ZoomedInAllEdgesAreDrawnThatAreInSight) {
  const auto run = large_tree(60'000);
  run->timeline().seek(run->timeline().size());
  View view;
  view.overlays = {};
  view.overlays.set(Overlay::tree, true);
  view.camera = {30, 30, 40};  // 20 x 15 cells
  const Scene scene = build_scene(*run, view, {800, 600}, Palette{});
  EXPECT_EQ(scene.every_edge, 1);
  const SearchState& state = run->timeline().state();
  std::size_t inside = 0;
  for (std::uint32_t v = 1; v < vertex_count(state); ++v) {
    const Point at = point_of(vertex_place(state, v, false));
    inside += std::abs(at.x - 30) < 10 && std::abs(at.y - 30) < 7.5 ? 1 : 0;
  }
  EXPECT_GT(inside, 1'000u);
  EXPECT_GE(lines_of(scene), inside);
  EXPECT_LT(lines_of(scene), inside * 2);
}

/// Against a look at one after the other, of cells all over the world and at several moments.
void expect_nearest(replan::Run& run, std::size_t position) {
  run.timeline().seek(position);
  const SearchState& state = run.timeline().state();
  const bool solid = run.lattice().solid();
  for (NodeId node = 0; node < run.lattice().node_count(); node += 97) {
    const Place place = place_in(run.lattice().position(node));
    std::uint32_t nearest = kNoNode;
    const auto squared = [&](std::uint32_t v) {
      return squared_between(vertex_place(state, v, solid), place);
    };
    for (std::uint32_t v = 0; v < vertex_count(state); ++v)
      if (!vertex_cost(state, v).is_infinite() && (nearest == kNoNode || squared(v) < squared(nearest)))
        nearest = v;
    ASSERT_EQ(nearest_vertex(state, place, solid), nearest) << "node " << node << " at " << position;
  }
}

TEST(TreeDebug, FindsTheNearestVertex) {
  const auto run = finished("informed-rrt-star");
  const std::size_t size = run->timeline().size();
  for (const std::size_t position : {std::size_t{0}, std::size_t{9}, size / 7, size / 2, size})
    expect_nearest(*run, position);
  auto scenario = std::make_shared<Scenario>();
  scenario->map = GridMap(12, 10, 8);
  scenario->start = {1, 1, 1};
  scenario->goal = {10, 8, 6};
  scenario->planners = {{"rrt-star", {}}};
  scenario->planners[0].settings.set("samples", 500);
  replan::Run solid(scenario, 0);
  solid.finish(Target::end());
  expect_nearest(solid, solid.timeline().size());
}

TEST(TreeDebug, TheNearestVertexIsLookedForOnceForACellAtAMoment) {
  const auto run = finished("rrt-star");
  Timeline& log = run->timeline();
  NearestVertex kept;
  const auto expect = [&](Cell cell, std::size_t searches) {
    const std::uint32_t anew = nearest_vertex(log.state(), place_in(cell), false);
    EXPECT_EQ(kept.follow(run->log_view(), run->log_id(), cell), anew);
    EXPECT_EQ(kept.searches(), searches);
  };
  log.seek(log.size() / 3);
  expect({6, 15}, 1);
  expect({6, 15}, 1);
  expect({30, 4}, 2);
  log.seek(log.size());
  expect({30, 4}, 3);
  expect({30, 4}, 3);
}

/// However the log is cut into slices, and however few gains are read of each.
TEST(TreeDebug, GainsAreReadOnAsTheLogGrows) {
  const auto run = finished("informed-rrt-star");
  const std::vector<PathGain> whole = gains_of(*run);
  ASSERT_GT(whole.size(), 5u);
  for (const std::size_t slice : {1u, 7u, 1000u, 30000u}) {
    for (const std::size_t most : {std::size_t{1}, std::size_t{3}, SIZE_MAX}) {
      PathGains read;
      read_while_growing(*run, slice, [&](const LogView& view) {
        const std::size_t before = read.gains().size();
        read.follow(view, 1, 0, view.log.size(), most);
        EXPECT_LE(read.gains().size() - before, most);
      });
      while (!read.complete()) read.follow(run->log_view(), 1, 0, run->timeline().size(), most);
      ASSERT_EQ(read.gains().size(), whole.size());
      for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(read.gains()[i].event, whole[i].event);
        EXPECT_EQ(read.gains()[i].sample, whole[i].sample);
        EXPECT_EQ(read.gains()[i].cost, whole[i].cost);
      }
    }
  }
}

/// A chart puts its playhead by expansions, and its gains by samples.
TEST(TreeDebug, ASampleIsAnExpansion) {
  for (const char* planner : {"rrt-star", "informed-rrt-star", "greedy-informed-rrt-star"}) {
    const auto run = finished(planner);
    const std::vector<PathGain> gains = gains_of(*run);
    ASSERT_FALSE(gains.empty());
    for (const PathGain& gain : gains)
      EXPECT_EQ(expansions_between(*run, 0, gain.event + 1), gain.sample) << planner;
  }
}

TEST(TreeDebug, GainsOfAnotherPlanOrLogAreReadAnew) {
  const auto run = finished("rrt-star"), other = finished("informed-rrt-star");
  PathGains read;
  read.follow(other->log_view(), other->log_id(), 0, other->timeline().size(), SIZE_MAX);
  read.follow(run->log_view(), run->log_id(), 0, run->timeline().size(), SIZE_MAX);
  const std::vector<PathGain> whole = gains_of(*run);
  ASSERT_GT(whole.size(), 1u);
  EXPECT_EQ(read.gains().size(), whole.size());
  read.follow(run->log_view(), run->log_id(), 0, whole[1].event, SIZE_MAX);
  EXPECT_EQ(read.gains().size(), 1u) << "the end has come before what was read";
  read.follow(run->log_view(), run->log_id(), whole[0].event + 1, run->timeline().size(), SIZE_MAX);
  EXPECT_EQ(read.gains().size(), whole.size() - 1);
  EXPECT_EQ(read.gains().back().cost, whole.back().cost);
}

TEST(TreeDebug, TheSecondPhaseIsToldApart) {
  const auto run = finished("greedy-informed-rrt-star");
  Timeline& log = run->timeline();
  const auto gains = gains_of(*run);
  ASSERT_GT(gains.size(), 1u);
  log.seek(gains[1].event + 1);
  const auto hand = sample_in_hand(run->log_view());
  ASSERT_TRUE(hand.has_value());
  EXPECT_TRUE(hand->pulls);
  log.seek(gains[0].event);
  EXPECT_FALSE(sample_in_hand(run->log_view())->pulls);
}

/// A condition that is offered can come true: no path is shorter than the way as the crow flies.
TEST(TreeDebug, ACostToFallBelowLiesBetweenTheLeastAndTheBest) {
  for (const double least : {0.5, 7.0, 31.4})
    for (const double above : {1e-2, 0.3, 2.0, 40.0}) {
      const double best = least + above;
      const double cost = std::stod(cost_to_fall_below(best, least));
      EXPECT_GT(cost, least) << best;
      EXPECT_LT(cost, best) << least;
    }
  EXPECT_EQ(cost_to_fall_below(60.0, 31.0), "54");
  EXPECT_EQ(cost_to_fall_below(10.0, 9.9), "9.95");
  // Without a path, or with the shortest: what a run from the beginning comes to.
  EXPECT_EQ(cost_to_fall_below(std::nullopt, 31.0), "35");
  EXPECT_EQ(cost_to_fall_below(31.0, 31.0), "35");
}

TEST(TreeDebug, WhatARewiringSavesIsNeverToldAsNothing) {
  const auto cells = [](double length) {
    return Cost{static_cast<std::int64_t>(std::llround(length * Cost::kScale))};
  };
  EXPECT_EQ(saving_text({}, cells(1.25)), "−1.2");
  EXPECT_EQ(saving_text({}, cells(0.04)), "−0.04");
  EXPECT_EQ(saving_text({}, cells(0.0004)), "−0.0004");
  EXPECT_EQ(saving_text({0.05}, cells(20)), "−1.00 m");
  EXPECT_EQ(saving_text({0.05}, cells(0.06)), "−0.003 m");
}

}  // namespace
}  // namespace replan::tree_debug_test
