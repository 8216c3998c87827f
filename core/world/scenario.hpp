// A scenario: everything that a run depends on. The same scenario gives the same events on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/plan/parameters.hpp"
#include "core/world/grid_map.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

/// What the robot knows of the world before it has seen anything.
enum class Knowledge : std::uint8_t {
  all,      ///< every change of the world at once, wherever it happens
  map,      ///< the map as it is at the start; surprises only when sensed
  nothing,  ///< an empty map; every obstacle only when sensed
};

/// The robot and its sensor.
struct RobotSetup {
  Knowledge knowledge = Knowledge::map;
  double sensor_radius = 6;     ///< cells, centre to centre; the 8 cells around the robot are always felt
  bool sensor_blocked = false;  ///< obstacles hide what is behind them
  friend bool operator==(const RobotSetup&, const RobotSetup&) = default;
};

/// When a scripted change happens. Exactly one of the two is set. Of several changes that are due at once the
/// first in the list happens first, and the next one once the plan stands again.
struct Trigger {
  std::optional<std::int64_t>
      move;                  ///< after that many steps of the robot: moves, and waits while there is no path
  std::optional<Cell> near;  ///< when the robot is within `within` cells (centre to centre) of it
  double within = 0;
  friend bool operator==(const Trigger&, const Trigger&) = default;
};

/// Cells that appear or disappear while the run goes on.
struct Surprise {
  Trigger at;
  std::vector<CellChange> cells;  ///< row-major, each cell once
  bool announced = false;         ///< the robot is told at once; else it has to see it
  friend bool operator==(const Surprise&, const Surprise&) = default;
};

/// A planner by its registry id, with the settings that differ from its defaults.
struct PlannerChoice {
  std::string id;
  Settings settings;
  friend bool operator==(const PlannerChoice&, const PlannerChoice&) = default;
};

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

struct Scenario {
  std::string name;
  std::string caption;
  GridMap map;
  std::string map_file;    ///< as written in the file, relative to it; empty = the map is held inline
  MapReading map_reading;  ///< how that file is read
  Cell start;
  Cell goal;
  std::vector<PlannerChoice> planners;  ///< at least one
  RobotSetup robot;
  std::vector<Surprise> surprises;
  ViewSetup view;
  std::uint64_t seed = 1;
  friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// Reads a scenario (JSON, `"replan": 1`; the schema is assets/scenario.schema.json). A map file is looked
/// for beside the scenario. Errors name the file, the place in it and the mend; an unknown key is an error
/// that suggests the nearest known one.
Result<Scenario> read_scenario(const std::string& path);
/// As read_scenario() from text; `origin` names it in errors, map files are looked for in `folder`.
Result<Scenario> parse_scenario(const std::string& text, const std::string& origin,
                                const std::string& folder);
/// The scenario as JSON text that parse_scenario() reads back to an equal one.
std::string scenario_text(const Scenario& scenario);
/// Writes the scenario (and not its map file) atomically.
Result<void> write_scenario(const Scenario& scenario, const std::string& path);

}  // namespace replan
