// Pictures of what the window tells of trees and populations against golden ones. REPLAN_UPDATE_GOLDEN=1 writes them anew:
// look at them then.
#include "tests/ui/golden_picture.hpp"

namespace replan::app::samples_render_test {
namespace {

/// A field of cells of 5 cm in which a wall falls in the robot's way.
RenderRequest window_of(std::vector<PlannerChoice> planners, const std::string& theme) {
  RenderRequest request;
  Scenario& scenario = request.scenario;
  scenario.name = "Field";
  scenario.map = GridMap(40, 30);
  scenario.map.resolution = 0.05;
  scenario.start = {3, 15};
  scenario.goal = {36, 15};
  scenario.planners = std::move(planners);
  scenario.robot.sensor_radius = 30;
  Surprise surprise;
  surprise.at.move = 3;
  for (int y = 8; y < 23; ++y) surprise.cells.push_back({{18, y}, true});
  scenario.surprises = {surprise};
  request.window = true;
  request.width = 1024;
  request.height = 720;
  request.theme = theme;
  return request;
}

PlannerChoice planner(const char* id, const char* setting, double value) {
  PlannerChoice choice{id, {}};
  choice.settings.set(setting, value);
  return choice;
}

/// A population between two walls, each with a gap.
RenderRequest window_of_population(const std::string& theme) {
  RenderRequest request = window_of({planner("improved-ga", "generations", 20)}, theme);
  for (int y = 0; y < 30; ++y) {
    request.scenario.map.set({12, y}, y < 20 || y > 24);
    request.scenario.map.set({26, y}, y < 5 || y > 9);
  }
  return request;
}

class SamplesRenderGolden : public testing::TestWithParam<const char*> {};

TEST_P(SamplesRenderGolden, WhyAVertexHangsWhereItDoes) {
  RenderRequest request = window_of({planner("rrt-star", "samples", 600)}, GetParam());
  request.pinned = Cell{30, 15};
  request.actions = {"show_cell"};
  compare_with_golden(request, std::string("tree_cell_") + GetParam());
}

TEST_P(SamplesRenderGolden, WhatAReplanCutOff) {
  RenderRequest request = window_of({planner("rrt-star", "samples", 600)}, GetParam());
  request.at = "replan:1";
  request.actions = {"show_touched"};
  compare_with_golden(request, std::string("tree_cut_off_") + GetParam());
}

TEST_P(SamplesRenderGolden, GainsOfTwoPlanners) {
  RenderRequest request = window_of(
      {planner("rrt-star", "samples", 600), planner("informed-rrt-star", "samples", 600)}, GetParam());
  request.actions = {"show_figures"};
  compare_with_golden(request, std::string("tree_gains_") + GetParam());
}

TEST_P(SamplesRenderGolden, TheChildInHandAndPathsOverACell) {
  RenderRequest request = window_of_population(GetParam());
  request.pinned = Cell{13, 20};
  request.at = std::size_t{20'000};
  request.actions = {"show_cell"};
  compare_with_golden(request, std::string("population_cell_") + GetParam());
}

TEST_P(SamplesRenderGolden, CostOverGenerations) {
  RenderRequest request = window_of_population(GetParam());
  request.at = "replan:1";
  request.actions = {"show_figures"};
  compare_with_golden(request, std::string("population_fitness_") + GetParam());
}

INSTANTIATE_TEST_SUITE_P(Themes, SamplesRenderGolden, testing::Values("dark", "light"),
                         [](const auto& theme) { return std::string(theme.param); });

}  // namespace
}  // namespace replan::app::samples_render_test
