// The commands of commands.def, as plain data.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/session/stepping.hpp"
#include "core/world/scenario.hpp"

namespace replan {

/// Cells and their new values. Strokes with the same nonzero number are taken back together.
struct PaintCells {
  std::vector<CellChange> cells;
  std::uint64_t stroke = 0;
};
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
struct Seek {
  std::size_t position = 0;
};
struct RunToEnd {};
/// What was planned until then stays; steps, play and RunToEnd take it up again.
struct Cancel {};

using Command = std::variant<std::monostate
#define REPLAN_COMMAND(NAME, TEXT) , NAME
#include "core/session/commands.def"
#undef REPLAN_COMMAND
                             >;

/// What a command does, for menus and the log.
const char* command_text(const Command& command);

}  // namespace replan
