// What a D* search (dstar.hpp) remembers of a state, and what it orders states by.
#pragma once

#include <compare>
#include <cstdint>

#include "core/base/cost.hpp"
#include "core/trace/field.hpp"

namespace replan {

/// What D* remembers of a state.
struct DStarNode {
  Cost g = Cost::infinity();  // h(X)
  Cost k = Cost::infinity();
  std::uint32_t slot : 27 = 0;    // in OPEN
  std::uint32_t parent : 5 = 31;  // b(X), as a direction
  fields::StateTag tag = fields::StateTag::fresh;
};
static_assert(sizeof(DStarNode) == 24, "a large map has many of them");

/// <f(X), k(X)>, compared lexicographically: val in the papers.
struct FocusedCost {
  Cost f = Cost::infinity();
  Cost k = Cost::infinity();
  friend constexpr auto operator<=>(const FocusedCost&, const FocusedCost&) = default;
};
/// What OPEN is ordered by: f_B(X), then f(X), then k(X).
struct FocusedKey {
  Cost k1 = Cost::infinity();
  FocusedCost k2;
  friend constexpr auto operator<=>(const FocusedKey&, const FocusedKey&) = default;
};

}  // namespace replan
