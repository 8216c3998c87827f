#include "core/debug/offers.hpp"

#include <algorithm>
#include <bit>

#include "core/lattice/box_lattice.hpp"
#include "core/plan/common_parameters.hpp"

namespace replan {
namespace {

/// The moves are those of a window of the cells around, under the same rules: the map need not be copied.
template <int D>
std::vector<Offer> offers_in(const LogView& view, const SearchState& state, NodeId node) {
  using L = BoxLattice<D>;
  const auto to_cell = [](const typename L::Coordinates& at) {
    return Cell{at[0], at[1], D == 3 ? at[D - 1] : 0};
  };
  const auto at = L::to_coordinates(view.lattice.position(node));
  const auto sides = view.lattice.template sides<D>();
  typename L::Coordinates low{}, size{};
  for (std::size_t axis = 0; axis < D; ++axis) {
    low[axis] = std::max(at[axis] - 1, 0);
    size[axis] = std::min(at[axis] + 1, sides[axis] - 1) - low[axis] + 1;
  }
  L window(size, move_rules(view.settings));
  const auto node_of = [&](NodeId place) {
    auto there = window.coordinates(place);
    for (std::size_t axis = 0; axis < D; ++axis) there[axis] += low[axis];
    return view.lattice.node(to_cell(there));
  };
  std::vector<CellEdit> obstacles;
  for (NodeId place = 0; place < window.node_count(); ++place)
    if (state.known_blocked(node_of(place))) obstacles.push_back({place, true});
  window.apply(obstacles);
  auto middle = at;
  for (std::size_t axis = 0; axis < D; ++axis) middle[axis] -= low[axis];
  const NodeId from = window.node(middle);
  std::vector<Offer> all;
  for (auto rest = static_cast<std::uint32_t>(window.moves(from)); rest != 0; rest &= rest - 1) {
    const int d = std::countr_zero(rest);
    const NodeId there = node_of(window.neighbour(from, d));
    const Cost g = state.g(there), dist = state.dist(there), step = L::step_cost(d);
    all.push_back({there, step, g, dist, step + g + dist});
  }
  std::stable_sort(all.begin(), all.end(), [](const Offer& a, const Offer& b) { return a.sum < b.sum; });
  return all;
}

}  // namespace

std::vector<Offer> offers_to(const LogView& view, const SearchState& state, NodeId node) {
  return with_dimensions(view.lattice, [&](auto d) { return offers_in<d()>(view, state, node); });
}

}  // namespace replan
