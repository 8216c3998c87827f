// The planners of the D* Lite family as the DLD* Lite paper sets them: Euclidean heuristic, lines drawn cell by cell.
//
//  Huang L. & Zhou F., "Path planning of moving robot based on path optimization of D* Lite algorithm", Control and
//  Decision, 2018 (in Chinese), doi 10.13195/j.kzyjc.2018.0583
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/study/study_runs.hpp"

namespace replan {

StudyEntryText dstar_lite_entry();
StudyEntryText los_entry();
StudyEntryText dist_entry();
StudyEntryText dld_entry();
/// With sight checked where a path is read out, and not in the search: our answer to what the paper leaves open.
StudyEntryText dld_along_path_entry();

/// The paper's random maps: 200 x 200 cells, rectangles with sides of 5 to 15 that cover 17 of 100 cells.
inline constexpr Cell kDldStart{15, 15, 0}, kDldGoal{175, 175, 0};
Result<std::vector<GridMap>> dld_random_maps(std::uint64_t count);

/// Plans with every entry on the first `count` maps: a report with planners, worlds, figures and runs, and whether all of
/// them are done.
struct DldRuns {
  StudyReport report;
  bool whole = false;
};
Result<DldRuns> plan_on_random_maps(const Result<std::vector<StudyEntry>>& entries, std::uint64_t count,
                                    const StudyWatch& watch);

/// What sight checks along the path come to beside those in the search, in a world or in all: the paper closes with the
/// question how narrow surroundings could take less time. `plain`, `dld` and `along` are places in the report's planners.
StudyClaim sight_claim(const StudyReport& report, std::size_t plain, std::size_t dld, std::size_t along,
                       std::optional<std::size_t> world = {});

}  // namespace replan
