// The session's debugger: what its commands do to breakpoints, watches and checks.
#include "core/session/session.hpp"

namespace replan {

Result<void> Session::run_command(const AddBreakpoint&) {
  return Error{"not built yet"};
}
Result<void> Session::run_command(const SwitchBreakpoint&) {
  return Error{"not built yet"};
}
Result<void> Session::run_command(const RemoveBreakpoint&) {
  return Error{"not built yet"};
}
Result<void> Session::run_command(const GoToBreakpoint&) {
  return Error{"not built yet"};
}
Result<void> Session::run_command(const GoToChange&) {
  return Error{"not built yet"};
}
Result<void> Session::run_command(const AddWatch&) {
  return Error{"not built yet"};
}
Result<void> Session::run_command(const RemoveWatch&) {
  return Error{"not built yet"};
}

}  // namespace replan
