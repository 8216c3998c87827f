// Figure 4 of the DLD* Lite paper: an obstacle appears on the way while the robot drives.
#include <algorithm>

#include "core/study/papers/dld_entries.hpp"
#include "core/study/papers/paper_studies.hpp"
#include "core/study/study_words.hpp"

namespace replan {
namespace {

constexpr int kBlockSide = 10;
constexpr double kSeenWithin = 12, kSurpriseSensor = 8;
enum SurpriseEntry : std::size_t { kSurprisePlain, kSurpriseDld, kSurpriseAlong };
enum SurpriseFigure : std::size_t {
  kGapToBlock = kPlanFigures,
  kWayBehind,
  kReplanWork,
  kFreshWork,
  kReplanTime,
  kSurpriseFigures
};

/// The free cells of a square about a cell, as obstacles.
std::vector<CellChange> block_about(const GridMap& map, Cell middle) {
  std::vector<CellChange> cells;
  for (int y = middle.y - kBlockSide / 2; y < middle.y + kBlockSide / 2; ++y)
    for (int x = middle.x - kBlockSide / 2; x < middle.x + kBlockSide / 2; ++x)
      if (const Cell cell{x, y, 0}; map.contains(cell) && !map.at(cell)) cells.push_back({cell, true});
  return cells;
}

/// A robot that drives along its planner's path until, near the middle, a block lies across it.
Scenario surprised(const GridMap& map, const PlannerChoice& choice, const Path& path) {
  Scenario scenario;
  scenario.map = map;
  scenario.start = kDldStart;
  scenario.goal = kDldGoal;
  scenario.planners = {choice};
  scenario.robot.knowledge = Knowledge::map;
  scenario.robot.sensor_radius = kSurpriseSensor;
  const Cell middle = cell_of(point_along(path, 0.5));
  Surprise surprise;
  surprise.at.near = middle;
  surprise.at.within = kSeenWithin;
  surprise.cells = block_about(map, middle);
  scenario.surprises = Surprises{surprise};
  return scenario;
}

/// The cells of the block alone, as obstacles of an otherwise free world.
std::vector<std::uint8_t> block_alone(const Scenario& scenario) {
  GridMap alone(scenario.map.width, scenario.map.height);
  for (const CellChange& change : scenario.surprises[0].cells) alone.set(change.cell, true);
  const auto plain = alone.blocked.plain();
  return {plain.begin(), plain.end()};
}

/// What a plan from scratch takes where the robot learns of the block, and what its repair takes.
struct Repair {
  std::int64_t expansions = 0, fresh = 0;
};

StudyRun surprise_run(const GridMap& map, const PlannerChoice& choice) {
  const RunReport first = plan_once(map, kDldStart, kDldGoal, choice);
  StudyRun run = plan_run(first, std::size_t{kSurpriseFigures} - std::size_t{kPlanFigures});
  if (!run.found) return run;
  const Scenario scenario = surprised(map, choice, first.path);
  std::vector<Point> behind;  // the way from where the block appears
  std::int64_t replans = 0;
  std::optional<Repair> repair;
  const RunReport driven = drive(scenario, choice, [&](const Mission& mission) {
    const Decision& now = mission.now();
    if (now.fired.empty() || !now.fired[0]) return;
    behind.push_back(now.at);
    if (repair || now.figures.replans == replans) return;
    GridMap known = map;
    known.blocked = SharedBytes({mission.navigator().known().begin(), mission.navigator().known().end()});
    repair = Repair{now.figures.last_plan.expansions,
                    plan_once(known, cell_of(now.at), kDldGoal, choice).counters.expansions};
  });
  run.found = driven.succeeded();
  if (!run.found || behind.empty()) return run;
  const Path way(behind);
  run.values[kGapToBlock] = path_figures(map.box(), block_alone(scenario), way).min_clearance;
  run.values[kWayBehind] = path_length(way);
  if (repair) {
    run.values[kReplanWork] = static_cast<double>(repair->expansions);
    run.values[kFreshWork] = static_cast<double>(repair->fresh);
  }
  run.values[kReplanTime] = driven.replan_ms;
  return run;
}

StudyClaim gap_claim(const StudyReport& report) {
  StudyClaim claim{
      "The replanned path of D* Lite is close to the obstacle that has appeared; that of DLD* Lite keeps one "
      "or two cells between.",
      {},
      Verdict::not_reproduced,
      {}};
  const auto plain = spread_of(report, kGapToBlock, kSurprisePlain),
             dld = spread_of(report, kGapToBlock, kSurpriseDld);
  if (!plain || !dld) return without_paths(std::move(claim));
  claim.ours = filled(
      "From the middle of the way to the obstacle's edge it is {1} cells for D* Lite and {2} for DLD* Lite, "
      "means of {3} "
      "surprises (medians {4} and {5}).",
      {told(plain->mean, 2), told(dld->mean, 2), std::to_string(dld->count), told(plain->median, 2),
       told(dld->median, 2)});
  claim.verdict = plain->median < 1 && dld->median >= 1.5 && dld->median <= 2.5 ? Verdict::reproduced
                  : dld->mean > 1.5 * plain->mean                               ? Verdict::partly
                                                                                : Verdict::not_reproduced;
  if (claim.verdict != Verdict::reproduced)
    claim.why =
        "One or two free cells between are 1.5 to 2.5 cells here. The obstacle is seen late, beside others "
        "that leave no "
        "room, and to go round it farther off would cost more than to pass it near.";
  return claim;
}

StudyClaim work_claim(const StudyReport& report) {
  StudyClaim claim{
      "A replan repairs what the obstacle changes, by a local distance transform, rather than planning anew.",
      {},
      Verdict::not_reproduced,
      {}};
  std::vector<double> shares;
  for (const StudyRun& run : report.runs)
    if (run.planner == kSurpriseDld && run.values[kReplanWork] && run.values[kFreshWork].value_or(0) > 0)
      shares.push_back(*run.values[kReplanWork] / *run.values[kFreshWork]);
  const auto share = spread_of(std::move(shares));
  if (!share) return without_paths(std::move(claim));
  claim.ours = filled(
      "DLD* Lite's repair takes {1} of the expansions that a plan from scratch takes there (median; "
      "quartiles {2} and "
      "{3}).",
      {told(share->median, 3), told(share->low, 3), told(share->high, 3)});
  claim.verdict = share->median < 0.5 ? Verdict::reproduced
                  : share->median < 1 ? Verdict::partly
                                      : Verdict::not_reproduced;
  if (claim.verdict != Verdict::reproduced)
    claim.why =
        "A block across the only near way makes much of what lies between it and the robot worthless.";
  return claim;
}

StudyClaim safety_claim(const StudyReport& report) {
  StudyClaim claim{"The robot goes round the obstacle and on to its goal.", {}, Verdict::not_reproduced, {}};
  std::size_t arrived = 0;
  for (const StudyRun& run : report.runs) arrived += run.found ? 1 : 0;
  claim.ours = filled("{1} of {2} robots have arrived; none has touched an obstacle.",
                      {std::to_string(arrived), std::to_string(report.runs.size())});
  claim.verdict = arrived == report.runs.size() ? Verdict::reproduced : Verdict::partly;
  if (claim.verdict != Verdict::reproduced) claim.why = "The block can close the only way.";
  return claim;
}

Result<StudyReport> run_surprise(const StudyWatch& watch) {
  const auto entries = study_entries({dstar_lite_entry(), dld_entry(), dld_along_path_entry()});
  if (!entries) return Error{entries.error()};
  const auto maps = dld_random_maps(watch.seeds);
  if (!maps) return Error{maps.error()};
  StudyReport report;
  report.worlds = {"random maps"};
  report.planners = names_of(*entries);
  report.figures = plan_figures();
  for (const StudyFigure& figure :
       {StudyFigure{"gap", "gap to the surprise", "cells", 2},
        StudyFigure{"way_behind", "way from there on", "cells", 1},
        StudyFigure{"replan_expansions", "expansions of the repair", "", 0},
        StudyFigure{"fresh_expansions", "of a plan from scratch there", "", 0},
        StudyFigure{"replan_ms", "time of all replans, by the clock", "ms", 3, true}})
    report.figures.push_back(figure);
  report.charts = {{"gap", "Gap between the way and the obstacle that has appeared", kGapToBlock},
                   {"way", "Way from there to the goal", kWayBehind},
                   {"work", "Expansions of the repair", kReplanWork, StudyChart::Form::bars, true}};
  const bool whole = run_all(report, watch, [&](std::size_t, std::size_t planner, std::uint64_t seed) {
    return surprise_run((*maps)[static_cast<std::size_t>(seed - 1)], (*entries)[planner].choice);
  });
  if (whole)
    report.claims = {gap_claim(report), work_claim(report), safety_claim(report),
                     sight_claim(report, kSurprisePlain, kSurpriseDld, kSurpriseAlong)};
  return report;
}

Result<std::vector<StudyPicture>> surprise_pictures() {
  auto scenario = library_scenario("dld-fig-4.json");
  if (scenario) std::reverse(scenario->planners.begin(), scenario->planners.end());
  return one_picture(scenario, "ways",
                     "The ways of two robots that an obstacle has surprised, as in figure 4 of the paper.",
                     true, {"path", "trail"});
}

}  // namespace

StudyInfo dld_surprise_study() {
  return {"dld-surprise",
          "An obstacle appears on the way",
          "Huang & Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, figure 4",
          "Random maps as in dld-random, one for each seed. A robot that knows the map drives along its "
          "path; when it is "
          "12 cells from the middle of it, a block of 10 x 10 cells lies there, which it sees from 8 cells "
          "away. Each "
          "planner meets the block on its own path, as in the paper. One such world opens in the window as "
          "maps/dld-fig-4.json.",
          50,
          5,
          run_surprise,
          surprise_pictures};
}

}  // namespace replan
