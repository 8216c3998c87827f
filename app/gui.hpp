// The window as a program: what happens from start to close.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/world/scenario.hpp"

namespace replan::app {

/// Opens the window on `file` (a scenario, a map or a picture), else on the demo world, and returns when it
/// is closed. A file that cannot be read is an error before any window opens. `in_step`: works in step with its frames,
/// as it does where there are no threads; films alone have threads of their own.
///
/// Environment, for tests and measurements: REPLAN_TIMING=1 prints the time to the first frame, and of
/// each that comes late what it took and what was asked for;
/// REPLAN_STATE_DUMP=FILE writes facts of the session as JSON when the window closes.
Result<void> run_window(const std::optional<std::string>& file, bool in_step);
/// The same on a world that is in no file: saving asks for a name.
Result<void> run_window(Scenario world);

}  // namespace replan::app
