// Table 1 of the fusion paper: plain A* against the improved one, whose factor follows the obstacles and whose turns are
// smoothed.
//
//  Liu J., Xue L., Zhang H. & Liu Z., "Robot dynamic path planning based on improved A* and DWA algorithm" (in Chinese),
//  Henan University of Technology, table 1 and figure 5
#include <algorithm>
#include <array>

#include "core/study/papers/paper_studies.hpp"
#include "core/study/study_runs.hpp"
#include "core/study/study_words.hpp"
#include "core/world/generators/generators.hpp"

namespace replan {
namespace {

enum AstarEntry : std::size_t { kAstarPlain, kAstarAdaptive, kAstarImproved };
constexpr Cell kAstarStart{2, 2, 0}, kAstarGoal{30, 30, 0};
constexpr std::uint64_t kAstarMazes = 19;

struct AstarWorld {
  std::string name;
  GridMap map;
  Cell start, goal;
};

Result<Scenario> figure_5() {
  return library_scenario("fusion-maze.json");
}

/// The library's, and random ones of its kind: corridors of 3 cells with many ways round.
Result<std::vector<AstarWorld>> astar_worlds() {
  const auto scenario = figure_5();
  if (!scenario) return Error{scenario.error()};
  std::vector<AstarWorld> worlds{{"figure 5", scenario->map, scenario->start, scenario->goal}};
  const std::array keep_free{kAstarStart, kAstarGoal};
  for (std::uint64_t seed = 1; seed <= kAstarMazes; ++seed) {
    auto map = maze(33, 33, {.corridor = 3, .braid = 1, .loops = 0.35}, seed, keep_free);
    if (!map) return Error{map.error()};
    worlds.push_back({"maze " + std::to_string(seed), std::move(*map), kAstarStart, kAstarGoal});
  }
  return worlds;
}

/// By how much a figure of the improved planner differs from plain A*'s: -0.2 is a fifth less.
std::optional<double> change_from_astar(const StudyReport& report, std::size_t figure,
                                        std::optional<std::size_t> world = {}) {
  const auto ratio = ratio_of(report, figure, kAstarImproved, kAstarPlain, world);
  return ratio ? std::optional(typical(report.figures[figure], *ratio) - 1) : std::nullopt;
}

StudyClaim shape_claim(const StudyReport& report, std::size_t figure, double paper, const char* sentence,
                       const char* why) {
  StudyClaim claim{sentence, {}, Verdict::not_reproduced, {}};
  const auto all = change_from_astar(report, figure), own = change_from_astar(report, figure, 0);
  if (!all || !own) return without_paths(std::move(claim));
  claim.ours = filled("On the average of all mazes {1}; in that of figure 5 {2}.",
                      {signed_percent(*all), signed_percent(*own)});
  const auto near = [&](double change) { return std::abs(change - paper) <= 0.25 * std::abs(paper); };
  claim.verdict = near(*all)             ? Verdict::reproduced
                  : *all < 0 && *own < 0 ? Verdict::partly
                                         : Verdict::not_reproduced;
  if (claim.verdict != Verdict::reproduced) claim.why = why;
  return claim;
}

constexpr const char* kTurnsWhy =
    "How many turns there are to take away depends on the grid, which is lost but for a small picture, and "
    "on how A* breaks "
    "ties between equally short ways, which the paper does not tell: A* turns more often where it breaks "
    "them badly.";
constexpr const char* kTurningWhy =
    "As with the turns; each that is left may be sharper than those it stands for.";
constexpr const char* kLengthWhy =
    "Smoothing makes the path shorter, but what it begins with is longer than the shortest (see the last "
    "row), and a way "
    "that goes round the wrong side of a wall is not mended by it.";

StudyClaim astar_time_claim(const StudyReport& report) {
  StudyClaim claim{"The improved A* takes 0.8 s less, since its search is more directed.",
                   {},
                   Verdict::not_reproduced,
                   {}};
  const auto time = change_from_astar(report, kPlanTime), work = change_from_astar(report, kExpansions);
  const auto search = ratio_of(report, kPlanTime, kAstarAdaptive, kAstarPlain);
  if (!time || !work || !search) return without_paths(std::move(claim));
  claim.ours = filled("Time {1}, of the search without smoothing {2}; expansions {3}.",
                      {signed_percent(*time), signed_percent(search->median - 1), signed_percent(*work)});
  claim.verdict = *time < 0 && *work < 0 ? Verdict::partly : Verdict::not_reproduced;
  claim.why = claim.verdict == Verdict::partly
                  ? "The direction is the paper's; of what time its 0.8 s are, in MATLAB, it does not tell."
                  : "The factor draws the search towards the goal, and where walls stand across, that is the "
                    "wrong way.";
  return claim;
}

StudyClaim astar_price_claim(const StudyReport& report) {
  StudyClaim claim{"The global path is the optimal one.", {}, Verdict::not_reproduced, {}};
  const auto search = ratio_of(report, kLength, kAstarAdaptive, kAstarPlain);
  if (!search) return without_paths(std::move(claim));
  claim.ours = filled("Before it is smoothed, the improved A*'s path is {1} times as long as the shortest.",
                      {told(search->mean, 3)});
  claim.verdict = search->mean <= 1.0001 ? Verdict::reproduced : Verdict::not_reproduced;
  if (claim.verdict != Verdict::reproduced)
    claim.why =
        "Its factor is above one wherever there is a free cell, which makes it a weighted A*: quicker, and "
        "not sure to "
        "find the shortest path. What smoothing makes shorter can hide it.";
  return claim;
}

Result<StudyReport> run_astar_table(const StudyWatch& watch) {
  const auto entries = study_entries({{"A*", "astar", {{"heuristic", "euclidean"}}},
                                      {"Improved A*, not smoothed", "adaptive-astar"},
                                      {"Improved A*", "adaptive-astar", {}, {"floyd"}}});
  if (!entries) return Error{entries.error()};
  const auto worlds = astar_worlds();
  if (!worlds) return Error{worlds.error()};
  StudyReport report;
  for (const AstarWorld& world : *worlds) report.worlds.push_back(world.name);
  report.planners = names_of(*entries);
  report.figures = plan_figures();
  report.figures[kPlanTime].decimals = 4;
  report.charts = {{"turns", "Turns of the path", kTurns},
                   {"turning", "Turning angle of the path", kTurning},
                   {"length", "Length of the path", kLength},
                   {"time", "Time of a plan", kPlanTime}};
  const bool whole = run_all(report, watch, [&](std::size_t world, std::size_t planner, std::uint64_t seed) {
    const AstarWorld& in = (*worlds)[world];
    return plan_run(in.map, in.start, in.goal, (*entries)[planner].choice, seed);
  });
  if (whole)
    report.claims = {
        astar_time_claim(report),
        shape_claim(report, kTurns, -0.480, "The path of the improved A* has 48.0 % fewer turns.", kTurnsWhy),
        shape_claim(report, kTurning, -0.421, "It turns by 42.1 % less.", kTurningWhy),
        shape_claim(report, kLength, -0.080, "It is 8.0 % shorter.", kLengthWhy), astar_price_claim(report)};
  return report;
}

Result<std::vector<StudyPicture>> astar_pictures() {
  return one_picture(figure_5(), "paths",
                     "Plain and improved A* in a maze-like grid, as in figure 5 of the paper.", false,
                     {"path", "grid"});
}

}  // namespace

StudyInfo astar_table_study() {
  return {"astar-table1",
          "The improved A* against plain A*",
          "Liu, Xue, Zhang & Liu, Henan University of Technology, table 1 and figure 5",
          "Maze-like grids with cells of 1 m: one drawn after the picture in the paper, which opens in the "
          "window as "
          "maps/fusion-maze.json, and 19 random ones of 33 x 33 cells with corridors of 3 and many ways "
          "round. The safety "
          "distance is the paper's 0.8 m. Each seed is one more run of all for the sake of their times.",
          25,
          3,
          run_astar_table,
          astar_pictures};
}

}  // namespace replan
