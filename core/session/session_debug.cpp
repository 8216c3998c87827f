// The session's debugger: what its commands do to breakpoints, watches, checks and panes.
#include "core/session/session.hpp"

namespace replan {

Result<void> Session::run_command(const SetLockstep& command) {
  lockstep_ = command.by;
  return {};
}

Result<void> Session::run_command(const SetPanes&) {
  return Error{"not built yet"};
}
}  // namespace replan
