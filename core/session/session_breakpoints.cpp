// Breakpoints and watches: commands, what becomes of them with the document, and where playing stops.
#include <algorithm>

#include "core/session/session.hpp"

namespace replan {

Result<void> Session::run_command(const AddBreakpoint& command) {
  if (auto added = breakpoints_.add(command.condition, box()); !added)
    return Error{"breakpoint '" + command.condition + "': " + added.error()};
  stop_hunt();
  return {};
}

Result<void> Session::run_command(const SwitchBreakpoint& command) {
  if (command.index >= breakpoints_.list().size()) return Error{"there is no such breakpoint"};
  breakpoints_.enable(command.index, command.enabled);
  stop_hunt();
  return {};
}

Result<void> Session::run_command(const RemoveBreakpoint& command) {
  if (command.index >= breakpoints_.list().size()) return Error{"there is no such breakpoint"};
  breakpoints_.remove(command.index);
  stop_hunt();
  return {};
}

Result<void> Session::run_command(const AddWatch& command) {
  if (auto added = watches_.add(command.expression, box()); !added)
    return Error{"watch '" + command.expression + "': " + added.error()};
  return {};
}

Result<void> Session::run_command(const RemoveWatch& command) {
  if (command.index >= watches_.list().size()) return Error{"there is no such watch"};
  watches_.remove(command.index);
  return {};
}

/// The first hit that playing from one position to another would pass.
std::optional<Hit> Session::stop_between(std::size_t from, std::size_t to) {
  if (from == to || !breakpoints_.wants_any()) return std::nullopt;
  const CheckedLog checked = checked_log();
  breakpoints_.look(run(), checked, 0);
  if (std::max(from, to) <= breakpoints_.looked_through()) {
    const Hit* hit = from < to ? breakpoints_.known_after(from) : breakpoints_.known_before(from);
    const bool passed = hit != nullptr && (from < to ? hit->position <= to : hit->position >= to);
    return passed ? std::optional(*hit) : std::nullopt;
  }
  StopSearch search = breakpoints_.search(run(), checked, from);
  if (from > to) return search.backwards(to, checked.verdicts());
  std::vector<Hit> hits;
  while (search.position() < to && hits.empty())
    search.forwards(std::min(to, search.position() + search.slice()), checked.verdicts(), hits);
  return hits.empty() ? std::nullopt : std::optional(hits.front());
}

/// How far playing may go: to where the checkers that a breakpoint asks have come.
std::size_t Session::may_play_to(std::size_t from, std::size_t to) const {
  return to <= from ? to : std::max(from, breakpoints_.can_look_to(checked_log(), to));
}

CheckedLog Session::checked_log() const {
  CheckedLog result;
  const LawReport laws = checks_.laws(lead_);
  const OracleReport oracle = checks_.oracle(lead_);
  result.laws_on = laws.on;
  result.oracle_on = oracle.on;
  for (const Breach& breach : checks_.breaches(lead_)) result.breaches.push_back(breach.position);
  for (const Disagreement& each : checks_.disagreements(lead_)) result.disagreements.push_back(each.position);
  if (laws.on) result.laws = laws.checked;
  if (!oracle.on) return result;
  std::size_t plans = 0;
  for (const Milestone& milestone : run().milestones())
    if (milestone.kind == EventKind::plan_end && plans++ == oracle.asked) {
      result.oracle = milestone.event;
      break;
    }
  return result;
}

Box Session::box() const {
  return scenario_->map.box();
}

/// Breakpoints and watches follow what has become of the document, the runs and the cursors.
bool Session::update_instruments() {
  const Box world = box();
  if (world != instruments_world_) {
    breakpoints_.read_again(world);
    watches_.read_again(world);
    instruments_world_ = world;
  }
  if (!breakpoints_.stopped().empty() &&
      (run().log_id() != stopped_log_ || run().timeline().cursor() != stopped_at_))
    breakpoints_.set_stopped("");
  return watches_.read_cursors(runs_);
}

DebugSetup Session::debug() const {
  return {{breakpoints_.list().begin(), breakpoints_.list().end()},
          {watches_.list().begin(), watches_.list().end()}};
}

void Session::take_debug(const DebugSetup& debug) {
  instruments_world_ = box();
  breakpoints_.set_list(debug.breakpoints, instruments_world_);
  watches_.set_list(debug.watches, instruments_world_);
  stop_hunt();
}

}  // namespace replan
