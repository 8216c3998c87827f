// What the debugger's actions do.
#include <algorithm>

#include "ui/shell/actions.hpp"
#include "ui/shell/conditions.hpp"
#include "ui/tabs/debug.hpp"

namespace replan::ui {
namespace {

std::optional<FirstBreach> breach_of(const Session& session, std::size_t pane) {
  const LawReport laws = session.checks().laws(pane);
  const OracleReport oracle = session.checks().oracle(pane);
  std::optional<FirstBreach> first;
  if (laws.first) first = FirstBreach{pane, laws.first->position, true};
  if (oracle.first && (!first || oracle.first->position < first->position))
    first = FirstBreach{pane, oracle.first->position, false};
  return first;
}

/// The value that tells most of a vertex: D* Lite's rhs, A*'s g.
EventKind main_value(const Session& session) {
  return session.run().info().values.lookahead() ? EventKind::rhs : EventKind::g;
}

}  // namespace

std::optional<FirstBreach> first_breach(const Session& session) {
  if (const auto first = breach_of(session, session.lead())) return first;
  for (std::size_t pane = 0; pane < session.runs().size(); ++pane)
    if (const auto first = breach_of(session, pane)) return first;
  return std::nullopt;
}

std::optional<Cell> ActionContext::cell() const {
  const std::optional<Cell>& chosen = view.view.pinned ? view.view.pinned : view.view.hovered;
  return chosen && session.scenario().map.contains(*chosen) ? chosen : std::nullopt;
}

void ActionContext::go_to_breakpoint(int direction) {
  if (session.breakpoints().list().empty())
    action(ActionId::show_debug).effect(*this);  // where one is set
  else
    push(GoToBreakpoint{direction});
}

void ActionContext::break_on_cell() {
  if (const auto at = cell()) push(toggle_breakpoint(session, when_taken(*at, session.run().lattice())));
}

void ActionContext::watch_cell() {
  if (const auto at = cell())
    push(toggle_watch(session, value_expression(main_value(session), *at, session.run().lattice())));
}

void ActionContext::go_to_change(int direction) {
  if (const auto at = cell())
    push(GoToChange{main_value(session), session.run().lattice().node(*at), direction});
}

void ActionContext::open_cell_menu() {
  view.menu = cell();
}

void ActionContext::switch_checks(bool laws, bool oracle) {
  const bool laws_on = session.checks().laws(session.lead()).on;
  const bool oracle_on = session.checks().oracle(session.lead()).on;
  push(SetChecks{laws_on != laws, oracle_on != oracle});
}

void ActionContext::go_to_breach() {
  const auto first = first_breach(session);
  if (!first) return;
  if (first->pane != session.lead()) push(Lead{first->pane});
  push(Seek{first->position});
  action(ActionId::show_debug).effect(*this);
}

void ActionContext::find_difference() {
  action(ActionId::show_debug).effect(*this);
  push(panels.tabs.get<DebugTab>().find_difference(session));
}

}  // namespace replan::ui
