// The numbers of the trace formats.
#pragma once

#include <charconv>
#include <concepts>
#include <string>

#include "core/base/cost.hpp"

namespace replan {

void append_whole(std::string& out, std::integral auto number) {
  char digits[24];
  out.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

/// A finite cost in cells, with as many decimals as it takes, ten at most: the number times 2^30, rounded, is
/// the cost again. (A reader that holds numbers as doubles has it exactly up to 4 million cells.)
void append_cost(std::string& out, Cost cost);

}  // namespace replan
