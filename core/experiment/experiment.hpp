// An experiment of a user's own: planners x robots x worlds x surprises x seeds, as a file says it (JSON, `"format": "replan
// experiment"`, `"version": 1`; docs/batches.md has all its keys). Nothing is read here but that file and the names of those
// it asks for; core/experiment/run_list.hpp loads the worlds and numbers the runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/plan/planner_choice.hpp"
#include "core/world/map_reading.hpp"
#include "core/world/robot.hpp"

namespace replan {

/// One file with a world in it: a scenario (.json), problems on a map (.scen, .3dscen), or a map of any other format, or
/// of a generator ("generator:rooms?seed=3").
struct ExperimentWorld {
  std::string file;         ///< relative to the experiment's folder
  std::string map = {};     ///< of problems: their map, relative to that folder; empty: the one beside them
  MapReading reading = {};  ///< how the map is read
  std::size_t limit = 0;    ///< of problems: so many, spread evenly over the file; 0: all
  std::optional<std::vector<int>> start = {}, goal = {};  ///< of a map: coordinates of cells
  friend bool operator==(const ExperimentWorld&, const ExperimentWorld&) = default;
};

/// Blocks that nobody has mapped, dropped one by one ahead of the robot, on a shortest way from start to goal. Which, the
/// seed says; they are the same for every planner.
struct RandomBlocks {
  int count = 1;
  int side = 3;      ///< cells, of a square or in space of a cube
  double ahead = 6;  ///< cells between the robot and the block's middle when it drops
  friend bool operator==(const RandomBlocks&, const RandomBlocks&) = default;
};
inline constexpr int kMostBlocks = 1000, kLongestBlock = 64;
/// How much farther ahead than its side is long a block drops at least: so it never covers the robot.
inline constexpr int kBlockMargin = 2;

/// What happens while a robot drives.
struct ExperimentSurprises {
  enum class Kind : std::uint8_t {
    none,   ///< nothing
    own,    ///< what the scenario has: surprises and moving obstacles
    blocks  ///< RandomBlocks
  };
  Kind kind = Kind::own;
  RandomBlocks blocks = {};
  friend bool operator==(const ExperimentSurprises&, const ExperimentSurprises&) = default;
};

struct Experiment {
  std::string name;
  std::vector<PlannerChoice> planners;  ///< swept settings written out, one after the other
  std::vector<std::optional<RobotSetup>> robots{
      std::nullopt};                    ///< nothing: the scenario's own, or the usual one
  std::vector<ExperimentWorld> worlds;  ///< patterns written out, in the order of their names
  std::vector<ExperimentSurprises> surprises{ExperimentSurprises{}};
  std::vector<std::uint64_t> seeds{1};
  bool drive = false;  ///< the robot drives; else it is planned once. Pilots drive in any case
  int repeat = 1;      ///< how often each run is timed
  std::optional<double>
      seconds;  ///< that a planner has which becomes better with time; results then do not repeat

  std::string folder = ".";  ///< what its files are relative to; no part of it
  /// Whether the same experiment gives the same results everywhere.
  [[nodiscard]] bool repeats() const { return !seconds; }
};

/// The most of each that an experiment may ask for, and the most runs in all.
inline constexpr std::size_t kMostPlanned = 10'000;
inline constexpr std::int64_t kMostRuns = 1'000'000'000;

/// Reads an experiment. Errors name the file, the place in it and the mend; an unknown key is an error that suggests the
/// nearest known one.
Result<Experiment> read_experiment(const std::string& path);
/// As read_experiment() from text; `origin` names it in errors, files are looked for in `folder`.
Result<Experiment> parse_experiment(const std::string& text, const std::string& origin,
                                    const std::string& folder);
/// The experiment with everything written out, as text that parse_experiment() reads back to an equal one where the same
/// files are.
std::string experiment_text(const Experiment& experiment);
/// The folder and the file, as a path.
std::string path_in(const Experiment& experiment, const std::string& file);

/// How results name a planner's settings, its stages, a robot and what happens: "weight=1.5", "bspline degree=3",
/// "radius=1.5", "3 blocks of 2"; empty where there is nothing that is not usual. They tell apart what is not equal.
std::string settings_label(const PlannerChoice& choice);
std::string stages_label(const PlannerChoice& choice);
std::string robot_label(const std::optional<RobotSetup>& robot);
std::string surprises_label(const ExperimentSurprises& surprises);

}  // namespace replan
