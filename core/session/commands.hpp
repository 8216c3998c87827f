// The commands of commands.def, as plain data.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/debug/difference.hpp"
#include "core/session/lockstep.hpp"
#include "core/session/stepping.hpp"
#include "core/world/scenario.hpp"
#include "core/world/transform.hpp"

namespace replan {

/// Cells and their new values. Strokes with the same nonzero number are taken back together.
struct PaintCells {
  std::vector<CellChange> cells;
  std::uint64_t stroke = 0;
};
/// So many cells that nobody wants them told to the robot one by one: what lies in the world of the boxes, or of the
/// region of alike cells around one, in the map. The robot starts afresh. Start and goal stay free.
struct PaintBoxes {
  std::vector<CellBox> boxes;
  bool blocked = true;
};
/// The region lies in one layer across that axis; its cells are written there and in so many layers from it on.
struct FillRegion {
  Cell from;
  bool blocked = true;
  Axis across = Axis::z;
  int layers = 1;
};
/// At most kMostSurprised cells.
struct DropSurprise {
  std::vector<CellChange> cells;
  std::uint64_t stroke = 0;
};
struct SetStart {
  Cell cell;
  std::uint64_t stroke = 0;
};
/// Once the robot has set out, the goal moves at its present step and the planner plans afresh from there.
struct SetGoal {
  Cell cell;
  std::uint64_t stroke = 0;
};
/// Before the robot has set out this moves the start.
struct PutRobot {
  Cell cell;
  std::uint64_t stroke = 0;
};
/// It appears at the robot's present step. The runs start afresh and go to where the robot was.
struct AddMover {
  MovingObstacle mover;
};
struct ChangeMover {
  std::size_t index = 0;
  MovingObstacle mover;
  std::uint64_t stroke = 0;
};
struct RemoveMover {
  std::size_t index = 0;
};
/// Changes cells at a later step, or when the robot comes near a place. The run goes on from where it is.
struct ScheduleSurprise {
  Surprise surprise;
};
/// `index` into Scenario::surprises.
struct RemoveSurprise {
  std::size_t index = 0;
};
struct TurnWorld {
  Turn turn = Turn::left;
};
struct ResizeWorld {
  NewSize size;
};
/// But for the cells of the start, the goal and the robot, which stay free.
struct InvertWorld {};
struct ClearWorld {};
/// Takes the place of the map, and of the surprises and moving obstacles in it. Without ends they are put far
/// apart in its largest open region.
struct ReplaceMap {
  GridMap map;
  std::optional<Cell> start;
  std::optional<Cell> goal;
};
/// As ReplaceMap, with a map made by a generator (core/world/generators/list.hpp).
struct GenerateWorld {
  std::string generator;
  Settings settings;
  int width = 0, height = 0;
  std::uint64_t seed = 1;
  int layers = 1;
};
struct ChoosePlanner {
  std::size_t pane = 0;
  std::string id;
};
/// `value` as numbers are held in Settings.
struct SetParameter {
  std::size_t pane = 0;
  std::string key;
  double value = 0;
};
struct ResetParameters {
  std::size_t pane = 0;
};
/// All of them, in their order.
struct SetStages {
  std::size_t pane = 0;
  std::vector<StageChoice> stages;
};
struct SetRobot {
  RobotSetup robot;
};
/// `file` is where it came from, empty for a new world. The other two are for work that is taken up again
/// after a crash: how many edits of it are not in the file, and how many of its surprises were there before
/// them (else all were).
struct ReplaceScenario {
  Scenario scenario;
  std::string file;
  std::size_t unsaved_edits = 0;
  std::optional<std::size_t> scripted = {};
};
struct Undo {};
struct Redo {};
/// How many of the edits in Session::history() shall have been made.
struct GoToHistory {
  std::size_t position = 0;
};
struct Restart {};
/// 1 forwards, -1 backwards, 0 pause.
struct Play {
  int direction = 1;
};
/// Expansions per second; at or above Session::kFullSpeed as fast as possible.
struct SetSpeed {
  double expansions_per_second = 240;
};
/// `count` steps, backwards if negative.
struct Step {
  StepUnit unit = StepUnit::expansion;
  int count = 1;
};
/// `travel`: how much of its last step the robot has made there, 0 to 1, for views that draw it on its way.
struct Seek {
  std::size_t position = 0;
  double travel = 1;
};
/// The transport shows this pane's run from now on, and the others follow its cursor.
struct Lead {
  std::size_t pane = 0;
};
/// How the other panes follow the leading one.
struct SetLockstep {
  Lockstep by = Lockstep::expansions;
};
/// From 1 to 4. Further planners are added at the end, others than those that are there already: those that went
/// before, then new ones. The last ones go first. The runs that stay are kept as they are.
struct SetPanes {
  std::size_t count = 2;
};
struct AddBreakpoint {
  std::string condition;
};
struct SwitchBreakpoint {
  std::size_t index = 0;
  bool enabled = true;
};
struct RemoveBreakpoint {
  std::size_t index = 0;
};
/// 1: the next one, running the mission on as far as needed; -1: the previous one.
struct GoToBreakpoint {
  int direction = 1;
};
/// To behind the next event of the leading run that changes the value (1), or to behind the latest one before
/// the cursor (-1). `node` is the Scalar for EventKind::scalar.
struct GoToChange {
  EventKind kind = EventKind::rhs;
  NodeId node = kNoNode;
  int direction = -1;
};
struct AddWatch {
  std::string expression;
};
struct RemoveWatch {
  std::size_t index = 0;
};
struct SetChecks {
  bool laws = false;
  bool oracle = false;
};
/// Runs both panes as far as they are alike and goes to where they differ first.
struct FindDifference {
  std::array<std::size_t, 2> panes{0, 1};
  Compare what = Compare::expansions;
};
/// Runs the mission on until the leading run's log has so many events, or it is over; the cursor goes along.
struct RunTo {
  std::size_t events = 0;
};
struct RunToEnd {};
/// What was planned until then stays; steps, play and RunToEnd take it up again.
struct Cancel {};

using Command = std::variant<std::monostate
#define REPLAN_COMMAND(NAME) , NAME
#include "core/session/commands.def"
#undef REPLAN_COMMAND
                             >;

}  // namespace replan
