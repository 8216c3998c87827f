// How often and when each node was expanded, as the log tells of it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/trace/search_state.hpp"
#include "core/trace/tracer.hpp"

namespace replan {

/// The `visit` values of a search. Kept in recorded runs only; else it is nothing and costs nothing.
template <Tracer T>
class Visits {
 public:
  explicit Visits(std::size_t nodes) {
    if constexpr (T::kEnabled) visits_.resize(nodes);
  }

  /// All nodes count as never expanded, and expansions are numbered from 1 again.
  void begin() { first_ = latest_; }
  /// All nodes count as never expanded; the numbers go on.
  void forget() { forgotten_ = latest_; }

  /// The node is expanded.
  void record(T& tr, NodeId node) {
    if constexpr (T::kEnabled) {
      Visit& visit = visits_[node];
      const std::uint64_t before = value(visit);
      visit = {++latest_, before == 0 ? 1 : visit.times + 1};
      tr.change(EventKind::visit, node, before, value(visit));
    }
  }

  /// As `state` shows them, `expansions` being those since begin().
  void restore(const SearchState& state, std::int64_t expansions) {
    if constexpr (T::kEnabled) {
      first_ = forgotten_ = 0;
      latest_ = static_cast<std::uint32_t>(expansions);
      for (NodeId node = 0; node < visits_.size(); ++node)
        visits_[node] = {state.order(node), state.times_expanded(node)};
    }
  }

 private:
  struct Visit {
    std::uint32_t latest = 0;  // number of the latest expansion, counted over all searches
    std::uint32_t times = 0;
  };
  /// As events hold it. What was written before all nodes were forgotten no longer counts.
  [[nodiscard]] std::uint64_t value(const Visit& visit) const {
    const bool counts = visit.latest > first_ && visit.latest > forgotten_;
    return counts ? std::uint64_t{visit.times} << 32 | (visit.latest - first_) : 0;
  }

  std::vector<Visit> visits_;
  std::uint32_t latest_ = 0, first_ = 0, forgotten_ = 0;
};

}  // namespace replan
