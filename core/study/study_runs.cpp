#include "core/study/study_runs.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/plan/registry.hpp"
#include "core/plan/stage.hpp"
#include "core/world/choices.hpp"
#include "core/world/library.hpp"

namespace replan {
namespace {

/// A short plan is timed so often, and the quickest counts: what else the machine does cannot make it quicker.
constexpr int kPlansTimed = 3;
constexpr double kLongPlan = 50;  // ms

Result<PlannerChoice> choice_of(const StudyEntryText& text) {
  const auto info = require_choice(text.id);
  if (!info) return Error{info.error()};
  PlannerChoice choice;
  choice.id = text.id;
  for (const auto& [key, value] : text.settings)
    if (const auto set = set_from_text(choice.settings, (*info)->parameters, key, value); !set)
      return Error{set.error()};
  for (const char* id : text.stages) {
    if (const auto stage = require_stage(id); !stage) return Error{stage.error()};
    choice.stages.push_back({id, {}});
  }
  return choice;
}

}  // namespace

Result<std::vector<StudyEntry>> study_entries(std::initializer_list<StudyEntryText> texts) {
  std::vector<StudyEntry> entries;
  for (const StudyEntryText& text : texts) {
    auto choice = choice_of(text);
    if (!choice) return Error{choice.error()};
    entries.push_back({text.name, std::move(*choice)});
  }
  return entries;
}

std::vector<std::string> names_of(const std::vector<StudyEntry>& entries) {
  std::vector<std::string> names;
  for (const StudyEntry& entry : entries) names.push_back(entry.name);
  return names;
}

bool run_all(StudyReport& report, const StudyWatch& watch, const StudyTask& task) {
  report.seeds = watch.seeds;
  const std::size_t all =
      report.worlds.size() * report.planners.size() * static_cast<std::size_t>(watch.seeds);
  for (std::uint64_t seed = 1; seed <= watch.seeds; ++seed)
    for (std::size_t world = 0; world < report.worlds.size(); ++world)
      for (std::size_t planner = 0; planner < report.planners.size(); ++planner) {
        if (watch.stop.stop_requested()) return false;
        StudyRun run = task(world, planner, seed);
        run.world = world;
        run.planner = planner;
        run.seed = seed;
        report.runs.push_back(std::move(run));
        if (watch.progress) watch.progress(report.runs.size(), all);
      }
  return true;
}

std::vector<StudyFigure> plan_figures() {
  return {{"nodes", "nodes", "", 1},
          {"length", "length", "cells", 2},
          {"turns", "turns", "", 1},
          {"turning", "turning angle", "degrees", 0},
          {"min_clearance", "least clearance", "cells", 2},
          {"mean_clearance", "mean clearance", "cells", 2},
          {"expansions", "expansions", "", 0},
          {"sight_checks", "sight checks", "", 0},
          {"plan_ms", "time", "ms", 2, true}};
}

StudyRun plan_run(const RunReport& report, std::size_t more) {
  StudyRun run{.found = report.succeeded(), .values = {}};
  run.values.resize(kPlanFigures + more);
  run.values[kExpansions] = static_cast<double>(report.counters.expansions);
  run.values[kSightChecks] = static_cast<double>(report.counters.sight_checks);
  run.values[kPlanTime] = report.plan_cpu_ms;
  if (report.path.empty()) return run;
  run.values[kNodes] = static_cast<double>(report.figures.nodes);
  run.values[kLength] = report.figures.length;
  run.values[kTurns] = static_cast<double>(report.figures.turns);
  run.values[kTurning] = report.figures.turning_angle_deg;
  run.values[kLeastClearance] = report.figures.min_clearance;
  run.values[kMeanClearance] = report.figures.mean_clearance;
  return run;
}

StudyRun plan_run(const GridMap& map, Cell start, Cell goal, PlannerChoice choice, std::uint64_t seed) {
  if (find_parameter(info_of(choice).parameters, "seed") != nullptr)
    choice.settings.set("seed", static_cast<double>(seed));
  RunReport report = plan_once(map, start, goal, choice);
  for (int again = 1; again < kPlansTimed && report.plan_cpu_ms < kLongPlan; ++again)
    report.plan_cpu_ms = std::min(report.plan_cpu_ms, plan_once(map, start, goal, choice).plan_cpu_ms);
  return plan_run(report);
}

Point point_along(const Path& path, double share) {
  double left = path_length(path) * share;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point from = path.point(i - 1), to = path.point(i);
    const double step = distance(from, to);
    if (left <= step && step > 0) {
      const double part = left / step;
      return {from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part,
              from.z + (to.z - from.z) * part};
    }
    left -= step;
  }
  return path.point(path.size() - 1);
}

Result<Scenario> library_scenario(const char* file) {
  return read_scenario((std::filesystem::path(library_folder()) / file).string());
}

Result<std::vector<StudyPicture>> one_picture(const Result<Scenario>& scenario, std::string_view id,
                                              const char* caption, bool at_end,
                                              std::vector<std::string> overlays) {
  if (!scenario) return Error{scenario.error()};
  return std::vector<StudyPicture>{{id, caption, *scenario, at_end, std::move(overlays)}};
}

std::vector<double> typical_values(const StudyReport& report, std::size_t figure,
                                   std::optional<std::size_t> world) {
  std::map<std::pair<std::size_t, std::uint64_t>, std::vector<const StudyRun*>> found;
  for (const StudyRun& run : report.runs)
    if (run.found && run.values[figure] && (!world || run.world == *world))
      found[{run.world, run.seed}].push_back(&run);
  std::vector<std::vector<double>> values(report.planners.size());
  for (const auto& [_, runs] : found)
    if (runs.size() == report.planners.size())
      for (const StudyRun* run : runs) values[run->planner].push_back(*run->values[figure]);
  std::vector<double> typicals;
  for (std::vector<double>& each : values) {
    const auto spread = spread_of(std::move(each));
    if (!spread) return {};
    typicals.push_back(typical(report.figures[figure], *spread));
  }
  return typicals;
}

StudyClaim without_paths(StudyClaim claim) {
  claim.ours = "There is no run in which each of the planners has found a path.";
  claim.verdict = Verdict::not_reproduced;
  claim.why = "Without paths there is nothing to compare.";
  return claim;
}

}  // namespace replan
