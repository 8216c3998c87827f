// The values of a tree of places (core/planners/grown_tree.hpp), read out of a state of its log.
#pragma once

#include <optional>
#include <vector>

#include "core/space/place.hpp"
#include "core/trace/search_state.hpp"

namespace replan {

/// What a tree grew from.
enum class TreeSide : std::uint8_t { start, goal };

/// Vertices that there are, those that were cut off among them.
inline std::uint32_t vertex_count(const SearchState& state) {
  return static_cast<std::uint32_t>(state.scalar(Scalar::vertices));
}
inline Cost vertex_cost(const SearchState& state, std::uint32_t v) {
  return {static_cast<std::int64_t>(state.value(fields::kVertexCost.kind, v))};
}
/// The vertex that it hangs on; kNoNode if there is none.
inline std::uint32_t vertex_parent(const SearchState& state, std::uint32_t v) {
  return static_cast<std::uint32_t>(state.value(fields::kVertexParent.kind, v)) - 1u;
}
/// In a plane the middle of its only layer.
inline Place vertex_place(const SearchState& state, std::uint32_t v, bool in_space) {
  return {units_of(state.value(fields::kVertexX.kind, v)), units_of(state.value(fields::kVertexY.kind, v)),
          in_space ? units_of(state.value(fields::kVertexZ.kind, v)) : kPlaceUnits / 2};
}

/// Which end it grew from; the start in trees that do not declare it.
inline TreeSide vertex_side(const SearchState& state, std::uint32_t v) {
  return static_cast<TreeSide>(state.value(fields::kVertexSide.kind, v));
}

/// The vertices of a page of the state, from `first` on, which begins one: a tree may have a million of them, and value by
/// value takes several times as long.
class VertexPage {
 public:
  static constexpr std::uint32_t kSize = SearchState::kPage;

  VertexPage(const SearchState& state, std::uint32_t first, bool in_space)
      : x_(state, fields::kVertexX.kind, first),
        y_(state, fields::kVertexY.kind, first),
        parent_(state, fields::kVertexParent.kind, first),
        cost_(state, fields::kVertexCost.kind, first) {
    if (in_space) z_.emplace(state, fields::kVertexZ.kind, first);
  }
  [[nodiscard]] Cost cost(std::uint32_t i) const { return {static_cast<std::int64_t>(cost_[i])}; }
  /// As vertex_parent() and vertex_place().
  [[nodiscard]] std::uint32_t parent(std::uint32_t i) const {
    return static_cast<std::uint32_t>(parent_[i]) - 1u;
  }
  [[nodiscard]] Place place(std::uint32_t i) const {
    return {units_of(x_[i]), units_of(y_[i]), z_ ? units_of((*z_)[i]) : kPlaceUnits / 2};
  }

 private:
  /// Its values of one kind.
  class Values {
   public:
    Values(const SearchState& state, EventKind kind, std::uint32_t first)
        : page_(state.page(kind, first)), initial_(state.initial_value(kind)) {}
    [[nodiscard]] std::uint64_t operator[](std::uint32_t i) const {
      return page_ != nullptr ? page_[i] : initial_;
    }

   private:
    const std::uint64_t* page_;  // nullptr: nothing was ever written there
    std::uint64_t initial_;
  };

  Values x_, y_, parent_, cost_;
  std::optional<Values> z_;
};

/// That of the goal; kNoNode without a path.
inline std::uint32_t goal_vertex(const SearchState& state) {
  return static_cast<std::uint32_t>(state.scalar(Scalar::goal_vertex)) - 1u;
}
/// The points from a vertex to the root; none of kNoNode.
inline std::vector<Point> way_in_tree(const SearchState& state, std::uint32_t v, bool in_space) {
  std::vector<Point> points;
  for (; v != kNoNode; v = vertex_parent(state, v))
    points.push_back(point_of(vertex_place(state, v, in_space)));
  return points;
}

}  // namespace replan
