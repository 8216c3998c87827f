// Runs and batches: what their reports say.
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/study/batch.hpp"
#include "core/study/figures_table.hpp"
#include "core/study/run_report.hpp"
#include "core/world/choices.hpp"
#include "core/world/formats/voxel_map.hpp"

namespace replan::test::study_test {
namespace {

GridMap map_of(const std::vector<std::string>& rows) {
  GridMap map(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      map.set({x, y}, rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '@');
  return map;
}

Scenario corridor() {
  Scenario scenario;
  scenario.map = map_of({".......", "...@...", "......."});
  scenario.start = {0, 1};
  scenario.goal = {6, 1};
  scenario.planners = {{.id = "dstar-lite", .settings = {}}};
  scenario.robot.sensor_radius = 2;
  return scenario;
}

std::vector<ScenProblem> problems(int count) {
  std::vector<ScenProblem> result(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) result[static_cast<std::size_t>(i)].line = i;
  return result;
}

std::vector<int> sampled(int count, std::size_t limit) {
  std::vector<int> lines;
  for (const ScenProblem& problem : even_sample(problems(count), limit)) lines.push_back(problem.line);
  return lines;
}

TEST(EvenSample, spreadsOverTheFileWithItsEnds) {
  EXPECT_EQ(sampled(9, 3), (std::vector{0, 4, 8}));
  EXPECT_EQ(sampled(10, 4), (std::vector{0, 3, 6, 9}));
  EXPECT_EQ(sampled(5, 1), (std::vector{0}));
  EXPECT_EQ(sampled(3, 0), (std::vector{0, 1, 2}));
  EXPECT_EQ(sampled(3, 3), (std::vector{0, 1, 2}));
  EXPECT_EQ(sampled(3, 60), (std::vector{0, 1, 2}));
  EXPECT_TRUE(sampled(0, 5).empty());
}

TEST(Batch, solvesProblemsInThreeDimensions) {
  GridMap box(5, 4, 3);
  for (int y = 0; y < 4; ++y)
    for (int x = 1; x < 5; ++x) box.blocked[box.index({x, y, 1})] = 1;  // a floor with a gap at x = 0
  const auto scen = parse_voxel_scen(
      "version 1\nb\n0 0 0 0 1 2 2.41421356 1\n2 2 0 2 2 2 6.00000000 3\n0 0 0 1 1 0 1.41421356 1\n"
      "1 1 1 0 0 0 1.00000000 1\n0 0 0 0 0 2 3.00000000 1\n",
      "b.3dscen");
  ASSERT_TRUE(scen.ok()) << scen.error();
  EXPECT_EQ(scen->lengths.digits, 8);
  const BatchReport report = run_batch(box, scen->lengths, scen->problems, {"astar", {}});
  EXPECT_TRUE(report.comparable);
  EXPECT_EQ(report.problems, 5);
  EXPECT_EQ(report.skipped, 1);
  EXPECT_EQ(report.found, 4);
  EXPECT_EQ(report.mismatches, 1);
  ASSERT_EQ(report.first_mismatches.size(), 1u);
  EXPECT_EQ(report.first_mismatches[0].line, 7);
  EXPECT_EQ(report.first_mismatches[0].found, 2);
}

TEST(LengthsApply, toShortestPathsUnderTheFilesRules) {
  EXPECT_TRUE(lengths_apply({"astar", {}}));
  EXPECT_TRUE(lengths_apply({"dstar-lite", {}}));
  EXPECT_FALSE(lengths_apply({"dld-star-lite", {}}));
  for (const auto& [key, value] : {std::pair{"moves", 1.0}, {"corners", 2.0}, {"heuristic", 3.0}}) {
    PlannerChoice choice{"astar", {}};
    choice.settings.set(key, value);
    EXPECT_FALSE(lengths_apply(choice)) << key;
  }
}

ScenFile scen(const std::string& lines) {
  auto file = parse_scen("version 1\n" + lines, "test.scen");
  EXPECT_TRUE(file.ok()) << file.error();
  return file.value();
}

BatchReport batch(const ScenFile& file, const std::string& planner) {
  const GridMap map = map_of({"...@.", ".@.@.", "...@."});
  return run_batch(map, file.lengths, file.problems, {planner, {}});
}

TEST(Batch, countsWhatAgreesWhatDoesNotAndWhatIsSkipped) {
  const ScenFile file = scen(
      "0 m.map 5 3 0 0 2 0 2\n"        // agrees
      "0 m.map 5 3 0 0 2 2 4.5\n"      // the length is 4
      "0 m.map 5 3 1 1 0 0 1\n"        // starts in an obstacle
      "0 m.map 5 3 0 0 4 0 6.82842\n"  // no way there
      "0 m.map 5 3 1 0 1 0 0\n");      // to where it stands
  const BatchReport report = batch(file, "astar");
  EXPECT_TRUE(report.comparable);
  EXPECT_EQ(report.problems, 5);
  EXPECT_EQ(report.skipped, 1);
  EXPECT_EQ(report.found, 3);
  EXPECT_EQ(report.unsolved(), 1);
  EXPECT_EQ(report.mismatches, 2);
  EXPECT_FALSE(report.passed());
  ASSERT_EQ(report.first_mismatches.size(), 2u);
  EXPECT_EQ(report.first_mismatches[0].line, 3);
  EXPECT_EQ(report.first_mismatches[0].found, 4);
  EXPECT_EQ(report.first_mismatches[1].line, 5);
  EXPECT_EQ(report.first_mismatches[1].found, 0);
  EXPECT_NEAR(report.max_relative_error, 0.5 / 4.5, 1e-12);
  EXPECT_NEAR(report.mean_ratio, (1 + 4 / 4.5) / 2, 1e-12);
}

TEST(Batch, holdsNoPlannerToLengthsThatItDoesNotLookFor) {
  const BatchReport report = batch(scen("0 m.map 5 3 0 0 2 2 4.5\n"), "dld-star-lite");
  EXPECT_FALSE(report.comparable);
  EXPECT_EQ(report.mismatches, 0);
  EXPECT_TRUE(report.passed());
  EXPECT_FALSE(batch(scen("0 m.map 5 3 0 0 4 0 4\n"), "dld-star-lite").passed())
      << "a path that is not found";
}

TEST(Batch, oneInstanceGivesWhatFreshOnesGive) {
  const std::string first = "0 m.map 5 3 0 0 2 2 4\n", second = "0 m.map 5 3 2 2 0 0 4\n";
  for (const PlannerInfo& info : choices()) {
    const std::string id(info.id);
    EXPECT_EQ(batch(scen(first + second), id).expansions,
              batch(scen(first), id).expansions + batch(scen(second), id).expansions)
        << id;
  }
}

TEST(Batch, stopsWhenAsked) {
  const GridMap map(5, 3);
  const ScenFile file = scen("0 m.map 5 3 0 0 2 0 2\n0 m.map 5 3 0 0 3 0 3\n0 m.map 5 3 0 0 4 0 4\n");
  std::stop_source source;
  std::size_t told = 0;
  const BatchWatch watch{.progress =
                             [&](std::size_t done) {
                               told = done;
                               if (done == 2) source.request_stop();
                             },
                         .stop = source.get_token()};
  EXPECT_EQ(run_batch(map, file.lengths, file.problems, {"astar", {}}, watch).problems, 2);
  EXPECT_EQ(told, 2u);
}

TEST(RunReport, aPlanHasItsPathAndFigures) {
  const Scenario world = corridor();
  const RunReport report = plan_once(world.map, world.start, world.goal, world.planners.front());
  EXPECT_EQ(report.status, "found");
  EXPECT_TRUE(report.succeeded());
  EXPECT_EQ(cell_of(report.path.point(0)), world.start);
  EXPECT_EQ(cell_of(report.path.point(report.path.size() - 1)), world.goal);
  EXPECT_EQ(report.figures.nodes, static_cast<std::int64_t>(report.path.size()));
  EXPECT_NEAR(report.figures.length, 4 + 2 * std::sqrt(2.0), 1e-9);
  EXPECT_GT(report.counters.expansions, 0);
  EXPECT_GT(report.memory_bytes, 0);
  EXPECT_FALSE(report.robot.has_value());
}

/// A straight line through walls is no shortest path.
TEST(RunReport, holdsNoPlanAgainstABlindOne) {
  Scenario world = corridor();
  const RunReport reports[] = {drive(world, {"dwa", {}}), drive(world, {"fusion", {}})};
  EXPECT_TRUE(reports[0].blind);
  EXPECT_FALSE(reports[1].blind);
  bool fusion_competes = false;
  for (const FigureRow& row : figures_table(reports).rows) {
    EXPECT_TRUE(row.info->group == FigureGroup::robot || !row.competes[0]) << row.info->key;
    fusion_competes |= row.competes[1];
  }
  EXPECT_TRUE(fusion_competes);
}

TEST(RunReport, figuresAreFiniteNumbersWhateverHappens) {
  Scenario world = corridor();
  world.goal = {3, 1};
  for (const PlannerInfo& info : choices()) {
    const RunReport reports[] = {plan_once(world.map, world.start, world.goal, {std::string(info.id), {}}),
                                 drive(world, {std::string(info.id), {}})};
    EXPECT_FALSE(reports[0].succeeded() || reports[1].succeeded());
    const auto json = nlohmann::json::parse(runs_json(reports));
    for (const auto& run : json["runs"]) {
      EXPECT_EQ(run["status"], "goal-blocked");
      EXPECT_TRUE(run["path"].empty());
      EXPECT_EQ(run["figures"].size(), 14u);
      for (const auto& [key, value] : run["figures"].items()) EXPECT_TRUE(value.is_number()) << key;
    }
  }
}

TEST(RunReport, tellsTheFirstPlanAndTheWholeDrive) {
  Scenario world = corridor();
  const RunReport plain = plan_once(world.map, world.start, world.goal, world.planners.front());
  const int row = cell_of(plain.path.point(3)).y;
  world.surprises = {
      {.at = {.move = 1, .near = {}, .within = 0}, .cells = {{{3, row}, true}}, .announced = false}};
  const RunReport report = drive(world, world.planners.front());
  ASSERT_TRUE(report.robot.has_value());
  EXPECT_EQ(report.path, plain.path) << "the plan before the surprise";
  EXPECT_TRUE(report.robot->reached());
  EXPECT_GE(report.robot->replans, 1);
  EXPECT_EQ(report.replans, report.robot->replans);
  EXPECT_GT(report.robot->travelled, report.figures.length);
  EXPECT_GT(report.counters.expansions, plain.counters.expansions);
}

TEST(RunReport, aWayThatOpensLaterIsASuccess) {
  Scenario world = corridor();
  for (const int y : {0, 2}) world.map.set({3, y}, true);
  world.surprises = {
      {.at = {.move = 2, .near = {}, .within = 0}, .cells = {{{3, 1}, false}}, .announced = true}};
  const RunReport report = drive(world, world.planners.front());
  EXPECT_EQ(report.status, "no-path");
  EXPECT_TRUE(report.path.empty());
  EXPECT_TRUE(report.succeeded());
}

TEST(RunReport, csvHasOneColumnForEachName) {
  const Scenario world = corridor();
  const RunReport reports[] = {drive(world, world.planners.front())};
  const std::string csv = runs_csv(reports);
  const std::string names = csv.substr(0, csv.find('\n')), line = csv.substr(names.size() + 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), ','), std::count(line.begin(), line.end(), ','));
  EXPECT_TRUE(names.ends_with("robot_moves,robot_travelled,robot_collisions,robot_replans,robot_seconds"));
}

TEST(RunReport, hasTheFiguresOfADriveOnlyWhereSomethingDrives) {
  Scenario world = corridor();
  const RunReport walks = drive(world, world.planners.front());
  world.robot.kind = "dwa";
  const RunReport drives = drive(world, world.planners.front());
  ASSERT_TRUE(drives.succeeded());
  for (const NamedFigure& figure : drive_figures(*walks.robot)) EXPECT_FALSE(figure.value) << figure.key;
  for (const NamedFigure& figure : drive_figures(*drives.robot)) EXPECT_TRUE(figure.value) << figure.key;
  const RunReport both[] = {walks, drives};
  const std::string csv = runs_csv(both), names = csv.substr(0, csv.find('\n'));
  EXPECT_NE(names.find("robot_mean_speed,robot_top_speed,robot_mean_curvature,robot_turned_deg,"),
            std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), ','), 3 * std::count(names.begin(), names.end(), ','));
  EXPECT_EQ(runs_json({both, 1}).find("mean_speed"), std::string::npos);
  EXPECT_NE(runs_json({both + 1, 1}).find("mean_speed"), std::string::npos);
}

/// What is said of an open field whose script goes wrong at the robot's second step.
std::string told_of(Surprise surprise, bool robot_cell_blocks = true) {
  Scenario world;
  world.map = GridMap(7, 2);
  world.goal = {6, 0};
  world.planners = {{"astar", {}}};
  world.robot.robot_cell_blocks = robot_cell_blocks;
  surprise.at.move = 2;
  world.surprises = {std::move(surprise)};
  return explanation(drive(world, world.planners.front()));
}

TEST(RunReport, saysByNameWhichCellIsBlocked) {
  Surprise on_robot, on_goal, put_into_wall, around;
  on_robot.cells = {{{2, 0}, true}};
  on_goal.cells = {{{6, 0}, true}};
  put_into_wall.cells = {{{4, 1}, true}};
  put_into_wall.robot = Cell{4, 1};
  for (int x = 1; x <= 3; ++x)
    for (int y = 0; y < 2; ++y) around.cells.push_back({{x, y}, true});
  EXPECT_EQ(told_of(on_robot),
            "The robot did not arrive: its own cell is an obstacle, and it cannot leave it.");
  EXPECT_EQ(told_of(on_robot, false), "");
  EXPECT_EQ(told_of(put_into_wall, false), told_of(on_robot));
  EXPECT_EQ(told_of(on_goal), "The robot did not arrive: the goal's cell has become an obstacle.");
  EXPECT_EQ(told_of(around, false),
            "The robot did not arrive: an obstacle covers its own cell, and no way leads out of it.");
  around.cells = {{{3, 0}, true}, {{3, 1}, true}};
  EXPECT_EQ(told_of(around), "The robot did not arrive: the way to the goal was cut off while it drove.");
}

TEST(RunReport, saysHowNearToTheGoalTheRobotCame) {
  Scenario world;
  world.map = GridMap(7, 2);
  world.map.set({6, 0}, true);
  world.map.set({5, 0}, true);
  world.goal = {6, 0};
  world.planners = {{"astar", {}}};
  EXPECT_EQ(explanation(drive(world, world.planners.front())), status_sentence(PlanStatus::goal_blocked));
  world.robot.unreachable_goal = UnreachableGoal::nearest;
  const RunReport driven[] = {drive(world, world.planners.front())};
  EXPECT_EQ(driven[0].status, "found-nearest");
  EXPECT_EQ(cell_of(driven[0].path.point(driven[0].path.size() - 1)), (Cell{6, 1}));
  EXPECT_FALSE(driven[0].succeeded());
  EXPECT_EQ(driven[0].robot->short_of_goal, 1);
  EXPECT_EQ(explanation(driven[0]),
            "The goal cannot be reached: the robot stands on the reachable cell nearest to it, 1.000 cells "
            "away.");
  for (const char* part :
       {"\"ending\": \"nearest\"", "\"last_status\": \"found-nearest\"", "\"short_of_goal\": 1"})
    EXPECT_NE(runs_json(driven).find(part), std::string::npos) << runs_json(driven);
  const RunReport planned = plan_once(world.map, world.start, world.goal, world.planners.front(),
                                      {.unreachable_goal = UnreachableGoal::nearest});
  EXPECT_EQ(planned.status, "found-nearest");
  EXPECT_EQ(planned.path, driven[0].path);
  EXPECT_FALSE(planned.succeeded());
}

}  // namespace
}  // namespace replan::test::study_test
