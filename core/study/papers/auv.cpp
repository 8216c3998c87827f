// The experiments of the underwater vehicle's paper, in the plane and in space: D* with a threat cost and a B-spline.
//
//  Zhu X., Sun B. & Zhu D., "Three-dimensional dynamic path planning of AUV based on improved D* algorithm", Control
//  Engineering of China 28(4), 2021 (in Chinese), doi 10.14107/j.cnki.kzgc.20190179
#include <algorithm>
#include <array>
#include <limits>

#include "core/sim/mover.hpp"
#include "core/study/papers/paper_studies.hpp"
#include "core/study/study_runs.hpp"
#include "core/study/study_words.hpp"
#include "core/world/generators/generators.hpp"

namespace replan {
namespace {

enum AuvEntry : std::size_t { kAuvPlain, kAuvFocused, kAuvThreat, kAuvImproved };
enum AuvWorld : std::size_t { kAuvPlane, kAuvSpace };
enum AuvFigure : std::size_t {
  kCurvature = std::size_t{kPlanFigures},
  kVehicleWay,
  kStops,
  kWayClearance,
  kDynamicGap,
  kVehicleCollisions,
  kAuvFigures
};
constexpr int kPlaneSide = 60;
constexpr int kAuvWidth = 40, kAuvHeight = 30, kAuvDepth = 14;

/// A world that the vehicle knows, and in it a box that appears on its way and one that moves across, which it does not.
Result<Scenario> auv_world(std::size_t world, std::uint64_t seed) {
  const bool solid = world == kAuvSpace;
  Scenario scenario;
  scenario.start = solid ? Cell{2, 3, 6} : Cell{3, 3, 0};
  scenario.goal = solid ? Cell{kAuvWidth - 3, kAuvHeight - 4, 7} : Cell{kPlaneSide - 4, kPlaneSide - 4, 0};
  const std::array keep_free{scenario.start, scenario.goal};
  auto map = solid ? random_boxes({kAuvWidth, kAuvHeight, kAuvDepth}, 0.12, 3, 8, seed, keep_free)
                   : random_rectangles(kPlaneSide, kPlaneSide, 0.12, 3, 8, seed, keep_free);
  if (!map) return Error{map.error()};
  scenario.map = std::move(*map);
  scenario.robot.kind = "vehicle";
  scenario.robot.knowledge = Knowledge::map;
  scenario.robot.sensor_radius = 10;
  scenario.robot.sensor_angle = 120;
  scenario.robot.sensor_blocked = true;
  scenario.robot.speed = 2;
  if (!solid) scenario.robot.settings.set("climb_rate", 1);
  scenario.robot.settings.set("turn_rate", 45);
  PlannerChoice plain;
  plain.id = "dstar";
  const RunReport known = plan_once(scenario.map, scenario.start, scenario.goal, plain);
  if (!known.succeeded()) return scenario;
  const Cell middle = cell_of(point_along(known.path, 0.45)), late = cell_of(point_along(known.path, 0.75));
  const int depth = solid ? 4 : 1;
  Surprise appears;
  appears.at.near = middle;
  appears.at.within = 7;
  for (int z = 0; z < depth; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        if (const Cell cell{middle.x - 2 + x, middle.y - 2 + y, solid ? middle.z - 2 + z : 0};
            scenario.map.contains(cell) && !scenario.map.at(cell))
          appears.cells.push_back({cell, true});
  std::sort(appears.cells.begin(), appears.cells.end(), [&](const CellChange& a, const CellChange& b) {
    return scenario.map.index(a.cell) < scenario.map.index(b.cell);
  });
  scenario.surprises = Surprises{appears};
  const auto inside = [&](int x, int y) {
    return Cell{std::clamp(x, 0, scenario.map.width - 2), std::clamp(y, 0, scenario.map.height - 2),
                solid ? std::clamp(late.z - 1, 0, scenario.map.depth - 2) : 0};
  };
  scenario.movers = {{.way = {inside(late.x + 5, late.y - 5), inside(late.x - 5, late.y + 5)},
                      .width = 2,
                      .height = 2,
                      .depth = solid ? 2 : 1,
                      .speed = 1}};
  return scenario;
}

/// From a point to a box of cells.
double distance_to_box(const Point& at, Cell corner, int width, int height, int depth) {
  const auto beyond = [](double value, double low, double high) {
    return std::max({low - value, 0.0, value - high});
  };
  return distance(Point{},
                  Point{beyond(at.x, corner.x, corner.x + width), beyond(at.y, corner.y, corner.y + height),
                        beyond(at.z, corner.z, corner.z + depth)});
}

/// From where the vehicle is to what has appeared and to what moves.
double gap_to_dynamic(const Scenario& scenario, const Decision& now) {
  double gap = std::numeric_limits<double>::infinity();
  if (!now.fired.empty() && now.fired[0])
    for (const CellChange& change : scenario.surprises[0].cells)
      gap = std::min(gap, distance_to_box(now.at, change.cell, 1, 1, 1));
  for (std::size_t m = 0; m < now.movers.size(); ++m) {
    if (now.movers[m].steps < 0) continue;
    const MovingObstacle& setup = scenario.movers[m];
    gap = std::min(gap, distance_to_box(now.at, Mover(setup).at(now.movers[m].steps), setup.width,
                                        setup.height, setup.depth));
  }
  return gap;
}

StudyRun auv_run(const Scenario& scenario, const PlannerChoice& choice) {
  const RunReport planned = plan_once(scenario.map, scenario.start, scenario.goal, choice);
  StudyRun run = plan_run(planned, std::size_t{kAuvFigures} - std::size_t{kPlanFigures});
  if (!run.found) return run;
  run.values[kCurvature] = planned.figures.greatest_curvature;
  double gap = std::numeric_limits<double>::infinity();
  const RunReport driven = drive(scenario, choice, [&](const Mission& mission) {
    gap = std::min(gap, gap_to_dynamic(scenario, mission.now()));
  });
  run.found = driven.succeeded();
  run.values[kVehicleCollisions] = static_cast<double>(driven.robot->collisions);
  if (!run.found || !driven.robot->kept) return run;
  run.values[kVehicleWay] = driven.robot->travelled;
  run.values[kStops] = static_cast<double>(driven.robot->kept->stops);
  run.values[kWayClearance] = driven.robot->kept->clearance;
  run.values[kDynamicGap] = gap;
  return run;
}

/// D*'s and the improved D*'s value in the plane and in space; nothing if there is nothing to compare.
struct AuvPair {
  double plain = 0, improved = 0;
};
std::optional<std::array<AuvPair, 2>> pairs_of(const StudyReport& report, std::size_t figure) {
  std::array<AuvPair, 2> pairs;
  for (const std::size_t world : {kAuvPlane, kAuvSpace}) {
    const auto values = typical_values(report, figure, world);
    if (values.empty()) return std::nullopt;
    pairs[world] = {values[kAuvPlain], values[kAuvImproved]};
  }
  return pairs;
}

template <class Holds>
StudyClaim auv_claim(const StudyReport& report, std::size_t figure, int decimals, const char* paper,
                     const char* ours, const char* why, Holds&& holds) {
  StudyClaim claim{paper, {}, Verdict::not_reproduced, {}};
  const auto pairs = pairs_of(report, figure);
  if (!pairs) return without_paths(std::move(claim));
  claim.ours = filled(ours, {told((*pairs)[0].plain, decimals), told((*pairs)[0].improved, decimals),
                             told((*pairs)[1].plain, decimals), told((*pairs)[1].improved, decimals)});
  const int held = (holds((*pairs)[0]) ? 1 : 0) + (holds((*pairs)[1]) ? 1 : 0);
  claim.verdict = held == 2 ? Verdict::reproduced : held == 1 ? Verdict::partly : Verdict::not_reproduced;
  if (held < 2) claim.why = why;
  return claim;
}

StudyClaim auv_safety_claim(const StudyReport& report) {
  std::size_t runs = 0, arrived = 0, collisions = 0;
  for (const StudyRun& run : report.runs) {
    if (run.planner != kAuvImproved) continue;
    ++runs;
    arrived += run.found ? 1 : 0;
    collisions += run.values[kVehicleCollisions].value_or(0) > 0 ? 1 : 0;
  }
  StudyClaim claim{"The vehicle plans anew as boxes appear and move, and reaches its goal.",
                   filled("{1} of {2} arrive with the improved D*; {3} touch anything.",
                          {std::to_string(arrived), std::to_string(runs), std::to_string(collisions)}),
                   Verdict::not_reproduced,
                   {}};
  claim.verdict = collisions == 0 && arrived == runs ? Verdict::reproduced
                  : collisions == 0                  ? Verdict::partly
                                                     : Verdict::not_reproduced;
  if (claim.verdict != Verdict::reproduced)
    claim.why = "In some of the random worlds there is no way, or what moves keeps the only one closed.";
  return claim;
}

Result<StudyReport> run_auv(const StudyWatch& watch) {
  const auto entries = study_entries({{"D*", "dstar"},
                                      {"Focused D*", "focused-dstar"},
                                      {"D* with threat cost", "threat-dstar"},
                                      {"Improved D*", "threat-dstar", {}, {"bspline"}}});
  if (!entries) return Error{entries.error()};
  StudyReport report;
  report.worlds_apart = true;
  report.worlds = {"in the plane", "in space"};
  report.planners = names_of(*entries);
  report.figures = plan_figures();
  for (const StudyFigure& figure :
       {StudyFigure{"curvature", "greatest curvature", "rad/cell", 2},
        StudyFigure{"way", "way driven", "cells", 2}, StudyFigure{"stops", "stops to turn", "", 1},
        StudyFigure{"way_clearance", "least clearance of the way", "cells", 2},
        StudyFigure{"dynamic_gap", "least gap to what appears or moves", "cells", 2},
        StudyFigure{"collisions", "collisions", "", 2}})
    report.figures.push_back(figure);
  report.charts = {{"clearance", "Mean clearance of the path", kMeanClearance},
                   {"gap", "Least gap to what appears or moves", kDynamicGap},
                   {"curvature", "Greatest curvature of the path", kCurvature},
                   {"stops", "Stops to turn", kStops}};
  std::vector<std::array<Scenario, 2>> worlds;
  for (std::uint64_t seed = 1; seed <= watch.seeds; ++seed) {
    auto plane = auv_world(kAuvPlane, seed), space = auv_world(kAuvSpace, seed);
    if (!plane) return Error{plane.error()};
    if (!space) return Error{space.error()};
    worlds.push_back({std::move(*plane), std::move(*space)});
  }
  const bool whole = run_all(report, watch, [&](std::size_t world, std::size_t planner, std::uint64_t seed) {
    return auv_run(worlds[static_cast<std::size_t>(seed - 1)][world], (*entries)[planner].choice);
  });
  if (!whole) return report;
  const auto greater = [](const AuvPair& pair) { return pair.improved > pair.plain; };
  report.claims = {
      auv_claim(
          report, kMeanClearance, 2,
          "The threat cost keeps the path away from obstacles, where D*'s hugs them.",
          "Mean clearance of the path: D* {1}, improved D* {2} cells in the plane; {3} and {4} in space.",
          "Where there is no room, there is none to keep.", greater),
      auv_claim(report, kDynamicGap, 2, "It keeps off dynamic obstacles above all.",
                "Least gap to what appears or moves: D* {1}, improved D* {2} cells in the plane; {3} and {4} "
                "in space.",
                "What moves comes to the vehicle, whatever its plan keeps off.", greater),
      auv_claim(report, kCurvature, 2,
                "The B-spline makes the path smooth: it can be followed by a vehicle whose turns "
                "are limited.",
                "Greatest curvature of the path: D* {1}, improved D* {2} rad per cell in the plane; {3} and "
                "{4} in space.",
                "Near obstacles the curve is pulled in to its control polygon, and has its corners.",
                [](const AuvPair& pair) { return pair.improved < pair.plain; }),
      auv_safety_claim(report)};
  return report;
}

Result<std::vector<StudyPicture>> auv_pictures() {
  return one_picture(library_scenario("auv.json"), "ways",
                     "The ways of a vehicle that knows its boxes by sonar alone: with D*, improved D* and "
                     "DLD* Lite. Shown is one layer; what lies in others is faint.",
                     true, {"path", "trail", "unknown", "spline"});
}

}  // namespace

StudyInfo auv_study() {
  return {
      "auv",
      "D* with threat cost and B-spline for an underwater vehicle",
      "Zhu, Sun & Zhu 2021, doi 10.14107/j.cnki.kzgc.20190179, its simulations in two and three dimensions",
      "The paper shows pictures and gives no numbers. For each seed a plane of 60 x 60 cells and a space of "
      "40 x 30 x 14 "
      "are filled to 12 in 100 with boxes, which the vehicle knows. One box appears on its way as it comes "
      "near, and one "
      "moves across; it sees them by sonar, 120 degrees ahead and 10 cells far. It goes 2 cells a second and "
      "turns by 45 "
      "degrees a second. c = 5, r_min = 1 and r_max = 3 as in the paper. A world with a sonar, boxes and "
      "three "
      "planners opens in the window as maps/auv.json.",
      20,
      3,
      run_auv,
      auv_pictures};
}

}  // namespace replan
