// How a best-first search orders its open list, declared once for the search and for all that checks it.
#pragma once

#include <functional>
#include <type_traits>

#include "core/base/cost.hpp"
#include "core/plan/parameters.hpp"

namespace replan {

/// f of a vertex, made of its g and its estimate h, and of the weight that the log holds for a search that works
/// one out for each plan (Scalar::weight). Among equal f the larger g comes first, then the smaller index, so that
/// the log need not hold more of a key than f.
struct KeyRule {
  using F = std::function<Cost(Cost g, Cost h, Cost weight)>;

  const char* law = nullptr;                   ///< as a sentence: "a key in the list is g + h"
  F (*f)(const Settings& settings) = nullptr;  ///< under these settings
  bool once = false;  ///< a vertex that was taken is never opened again, be there a shorter way to it
};

/// f by such a class.
template <class F>
constexpr Cost made_by(const F& f, Cost g, Cost h, Cost weight) {
  if constexpr (std::is_invocable_v<const F&, Cost, Cost, Cost>)
    return f(g, h, weight);
  else
    return f(g, h);
}

/// Whether a class says `kOnce`: KeyRule::once.
template <class F>
constexpr bool takes_once() {
  if constexpr (requires { F::kOnce; })
    return F::kOnce;
  else
    return false;
}

/// The rule of a class that is built from settings, called with g and h, and with the weight if it takes one, and
/// says its law in `kLaw`.
template <class F>
constexpr KeyRule key_rule() {
  return {F::kLaw,
          [](const Settings& settings) -> KeyRule::F {
            return [f = F(settings)](Cost g, Cost h, Cost weight) { return made_by(f, g, h, weight); };
          },
          takes_once<F>()};
}

/// `times` the estimate, rounded down: a weight is a number of 2^-30, as costs are. Saturates at infinity.
constexpr Cost weighted(Cost h, Cost times) {
  __extension__ using Wide = __int128;
  const Wide product = static_cast<Wide>(h.raw) * times.raw >> 30;
  return {product < Cost::kInfinityRaw ? static_cast<std::int64_t>(product) : Cost::kInfinityRaw};
}

/// That of A*.
struct GPlusH {
  static constexpr const char* kLaw = "a key in the list is g + h";
  explicit GPlusH(const Settings&) {}
  Cost operator()(Cost g, Cost h) const { return g + h; }
};

}  // namespace replan
