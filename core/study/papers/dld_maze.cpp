// Figure 7 of the DLD* Lite paper, a maze; and what becomes of its sight checks as corridors get narrower, which it leaves
// open.
#include <algorithm>
#include <array>

#include "core/study/papers/dld_entries.hpp"
#include "core/study/papers/paper_studies.hpp"
#include "core/study/study_words.hpp"
#include "core/world/generators/generators.hpp"

namespace replan {
namespace {

enum MazeEntry : std::size_t { kMazePlain, kMazeDld, kMazeAlong };
enum MazeWorld : std::size_t { kMazeOpen, kMazeWide, kMazeMedium, kMazeNarrow, kMazeWorlds };
constexpr Cell kMazeStart{4, 4, 0}, kMazeGoal{490, 490, 0};

Result<Scenario> figure_7() {
  return library_scenario("dld-fig-7.json");
}

/// From open to narrow, all of 500 x 500 cells; the second is the library's.
Result<std::vector<GridMap>> maze_maps() {
  const std::array keep_free{kMazeStart, kMazeGoal};
  const auto scenario = figure_7();
  if (!scenario) return Error{scenario.error()};
  const auto open = random_rectangles(500, 500, 0.17, 5, 15, 1, keep_free);
  const auto medium = maze(500, 500, {.corridor = 5, .loops = 0.3}, 1, keep_free);
  const auto narrow = maze(500, 500, {.corridor = 3, .loops = 0.3}, 1, keep_free);
  for (const auto* map : {&open, &medium, &narrow})
    if (!*map) return Error{map->error()};
  return std::vector<GridMap>{*open, scenario->map, *medium, *narrow};
}

/// In each of the mazes.
template <class Holds>
std::size_t mazes_that(Holds&& holds) {
  std::size_t count = 0;
  for (std::size_t world = kMazeWide; world < kMazeWorlds; ++world) count += holds(world) ? 1 : 0;
  return count;
}
constexpr std::size_t kMazes = kMazeWorlds - kMazeWide;
Verdict verdict_of_mazes(std::size_t count) {
  return count == kMazes ? Verdict::reproduced : count > 0 ? Verdict::partly : Verdict::not_reproduced;
}

StudyClaim clearance_in_mazes(const StudyReport& report) {
  StudyClaim claim{
      "D* Lite's path goes along walls, close to them; that of DLD* Lite keeps away from obstacles "
      "throughout.",
      {},
      Verdict::not_reproduced,
      {}};
  const auto wide = typical_values(report, kMeanClearance, kMazeWide),
             least = typical_values(report, kLeastClearance, kMazeWide);
  if (wide.empty()) return without_paths(std::move(claim));
  claim.ours = filled(
      "In the maze of figure 7 the mean clearance is {1} cells for D* Lite and {2} for DLD* Lite, the least "
      "{3} and {4}.",
      {told(wide[kMazePlain], 2), told(wide[kMazeDld], 2), told(least[kMazePlain], 2),
       told(least[kMazeDld], 2)});
  claim.verdict = verdict_of_mazes(mazes_that([&](std::size_t world) {
    const auto mean = typical_values(report, kMeanClearance, world),
               nearest = typical_values(report, kLeastClearance, world);
    return !mean.empty() && mean[kMazeDld] > mean[kMazePlain] && nearest[kMazeDld] > nearest[kMazePlain];
  }));
  if (claim.verdict != Verdict::reproduced)
    claim.why = "Where a corridor is as narrow as the range of the clearance, all of it is near a wall.";
  return claim;
}

StudyClaim smoothness_in_mazes(const StudyReport& report) {
  StudyClaim claim{
      "D* Lite's path is far from smooth, and that of DLD* Lite smooth.", {}, Verdict::not_reproduced, {}};
  const auto turns = typical_values(report, kTurns, kMazeWide),
             angle = typical_values(report, kTurning, kMazeWide);
  if (turns.empty()) return without_paths(std::move(claim));
  claim.ours = filled(
      "In the maze of figure 7 D* Lite's path turns {1} times, by {2} degrees in all, that of DLD* Lite {3} "
      "times, "
      "by {4} degrees.",
      {told(turns[kMazePlain], 0), told(angle[kMazePlain], 0), told(turns[kMazeDld], 0),
       told(angle[kMazeDld], 0)});
  claim.verdict = verdict_of_mazes(mazes_that([&](std::size_t world) {
    const auto all = typical_values(report, kTurning, world);
    return !all.empty() && all[kMazeDld] < all[kMazePlain];
  }));
  if (claim.verdict != Verdict::reproduced)
    claim.why =
        "It holds in some of the mazes alone: in narrow corridors sight ends wherever clearance costs "
        "something, so that "
        "the path goes from cell to cell there, and keeping to the middle of corridors takes turns of its "
        "own.";
  return claim;
}

StudyClaim time_in_mazes(const StudyReport& report) {
  StudyClaim claim{
      "In very narrow surroundings sight lines cost DLD* Lite much time.", {}, Verdict::not_reproduced, {}};
  std::array<double, kMazeWorlds> ratio{};
  for (std::size_t world = 0; world < kMazeWorlds; ++world) {
    const auto spread = ratio_of(report, kPlanTime, kMazeDld, kMazePlain, world);
    if (!spread) return without_paths(std::move(claim));
    ratio[world] = spread->median;
  }
  claim.ours = filled(
      "DLD* Lite takes {1} times as long as D* Lite on an open map, and {2}, {3} and {4} times in mazes with "
      "corridors of "
      "8, 5 and 3 cells.",
      {told(ratio[kMazeOpen], 2), told(ratio[kMazeWide], 2), told(ratio[kMazeMedium], 2),
       told(ratio[kMazeNarrow], 2)});
  const std::size_t slower =
      mazes_that([&](std::size_t world) { return ratio[world] > 1.05 * ratio[kMazeOpen]; });
  claim.verdict = verdict_of_mazes(slower);
  const auto along = ratio_of(report, kPlanTime, kMazeAlong, kMazePlain, kMazeNarrow);
  if (claim.verdict != Verdict::reproduced && along)
    claim.why = filled(
        "Against an open map the share of sight checks does not grow with every narrowing: a line that ends "
        "at the next "
        "wall is soon checked. In the narrowest maze most of the difference is not theirs: without checks in "
        "the search "
        "it is still {1} times, the price of clearance where everything is near a wall.",
        {told(along->median, 2)});
  return claim;
}

Result<StudyReport> run_maze(const StudyWatch& watch) {
  const auto entries = study_entries({dstar_lite_entry(), dld_entry(), dld_along_path_entry()});
  if (!entries) return Error{entries.error()};
  const auto maps = maze_maps();
  if (!maps) return Error{maps.error()};
  StudyReport report;
  report.worlds_apart = true;
  report.worlds = {"open map", "maze of figure 7, corridors of 8 cells", "maze, corridors of 5 cells",
                   "maze, corridors of 3 cells"};
  report.planners = names_of(*entries);
  report.figures = plan_figures();
  report.charts = {{"clearance", "Mean clearance of the path", kMeanClearance},
                   {"turning", "Turning angle of the path", kTurning},
                   {"checks", "Sight checks of a plan", kSightChecks, StudyChart::Form::bars, true},
                   {"time", "Time of a plan", kPlanTime}};
  const bool whole = run_all(report, watch, [&](std::size_t world, std::size_t planner, std::uint64_t seed) {
    return plan_run((*maps)[world], kMazeStart, kMazeGoal, (*entries)[planner].choice, seed);
  });
  if (whole)
    report.claims = {clearance_in_mazes(report), smoothness_in_mazes(report), time_in_mazes(report),
                     sight_claim(report, kMazePlain, kMazeDld, kMazeAlong, kMazeNarrow)};
  return report;
}

Result<std::vector<StudyPicture>> maze_pictures() {
  auto scenario = figure_7();
  if (scenario) std::reverse(scenario->planners.begin(), scenario->planners.end());
  return one_picture(scenario, "paths",
                     "The paths through a maze of 500 x 500 cells, as in figure 7 of the paper.", false,
                     {"path"});
}

}  // namespace

StudyInfo dld_maze_study() {
  return {"dld-maze",
          "D* Lite and DLD* Lite in mazes",
          "Huang & Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, figure 7",
          "The paper shows a maze of 500 x 500 cells and gives no numbers. Here is one with corridors of 8 "
          "cells and ways "
          "round, which opens in the window as maps/dld-fig-7.json, two with narrower corridors, and an open "
          "map of "
          "rectangles to hold them against. Each seed is one more run of all for the sake of their times.",
          5,
          1,
          run_maze,
          maze_pictures};
}

}  // namespace replan
