// Where a state stands in the waves of a search like D*, by its tag, k and h.
#pragma once

#include "core/trace/field.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

enum class Wave : std::uint8_t {
  fresh,   ///< NEW: the search has not come there
  raise,   ///< OPEN, its cost above what it was: it looks for a better way, and tells those that rely on it
  lower,   ///< OPEN, its cost as low as it was since it waits: it offers that to its neighbours
  closed,  ///< CLOSED: it has told its neighbours
};

/// Of a run whose planner has such values (SearchValues::waves).
inline Wave wave_of(const SearchState& state, NodeId node) {
  const auto tag = static_cast<fields::StateTag>(state.value(fields::kTag.kind, node));
  if (tag == fields::StateTag::fresh) return Wave::fresh;
  if (tag == fields::StateTag::closed) return Wave::closed;
  const Cost dist = state.dist(node).is_infinite() ? Cost::zero() : state.dist(node);
  const Cost k{static_cast<std::int64_t>(state.value(fields::kLowest.kind, node))};
  return k < state.g(node) + dist ? Wave::raise : Wave::lower;
}

/// "RAISE"
inline const char* wave_name(Wave wave) {
  constexpr const char* kNames[] = {"NEW", "RAISE", "LOWER", "CLOSED"};
  return kNames[static_cast<std::size_t>(wave)];
}

}  // namespace replan
