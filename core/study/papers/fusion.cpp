// Figure 6 of the fusion paper: a robot on two wheels meets four boxes that are on no map, and something that moves.
//
//  Liu J., Xue L., Zhang H. & Liu Z., "Robot dynamic path planning based on improved A* and DWA algorithm" (in Chinese),
//  Henan University of Technology, figure 6
#include <algorithm>

#include "core/base/random.hpp"
#include "core/study/barn.hpp"
#include "core/study/papers/paper_studies.hpp"
#include "core/study/study_runs.hpp"
#include "core/study/study_words.hpp"

namespace replan {
namespace {

enum FusionEntry : std::size_t { kDwaAlone, kFusionAstar, kFusion };
enum FusionFigure : std::size_t {
  kArrived,
  kTouched,
  kWay,
  kWayOverPlan,
  kOffPlan,
  kGap,
  kSeconds,
  kFusionFigures
};
constexpr int kBoxes = 4;

Result<Scenario> figure_6() {
  return library_scenario("fusion-boxes.json");
}

/// The world of figure 6 without what the robot does not know of.
Scenario known_world(Scenario scenario) {
  scenario.map.blocked = with_unmapped_as(scenario.map.blocked, kFree);
  scenario.movers.clear();
  return scenario;
}

RunReport plan_of(const Scenario& scenario, const GridMap& map) {
  return plan_once(map, scenario.start, scenario.goal, scenario.planners.front(), scenario.robot);
}

/// An unmapped box of 1 x 2 or 2 x 1 cells about a point of the path; the ends stay free.
void put_box(Scenario& scenario, Cell corner, bool flat) {
  for (int i = 0; i < 2; ++i) {
    const Cell cell{corner.x + (flat ? i : 0), corner.y + (flat ? 0 : i), 0};
    if (scenario.map.contains(cell) && !scenario.map.at(cell))
      scenario.map.blocked[scenario.map.index(cell)] = kUnmapped;
  }
}

/// Something that goes to and fro across the path, as far as the world is free there, three cells each way at most.
MovingObstacle crossing(const GridMap& map, Cell middle, bool flat) {
  const auto reach = [&](int sign) {
    Cell cell = middle;
    for (int i = 0; i < 3; ++i) {
      const Cell next{cell.x + (flat ? sign : 0), cell.y + (flat ? 0 : sign), 0};
      if (!map.contains(next) || map.at(next)) break;
      cell = next;
    }
    return cell;
  };
  return {.way = {reach(-1), reach(1)}, .speed = 0.3};
}

/// Four boxes and a crossing at random places of the path that improved A* has on the map; drawn again as long as no way is
/// left for a robot of that size.
Scenario with_surprises(const Scenario& known, const Path& path, std::uint64_t seed) {
  Random random(seed);
  for (;;) {
    Scenario scenario = known;
    for (int box = 0; box < kBoxes; ++box) {
      const double share = 0.1 + 0.8 * (box + random.unit()) / kBoxes;
      put_box(scenario, cell_of(point_along(path, share)), random.below(2) == 0);
    }
    GridMap truth = scenario.map;
    truth.blocked = with_unmapped_as(truth.blocked, kObstacle);
    const RunReport plan = plan_of(scenario, truth);
    if (!plan.succeeded()) continue;
    scenario.movers = {
        crossing(truth, cell_of(point_along(plan.path, 0.3 + 0.5 * random.unit())), random.below(2) == 0)};
    return scenario;
  }
}

StudyRun fusion_run(const Scenario& scenario, const PlannerChoice& choice, double planned) {
  std::vector<Point> way;
  const RunReport report =
      drive(scenario, choice, [&](const Mission& mission) { way.push_back(mission.now().at); });
  StudyRun run{.found = report.succeeded(), .values = std::vector<std::optional<double>>(kFusionFigures)};
  run.values[kArrived] = run.found ? 1 : 0;
  run.values[kTouched] = static_cast<double>(report.robot->collisions);
  GridMap truth = scenario.map;
  truth.blocked = with_unmapped_as(truth.blocked, kObstacle);
  run.values[kGap] = path_figures(truth.box(), truth.blocked.plain(), Path(std::move(way))).min_clearance -
                     scenario.robot.radius;
  if (!run.found) return run;
  run.values[kWay] = report.robot->travelled;
  run.values[kWayOverPlan] = report.robot->travelled / planned;
  if (report.robot->drive) run.values[kOffPlan] = report.robot->drive->mean_off_plan();
  run.values[kSeconds] = report.robot->seconds;
  return run;
}

struct Arrivals {
  std::size_t runs = 0, arrived = 0, touched = 0;
};
Arrivals arrivals_of(const StudyReport& report, std::size_t planner) {
  Arrivals arrivals;
  for (const StudyRun& run : report.runs) {
    if (run.planner != planner) continue;
    ++arrivals.runs;
    arrivals.arrived += run.found ? 1 : 0;
    arrivals.touched += run.values[kTouched].value_or(0) > 0 ? 1 : 0;
  }
  return arrivals;
}

StudyClaim avoids_claim(const StudyReport& report) {
  const Arrivals all = arrivals_of(report, kFusion);
  StudyClaim claim{
      "The fused method avoids the four unknown static obstacles and the moving one, and reaches its goal.",
      filled("{1} of {2} robots arrive; {3} touch anything.",
             {std::to_string(all.arrived), std::to_string(all.runs), std::to_string(all.touched)}),
      Verdict::not_reproduced,
      {}};
  claim.verdict = all.touched == 0 && all.arrived == all.runs      ? Verdict::reproduced
                  : all.touched == 0 && 2 * all.arrived > all.runs ? Verdict::partly
                                                                   : Verdict::not_reproduced;
  if (claim.verdict != Verdict::reproduced)
    claim.why =
        "The paper shows one world. In random ones a box can stand so near a sub-goal that no arc leads past "
        "it, and a "
        "robot that scores arcs one step ahead stays before it.";
  return claim;
}

StudyClaim near_plan_claim(const StudyReport& report) {
  StudyClaim claim{
      "The way that is driven stays near the global path of the improved A*, which is the best without the "
      "surprises.",
      {},
      Verdict::not_reproduced,
      {}};
  const auto over = spread_of(report, kWayOverPlan, kFusion), off = spread_of(report, kOffPlan, kFusion);
  if (!over || !off) return without_paths(std::move(claim));
  claim.ours = filled("It is {1} times as long (quartiles {2} and {3}), and {4} m off it on the average.",
                      {told(over->median, 3), told(over->low, 3), told(over->high, 3), told(off->mean, 2)});
  claim.verdict = over->median <= 1.1 && off->mean <= 1 ? Verdict::reproduced
                  : over->median <= 1.25                ? Verdict::partly
                                                        : Verdict::not_reproduced;
  if (claim.verdict != Verdict::reproduced)
    claim.why = "To go round four boxes and one that moves costs way, and arcs do not keep to lines.";
  return claim;
}

StudyClaim alone_claim(const StudyReport& report) {
  const Arrivals alone = arrivals_of(report, kDwaAlone), fused = arrivals_of(report, kFusion);
  StudyClaim claim{
      "DWA alone, which knows its goal and no sub-goals, gets into local optima: it fails or goes a longer "
      "way.",
      filled("DWA alone arrives {1} of {2} times, the fused method {3} times.",
             {std::to_string(alone.arrived), std::to_string(alone.runs), std::to_string(fused.arrived)}),
      Verdict::not_reproduced,
      {}};
  claim.verdict = 2 * alone.arrived < fused.arrived ? Verdict::reproduced
                  : alone.arrived < fused.arrived   ? Verdict::partly
                                                    : Verdict::not_reproduced;
  if (claim.verdict != Verdict::reproduced)
    claim.why = "Where nothing stands in the straight way no plan is needed.";
  return claim;
}

/// The table of the BARN benchmark: DWA alone and behind either A*.
Result<std::string> barn_supplement(const StudyWatch& watch) {
  if (watch.barn.empty()) return std::string();
  const auto worlds = read_barn(watch.barn);
  if (!worlds) return Error{worlds.error()};
  std::vector<BarnSummary> summaries;
  for (const auto& [name, global] : {std::pair{"dwa", ""},
                                     {"fusion with astar", "astar"},
                                     {"fusion with adaptive-astar", "adaptive-astar"}}) {
    if (watch.stop.stop_requested()) return std::string();
    summaries.push_back(summary_of(name, drive_barn(*worlds, barn_settings(barn_drive(), global))));
  }
  return "## The worlds of the BARN benchmark\n\n" + barn_table(summaries);
}

Result<StudyReport> run_fusion(const StudyWatch& watch) {
  const auto entries =
      study_entries({{"DWA alone", "dwa", {{"w_max", "1"}}},
                     {"Fusion with plain A*", "fusion", {{"w_max", "1"}, {"global", "astar"}}},
                     {"Fusion", "fusion", {{"w_max", "1"}}}});
  if (!entries) return Error{entries.error()};
  auto scenario = figure_6();
  if (!scenario) return Error{scenario.error()};
  const Scenario known = known_world(std::move(*scenario));
  const RunReport plan = plan_of(known, known.map);
  StudyReport report;
  report.worlds = {"boxes and a crossing"};
  report.planners = names_of(*entries);
  report.figures = {{"arrived", "arrived", "", 2},
                    {"collisions", "collisions", "", 2},
                    {"way", "way", "m", 2},
                    {"way_over_plan", "way over the path on the map", "", 3},
                    {"off_plan", "off that path, mean", "m", 2},
                    {"gap", "least gap to what stands", "m", 2},
                    {"seconds", "time of the drive", "s", 0}};
  report.charts = {{"arrived", "Share of the robots that arrive", kArrived},
                   {"way", "Way over the length of the path on the map", kWayOverPlan},
                   {"gap", "Least gap between the robot's edge and what stands", kGap}};
  const bool whole = run_all(report, watch, [&](std::size_t, std::size_t planner, std::uint64_t seed) {
    return fusion_run(with_surprises(known, plan.path, seed), (*entries)[planner].choice,
                      plan.figures.length);
  });
  if (!whole) return report;
  report.claims = {avoids_claim(report), near_plan_claim(report), alone_claim(report)};
  const auto barn = barn_supplement(watch);
  if (!barn) return Error{barn.error()};
  report.supplement = *barn;
  return report;
}

Result<std::vector<StudyPicture>> fusion_pictures() {
  auto scenario = figure_6();
  if (scenario) scenario->planners.resize(1);
  return one_picture(scenario, "way",
                     "The way of a robot round four boxes that are on no map, and past "
                     "something that moves, as in figure 6 of the paper.",
                     true, {"path", "trail", "grid"});
}

}  // namespace

StudyInfo fusion_study() {
  return {"fusion",
          "Improved A* fused with DWA, among what is on no map",
          "Liu, Xue, Zhang & Liu, Henan University of Technology, figure 6",
          "The grid of figure 5 with cells of 1 m. For each seed four boxes of 1 x 2 cells stand at random "
          "places of the "
          "path that the improved A* has on the map, unknown to the robot, and something of 1 x 1 m crosses "
          "it to and fro "
          "at 0.3 m/s. Weights 0.3, 0.4, 0.2 and 0.2 as in the paper; the table of its robot is lost: 0.5 "
          "m/s and 10 x 20 "
          "samples each 0.2 s as on its Turtlebot2, 1 rad/s, a radius of 0.3 m. One such world opens in the "
          "window as "
          "maps/fusion-boxes.json. With the BARN benchmark's folder (--barn) its 300 worlds are driven too.",
          40,
          6,
          run_fusion,
          fusion_pictures};
}

}  // namespace replan
