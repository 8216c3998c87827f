// A scenario: everything that a run depends on. The same scenario gives the same events on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/plan/planner_choice.hpp"
#include "core/world/grid_map.hpp"
#include "core/world/map_reading.hpp"
#include "core/world/robot.hpp"

namespace replan {

/// What a moving obstacle does at the end of its way.
enum class WayEnd : std::uint8_t {
  back,  ///< goes back the way it came, and so on
  loop,  ///< goes straight to the way's beginning, and so on
  stop,  ///< stays there
};

/// A box of cells that moves along a drawn way. The robot knows of it only what its sensor sees. Walls do not
/// stop it; for the robot it waits.
struct MovingObstacle {
  std::vector<Cell>
      way;  ///< corners for its first cell, the upper left one, which goes in straight lines; at least one
  int width = 1;  ///< cells; what lies outside the world is not there
  int height = 1;
  int depth = 1;     ///< layers, from that of its first cell up
  double speed = 2;  ///< cells per second; a diagonal step takes as long as a straight one
  WayEnd at_end = WayEnd::back;
  std::int64_t from = 0;  ///< step of the robot at which it appears
  friend bool operator==(const MovingObstacle&, const MovingObstacle&) = default;
};

/// When a scripted change happens. Exactly one of the two is set. Of several changes that are due at once the
/// first in the list happens first, and the next one once the plan stands again.
struct Trigger {
  std::optional<std::int64_t>
      move;                  ///< after that many steps of the robot: moves, turns on the spot, and waits
  std::optional<Cell> near;  ///< when the robot is within `within` cells (centre to centre) of it
  double within = 0;
  friend bool operator==(const Trigger&, const Trigger&) = default;
};

/// What happens while the run goes on: cells appear or disappear, the goal or the robot is put elsewhere.
struct Surprise {
  Trigger at;
  std::vector<CellChange> cells;   ///< as in_node_order() has them, each cell once
  bool announced = false;          ///< the robot is told of the cells at once; else it has to see them
  std::optional<Cell> goal = {};   ///< where it has to go from now on: it plans afresh
  std::optional<Cell> robot = {};  ///< where somebody puts it down
  friend bool operator==(const Surprise&, const Surprise&) = default;
};

/// Surprises in the order of their list. Versions of a scenario share them.
using Surprises = SharedArray<Surprise, 32>;

/// What a view of the scenario shows when it is opened. Not part of the run.
struct ViewSetup {
  std::vector<std::string> overlays;  ///< ids as in core/scene/view.cpp
  std::optional<std::string> theme;   ///< "light" or "dark"
  struct Camera {
    double x = 0, y = 0;  ///< the cell coordinates in the middle of the view
    double zoom = 0;      ///< pixels per cell
    friend bool operator==(const Camera&, const Camera&) = default;
  };
  std::optional<Camera> camera;
  friend bool operator==(const ViewSetup&, const ViewSetup&) = default;
};

/// A place of the run that is worth stopping at, as a condition (core/debug/condition.hpp).
struct Breakpoint {
  std::string condition;
  bool enabled = true;
  friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

/// What is looked for in the run. Not part of it.
struct DebugSetup {
  std::vector<Breakpoint> breakpoints;
  std::vector<std::string> watches;  ///< expressions that are followed
  friend bool operator==(const DebugSetup&, const DebugSetup&) = default;
};

/// The most breakpoints and watches of a scenario.
inline constexpr std::size_t kMaxBreakpoints = 64, kMaxWatches = 16;
/// The most moving obstacles of a scenario, and the longest side of one.
inline constexpr std::size_t kMaxMovers = 100;
inline constexpr int kMaxMoverSide = 64;
/// Limits of a robot's and a moving obstacle's speed, in cells per second.
inline constexpr double kMinSpeed = 0.01, kMaxSpeed = 1000;

struct Scenario {
  std::string name;
  std::string caption;
  GridMap map;
  std::string map_file;    ///< as written in the file, relative to it; empty = the map is held inline
  MapReading map_reading;  ///< how that file is read
  MapFindings map_found;   ///< what was found then
  Cell start;
  Cell goal;
  std::vector<PlannerChoice> planners;  ///< at least one
  RobotSetup robot;
  Surprises surprises;
  std::vector<MovingObstacle> movers;
  ViewSetup view;
  DebugSetup debug;
  std::uint64_t seed = 1;
  friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// Reads a scenario (JSON, `"replan": 1`; the schema is assets/scenario.schema.json). A map file is looked
/// for beside the scenario. Errors name the file, the place in it and the mend; an unknown key is an error
/// that suggests the nearest known one.
Result<Scenario> read_scenario(const std::string& path);
/// For parse_scenario(): the text comes from elsewhere, and no file is read for it, whatever it names.
inline constexpr const char* kNoFolder = "//";
/// As read_scenario() from text; `origin` names it in errors, map files are looked for in `folder`.
Result<Scenario> parse_scenario(const std::string& text, const std::string& origin,
                                const std::string& folder);
/// The scenario as JSON text that parse_scenario() reads back to an equal one.
std::string scenario_text(const Scenario& scenario);
/// Writes the scenario (and not its map file) atomically.
Result<void> write_scenario(const Scenario& scenario, const std::string& path);

}  // namespace replan
