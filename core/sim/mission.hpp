// A robot on its way: sense, tell the planner what changed, replan, move. Cell by cell, in fixed steps, so
// that the same scenario always gives the same events.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/drive/dynamic_window.hpp"
#include "core/plan/navigator.hpp"
#include "core/sim/course.hpp"
#include "core/sim/drive_figures.hpp"
#include "core/sim/mover.hpp"
#include "core/sim/route.hpp"
#include "core/sim/senses.hpp"
#include "core/trace/search_state.hpp"
#include "core/trace/tracer.hpp"
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
  stuck,      ///< a robot that drives has a plan, and finds no arc that leads along it
};

/// The state as its fixed name in JSON output.
const char* mission_state_name(MissionState state);

/// A drive among moving obstacles ends as endless after so many moves per cell of the world (without them a
/// robot enters a cell a few times at most), or after so many steps that it has waited, beyond its patience,
/// for what is scripted.
inline constexpr std::int64_t kMovesPerCell = 10, kMostWaits = 1'000'000;

/// How a robot has gone that keeps to its plan and turns no faster than it can.
struct KeptWay {
  static constexpr double kFarthest = 8;  ///< cells: so far around it looks for its clearance
  std::int64_t stops = 0;                 ///< at corners too sharp to be taken under way
  SimTime turning = 0;                    ///< on the spot, at these
  double turned = 0;                      ///< rad, all changes of its course, under way too
  double clearance = kFarthest;  ///< cells, of its centre from what stood in the world, where it came nearest
  friend bool operator==(const KeptWay&, const KeptWay&) = default;
};

/// What a mission has come to so far.
struct MissionFigures {
  std::int64_t moves = 0;
  double travelled = 0;  ///< cells, along the route
  std::int64_t collisions = 0;
  std::int64_t replans = 0;
  double plan_ms = 0;           ///< wall time of the first plan
  double replan_ms = 0;         ///< of all replans together: taking in the changes and the search
  Counters counters;            ///< of the planner, all plans together
  Counters last_plan;           ///< of the latest plan or replan alone
  std::size_t peak_bytes = 0;   ///< held by the planner at most, the map not counted
  DriveFigures drive;           ///< of a robot that drives
  std::optional<KeptWay> kept;  ///< of a robot whose course turns no faster than it can
};

/// What the log says of the latest decision of a robot that drives, as scalars (core/trace/event.hpp).
struct DriveChoice {
  std::uint64_t sub_goal = 0, admissible = 0, score = 0;
  friend bool operator==(const DriveChoice&, const DriveChoice&) = default;
};

/// How a robot stands that drives instead of going from cell to cell.
struct Drive {
  bool begun = false;        ///< it has taken up its pose
  DriveState state;          ///< in metres; y downwards, as rows count
  std::size_t sub_goal = 0;  ///< the place of the plan's path that it makes for
  double to_go =
      std::numeric_limits<double>::infinity();  ///< m, the least that was left of the plan to it ...
  SimTime since = 0;                            ///< ... and when that was
  SimTime planned = 0;                          ///< when it last planned again since it had lost its way
  int stuck = 0;  ///< how often it has turned all the way round since it last drove
  /// What it comes nearer to is another place, or time has gone by that it could do nothing with.
  void begin_to_count_progress() { to_go = std::numeric_limits<double>::infinity(); }
  DriveChoice choice;
  friend bool operator==(const Drive&, const Drive&) = default;
};

/// A moment at which the robot can decide something, and how the mission stands then: it can be taken up again from
/// there.
struct Decision {
  std::size_t event = 0;      ///< position in the event log
  std::int64_t clock = 0;     ///< steps of the robot: moves, turns on the spot, and waits
  SimTime time = 0;           ///< that these took
  std::vector<bool> fired;    ///< which surprises have happened
  std::vector<bool> noticed;  ///< and of which of them the robot knows; shorter where it knows of no more
  MissionState state = MissionState::driving;
  MissionFigures figures;
  Counters before_goal;  ///< of the figures' counters: the planner's work for earlier goals
  std::shared_ptr<const Plan> plan;
  std::shared_ptr<const Path> first_path;  ///< of the first plan that had one
  std::size_t next = 0;                    ///< the cell of the plan's route that the robot enters next
  Point before;           ///< where on the plan it was before its last move; `at` if it has not moved since
  Point at;               ///< where it is: not in the middle of the cell that the path crosses there
  Point after;            ///< where its next move leads; `at` if the plan has none
  double along_plan = 0;  ///< its way from the plan's beginning to there
  std::vector<MoverState> movers;
  std::shared_ptr<const Sightings> sightings;
  SimTime waited = 0;               ///< since the robot's last move
  SimTime forgets_after = kSecond;  ///< so much waiting it forgets the sightings that are out of sight
  Drive drive;                      ///< of a robot that drives
  Course course;  ///< which way it looks: that of its last move, or turn; of a robot that drives its heading
};

/// A moment between two calls of Mission::advance(), in the middle of a search too, from which a mission can
/// be taken up again. What the planner needs is in the log's state there.
struct Checkpoint {
  Decision now;
  Counters planner;      ///< its counters
  Counters before_plan;  ///< and what they were when the latest plan began
  int line = 0;          ///< the recorder's, for the owner of the log
};

/// Tells a recorder what happens, if there is one.
class MissionLog {
 public:
  explicit MissionLog(Recorder* recorder) : recorder_(recorder) {}
  void line(int number) const {
    if (recorder_ != nullptr) recorder_->line(number);
  }
  void note(EventKind kind, NodeId node, std::uint64_t payload = 0) const {
    if (recorder_ != nullptr) recorder_->note(kind, node, payload);
  }
  void change(EventKind kind, NodeId node, std::uint64_t before, std::uint64_t after) const {
    if (recorder_ != nullptr) recorder_->change(kind, node, before, after);
  }
  void change(Scalar scalar, std::uint64_t before, std::uint64_t after) const {
    if (recorder_ != nullptr) recorder_->change(scalar, before, after);
  }

 private:
  Recorder* recorder_;
};

/// One mission with one planner: all that a robot does but for how it moves, which is a robot's own
/// (core/robots). It senses, learns, replans, waits and decides.
///
/// What moves: obstacles wait for the robot rather than run into it or the cell that it is leaving. The robot
/// remembers where it saw them. Where that leaves it without a path it waits, looking around after every
/// step; after a second, then after twice as long each time, it forgets the sightings out of its sight and
/// plans again; when it has waited as long as its patience lasts and nothing scripted is to come, it gives
/// up.
///
/// A robot with a size plans over what its radius leaves free, and nothing that moves comes nearer to it than that. It
/// collides where its body would touch an obstacle on its way, unless it only drives away from one that has come too
/// near; see Navigator::begin() and core/sim/body.hpp.
///
/// An obstacle that comes onto the robot's own cell is not on its map while it stands there, unless
/// RobotSetup::robot_cell_blocks: it drives out, and then learns of it. A robot that starts in a wall or is
/// put into one stays there.
///
/// With UnreachableGoal::nearest the robot makes for the reachable cell nearest to its goal where there is no
/// path to the goal itself. That cell is chosen anew whenever its map changes, and the planner begins from
/// scratch where it is another one; Scalar::wanted holds the goal itself all the while.
class Mission {
 public:
  /// `scenario` may go after this. Planner and stages must be in their registries, start and goal on the map; a pilot is
  /// no planner (make_mission()).
  Mission(const Scenario& scenario, const PlannerChoice& choice, Recorder* recorder);
  virtual ~Mission() = default;
  Mission(const Mission&) = delete;
  Mission& operator=(const Mission&) = delete;

  /// Runs at most `iterations` iterations of the planner's main loop, or takes one decision of the robot.
  /// False if there is nothing more to do.
  bool advance(std::int64_t iterations);

  [[nodiscard]] MissionState state() const { return now_.state; }
  /// True while the robot could decide something: the moment that a `Decision` tells of.
  [[nodiscard]] bool standing() const { return now_.state != MissionState::planning; }
  /// True if the robot's next decision would be to move or to wait, or it has ended: nothing is due, nothing new is in
  /// sight.
  [[nodiscard]] bool settled() const;
  /// This moment; its `event` is left to the owner of the log.
  [[nodiscard]] const Decision& now() const { return now_; }
  [[nodiscard]] const Plan& plan() const { return *now_.plan; }
  [[nodiscard]] const Route& route() const { return route_; }
  [[nodiscard]] const Navigator& navigator() const { return *navigator_; }

  /// Whether something stands on the robot's cell.
  [[nodiscard]] bool covered() const { return truth_[robot_] != 0; }
  /// How far the robot is from its goal, as the crow flies.
  [[nodiscard]] double short_of_goal() const { return distance(box_.position(robot_), box_.position(goal_)); }

  /// Puts another list of surprises in place; those that have happened must be the same. A mission that had
  /// ended goes on if something is due.
  void set_surprises(Surprises surprises);
  /// This moment; not before the first advance(). Its `line` is left to the owner of the log.
  [[nodiscard]] Checkpoint checkpoint() const { return {now_, navigator_->counters(), before_plan_, 0}; }
  /// Goes to a moment of this scenario's own run, `state` being the log's state there.
  void restore(const Checkpoint& checkpoint, const SearchState& state);
  void restore(const Decision& decision, const SearchState& state) {
    restore({decision, decision.figures.counters - decision.before_goal, {}, 0}, state);
  }

 protected:
  /// The robot's next step along the plan that stands, which does not end where it is: step_along(), drive_on(),
  /// replan() or give_up().
  virtual void move() = 0;
  /// Before it waits: whether it stands still, or has taken a step to come to rest.
  virtual bool stands() { return true; }
  /// The way, from where it is on, on which it could still come to a stand: nothing that moves comes onto it.
  [[nodiscard]] virtual std::vector<Point> stopping_way() const { return {}; }
  /// Whether it is where a plan to that cell ends.
  [[nodiscard]] virtual bool is_at(NodeId cell) const { return robot_ == cell; }

  /// Goes on over so many cells of the route, or to its end if that is nearer, in one step of the clock. All of
  /// them have to be free. It takes `time`, or without one as long as RobotSetup says.
  void step_along(std::size_t cells, std::optional<SimTime> time = {});
  /// Turns to that course where it stands, a step of the clock by itself: it senses again before it goes on.
  void turn_on_the_spot(const Course& course, SimTime time);
  /// Drives over these points, from where it is on and near enough to each other for straight lines, in that time, one
  /// step of the clock; `way` is the length in cells. Stops at the first where its body would touch an obstacle.
  void drive_on(std::span<const Point> points, double way, SimTime time);
  /// Plans again from where it is, on the map as it is.
  void replan() { learn({}, EventKind::sensed); }
  void give_up(MissionState state);

  [[nodiscard]] const Box& box() const { return box_; }
  [[nodiscard]] const RobotSetup& setup() const { return robot_setup_; }
  /// The robot's map: nonzero = obstacle.
  [[nodiscard]] std::span<const std::uint8_t> known() const { return navigator_->known(); }
  [[nodiscard]] NodeId robot() const { return robot_; }
  /// How near a way comes to what stands in the world, in cells; `farthest` if no nearer.
  [[nodiscard]] double clearance_of(std::span<const Point> way, double farthest) const;
  [[nodiscard]] NodeId aim() const { return aim_; }
  [[nodiscard]] Decision& moment() { return now_; }
  [[nodiscard]] const Drive& driving() const { return now_.drive; }
  [[nodiscard]] const MissionLog& log() const { return tr_; }

 private:
  void begin();
  void search(std::int64_t iterations);
  void plan_stands();
  void decide();
  [[nodiscard]] bool ended() const;
  [[nodiscard]] std::size_t due_surprise() const;
  void happen(std::size_t index);
  [[nodiscard]] std::vector<CellEdit> write_cells(const Surprise& surprise);
  void notice(std::size_t index);
  void notice_surprises(const std::vector<CellEdit>& edits);
  [[nodiscard]] bool blocked(NodeId node) const { return navigator_->known()[node] != 0; }
  [[nodiscard]] Point point(NodeId node) const { return centre_of(box_.position(node)); }
  [[nodiscard]] Senses senses() const {
    return {box_, navigator_->known(), truth_, robot_setup_, robot_, now_.course};
  }
  void feel(NodeId cell, std::vector<CellEdit>& told) const;
  void learn(const std::vector<CellEdit>& edits, EventKind how, std::optional<NodeId> afresh_to = {});
  [[nodiscard]] bool seeks_nearest() const {
    return robot_setup_.unreachable_goal == UnreachableGoal::nearest;
  }
  [[nodiscard]] PlanStatus plan_status() const;
  [[nodiscard]] std::optional<NodeId> other_aim();
  void make_for_nearest();
  [[nodiscard]] bool arrives() const;
  [[nodiscard]] std::optional<std::int64_t> next_scripted_step(bool only_goals) const;
  void wait_for_change();
  [[nodiscard]] MissionState stuck() const;
  void wait_for_movers();
  void wait_on_goal(std::int64_t clock);
  void wait_until(std::int64_t clock);
  void advance_clock(std::int64_t steps, SimTime time, NodeId left, std::span<const Point> along = {});
  [[nodiscard]] std::vector<Cell> covered_cells(NodeId left, std::span<const Point> along) const;
  [[nodiscard]] SimTime step_time(double way) const;
  void put_robot(NodeId cell);
  void follow(const Path& path, PlanStatus status);
  [[nodiscard]] Point point_ahead() const;
  void collide(NodeId cell);
  void enter(std::size_t on_route, std::span<const Point> along, std::optional<SimTime> time);
  [[nodiscard]] bool goes_on_for_ever() const;
  void look_ahead();

  MissionLog tr_;
  RobotSetup robot_setup_;
  Surprises surprises_;
  Crowd crowd_;
  Box box_;
  std::vector<std::uint8_t> truth_;  // as EventKind::truth holds it
  std::unique_ptr<Navigator> navigator_;
  NodeId start_ = kNoNode, goal_ = kNoNode, robot_ = kNoNode;
  NodeId aim_ = kNoNode;  // where the planner plans to: the goal, or the reachable cell nearest to it
  bool begun_ = false;
  Counters before_plan_;
  Route route_;  // of the plan that stands
  Decision now_;
};

/// The map that the robot starts with.
SharedBytes initial_knowledge(const Scenario& scenario, bool all_mapped = false);

/// The state before the first event of a mission's log.
SearchState initial_state(const Scenario& scenario, const PlannerChoice& choice, bool all_mapped = false);

/// The mission of the scenario's robot with one planner, or of a pilot's own (core/world/choices.hpp). `recorder`, if
/// there is one, is told of it and must outlive it. `scenario` may go after this.
std::unique_ptr<Mission> make_mission(const Scenario& scenario, const PlannerChoice& choice,
                                      Recorder* recorder = nullptr);

}  // namespace replan
