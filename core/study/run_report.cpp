#include "core/study/run_report.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/cpu_time.hpp"
#include "core/base/words.hpp"
#include "core/debug/event_words.hpp"
#include "core/plan/navigator.hpp"
#include "core/world/choices.hpp"

namespace replan {
namespace {

/// Whether the path leads through cells that are known to be free.
bool is_free(const Navigator& navigator, const PlannerChoice& choice, double radius, const Path& path) {
  return with_dimensions(navigator.box(), [&](auto d) {
    const auto known = navigator.known();
    const BoxLattice<d()> lattice(navigator.box().template sides<d()>(), {known.begin(), known.end()},
                                  move_rules(choice.settings, radius));
    return path_is_free(lattice, path);
  });
}

/// Status, path and the figures of its shape. A plan that was made with unchecked parents is looked at here,
/// so that nobody takes it for a path that can be driven.
void report_plan(RunReport& report, const Navigator& navigator, const PlannerChoice& choice, const Path& path,
                 PlanStatus status, double radius) {
  report.status = status_name(status);
  if (path.loops)
    report.status = mission_state_name(MissionState::loop);
  else if (path.unchecked && !is_free(navigator, choice, radius, path))
    report.status = mission_state_name(MissionState::collision);
  report.path = path;
  report.blind = info_of(choice).blind;
  for (const PlanNumber& number : info_of(choice).values.numbers)
    report.plan_numbers.emplace_back(number, navigator.number(number.which).to_double());
  report.solid = navigator.box().solid();
  report.figures = path_figures(navigator.box(), navigator.known(), path);
  report.radius = radius;
}

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

RobotReport robot_report(const Decision& decision) {
  return {.ending = decision.state,
          .moves = decision.figures.moves,
          .travelled = decision.figures.travelled,
          .collisions = decision.figures.collisions,
          .replans = decision.figures.replans,
          .noticed = std::count(decision.noticed.begin(), decision.noticed.end(), true),
          .seconds = static_cast<double>(decision.time) / static_cast<double>(kSecond),
          .last_plan = decision.plan->status,
          .drive = decision.drive.begun || decision.figures.drive.time > 0
                       ? std::optional(decision.figures.drive)
                       : std::nullopt,
          .kept = decision.figures.kept};
}

/// Why the robot did not arrive, where its ending alone does not say it: how things stood in the end.
std::string_view why_without_a_path(const RunReport& report) {
  const PlanStatus last = report.robot->last_plan;
  const bool has_size = report.radius > 0;
  if (report.status == status_name(last)) return status_sentence(last, has_size);  // it was so from the start
  if (last == PlanStatus::start_blocked)
    return has_size ? "The robot did not arrive: its own cell is an obstacle or too near one, and no way "
                      "leads out."
                    : "The robot did not arrive: its own cell is an obstacle, and it cannot leave it.";
  if (last == PlanStatus::goal_blocked)
    return has_size ? "The robot did not arrive: the goal's cell has become an obstacle, or has one nearer "
                      "to it than "
                      "the robot's radius."
                    : "The robot did not arrive: the goal's cell has become an obstacle.";
  if (report.robot->covered)
    return "The robot did not arrive: an obstacle covers its own cell, and no way leads out of it.";
  return "The robot did not arrive: the way to the goal was cut off while it drove.";
}

/// Often enough asked to stop; for a planner that is given so much time, often enough held against the clock.
constexpr std::int64_t kSlice = std::int64_t{1} << 14, kTimedSlice = 16;

/// How the plan stands in the end; nothing if it was stopped.
std::optional<PlanStatus> finish_within(Navigator& navigator, const RunLimit& limit) {
  const auto begin = std::chrono::steady_clock::now();
  while (!navigator.advance(limit.seconds ? kTimedSlice : kSlice)) {
    if (limit.stop.stop_requested()) return std::nullopt;
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin;
    if (limit.seconds && gone.count() >= *limit.seconds)
      return navigator.settle() ? navigator.status() : PlanStatus::none_found;
  }
  return navigator.status();
}

}  // namespace

std::optional<RunReport> plan_once(Navigator& navigator, const GridMap& map, Cell start, Cell goal,
                                   const PlannerChoice& choice, const RobotSetup& robot,
                                   const RunLimit& limit) {
  RunReport report;
  report.planner = choice.id;
  const auto begin = std::chrono::steady_clock::now();
  const double cpu_begin = thread_cpu_ms();
  navigator.begin(centre_of(start), centre_of(goal));
  const auto first = finish_within(navigator, limit);
  if (!first) return std::nullopt;
  PlanStatus status = *first;
  Counters in_vain;
  if (robot.unreachable_goal == UnreachableGoal::nearest && may_be_unreachable(status)) {
    const NodeId aim = map.box().node(goal),
                 nearest = navigator.nearest_reachable(map.box().node(start), aim);
    if (nearest != aim) {
      in_vain = navigator.counters();
      navigator.begin(centre_of(start), centre_of(map.box().position(nearest)));
      const auto second = finish_within(navigator, limit);
      if (!second) return std::nullopt;
      if (*second == PlanStatus::found) status = PlanStatus::found_nearest;
    }
  }
  report.plan_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  report.plan_cpu_ms = thread_cpu_ms() - cpu_begin;
  report_plan(report, navigator, choice, navigator.path(), status, robot.radius);
  report.frame = metric_frame(map);
  report.counters = in_vain + navigator.counters();
  report.memory_bytes = static_cast<std::int64_t>(navigator.memory_bytes());
  return report;
}

RunReport plan_once(const GridMap& map, Cell start, Cell goal, const PlannerChoice& choice,
                    const RobotSetup& robot) {
  const auto navigator = make_navigator(planner_of(choice), map.box(), map.blocked, robot.radius);
  return *plan_once(*navigator, map, start, goal, choice, robot, {});
}

namespace {

/// Nothing if it was stopped.
std::optional<RunReport> drive_watched(const Scenario& scenario, const PlannerChoice& choice,
                                       const StopToken& stop,
                                       const std::function<void(const Mission&)>& watch) {
  const auto mission = make_mission(scenario, choice);
  RunReport report;
  report.planner = choice.id;
  report.frame = metric_frame(scenario.map);
  while (!mission->standing() && mission->advance(kSlice))
    if (stop.stop_requested()) return std::nullopt;
  report_plan(report, mission->navigator(), choice, *mission->plan().path, mission->plan().status,
              scenario.robot.radius);
  for (bool going = true; going;) {
    if (stop.stop_requested()) return std::nullopt;
    if (watch && mission->standing()) watch(*mission);
    going = mission->advance(kSlice);
  }
  if (watch) watch(*mission);
  const MissionFigures& figures = mission->now().figures;
  report.plan_ms = figures.plan_ms;
  report.replan_ms = figures.replan_ms;
  report.replans = figures.replans;
  report.counters = figures.counters;
  report.memory_bytes = static_cast<std::int64_t>(figures.peak_bytes);
  report.robot = robot_report(mission->now());
  report.robot->covered = mission->covered();
  report.robot->short_of_goal = mission->short_of_goal();
  return report;
}

}  // namespace

RunReport drive(const Scenario& scenario, const PlannerChoice& choice,
                const std::function<void(const Mission&)>& watch) {
  return *drive_watched(scenario, choice, {}, watch);
}

std::optional<RunReport> drive_until(const StopToken& stop, const Scenario& scenario,
                                     const PlannerChoice& choice) {
  return drive_watched(scenario, choice, stop, {});
}

std::string explanation(const RunReport& report) {
  if (report.succeeded()) return {};
  const std::string_view ending = report.robot ? mission_state_name(report.robot->ending) : report.status;
  if (ending == mission_state_name(MissionState::loop))
    return "The plan leads round in a circle: set remote_parents=checked.";
  if (ending == mission_state_name(MissionState::stuck))
    return "The robot did not arrive: it is stuck, and finds no arc that leads it on.";
  if (ending == mission_state_name(MissionState::collision) && report.robot && report.robot->drive)
    return "The robot hit something that came nearer than it can stop.";
  if (ending == mission_state_name(MissionState::collision))
    return "The plan leads into an obstacle: set remote_parents=checked.";
  if (ending == mission_state_name(MissionState::endless))
    return "The robot did not arrive: what moves turned it back, or kept it waiting, again and again.";
  if (ending == mission_state_name(MissionState::nearest))
    return "The goal cannot be reached: the robot stands on the reachable cell nearest to it, " +
           decimal_text(report.robot->short_of_goal.value_or(0), 3) + " cells away.";
  if (report.robot) return std::string(why_without_a_path(report));
  if (report.status == status_name(PlanStatus::found_nearest) && !report.path.empty())
    return "The goal cannot be reached: the path leads to " +
           cell_text(cell_of(report.path.point(report.path.size() - 1)), report.solid) +
           ", the reachable cell nearest to it.";
  for (const PlanStatus status :
       {PlanStatus::no_path, PlanStatus::start_blocked, PlanStatus::goal_blocked, PlanStatus::none_found})
    if (report.status == status_name(status)) return status_sentence(status, report.radius > 0);
  return {};
}

RunReport report_at(const Decision& decision, const Plan& first, const PathFigures& figures,
                    const PlannerChoice& choice, double radius) {
  RunReport report;
  report.planner = choice.id;
  report.status = status_name(first.status);
  report.blind = info_of(choice).blind;
  report.figures = figures;
  report.radius = radius;
  report.plan_ms = decision.figures.plan_ms;
  report.replan_ms = decision.figures.replan_ms;
  report.replans = decision.figures.replans;
  report.counters = decision.figures.counters;
  report.last_plan = decision.figures.last_plan;
  report.memory_bytes = static_cast<std::int64_t>(decision.figures.peak_bytes);
  report.robot = robot_report(decision);
  return report;
}

std::vector<NamedFigure> named_figures(const RunReport& report) {
  const auto whole = [](std::string_view key, std::int64_t value) {
    return NamedFigure{key, static_cast<double>(value), true};
  };
  const auto real = [](std::string_view key, double value) { return NamedFigure{key, finite(value), false}; };
  const auto of_path = [&report](NamedFigure figure) {
    if (report.figures.nodes == 0) figure.value.reset();
    return figure;
  };
  std::vector<NamedFigure> figures = {of_path(whole("nodes", report.figures.nodes)),
                                      of_path(real("length", report.figures.length)),
                                      of_path(whole("turns", report.figures.turns)),
                                      of_path(real("turning_angle_deg", report.figures.turning_angle_deg)),
                                      of_path(real("greatest_curvature", report.figures.greatest_curvature)),
                                      of_path(real("min_clearance", report.figures.min_clearance)),
                                      of_path(real("mean_clearance", report.figures.mean_clearance)),
                                      real("plan_ms", report.plan_ms),
                                      real("replan_ms", report.replan_ms),
                                      whole("replans", report.replans),
                                      whole("expansions", report.counters.expansions),
                                      whole("queue_operations", report.counters.queue_operations),
                                      whole("sight_checks", report.counters.sight_checks),
                                      whole("memory_bytes", report.memory_bytes)};
  if (report.radius > 0) {
    const auto after = figures.begin() + 7;
    figures.insert(after,
                   {of_path(real("min_edge_clearance", report.figures.min_clearance - report.radius)),
                    of_path(real("mean_edge_clearance", report.figures.mean_clearance - report.radius))});
  }
  return figures;
}

std::vector<NamedFigure> named_figures(const RobotReport& robot) {
  return {{"moves", static_cast<double>(robot.moves), true},
          {"travelled", finite(robot.travelled), false},
          {"collisions", static_cast<double>(robot.collisions), true},
          {"replans", static_cast<double>(robot.replans), true},
          {"seconds", finite(robot.seconds), false}};
}

std::vector<NamedFigure> drive_figures(const RobotReport& robot) {
  const auto of_drive = [&robot](std::string_view key, auto&& value) {
    return NamedFigure{key, robot.drive ? finite(value(*robot.drive)) : std::nullopt, false};
  };
  return {of_drive("mean_speed", [](const DriveFigures& all) { return all.mean_speed(); }),
          of_drive("top_speed", [](const DriveFigures& all) { return all.top_speed; }),
          of_drive("mean_curvature", [](const DriveFigures& all) { return all.mean_curvature(); }),
          of_drive("turned_deg", [](const DriveFigures& all) { return all.turned * 180 / kPi; }),
          of_drive("mean_off_plan", [](const DriveFigures& all) { return all.mean_off_plan(); }),
          of_drive("max_off_plan", [](const DriveFigures& all) { return all.most_off_plan; })};
}

std::vector<NamedFigure> kept_figures(const RobotReport& robot) {
  const auto of_way = [&robot](std::string_view key, auto&& value) {
    return NamedFigure{key, robot.kept ? std::optional(value(*robot.kept)) : std::nullopt, false};
  };
  std::vector<NamedFigure> figures = {
      of_way("stops", [](const KeptWay& way) { return static_cast<double>(way.stops); }),
      of_way(
          "turning_seconds",
          [](const KeptWay& way) { return static_cast<double>(way.turning) / static_cast<double>(kSecond); }),
      of_way("course_turned_deg", [](const KeptWay& way) { return way.turned * 180 / kPi; }),
      of_way("way_min_clearance", [](const KeptWay& way) { return way.clearance; })};
  figures.front().whole = true;
  return figures;
}

std::vector<NamedFigure> surprise_figures(const RobotReport& robot) {
  return {{"surprises_noticed", static_cast<double>(robot.noticed), true}};
}

std::vector<NamedFigure> in_metres(std::span<const NamedFigure> figures, const MapFrame& frame) {
  constexpr std::pair<std::string_view, std::string_view> kLengths[] = {
      {"length", "length_m"},
      {"min_clearance", "min_clearance_m"},
      {"mean_clearance", "mean_clearance_m"},
      {"min_edge_clearance", "min_edge_clearance_m"},
      {"mean_edge_clearance", "mean_edge_clearance_m"},
      {"travelled", "travelled_m"}};
  std::vector<NamedFigure> lengths;
  for (const NamedFigure& figure : figures)
    for (const auto& [in_cells, key] : kLengths)
      if (figure.key == in_cells)
        lengths.push_back({key, figure.value ? std::optional(frame.metres(*figure.value)) : std::nullopt});
  for (const NamedFigure& figure : figures)
    if (figure.key == "greatest_curvature")
      lengths.push_back({"greatest_curvature_per_m",
                         figure.value ? std::optional(*figure.value / frame.metres(1)) : std::nullopt});
  return lengths;
}

}  // namespace replan
