// What the session holds its planners to, and where two of them part.
#include "core/base/words.hpp"
#include "core/session/session.hpp"

namespace replan {

Result<void> Session::run_command(const SetChecks& command) {
  if (command.laws && box().node_count() > checks_.most_cells_)
    return Error{"the laws are not checked in worlds of more than " + counted(checks_.most_cells_, "cell") +
                 " while somebody watches: 'replan run --check' holds a whole run to them"};
  checks_.set(command.laws, command.oracle);
  return {};
}

Result<void> Session::run_command(const FindDifference& command) {
  for (const std::size_t pane : command.panes)
    if (pane >= runs_.size()) return Error{"there is no pane " + std::to_string(pane + 1) + " to compare"};
  if (command.panes[0] == command.panes[1])
    return Error{"a run does not differ from itself: choose two panes"};
  player_.stop();
  if (checks_.compare(runs_, command.panes, command.what)) {
    for (const std::size_t pane : command.panes) runs_[pane]->go(Target::end());
  } else {
    show_difference();
  }
  return {};
}

// Each of the two stands where it differs, which need not be in lockstep, until the next seek.
void Session::show_difference() {
  if (!checks_.comparison().empty()) say(checks_.comparison());
  const std::optional<Difference>& found = checks_.difference();
  if (!found) return;
  const auto& panes = found->panes;
  for (const std::size_t pane : panes) runs_[pane]->cancel();
  if (lead_ != panes[0] && lead_ != panes[1]) lead_ = panes[0];
  follow_ = false;
  seek(found->positions[lead_ == panes[0] ? 0 : 1]);
  for (std::size_t i = 0; i < panes.size(); ++i) runs_[panes[i]]->timeline().seek(found->positions[i]);
  catching_up_ = false;  // or the other one would go on to its place in lockstep
}

bool Session::check() {
  bool changed = checks_.update(runs_);
  if (checks_.comparing() && (checks_.compare_on(runs_) || !checks_.comparing())) {
    show_difference();
    changed = true;
  }
  return changed;
}

}  // namespace replan
