// `replan run --break`: where the runs of a world come to stop.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/world/scenario.hpp"

namespace CLI {
class App;
}

namespace replan::cli {

/// `--break`, as typed.
struct BreakArguments {
  std::vector<std::string> conditions;

  void declare(CLI::App& command);
  [[nodiscard]] bool given() const { return !conditions.empty(); }
  /// Runs each planner of the world to the first place where each of the conditions stops, and prints where
  /// these are, as a table or as JSON. With `only_plan` the robot does not set out. Returns kDone if every run
  /// stopped at one at least, else kFailed.
  [[nodiscard]] Result<int> run(const Scenario& world, bool only_plan, bool json) const;
};

/// The names of the condition language, for the end of the command's help.
std::string conditions_help();

}  // namespace replan::cli
