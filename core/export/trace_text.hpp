// The words and numbers of the trace formats.
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

#include "core/base/cost.hpp"
#include "core/plan/search_values.hpp"
#include "core/trace/event.hpp"

namespace replan {

/// The fixed name of a kind in files: "rhs", "plan_begin". `values` are those of the planner.
std::string_view event_name(const SearchValues& values, EventKind kind);
/// The fixed name of a value of the run: "km", "robot".
std::string_view scalar_name(Scalar scalar);

/// The fixed name of why a sample was given up: "blocked".
std::string_view fault_name(SampleFault why);

void append_whole(std::string& out, std::integral auto number) {
  char digits[24];
  out.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

/// With as many digits as tell it from all other numbers.
void append_real(std::string& out, double number);

/// A finite cost in cells, with as many decimals as it takes, ten at most: the number times 2^30, rounded, is
/// the cost again. (A reader that holds numbers as doubles has it exactly up to 4 million cells.)
void append_cost(std::string& out, Cost cost);

}  // namespace replan
