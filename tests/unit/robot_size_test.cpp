// A robot with a size, by example: what it gets through, how it gets away from what came too near, what keeps clear of
// it, and what of it is drawn and told.
#include <gtest/gtest.h>

#include "core/plan/replanner.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/svg.hpp"
#include "core/sim/body.hpp"
#include "core/sim/mission.hpp"
#include "core/study/figures_table.hpp"
#include "core/world/scenario.hpp"

namespace replan::robot_size_test {
namespace {

/// A wall across a hall at x = 10, with a gap of so many cells in the middle.
Scenario hall(int gap, double radius) {
  Scenario scenario;
  scenario.map = GridMap(21, 15);
  for (int y = 0; y < 15; ++y)
    if (y < 7 - gap / 2 || y >= 7 - gap / 2 + gap) scenario.map.set({10, y}, true);
  scenario.start = {3, 7};
  scenario.goal = {17, 7};
  scenario.planners = {{"dstar-lite", {}}};
  scenario.robot.radius = radius;
  return scenario;
}

MissionState driven(const Scenario& scenario) {
  const auto mission = make_mission(scenario, scenario.planners.front());
  while (mission->advance(1000)) {
  }
  return mission->state();
}

TEST(RobotSize, FitsThroughAGapAsWideAsItself) {
  // From the middle of a gap of n cells, n odd, it is n / 2 to each side.
  for (const int gap : {1, 3, 5})
    for (const double more : {-0.001, 0.0, 0.001})
      EXPECT_EQ(driven(hall(gap, gap / 2.0 + more)), more > 0 ? MissionState::no_path : MissionState::arrived)
          << gap << " " << more;
  // Of four cells, no cell's centre is more than 3 / 2 away from both sides.
  EXPECT_EQ(driven(hall(4, 1.5)), MissionState::arrived);
  EXPECT_EQ(driven(hall(4, 1.6)), MissionState::no_path);
}

TEST(RobotSize, MayOverhangTheBorderOfTheMap) {
  Scenario scenario = hall(15, 4);
  scenario.start = {0, 0};
  scenario.goal = {20, 14};
  EXPECT_EQ(driven(scenario), MissionState::arrived);
}

TEST(RobotSize, CutsNoCornersWhateverTheSettingSays) {
  Scenario scenario;
  scenario.map = GridMap(2, 2);
  scenario.map.set({1, 0}, true);
  scenario.start = {0, 0};
  scenario.goal = {1, 1};
  scenario.planners = {{"astar", {}}};
  const Parameter* corners = find_parameter(find_planner("astar")->parameters, "corners");
  ASSERT_TRUE(
      set_from_text(scenario.planners[0].settings, find_planner("astar")->parameters, corners->key, "any"));
  const auto way = [&] {
    const auto mission = make_mission(scenario, scenario.planners.front());
    while (mission->advance(1000)) {
    }
    return mission->now().figures.moves;
  };
  EXPECT_EQ(way(), 1);
  scenario.robot.radius = 0.25;
  EXPECT_EQ(way(), 2);
}

TEST(RobotSize, DrivesOutFromWhatCameTooNearAndNoDeeperIn) {
  Scenario scenario = hall(9, 1.5);
  scenario.robot.knowledge = Knowledge::all;
  Surprise surprise;
  surprise.at.move = 3;
  surprise.cells = {{{6, 8}, true}, {{7, 8}, true}};  // diagonally below the robot, at (6, 7)
  scenario.surprises.push_back(surprise);
  const auto mission = make_mission(scenario, scenario.planners.front());
  const Box box = scenario.map.box();
  double before = 0;
  bool seen = false;
  while (mission->advance(1000)) {
    if (mission->now().clock < 3 || mission->state() != MissionState::driving) continue;
    const double now = std::sqrt(Body(box, 1.5, mission->now().at, mission->now().at).nearest([&] {
      std::vector<std::uint8_t> cells = scenario.map.blocked.plain();
      cells[box.node({6, 8})] = cells[box.node({7, 8})] = 1;
      return cells;
    }()));
    seen |= now < 1.5;
    EXPECT_GE(now, before);
    before = std::min(now, 1.5);
  }
  EXPECT_TRUE(seen) << "it was too near";
  EXPECT_EQ(before, 1.5) << "and is no longer";
  EXPECT_EQ(mission->state(), MissionState::arrived);
  EXPECT_EQ(mission->now().figures.collisions, 0);
}

TEST(RobotSize, StaysWhereEveryWayOutLeadsDeeperIn) {
  Scenario scenario = hall(1, 0.75);
  scenario.start = {10, 7};  // in the gap: half a cell from both sides
  const auto mission = make_mission(scenario, scenario.planners.front());
  while (mission->advance(1000)) {
  }
  EXPECT_EQ(mission->state(), MissionState::arrived) << "straight out of it is no nearer to its sides";
  scenario.map.set({9, 6}, true), scenario.map.set({9, 8}, true);
  scenario.map.set({11, 6}, true), scenario.map.set({11, 8}, true);
  scenario.map.set({9, 7}, true), scenario.map.set({11, 7}, true);
  EXPECT_EQ(driven(scenario), MissionState::no_path);
}

TEST(RobotSize, WhatMovesKeepsClearOfItsBody) {
  Scenario scenario = hall(15, 2);
  scenario.start = scenario.goal = {10, 7};
  scenario.movers = {{.way = {{10, 0}, {10, 14}}, .speed = 4, .at_end = WayEnd::stop}};
  Surprise keeps_it_there;
  keeps_it_there.at.move = 40;
  keeps_it_there.goal = {10, 7};
  scenario.surprises.push_back(keeps_it_there);
  const auto mission = make_mission(scenario, scenario.planners.front());
  while (mission->advance(1000)) {
  }
  EXPECT_EQ(mission->state(), MissionState::arrived);
  const Mover mover(scenario.movers[0]);
  EXPECT_EQ(mover.at(mission->now().movers[0].steps), (Cell{10, 4}))
      << "2 1/2 cells from the centre: 3 would be 1 1/2";
}

TEST(RobotSize, FiguresTellTheClearanceOfItsEdge) {
  const Scenario sized = hall(5, 1.25), point = hall(5, 0);
  const RunReport report = drive(sized, sized.planners[0]), plain = drive(point, point.planners[0]);
  const auto value = [](const RunReport& of, std::string_view key) -> std::optional<double> {
    for (const NamedFigure& figure : named_figures(of))
      if (figure.key == key) return figure.value;
    return std::nullopt;
  };
  EXPECT_EQ(*value(report, "min_edge_clearance"), *value(report, "min_clearance") - 1.25);
  EXPECT_EQ(*value(report, "mean_edge_clearance"), *value(report, "mean_clearance") - 1.25);
  EXPECT_GE(*value(report, "min_edge_clearance"), 0);
  EXPECT_FALSE(value(plain, "min_edge_clearance"));
  EXPECT_EQ(named_figures(plain).size(), 14u);
  const RunReport reports[] = {report};
  EXPECT_NE(runs_csv(reports).find("mean_clearance,min_edge_clearance,mean_edge_clearance,plan_ms"),
            std::string::npos);
  EXPECT_NE(figures_text(FiguresFormat::markdown, reports).find("least clearance of the edge (cells)"),
            std::string::npos);
  const RunReport plains[] = {plain};
  EXPECT_EQ(figures_text(FiguresFormat::markdown, plains).find("edge"), std::string::npos);
}

TEST(RobotSize, IsDrawnWithWhereItsCentreCannotBe) {
  Palette palette;
  palette.robot = 0xFF0000FF;
  palette.obstacle = 0xFF202020;
  const auto picture = [&](double radius, bool shade) {
    replan::Run run(std::make_shared<const Scenario>(hall(5, radius)), 0);
    run.finish(Target::end());
    run.timeline().seek(run.timeline().size() / 2);
    View view;
    view.overlays.set(Overlay::size, shade);
    return build_scene(run, view, {800, 600}, palette);
  };
  const auto shaded = [&palette](const Scene& scene) {
    int count = 0;
    for (const Shape& shape : scene.shapes)
      if (const auto* outline = std::get_if<Outline>(&shape))
        count +=
            outline->shape == OutlineShape::filled && outline->colour == faded(palette.obstacle, 0.4) ? 1 : 0;
    return count;
  };
  const auto bodies = [](const Scene& scene, double radius) {
    int count = 0;
    for (const Shape& shape : scene.shapes)
      if (const auto* ring = std::get_if<Ring>(&shape))
        count += ring->radius == radius && ring->dash == 0 ? 1 : 0;
    return count;
  };
  const Scene sized = picture(1.25, true);
  // One column on each side of the wall, and one cell at each end of the gap; there are two of its corners.
  EXPECT_EQ(shaded(sized), 2 * (10 + 2) + 2);
  EXPECT_TRUE(sized.shows(Sign::too_near));
  EXPECT_EQ(bodies(sized, 1.25), 1);
  EXPECT_EQ(shaded(picture(1.25, false)), 0);
  EXPECT_EQ(shaded(picture(0, true)), 0);
  EXPECT_FALSE(picture(0, true).shows(Sign::too_near));
  EXPECT_NE(scene_svg(sized, palette).find("<circle"), std::string::npos);
}

TEST(RobotSize, IsOneSentenceToWhoPlansByHimself) {
  for (const double wrong : {-1.0, 33.0, std::nan("")}) {
    const auto made = Replanner::make(Box(4, 4), std::vector<std::uint8_t>(16), "astar", {}, wrong);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error(), "a robot cannot have such a radius: give a number of cells from 0 to 32");
  }
  const auto touching =
      Replanner::make(Box(4, 4), std::vector<std::uint8_t>(16), "visibility-graph", {}, 0.5);
  ASSERT_FALSE(touching);
  EXPECT_EQ(touching.error().find("'visibility-graph' plans for a robot without a size alone"), 0u);
  std::vector<std::uint8_t> cells(25);
  cells[12] = 1;
  auto made = Replanner::make(Box(5, 5), cells, "astar", {}, 1);
  ASSERT_TRUE(made);
  EXPECT_EQ(*made->plan({0, 2}, {4, 2}), PlanStatus::found);
  EXPECT_EQ(made->path().size(), 9u) << "round by the rows at the border: the next ones are too near";
  EXPECT_TRUE(made->blocked({2, 2}));
  EXPECT_FALSE(made->blocked({2, 1}));
}

}  // namespace
}  // namespace replan::robot_size_test
