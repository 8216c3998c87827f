// The library of worlds in maps/: each runs to the end that its caption tells of.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/base/file.hpp"
#include "core/plan/registry.hpp"
#include "core/sim/mission.hpp"
#include "core/world/choices.hpp"
#include "core/world/library.hpp"
#include "tests/support/shared_data.hpp"
#include "tests/support/temporary_folder.hpp"

namespace replan::shipped_worlds_test {
namespace {

std::unique_ptr<Mission> driven(const Scenario& scenario, const PlannerChoice& choice) {
  auto mission = make_mission(scenario, choice);
  while (mission->advance(1 << 20)) {
  }
  return mission;
}

bool as_printed(const PlannerChoice& choice) {
  return choice.settings.get("remote_parents", 0) == 1;
}

TEST(ShippedWorlds, AreManyAndEachSaysWhatItIsFor) {
  std::set<std::string> names;
  for (const auto& file : test::files_below(REPLAN_SOURCE_DIR "/maps", ".json")) {
    const auto scenario = read_scenario(file.string());
    ASSERT_TRUE(scenario.ok()) << scenario.error();
    EXPECT_TRUE(names.insert(scenario->name).second) << scenario->name << " is there twice";
    EXPECT_GT(scenario->caption.size(), 60u) << file;
    const auto& overlays = scenario->view.overlays;
    EXPECT_TRUE(overlays.empty() || std::find(overlays.begin(), overlays.end(), "grid") != overlays.end())
        << file << " hides the grid that every opened map has";
  }
  EXPECT_GE(names.size(), 15u);
}

TEST(ShippedWorlds, StandInTheOrderOfTheList) {
  const std::string maps = REPLAN_SOURCE_DIR "/maps";
  const std::vector<std::string> files = library_files(maps);
  EXPECT_EQ(file_name(files.front()), "demo.json");
  EXPECT_EQ(file_name(files.back()), "broken-planner.json") << "each world stands in maps/order.txt";
  EXPECT_TRUE(std::none_of(files.begin(), files.end(), [](const std::string& file) {
    return file_name(file) == "sea-floor.asc";
  })) << "it is what the sea floor's world is made of";
  const test::TemporaryFolder folder;
  for (const char* name : {"a.json", "b.json", "c.json"}) folder.with(name, "{}");
  EXPECT_EQ(library_files(folder.path()),
            (std::vector<std::string>{folder.file("a.json"), folder.file("b.json"), folder.file("c.json")}));
  folder.with("order.txt", "# first\n\nc.json\nnot-there.json\n");
  EXPECT_EQ(library_files(folder.path()),
            (std::vector<std::string>{folder.file("c.json"), folder.file("a.json"), folder.file("b.json")}));
  folder.with("order.txt", "c.json\n-a.json\n");
  EXPECT_EQ(library_files(folder.path()),
            (std::vector<std::string>{folder.file("c.json"), folder.file("b.json")}));
}

TEST(ShippedWorlds, CheckedPlannersArriveWithoutACollision) {
  for (const auto& file : test::files_below(REPLAN_SOURCE_DIR "/maps", ".json")) {
    const auto scenario = read_scenario(file.string());
    ASSERT_TRUE(scenario.ok()) << scenario.error();
    for (const PlannerChoice& choice : scenario->planners) {
      if (as_printed(choice) || find_choice(choice.id)->exercise) continue;
      const auto mission = driven(*scenario, choice);
      EXPECT_EQ(mission->state(), MissionState::arrived) << file << " " << choice.id;
      EXPECT_EQ(mission->now().figures.collisions, 0) << file << " " << choice.id;
      EXPECT_EQ(mission->now().fired, std::vector<bool>(scenario->surprises.size(), true))
          << file << " " << choice.id << ": a surprise never comes";
    }
  }
}

TEST(ShippedWorlds, ShowSightCheckedInTheSearchBesideSightCheckedAlongThePath) {
  const auto maze = read_scenario(REPLAN_SOURCE_DIR "/maps/sight-along-path.json");
  ASSERT_TRUE(maze.ok()) << maze.error();
  ASSERT_EQ(maze->planners.size(), 2u);
  const auto search = driven(*maze, maze->planners[0]), path = driven(*maze, maze->planners[1]);
  const auto &in_search = search->now().figures, &along = path->now().figures;
  std::printf("sight checks %lld and %lld, nodes %zu and %zu\n",
              static_cast<long long>(in_search.counters.sight_checks),
              static_cast<long long>(along.counters.sight_checks), search->plan().path->size(),
              path->plan().path->size());
  EXPECT_EQ(in_search.counters.expansions, along.counters.expansions);
  EXPECT_GT(in_search.counters.sight_checks, 5 * along.counters.sight_checks);
  EXPECT_LE(along.travelled, in_search.travelled);
}

TEST(ShippedWorlds, DemonstrateBothFaultsOfThePrintedPseudoCode) {
  const std::string maps = REPLAN_SOURCE_DIR "/maps/";
  const auto crash = read_scenario(maps + "fault-through-obstacle.json");
  const auto circle = read_scenario(maps + "fault-in-a-circle.json");
  ASSERT_TRUE(crash.ok() && circle.ok());
  ASSERT_TRUE(as_printed(crash->planners[0]) && as_printed(circle->planners[0]));
  const auto hit = driven(*crash, crash->planners[0]);
  EXPECT_EQ(hit->state(), MissionState::collision);
  EXPECT_EQ(hit->now().figures.collisions, 1);
  // It drives into what it sees: the cell is an obstacle on its own map.
  EXPECT_NE(hit->navigator().known()[hit->route().cells[hit->now().next]], 0);
  EXPECT_EQ(driven(*circle, circle->planners[0])->state(), MissionState::loop);
}

}  // namespace
}  // namespace replan::shipped_worlds_test
