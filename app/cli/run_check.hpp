// `replan run --check`: each planner held to its own laws and to the oracle.
#pragma once

#include "core/base/result.hpp"
#include "core/world/scenario.hpp"

namespace replan::cli {

/// Runs the scenario with each of its planners to the end, holds the log against the planner's laws and every
/// plan against a plain Dijkstra, and prints the verdicts, as text or JSON. The exit code: kFailed if any law
/// is broken or any plan costs what it should not.
Result<int> check_runs(const Scenario& scenario, bool json);

}  // namespace replan::cli
