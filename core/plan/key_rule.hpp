// How a best-first search orders its open list, declared once for the search and for all that checks it.
#pragma once

#include <functional>

#include "core/base/cost.hpp"
#include "core/plan/parameters.hpp"

namespace replan {

/// f of a vertex, made of its g and its estimate h. Among equal f the larger g comes first, then the smaller
/// index, so that the log need not hold more of a key than f.
struct KeyRule {
  using F = std::function<Cost(Cost g, Cost h)>;

  const char* law = nullptr;                   ///< as a sentence: "a key in the list is g + h"
  F (*f)(const Settings& settings) = nullptr;  ///< under these settings
};

/// The rule of a class that is built from settings, called with g and h, and says its law in `kLaw`.
template <class F>
constexpr KeyRule key_rule() {
  return {F::kLaw, [](const Settings& settings) -> KeyRule::F { return F(settings); }};
}

/// That of A*.
struct GPlusH {
  static constexpr const char* kLaw = "a key in the list is g + h";
  explicit GPlusH(const Settings&) {}
  Cost operator()(Cost g, Cost h) const { return g + h; }
};

}  // namespace replan
