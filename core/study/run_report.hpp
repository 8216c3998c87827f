// What one planner came to on one world: a plan alone, or a robot that drives it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/stop.hpp"
#include "core/plan/figures.hpp"
#include "core/plan/navigator.hpp"
#include "core/plan/planner.hpp"
#include "core/plan/search_values.hpp"
#include "core/sim/mission.hpp"
#include "core/world/map_frame.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// The robot's side of a run.
struct RobotReport {
  MissionState ending = MissionState::planning;  ///< arrived, no_path, collision, loop, endless, nearest
  std::int64_t moves = 0;
  double travelled = 0;  ///< cells, along the route
  std::int64_t collisions = 0;
  std::int64_t replans = 0;
  std::int64_t noticed =
      0;               ///< surprises that it came to know of: by their cells, a new goal, or being put down
  double seconds = 0;  ///< of the world's time, waiting counted
  PlanStatus last_plan = PlanStatus::searching;  ///< how the latest plan stands
  std::optional<DriveFigures> drive = {};        ///< of a robot on wheels
  std::optional<KeptWay> kept = {};              ///< of a robot that turns no faster than it can
  bool covered = false;                          ///< an obstacle stands on its cell
  std::optional<double> short_of_goal = {};      ///< cells from where it ends to its goal, as the crow flies
  [[nodiscard]] bool reached() const { return ending == MissionState::arrived; }
};

/// One run of one planner. `status`, `path` and its figures are of the first plan, from the start to the goal
/// on the map as it was known then; times, counters and memory are of the whole run, replans included.
struct RunReport {
  std::string planner;  ///< registry id
  std::string_view status =
      "no-path";  ///< status_name(), or "loop" or "collision" for a plan that cannot be driven
  Path path;
  bool blind = false;      ///< the path may lead through anything: nothing to hold other plans against
  bool solid = false;      ///< in space: its places have a z
  PathFigures figures;     ///< clearances are those of the robot's centre
  double radius = 0;       ///< of the robot
  double plan_ms = 0;      ///< wall time of the first plan
  double plan_cpu_ms = 0;  ///< and the processor's, of plan_once() alone
  double replan_ms = 0;    ///< of all replans together
  std::int64_t replans = 0;
  Counters counters;
  std::int64_t memory_bytes = 0;  ///< held by the planner at most, the map not counted
  /// The numbers that the planner declares, of the first plan.
  std::vector<std::pair<PlanNumber, double>> plan_numbers;
  std::optional<Counters> last_plan;  ///< the work of the latest plan alone, where that is told
  std::optional<RobotReport> robot;
  /// The frame of its map, if that is metric: what is told of its lengths in metres besides. Nothing: in cells alone.
  std::optional<MapFrame> frame;

  /// True if the plan leads to the goal and the robot, where there is one, arrived.
  [[nodiscard]] bool succeeded() const { return robot ? robot->reached() : status == "found"; }
};

/// What ends a run before it is done.
struct RunLimit {
  StopToken stop = {};
  /// Seconds that a planner has which becomes better with time: it then takes the best path that it has. Nothing: as many
  /// as it takes.
  std::optional<double> seconds = std::nullopt;
};

/// Plans once, for a robot of that radius; with UnreachableGoal::nearest to the reachable cell nearest to the goal if
/// there is no path to the goal. Start and goal must be on the map, the planner in the registry.
RunReport plan_once(const GridMap& map, Cell start, Cell goal, const PlannerChoice& choice,
                    const RobotSetup& robot = {});
/// As above with a navigator of that planner, map and radius, which may have planned before; nothing if it was stopped.
std::optional<RunReport> plan_once(Navigator& navigator, const GridMap& map, Cell start, Cell goal,
                                   const PlannerChoice& choice, const RobotSetup& robot,
                                   const RunLimit& limit);
/// Drives the scenario's robot with one planner until there is nothing more to do. `watch`, if there is one, is shown the
/// mission after each decision of the robot.
RunReport drive(const Scenario& scenario, const PlannerChoice& choice,
                const std::function<void(const Mission&)>& watch = {});
/// As above; nothing if it was stopped.
std::optional<RunReport> drive_until(const StopToken& stop, const Scenario& scenario,
                                     const PlannerChoice& choice);

/// Why a run did not succeed, as a sentence; empty if it did.
std::string explanation(const RunReport& report);

/// How a run stands at a decision: its first plan with the figures of its path, as everywhere, and the work until then.
/// The path itself is left out.
RunReport report_at(const Decision& decision, const Plan& first, const PathFigures& figures,
                    const PlannerChoice& choice, double radius);

/// A figure by its fixed name in JSON and CSV.
struct NamedFigure {
  std::string_view key;
  std::optional<double> value;  ///< always finite; nothing for the shape of a path that there is not
  bool whole = false;           ///< counts; times and lengths are not
};
/// The 14 figures of a run: nodes, length, ... memory_bytes; and of a robot with a size the clearance of its edge
/// besides, behind that of its centre. Lengths are in cells.
std::vector<NamedFigure> named_figures(const RunReport& report);
/// moves, travelled, collisions, replans, seconds.
std::vector<NamedFigure> named_figures(const RobotReport& robot);
/// What there is to say of a way on wheels besides: mean_speed, top_speed (m/s), mean_curvature (1/m), turned_deg,
/// mean_off_plan and max_off_plan, the distance to the first plan's path (m). Without values where nothing drives.
std::vector<NamedFigure> drive_figures(const RobotReport& robot);
/// stops, turning_seconds, course_turned_deg and way_min_clearance: how a robot that keeps to its plan has gone (KeptWay).
/// Without values for one that turns in no time.
std::vector<NamedFigure> kept_figures(const RobotReport& robot);
/// surprises_noticed.
std::vector<NamedFigure> surprise_figures(const RobotReport& robot);
/// Those of the figures that are lengths, in metres: length_m, min_clearance_m ...
std::vector<NamedFigure> in_metres(std::span<const NamedFigure> figures, const MapFrame& frame);

/// `{"runs": [...]}`. All figures are numbers; 0 stands for what a run without a path has not. On a metric map there are
/// lengths (length_m) and places (path_m) in metres too.
std::string runs_json(std::span<const RunReport> reports);
/// One line for each run under a line of names; the path is left out. 0 stands
/// for what a run without a path has not. On a metric map columns of lengths in metres (length_m) come last.
std::string runs_csv(std::span<const RunReport> reports);

}  // namespace replan
