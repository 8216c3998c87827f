// `replan run --trace FILE`: the runs' event logs for other programs.
#pragma once

#include <string>

#include "core/base/result.hpp"
#include "core/world/scenario.hpp"

namespace CLI {
class App;
}

namespace replan::cli {

struct TraceArguments {
  std::string file;
  std::string map;

  void declare(CLI::App& command);
  [[nodiscard]] bool given() const { return !file.empty() || !map.empty(); }
  /// Whether the files can be of the kinds that their names ask for, in such a world: before anything is run.
  [[nodiscard]] Result<void> check(const Box& world) const;
  /// Runs each of the scenario's planners once more, recording, and writes what was asked for: the whole
  /// mission, or the first plan alone.
  [[nodiscard]] Result<void> write(const Scenario& scenario, bool plan_alone) const;
};

/// FILE where there is one planner; else with the planner's id, and where an id comes more than once its
/// number too, before the ending: "run.astar.trace.yaml", "run.astar#2.trace.yaml".
std::string trace_name(const std::string& file, const Scenario& scenario, std::size_t planner);

}  // namespace replan::cli
