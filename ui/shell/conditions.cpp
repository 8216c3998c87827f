#include "ui/shell/conditions.hpp"

#include <algorithm>

#include "core/debug/condition.hpp"

namespace replan::ui {
namespace {

const char* name_of(EventKind kind) {
  switch (kind) {
    case EventKind::g:
      return "g";
    case EventKind::rhs:
      return "rhs";
    case EventKind::dist:
      return "dist";
    case EventKind::queue:
      return "k1";
    case EventKind::lp:
      return "lp";
    case EventKind::rp:
      return "rp";
    case EventKind::visit:
      return "times";
    case EventKind::known:
      return "known";
    default:
      return "";
  }
}

std::optional<std::size_t> find_watch(const Session& session, const std::string& expression) {
  const auto list = session.watches().list();
  const auto found = std::find(list.begin(), list.end(), expression);
  if (found == list.end()) return std::nullopt;
  return static_cast<std::size_t>(found - list.begin());
}

}  // namespace

std::string value_expression(EventKind kind, Cell cell, const Box& world) {
  const std::string name = name_of(kind);
  return name.empty() ? "" : name + cell_text(cell, world);
}

std::string when_changed(EventKind kind, Cell cell, const Box& world) {
  const std::string value = value_expression(kind, cell, world);
  return value.empty() ? "" : "changed(" + value + ")";
}

std::string when_taken(Cell cell, const Box& world) {
  return "taken" + cell_text(cell, world);
}

std::string when_line(int number) {
  return "line(" + std::to_string(number) + ")";
}

std::string language_error(const Session& session, const std::string& text, bool quantity) {
  const Box world = session.scenario().map.box();
  const Result<Condition> read = quantity ? parse_quantity(text, world) : parse_condition(text, world);
  return read ? "" : read.error();
}

std::vector<LanguageWord> language_words(bool quantities) {
  std::vector<LanguageWord> words;
  for (const ConditionName& name : condition_names())
    if (!quantities || name.type == ValueType::number) words.push_back({name.form, name.help});
  if (quantities) return words;
  // event(name) stands for all of these, with its own help.
  for (const HappeningName& happening : happening_names()) words.push_back({happening.name, happening.help});
  return words;
}

std::optional<std::size_t> find_breakpoint(const Session& session, const std::string& condition) {
  const auto list = session.breakpoints().list();
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Breakpoint& b) { return b.condition == condition; });
  if (found == list.end()) return std::nullopt;
  return static_cast<std::size_t>(found - list.begin());
}

Command toggle_breakpoint(const Session& session, const std::string& condition) {
  if (const auto set = find_breakpoint(session, condition)) return RemoveBreakpoint{*set};
  return AddBreakpoint{condition};
}

bool is_watched(const Session& session, const std::string& expression) {
  return find_watch(session, expression).has_value();
}

Command toggle_watch(const Session& session, const std::string& expression) {
  if (const auto watched = find_watch(session, expression)) return RemoveWatch{*watched};
  return AddWatch{expression};
}

}  // namespace replan::ui
