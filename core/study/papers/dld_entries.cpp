#include "core/study/papers/dld_entries.hpp"

#include <array>

#include "core/study/study_words.hpp"
#include "core/world/generators/generators.hpp"

namespace replan {

StudyEntryText dstar_lite_entry() {
  return {"D* Lite", "dstar-lite", {{"heuristic", "euclidean"}}};
}

StudyEntryText los_entry() {
  return {"Los D* Lite", "los-dstar-lite", {{"heuristic", "euclidean"}, {"sight", "bresenham"}}};
}

StudyEntryText dist_entry() {
  return {"Dist D* Lite", "dist-dstar-lite", {{"heuristic", "euclidean"}}};
}

StudyEntryText dld_entry() {
  return {"DLD* Lite", "dld-star-lite", {{"heuristic", "euclidean"}, {"sight", "bresenham"}}};
}

StudyEntryText dld_along_path_entry() {
  return {"DLD* Lite, checks along the path",
          "dld-star-lite",
          {{"heuristic", "euclidean"}, {"sight", "bresenham"}, {"sight_checks", "path"}}};
}

Result<std::vector<GridMap>> dld_random_maps(std::uint64_t count) {
  const std::array keep_free{kDldStart, kDldGoal};
  std::vector<GridMap> maps;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    auto map = random_rectangles(200, 200, 0.17, 5, 15, seed, keep_free);
    if (!map) return Error{map.error()};
    maps.push_back(std::move(*map));
  }
  return maps;
}

Result<DldRuns> plan_on_random_maps(const Result<std::vector<StudyEntry>>& entries, std::uint64_t count,
                                    const StudyWatch& watch) {
  if (!entries) return Error{entries.error()};
  const auto maps = dld_random_maps(count);
  if (!maps) return Error{maps.error()};
  DldRuns runs;
  runs.report.planners = names_of(*entries);
  for (std::size_t number = 1; number <= maps->size(); ++number)
    runs.report.worlds.push_back("map " + std::to_string(number));
  runs.report.figures = plan_figures();
  runs.whole = run_all(runs.report, watch, [&](std::size_t world, std::size_t planner, std::uint64_t seed) {
    return plan_run((*maps)[world], kDldStart, kDldGoal, (*entries)[planner].choice, seed);
  });
  return runs;
}

StudyClaim sight_claim(const StudyReport& report, std::size_t plain, std::size_t dld, std::size_t along,
                       std::optional<std::size_t> world) {
  const auto checks = typical_values(report, kSightChecks, world);
  const auto time = ratio_of(report, kPlanTime, dld, plain, world),
             time_along = ratio_of(report, kPlanTime, along, plain, world),
             length = ratio_of(report, kLength, along, dld, world);
  StudyClaim claim{
      "In very narrow surroundings sight checks take much time; how to do with less is left open.",
      {},
      Verdict::answered,
      {}};
  if (checks.empty() || !time || !time_along || !length) return without_paths(std::move(claim));
  claim.ours = filled(
      "With sight checked along the path, where it is read out, a plan takes {1} checks in place of {2}, and "
      "{3} times "
      "as long as D* Lite's in place of {4} times; its path is {5} times as long.",
      {told(checks[along], 0), told(checks[dld], 0), told(time_along->median, 2), told(time->median, 2),
       told(length->mean, 4)});
  claim.why =
      "Costs never depend on remote parents, so that none need be kept during the search; the planner's page "
      "has the "
      "reasoning.";
  return claim;
}

}  // namespace replan
