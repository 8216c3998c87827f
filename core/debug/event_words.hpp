// Events and the values that they write, in words: one spelling for the window, the command line and exports.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/cost.hpp"
#include "core/debug/log_view.hpp"
#include "core/plan/pages.hpp"

namespace replan {

/// What a value of a node is called in sentences: "rhs", "k1", "the robot's map", ...
std::string value_name(const Field& field);
/// The same for a value of the whole run: "km", "the robot", ...
const char* value_name(Scalar scalar);

/// With that many decimals; "∞".
std::string decimal_text(double number, int decimals);
/// "41.213", "∞".
std::string cost_text(Cost cost, int decimals = 3);
/// "(31, 18)", or "none" for kNoNode.
std::string node_text(const Box& lattice, NodeId node);

/// A value of a node as events hold it: "41.213", "not in U", "(31, 18)", "obstacle".
std::string value_text(const Box& lattice, const Field& field, std::uint64_t raw);
/// A value of the whole run as events hold it.
std::string scalar_text(const Box& lattice, Scalar scalar, std::uint64_t raw);

/// What an event did, as a sentence: "rhs(31, 18): 41.213 → 43.799". `after` is the raw value that it wrote,
/// SearchState::value() behind it; ignored for events that write none. `values` are those of the planner.
std::string event_text(const Box& lattice, const SearchValues& values, const Event& event,
                       std::uint64_t after);
/// The same of the event before a position of a log; empty for position 0. Takes a state_at(): not for many
/// positions in a row.
std::string event_text(const LogView& view, std::size_t position);

/// "line 48", or "line 12 of Algorithm 1: main" where the page has several algorithms; `number` as events
/// hold it. "line 212" if the page does not have it.
std::string line_name(const PlannerPage& page, int number);

}  // namespace replan
