// Experiments: what their files say, which runs they make, and what such a run is.
#include "core/experiment/experiment.hpp"

#include <set>

#include <gtest/gtest.h>

#include "core/experiment/batch_report.hpp"
#include "core/experiment/random_blocks.hpp"
#include "core/experiment/results_text.hpp"
#include "core/plan/navigator.hpp"
#include "core/study/run_report.hpp"
#include "tests/support/experiments.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::experiment_test {
namespace {

using test::kRoomMap;
using test::kRoomProblems;

class Experiments : public ::testing::Test {
 protected:
  Experiments() {
    folder_.with("room.map", kRoomMap);
    folder_.with("room.map.scen", kRoomProblems);
    folder_.with("other.map.scen", kRoomProblems);
  }

  /// The keys of an experiment besides its format.
  [[nodiscard]] Result<Experiment> parsed(const std::string& keys) const {
    return parse_experiment(R"({"format": "replan experiment", "version": 1, )" + keys + "}", "x.json",
                            folder_.path());
  }
  [[nodiscard]] Experiment experiment(const std::string& keys) const {
    auto read = parsed(keys);
    EXPECT_TRUE(read) << (read ? "" : read.error());
    return read ? std::move(read.value()) : Experiment{};
  }
  [[nodiscard]] RunList list(const std::string& keys) const {
    auto loaded = RunList::load(experiment(keys));
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error());
    return std::move(loaded.value());
  }
  /// What is said of an experiment, with nothing else wrong with it.
  [[nodiscard]] std::string complaint(const std::string& keys) const {
    const auto read = parsed(R"("worlds": ["room.map.scen"], "planners": [{"id": "astar"}], )" + keys);
    return read ? "" : read.error();
  }

  test::TemporaryFolder folder_;
};

TEST_F(Experiments, SweepWhatIsListedWithTheLastSettingFastest) {
  const Experiment read = experiment(
      R"("worlds": ["room.map.scen"], "planners": [{"id": "weighted-astar",
         "settings": {"weight": [1, 2.5], "corners": ["none", "any"]}}, {"id": "astar"}])");
  ASSERT_EQ(read.planners.size(), 5u);
  EXPECT_EQ(settings_label(read.planners[0]), "corners=none weight=1");
  EXPECT_EQ(settings_label(read.planners[1]), "corners=any weight=1");
  EXPECT_EQ(settings_label(read.planners[2]), "corners=none weight=2.5");
  EXPECT_EQ(settings_label(read.planners[4]), "");
}

TEST_F(Experiments, SayWhatIsWrongAndHowToMendIt) {
  EXPECT_EQ(complaint(R"("sedes": [1])"), "x.json:1: sedes: unknown key; did you mean 'seeds'?");
  EXPECT_NE(complaint(R"("repeat": 0)").find("must be a whole number from 1 to 1000, not 0"),
            std::string::npos);
  EXPECT_NE(complaint(R"("seeds": [1, 1])").find("seeds[1]: is there twice"), std::string::npos);
  EXPECT_NE(complaint(R"("seeds": {"from": 1, "cuont": 2})").find("did you mean 'count'?"),
            std::string::npos);
  EXPECT_NE(complaint(R"("surprises": ["own"])").find("give \"drive\": true"), std::string::npos);
  EXPECT_NE(complaint(R"("robots": ["mine"])").find("\"own\" for that of the scenario"), std::string::npos);
  EXPECT_NE(complaint(R"("drive": true, "surprises": [{"blocks": 2, "side": 4, "ahead": 5}])")
                .find("must be a number from 6 to 640, not 5"),
            std::string::npos);
  EXPECT_NE(complaint(R"("drive": true, "limit": {"seconds": 1})").find("is for planning alone"),
            std::string::npos);
  const auto planner = [&](const char* text) {
    const auto read = parsed(R"("worlds": ["room.map.scen"], "planners": [)" + std::string(text) + "]");
    return read ? "" : read.error();
  };
  EXPECT_NE(planner(R"({"id": "astr"})").find("did you mean 'astar'?"), std::string::npos);
  EXPECT_NE(planner(R"({"id": "weighted-astar", "settings": {"weight": [1, 2000]}})").find("weight[1]"),
            std::string::npos);
  EXPECT_NE(planner(R"({"id": "rrt", "settings": {"seed": 3}})").find("is one of 'seeds'"),
            std::string::npos);
  EXPECT_NE(planner(R"({"id": "astar"}, {"id": "astar"})").find("with the same settings"), std::string::npos);
  const auto world = [&](const char* text) {
    const auto read = parsed(R"("planners": [{"id": "astar"}], "worlds": [)" + std::string(text) + "]");
    return read ? "" : read.error();
  };
  EXPECT_NE(world(R"("no*.scen")").find("no file matches 'no*.scen'"), std::string::npos);
  EXPECT_NE(world(R"("room.map.scen", "room.*.scen")").find("'room.map.scen' is there twice"),
            std::string::npos);
  EXPECT_NE(world(R"({"file": "room.map", "limit": 3})").find("goes with a file of problems"),
            std::string::npos);
  EXPECT_NE(world(R"({"file": "room.map.scen", "start": [1, 1]})").find("goes with a map"),
            std::string::npos);
  EXPECT_NE(parse_experiment("{}", "x.json", ".").error().find("not an experiment"), std::string::npos);
  EXPECT_NE(parse_experiment(R"({"format": "replan experiment", "version": 2})", "x.json", ".")
                .error()
                .find("must be 1, the only version"),
            std::string::npos);
}

TEST_F(Experiments, SayWhichWorldAPlannerOrACellDoesNotFit) {
  const auto error = [&](const std::string& keys) {
    const auto loaded = RunList::load(experiment(keys));
    return loaded ? "" : loaded.error();
  };
  EXPECT_EQ(
      error(
          R"("planners": [{"id": "astar"}], "worlds": [{"file": "room.map", "start": [9, 1], "goal": [1, 1]}])"),
      "room.map: the start (9, 1) is not on the map");
  EXPECT_NE(error(R"("planners": [{"id": "astar"}], "worlds": ["room.map"])").find("the map has no start"),
            std::string::npos);
  EXPECT_NE(error(R"("planners": [{"id": "astar"}], "worlds": ["away.map.scen"])").find("away.map.scen"),
            std::string::npos);
}

TEST_F(Experiments, ReadBackWhatIsWrittenOut) {
  const Experiment read = experiment(
      R"("name": "all of it", "worlds": ["*.scen", {"file": "room.map", "start": [0, 0], "goal": [7, 0], "unknown": "free"}],
         "planners": [{"id": "rrt-star", "settings": {"step": [2, 4]}, "stages": [{"id": "floyd"}]}, {"id": "dstar-lite"}],
         "robots": ["own", {"radius": 0.5, "knowledge": "nothing"}], "seeds": {"from": 3, "count": 4}, "repeat": 2,
         "drive": true, "surprises": ["none", "own", {"blocks": 2, "side": 2}], "limit": {"samples": 300})");
  EXPECT_EQ(read.worlds.size(), 3u);
  const auto again = parse_experiment(experiment_text(read), "again.json", read.folder);
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(experiment_text(*again), experiment_text(read));
  EXPECT_EQ(again->planners, read.planners);
  EXPECT_EQ(again->robots, read.robots);
  EXPECT_EQ(again->worlds, read.worlds);
  EXPECT_EQ(again->surprises, read.surprises);
  EXPECT_EQ(again->seeds, read.seeds);
}

TEST_F(Experiments, NumberTheirRunsAndMakeNoneTwice) {
  const RunList runs = list(
      R"("worlds": ["room.map.scen", {"file": "room.map", "start": [0, 0], "goal": [7, 0]}], "drive": true,
         "planners": [{"id": "astar"}, {"id": "rrt", "settings": {"samples": [100, 200]}}], "seeds": [5, 6, 7],
         "robots": [{}, {"radius": 0.5}], "surprises": ["none", {"blocks": 1, "side": 1}])");
  // Five questions for two robots; A* has one run without surprises and three with, the two of rrt three of each.
  EXPECT_EQ(runs.count(), 5 * 2 * (1 + 3 + 2 * 6));
  std::set<RunName> names;
  RunParts before;
  for (std::int64_t run = 0; run < runs.count(); ++run) {
    const RunParts parts = runs.parts(run);
    EXPECT_TRUE(names.insert(runs.name(parts)).second) << run;
    const auto digits = [](const RunParts& p) {
      return std::tuple(p.world, p.robot, p.planner, p.problem, p.surprises, p.seed);
    };
    EXPECT_TRUE(run == 0 || digits(before) < digits(parts)) << run;
    before = parts;
  }
}

TEST(Experiment, OfTheDocumentationCanBeRun) {
  auto read = read_experiment(std::string(REPLAN_SOURCE_DIR) + "/docs/experiment.json");
  ASSERT_TRUE(read) << read.error();
  const auto runs = RunList::load(std::move(read.value()));
  ASSERT_TRUE(runs) << runs.error();
  EXPECT_GT(runs->count(), 100);
}

TEST_F(Experiments, TakeGeneratedMapsWhoseEndsAreFree) {
  const RunList runs = list(
      R"("worlds": [{"file": "generator:cells?width=30&height=20&seed=4&fraction=0.3", "start": [3, 3], "goal": [26, 15]}],
         "planners": [{"id": "astar"}])");
  ASSERT_EQ(runs.count(), 1);
  const Scenario made = runs.scenario(runs.parts(0));
  EXPECT_EQ(made.map.width, 30);
  EXPECT_FALSE(made.map.at(made.start) || made.map.at(made.goal));
}

TEST_F(Experiments, DependOnTheBytesOfTheirFilesAndOnEverySetting) {
  const std::string keys = R"("worlds": ["room.map.scen"], "planners": [{"id": "astar"}])";
  const std::string digest = list(keys).digest();
  EXPECT_EQ(list(keys).digest(), digest);
  EXPECT_NE(list(keys + R"(, "repeat": 2)").digest(), digest);
  std::string map = kRoomMap;
  map.back() = '.';
  folder_.with("room.map", map + "\n");
  const auto changed = RunList::load(experiment(keys));
  EXPECT_TRUE(!changed || changed->digest() != digest);
}

TEST_F(Experiments, HoldLengthsAgainstTheListedOnes) {
  const RunList runs = list(
      R"("worlds": ["room.map.scen"], "planners": [{"id": "astar"}, {"id": "theta-star"}], "repeat": 3)");
  const auto results = test::results_of(runs);
  ASSERT_EQ(results.size(), 8u);
  EXPECT_EQ(results[0].mismatch, false);
  EXPECT_EQ(results[1].ratio().value_or(0) > 0.99, true);
  EXPECT_EQ(results[2].status, "skipped");
  EXPECT_FALSE(results[2].mismatch);
  EXPECT_EQ(results[3].status, "no-path");
  EXPECT_EQ(results[3].mismatch, true);
  EXPECT_FALSE(results[4].mismatch) << "theta-star looks for other paths";
  EXPECT_EQ(results[0].plan_ms.size(), 3u);
  const auto reports = batch_reports(results);
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0].mismatches, 1);
  ASSERT_EQ(reports[0].first_mismatches.size(), 1u);
  EXPECT_EQ(reports[0].first_mismatches[0], (BatchMismatch{"room.map.scen", 5, 0, 9}));
  EXPECT_EQ(reports[0].skipped, 1);
  EXPECT_EQ(reports[1].found, 2);
}

TEST_F(Experiments, GiveEachRunAsAScenarioThatComesToTheSame) {
  const RunList runs = list(
      R"("worlds": ["room.map.scen"], "drive": true, "planners": [{"id": "dstar-lite"}, {"id": "rrt"}],
         "seeds": [1, 2], "robots": [{"sensor_radius": 3}], "surprises": [{"blocks": 2, "side": 1, "ahead": 3}])");
  for (const RunResult& result : test::results_of(runs)) {
    if (result.skipped()) continue;
    const auto again = parse_scenario(scenario_text(runs.scenario(runs.parts(result.run))), "run.json", ".");
    ASSERT_TRUE(again) << again.error();
    const RunReport report = drive(*again, again->planners.front());
    EXPECT_EQ(report.succeeded(), result.succeeded) << result.run;
    EXPECT_EQ(report.robot->travelled, result.figure("travelled_cells").value_or(-1)) << result.run;
    EXPECT_EQ(static_cast<double>(report.counters.expansions), result.figure("expansions")) << result.run;
  }
}

TEST_F(Experiments, CountTheSurprisesThatTheRobotCameToKnowOf) {
  folder_.with("field.map", [] {
    std::string map = "type octile\nheight 20\nwidth 40\nmap\n";
    for (int y = 0; y < 20; ++y) map += std::string(40, '.') + "\n";
    return map;
  }());
  const RunList runs = list(
      R"("worlds": [{"file": "field.map", "start": [1, 10], "goal": [38, 10]}], "drive": true,
         "planners": [{"id": "dstar-lite"}], "seeds": {"from": 1, "count": 20},
         "robots": [{"sensor_radius": 2}, {"sensor_radius": 12}, {"knowledge": "all"}],
         "surprises": ["none", {"blocks": 3, "side": 2, "ahead": 6}])");
  double seen[3] = {};
  for (const RunResult& result : test::results_of(runs)) {
    const RunParts parts = runs.parts(result.run);
    const auto noticed = result.figure("surprises_noticed");
    ASSERT_TRUE(noticed) << result.run;
    EXPECT_LE(*noticed, parts.surprises == 0 ? 0 : 3) << result.run;
    EXPECT_EQ(*noticed == 0, result.figure("replans") == 0) << "it learns of nothing else";
    seen[parts.robot] += *noticed;
    // The drive told by its events: which blocks are on the robot's map in the end.
    const Scenario scenario = runs.scenario(parts);
    double on_map = 0;
    drive(scenario, scenario.planners.front(), [&](const Mission& mission) {
      on_map = 0;
      for (const Surprise& surprise : scenario.surprises)
        on_map += std::any_of(surprise.cells.begin(), surprise.cells.end(), [&](const CellChange& change) {
          return mission.navigator().known()[scenario.map.index(change.cell)] != 0;
        });
    });
    EXPECT_EQ(*noticed, on_map) << result.run;
  }
  for (const double each : seen) EXPECT_GT(each, 0);
}

TEST(Surprises, AreNoticedWhereTheRobotLooksOrIsTold) {
  Scenario world;
  world.map = GridMap(30, 30);
  world.start = {1, 2};
  world.goal = {28, 2};
  world.planners = {{"dstar-lite", {}}};
  const auto block = [](Cell cell, bool announced) {
    return Surprise{
        .at = {.move = 3, .near = {}, .within = 0}, .cells = {{cell, true}}, .announced = announced};
  };
  const auto noticed = [&](double sees, bool told, std::optional<Cell> goal) {
    world.robot.sensor_radius = sees;
    std::vector<Surprise> all = {block({15, 2}, false), block({15, 20}, told)};
    if (goal) all.push_back({.at = {.move = 5, .near = {}, .within = 0}, .cells = {}, .goal = goal});
    world.surprises = all;
    const RunReport report = drive(world, world.planners.front());
    EXPECT_TRUE(report.succeeded());
    return report.robot->noticed;
  };
  EXPECT_EQ(noticed(2, false, {}), 1) << "the other one dropped where it never looked";
  EXPECT_EQ(noticed(25, false, {}), 2);
  EXPECT_EQ(noticed(2, true, {}), 2);
  EXPECT_EQ(noticed(2, false, Cell{28, 4}), 2) << "a new goal is no secret";
}

TEST_F(Experiments, TakeWorldsThatAreLoadedAlreadyAsTheyAre) {
  const std::string keys = R"("worlds": ["room.map.scen", "other.map.scen"], "planners": [{"id": "astar"}])";
  const std::string digest = list(keys).digest();
  Experiment asked = experiment(keys);
  auto first = load_world(asked, asked.worlds.front());
  ASSERT_TRUE(first) << first.error();
  std::vector<LoadedWorld> loaded;
  loaded.push_back(std::move(first.value()));
  folder_.with("room.map.scen", "nobody reads this again");
  const auto runs = RunList::load(std::move(asked), std::move(loaded));
  ASSERT_TRUE(runs) << runs.error();
  EXPECT_EQ(runs->digest(), digest);
  EXPECT_EQ(runs->count(), 8);
}

TEST(RandomBlocks, LeaveAWayAndDropAheadOfTheRobot) {
  Scenario world;
  world.map = GridMap(60, 40);
  world.start = {2, 20};
  world.goal = {57, 20};
  const RandomBlocks blocks{.count = 6, .side = 5, .ahead = 8};
  std::set<std::vector<CellChange>> drawn;
  for (world.seed = 1; world.seed <= 10; ++world.seed) {
    const Surprises dropped = dropped_blocks(world, blocks);
    EXPECT_EQ(dropped, dropped_blocks(world, blocks)) << "the seed says all";
    ASSERT_EQ(dropped.size(), 6u);
    GridMap with = world.map;
    for (const Surprise& surprise : dropped) {
      EXPECT_EQ(surprise.at.within, 8);
      EXPECT_FALSE(surprise.announced);
      for (const CellChange& change : surprise.cells) {
        EXPECT_TRUE(change.blocked);
        EXPECT_FALSE(with.at(change.cell)) << "each cell once";
        with.set(change.cell, true);
        const int dx = change.cell.x - surprise.at.near->x, dy = change.cell.y - surprise.at.near->y;
        EXPECT_LE(std::max(std::abs(dx), std::abs(dy)), 2);
      }
    }
    EXPECT_FALSE(with.at(world.start) || with.at(world.goal));
    EXPECT_TRUE(plan_once(with, world.start, world.goal, {"dijkstra", {}}).succeeded());
    drawn.insert(dropped.front().cells);
    world.planners = {{"dstar-lite", {}}};
    world.surprises = dropped;
    EXPECT_TRUE(drive(world, world.planners.front()).succeeded()) << world.seed;
    world.surprises = {};
  }
  EXPECT_GT(drawn.size(), 5u);
  world.map.set({30, 0}, true);
  for (int y = 0; y < 40; ++y) world.map.set({30, y}, true);
  EXPECT_TRUE(dropped_blocks(world, blocks).empty()) << "no way, no blocks";
}

}  // namespace
}  // namespace replan::experiment_test
