// The robot of a scenario, and the kinds of robots there are. Menus, settings, scenario files and help are made from
// robots/robots.def; nothing else names a kind.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/lattice/box.hpp"
#include "core/plan/parameters.hpp"

namespace replan {

/// What the robot knows of the world before it has seen anything.
enum class Knowledge : std::uint8_t {
  all,      ///< every change of the world at once, wherever it happens
  map,      ///< the map as it is at the start; surprises only when sensed
  nothing,  ///< an empty map; every obstacle only when sensed
};

/// How long a step takes.
enum class Motion : std::uint8_t {
  steps,   ///< every step takes 1 / speed seconds, straight or diagonal
  smooth,  ///< at a steady speed along the plan: a step takes as long as its way
};

/// What the robot does where its goal is an obstacle or cannot be reached.
enum class UnreachableGoal : std::uint8_t {
  wait,     ///< waits for a way to open
  nearest,  ///< goes to the reachable cell nearest to the goal, and on to the goal once a way opens
};

/// A kind of robot: how it moves. What can be said of it without driving it.
struct RobotInfo {
  std::string_view id = {};       ///< as in scenario files: "cells"
  std::string_view name = {};     ///< as in the window
  std::string_view summary = {};  ///< one sentence
  std::vector<Parameter> parameters = {};
  bool planar = false;  ///< it drives in a plane: in worlds of one layer alone
  bool drives = false;  ///< along arcs that it chooses by the dynamic window approach, not from cell to cell
  /// The parameter that says which way it looks when it sets out, in degrees from the right, upwards; none: towards its
  /// goal.
  std::string_view heading = {};
  bool own_pace = false;  ///< how long a step takes it works out itself: RobotSetup::motion says nothing to it
};

/// All kinds, in the order of robots.def. The first is the usual one.
std::span<const RobotInfo> robots();
/// The kind of that id, or nullptr.
const RobotInfo* find_robot(std::string_view id);
/// As find_robot(), with an error that suggests the nearest id.
Result<const RobotInfo*> require_robot(std::string_view id);
/// As require_robot(), of one that can drive in such a world.
Result<const RobotInfo*> require_robot(std::string_view id, const Box& world);

/// The robot and its sensor.
struct RobotSetup {
  Knowledge knowledge = Knowledge::map;
  double sensor_radius = 6;     ///< cells, centre to centre; the cells around the robot are always felt
  bool sensor_blocked = false;  ///< obstacles hide what is behind them
  double sensor_angle =
      360;  ///< degrees, the sensor's whole opening angle about the robot's course; 360: all round
  Motion motion = Motion::steps;
  double speed = 4;      ///< cells per second
  double patience = 60;  ///< seconds that it waits for obstacles to move out of its way before it gives up
  UnreachableGoal unreachable_goal = UnreachableGoal::wait;
  bool robot_cell_blocks = false;  ///< an obstacle that comes onto the robot's own cell keeps it there
  double radius = 0;               ///< of its body, in cells, up to MoveRules::kMostRadius; 0: a point
  std::string kind = "cells";      ///< a registry id: how it moves
  Settings settings = {};          ///< of its kind, those that differ from its defaults
  friend bool operator==(const RobotSetup&, const RobotSetup&) = default;
};

}  // namespace replan
