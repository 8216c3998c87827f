// A robot on its way: sense, tell the planner what changed, replan, move. Cell by cell, in fixed steps, so
// that the same scenario always gives the same events.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/lattice/box_lattice.hpp"
#include "core/plan/registry.hpp"
#include "core/sim/mover.hpp"
#include "core/sim/route.hpp"
#include "core/sim/senses.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// How a mission stands.
enum class MissionState : std::uint8_t {
  planning,  ///< the planner is at work
  driving,   ///< the plan stands, the robot can take its next step
  arrived,
  no_path,    ///< no path, and nothing that is scripted can open one: the robot waits for a change by hand
  collision,  ///< the plan leads into an obstacle (only with `remote_parents=printed`)
  loop,       ///< the plan leads round in a circle (only with `remote_parents=printed`)
  endless,    ///< what moves keeps turning the robot back, or waiting: see kMovesPerCell and kMostWaits
  nearest,    ///< as no_path, but the robot stands on the reachable cell nearest to its goal
};

/// The state as its fixed name in JSON output.
const char* mission_state_name(MissionState state);

/// A drive among moving obstacles ends as endless after so many moves per cell of the world (without them a
/// robot enters a cell a few times at most), or after so many steps that it has waited, beyond its patience,
/// for what is scripted.
inline constexpr std::int64_t kMovesPerCell = 10, kMostWaits = 1'000'000;

/// What a mission has come to so far.
struct MissionFigures {
  std::int64_t moves = 0;
  double travelled = 0;  ///< cells, along the route
  std::int64_t collisions = 0;
  std::int64_t replans = 0;
  double plan_ms = 0;          ///< wall time of the first plan
  double replan_ms = 0;        ///< of all replans together: taking in the changes and the search
  Counters counters;           ///< of the planner, all plans together
  Counters last_plan;          ///< of the latest plan or replan alone
  std::size_t peak_bytes = 0;  ///< held by the planner at most, the map not counted
};

/// A moment between two decisions of the robot, from which a mission can be taken up again.
struct Mark {
  std::size_t event = 0;    ///< position in the event log
  std::int64_t clock = 0;   ///< steps of the robot: moves, and waits while there is no path
  SimTime time = 0;         ///< that these took
  std::vector<bool> fired;  ///< which surprises have happened
  MissionState state = MissionState::driving;
  MissionFigures figures;
  Counters before_goal;  ///< of the figures' counters: the planner's work for earlier goals
  std::shared_ptr<const Plan> plan;
  std::size_t next = 0;   ///< the cell of the plan's route that the robot enters next
  PlanePoint before;      ///< where on the plan it was before its last move; `at` if it has not moved since
  PlanePoint at;          ///< where it is: not in the middle of the cell that the path crosses there
  PlanePoint after;       ///< where its next move leads; `at` if the plan has none
  double along_plan = 0;  ///< its way from the plan's beginning to there
  std::vector<MoverState> movers;
  std::shared_ptr<const Sightings> sightings;
  SimTime waited = 0;               ///< since the robot's last move
  SimTime forgets_after = kSecond;  ///< so much waiting it forgets the sightings that are out of sight
};

/// A moment between two calls of Mission::advance(), in the middle of a search too, from which a mission can
/// be taken up again. What the planner needs is in the log's state there.
struct Checkpoint {
  Mark now;
  Counters planner;      ///< its counters
  Counters before_plan;  ///< and what they were when the latest plan began
  int line = 0;          ///< the recorder's, for the owner of the log
};

/// One mission with one planner. T is NoTrace or Recorder.
///
/// What moves: obstacles wait for the robot rather than run into it or the cell that it is leaving. The robot
/// remembers where it saw them. Where that leaves it without a path it waits, looking around after every
/// step; after a second, then after twice as long each time, it forgets the sightings out of its sight and
/// plans again; when it has waited as long as its patience lasts and nothing scripted is to come, it gives
/// up.
///
/// An obstacle that comes onto the robot's own cell is not on its map while it stands there, unless
/// RobotSetup::robot_cell_blocks: it drives out, and then learns of it. A robot that starts in a wall or is
/// put into one stays there.
///
/// With UnreachableGoal::nearest the robot makes for the reachable cell nearest to its goal where there is no
/// path to the goal itself. That cell is chosen anew whenever its map changes, and the planner begins from
/// scratch where it is another one; Scalar::wanted holds the goal itself all the while.
template <class T>
class Mission {
 public:
  /// `scenario` may go after this. The planner must be in the registry, start and goal on the map.
  Mission(const Scenario& scenario, const PlannerChoice& choice, T& tracer);

  /// Runs at most `iterations` iterations of the planner's main loop, or takes one decision of the robot.
  /// False if there is nothing more to do.
  bool advance(std::int64_t iterations);

  [[nodiscard]] MissionState state() const { return now_.state; }
  /// True while the robot could decide something: the moment that a Mark records.
  [[nodiscard]] bool standing() const { return now_.state != MissionState::planning; }
  /// True if the robot's next decision would be to move or to wait: nothing is due, nothing new is in sight.
  [[nodiscard]] bool settled() const;
  /// This moment; its `event` is left to the owner of the log.
  [[nodiscard]] const Mark& now() const { return now_; }
  [[nodiscard]] const Plan& plan() const { return *now_.plan; }
  [[nodiscard]] const Route& route() const { return route_; }
  [[nodiscard]] const Planner<Grid2>& planner() const { return *planner_; }
  [[nodiscard]] const Grid2& known() const { return known_; }

  /// Whether something stands on the robot's cell.
  [[nodiscard]] bool covered() const { return truth_[robot_] != 0; }
  /// How far the robot is from its goal, as the crow flies.
  [[nodiscard]] double short_of_goal() const {
    return distance(known_.position(robot_), known_.position(goal_));
  }

  /// Puts another list of surprises in place; those that have happened must be the same. A mission that had
  /// ended goes on if something is due.
  void set_surprises(Surprises surprises);
  /// This moment; not before the first advance(). Its `line` is left to the owner of the log.
  [[nodiscard]] Checkpoint checkpoint() const { return {now_, planner_->counters(), before_plan_, 0}; }
  /// Goes to a moment of this scenario's own run, `state` being the log's state there.
  void restore(const Checkpoint& checkpoint, const SearchState& state);
  void restore(const Mark& mark, const SearchState& state) {
    restore({mark, mark.figures.counters - mark.before_goal, {}, 0}, state);
  }

 private:
  void begin();
  void search(std::int64_t iterations);
  void plan_stands();
  void decide();
  [[nodiscard]] bool ended() const;
  [[nodiscard]] std::size_t due_surprise() const;
  void happen(std::size_t index);
  [[nodiscard]] std::vector<CellEdit> write_cells(const Surprise& surprise);
  [[nodiscard]] Senses senses() const { return {known_, truth_, robot_setup_, robot_}; }
  void feel(NodeId cell, std::vector<CellEdit>& told) const;
  void learn(const std::vector<CellEdit>& edits, EventKind how, std::optional<NodeId> afresh_to = {});
  [[nodiscard]] bool seeks_nearest() const {
    return robot_setup_.unreachable_goal == UnreachableGoal::nearest;
  }
  [[nodiscard]] PlanStatus plan_status() const;
  [[nodiscard]] std::optional<NodeId> other_aim();
  void make_for_nearest();
  [[nodiscard]] std::optional<std::int64_t> next_scripted_step(bool only_goals) const;
  void wait_for_change();
  [[nodiscard]] MissionState stuck() const;
  void wait_for_movers();
  void wait_on_goal(std::int64_t clock);
  void wait_until(std::int64_t clock);
  void drive();
  void give_up(MissionState state);
  void advance_clock(std::int64_t steps, SimTime time, NodeId left);
  [[nodiscard]] SimTime step_time(double way) const;
  void put_robot(NodeId cell);
  void follow(const Path& path, PlanStatus status);
  [[nodiscard]] PlanePoint point_ahead() const;
  void enter(NodeId cell);

  T& tr_;
  std::shared_ptr<const PlannerInfo> info_;
  Settings settings_;
  SightRule sight_rule_ = SightRule::supercover;
  RobotSetup robot_setup_;
  Surprises surprises_;
  Crowd crowd_;
  Grid2 known_;
  std::vector<std::uint8_t> truth_;  // as EventKind::truth holds it
  std::unique_ptr<Planner<Grid2>> planner_;
  NodeId start_ = kNoNode, goal_ = kNoNode, robot_ = kNoNode;
  NodeId aim_ = kNoNode;  // where the planner plans to: the goal, or the reachable cell nearest to it
  bool begun_ = false;
  Counters before_plan_;
  Route route_;  // of the plan that stands
  Mark now_;
};

/// The map that the robot starts with.
SharedBytes initial_knowledge(const Scenario& scenario, bool all_mapped = false);

extern template class Mission<NoTrace>;
extern template class Mission<Recorder>;

}  // namespace replan
