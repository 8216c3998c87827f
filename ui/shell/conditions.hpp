// The conditions and quantities that buttons and menus write, in the language of core/debug/condition.hpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/lattice/box_words.hpp"
#include "core/session/session.hpp"

namespace replan::ui {

/// "rhs(31, 18)", in a world of several layers with a third coordinate; empty for a kind that the language has no word for.
std::string value_expression(EventKind kind, Cell cell, const Box& world);
/// "changed(rhs(31, 18))"; empty likewise.
std::string when_changed(EventKind kind, Cell cell, const Box& world);
/// "taken(31, 18)".
std::string when_taken(Cell cell, const Box& world);
/// "line(48)"; the number as events hold it.
std::string when_line(int number);

/// What is wrong with a condition, or with a quantity: "character 1: 'g' needs a cell: g(x, y)". Empty if
/// nothing.
std::string language_error(const Session& session, const std::string& text, bool quantity);
/// A word of the language and what it means.
struct LanguageWord {
  std::string_view form;  ///< "g(x, y)"
  std::string_view help;  ///< one sentence
};
/// All words, or those that stand for a quantity.
std::vector<LanguageWord> language_words(bool quantities);

/// The breakpoint with that condition.
std::optional<std::size_t> find_breakpoint(const Session& session, const std::string& condition);
/// What sets the breakpoint, or removes it if it is set.
Command toggle_breakpoint(const Session& session, const std::string& condition);
/// What follows the quantity, or no longer does.
Command toggle_watch(const Session& session, const std::string& expression);
[[nodiscard]] bool is_watched(const Session& session, const std::string& expression);

}  // namespace replan::ui
