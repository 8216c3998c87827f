// What most studies have in common: planners under the names of their tables, runs in a fixed order, and the figures of a
// plan.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "core/plan/planner_choice.hpp"
#include "core/study/run_report.hpp"
#include "core/study/study.hpp"

namespace replan {

/// A planner of a study under the name that its tables have for it.
struct StudyEntry {
  std::string name;
  PlannerChoice choice;
};
/// The same as text.
struct StudyEntryText {
  const char* name;
  const char* id;
  std::vector<std::pair<const char*, const char*>> settings = {};
  std::vector<const char*> stages = {};
};
/// An Error if one of them, or a setting, is not in the registry.
Result<std::vector<StudyEntry>> study_entries(std::initializer_list<StudyEntryText> texts);
std::vector<std::string> names_of(const std::vector<StudyEntry>& entries);

/// One run; its world, planner and seed are filled in by run_all().
using StudyTask = std::function<StudyRun(std::size_t world, std::size_t planner, std::uint64_t seed)>;
/// Runs every planner of the report in each of its worlds with each seed, and before the next seed every one of them once:
/// what keeps the machine busy for a while is borne by all alike. False if it was asked to stop.
bool run_all(StudyReport& report, const StudyWatch& watch, const StudyTask& task);

/// What is measured of a plan; a study's own figures come behind.
enum PlanFigure : std::size_t {
  kNodes,
  kLength,
  kTurns,
  kTurning,
  kLeastClearance,
  kMeanClearance,
  kExpansions,
  kSightChecks,
  kPlanTime,
  kPlanFigures,
};
std::vector<StudyFigure> plan_figures();
/// A run with these values; of one that has found no path only the work is told. Room for `more` values behind them.
StudyRun plan_run(const RunReport& report, std::size_t more = 0);
/// Of a plan; a planner that draws is given the seed. Its time is the processor's, of the quickest of three like plans.
StudyRun plan_run(const GridMap& map, Cell start, Cell goal, PlannerChoice choice, std::uint64_t seed);

/// Where a path is after that share of its length.
Point point_along(const Path& path, double share);

/// A scenario of the library (core/world/library.hpp).
Result<Scenario> library_scenario(const char* file);
/// One picture, of a scenario of the library.
Result<std::vector<StudyPicture>> one_picture(const Result<Scenario>& scenario, std::string_view id,
                                              const char* caption, bool at_end,
                                              std::vector<std::string> overlays);

/// Of every planner in the order of the report, over the runs of a world, or all worlds, in which each of them has found a
/// path: see typical(). Empty if there are none.
std::vector<double> typical_values(const StudyReport& report, std::size_t figure,
                                   std::optional<std::size_t> world = {});

/// A claim that nothing can be held against, since a planner has no path.
StudyClaim without_paths(StudyClaim claim);

}  // namespace replan
