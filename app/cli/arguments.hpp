// What several commands are told in the same words: a world, planners, settings.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/link/link.hpp"
#include "core/world/scenario.hpp"

namespace CLI {
class App;
}

namespace replan::cli {

/// `--planner`, `--set` and `--stage`, as typed.
struct PlannerArguments {
  std::vector<std::string> ids;
  std::vector<std::string> settings;
  std::vector<std::string> stages;

  void declare(CLI::App& command);
  /// The planners asked for, in that order; those of `own` (a scenario's) if none is asked for. A planner
  /// keeps the settings and stages that it has in `own`; `--set` changes them, `--stage` adds to them. With a world
  /// an error if one cannot plan there for a robot of that radius, in cells.
  [[nodiscard]] Result<std::vector<PlannerChoice>> choose(std::span<const PlannerChoice> own = {},
                                                          const GridMap* world = nullptr,
                                                          double radius = 0) const;
};

/// `--threshold`, `--invert`, `--unknown`, `--occupied`, and of heights `--height-map`, `--layers`, `--heights` and
/// `--reduce`: how a map file is read, as typed.
struct ReadingArguments {
  std::string threshold;
  bool invert = false;
  std::string unknown;
  std::string occupied;
  bool height_map = false;
  std::string layers;
  std::string heights;
  std::string reduce;

  void declare(CLI::App& command);
  /// For a map file of that name.
  [[nodiscard]] Result<MapReading> reading(const std::string& file) const;
  [[nodiscard]] bool given() const {
    return invert || !threshold.empty() || !unknown.empty() || !occupied.empty() || of_heights();
  }
  /// An error if any of them is given for what is no map file: a scenario, or a generator.
  [[nodiscard]] Result<void> check_unused_by(const std::string& source) const;

 private:
  [[nodiscard]] bool of_heights() const {
    return height_map || !layers.empty() || !heights.empty() || !reduce.empty();
  }
  [[nodiscard]] Result<std::optional<double>> occupied_number() const;
  [[nodiscard]] Result<HeightReading> height_reading() const;
};

/// A scenario, or a map with `--start` and `--goal`, as typed.
struct WorldArguments {
  std::string scenario;
  std::string map;
  std::string start;
  std::string goal;
  std::string unreachable_goal;
  std::string robot;
  std::string radius;
  ReadingArguments reading;
  PlannerArguments planners;

  void declare(CLI::App& command);
  /// The map of `--map`, a file or a generator, with the start and goal that are given, or else those of its
  /// file.
  [[nodiscard]] Result<MapFile> load_map() const;
  /// The world and its planners. With `--map` the scenario has no surprises, and its robot knows the map.
  [[nodiscard]] Result<Scenario> load() const;
  /// How a summary names it: the file.
  [[nodiscard]] std::string source() const {
    return is_link() ? "the link" : scenario.empty() ? map : scenario;
  }
  /// Whether the scenario is a link (core/link/link.hpp) and no file.
  [[nodiscard]] bool is_link() const { return replan::is_link(scenario); }
};

/// "X,Y with x from 0 to 39, y from 0 to 29": how a cell of the world is typed.
std::string cell_wanted(const Box& world);
/// Reads "X,Y", or "X,Y,Z" if the world is `solid`: has more than one layer. `option` names it in errors.
Result<Cell> parse_cell(std::string_view option, std::string_view text, bool solid);
/// As parse_cell(), or of a place in metres of the map's own frame ("1.5m,2m") the cell that it lies in. It must lie on
/// the map, which errors call `where`: "the map arena.map".
Result<Cell> parse_cell_in(const GridMap& map, std::string_view option, std::string_view text,
                           const std::string& where);
/// The metres of "0.3m"; nothing of another text.
std::optional<double> typed_metres(std::string_view typed);
/// So many metres in cells of the map, if that says how large they are; `what` begins the error.
Result<double> metres_in_cells(std::string_view what, double metres, const GridMap& map);
/// Reads a whole number of at least `low`.
Result<std::int64_t> parse_count(std::string_view option, std::string_view text, std::int64_t low);
/// The parts of "a,b,c", empty ones left out.
std::vector<std::string> split_list(std::span<const std::string> texts);
/// "; did you mean 'NAME'?", or `otherwise` if nothing is near.
std::string suggestion(std::string_view name, std::span<const std::string_view> names,
                       std::string_view otherwise);

/// Every planner's settings, for the end of a command's help.
std::string settings_help();

}  // namespace replan::cli
