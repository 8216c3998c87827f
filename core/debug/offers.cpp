#include "core/debug/offers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/lattice/box_lattice.hpp"
#include "core/lattice/interpolation.hpp"
#include "core/plan/common_parameters.hpp"

namespace replan {
namespace {

/// `node_of` makes nodes of the world of those of the window.
template <class NodeOf>
void add_ways_across(const Grid2& window, NodeId from, NodeOf&& node_of, const SearchState& state,
                     std::vector<Offer>& all) {
  const auto there = [&](std::uint32_t d) { return node_of(window.neighbour(from, static_cast<int>(d))); };
  const auto g = [&](int d) { return state.g(there(static_cast<std::uint32_t>(d))); };
  each_way_across(kFarSides, window.moves(from), g, Cost::infinity(), [&](const WayOn& way) {
    if (way.cost.is_infinite()) return;
    const Cost at_end = state.g(there(way.to));
    all.push_back({there(way.to), {way.cost.raw - at_end.raw}, at_end, Cost{}, way.cost, there(way.and_to)});
  });
}

/// Of a search from the start a way leads to the cell from its neighbour, else from the cell to the neighbour.
NodeId entered(const PlannerInfo& info, NodeId neighbour, NodeId node) {
  return info.from_goal ? neighbour : node;
}

/// The moves are those of a window of the cells around, and of those whose obstacles matter to them, under the same
/// rules: the map need not be copied.
template <int D>
std::vector<Offer> offers_in(const LogView& view, const SearchState& state, NodeId node) {
  const Box& box = view.lattice;
  const Cell at = box.position(node);
  const int reach = 1 + static_cast<int>(std::ceil(view.radius)), past = reach + 1;
  const Cell low{std::max(at.x - reach, 0), std::max(at.y - reach, 0), std::max(at.z - reach, 0)};
  const Box around(std::min(at.x + past, box.width()) - low.x, std::min(at.y + past, box.height()) - low.y,
                   std::min(at.z + past, box.depth()) - low.z);
  BoxLattice<D> window(around.sides<D>(), view.rules());
  const auto node_of = [&](NodeId place) {
    const Cell there = window.position(place);
    return box.node({there.x + low.x, there.y + low.y, there.z + low.z});
  };
  std::vector<CellEdit> obstacles;
  for (NodeId place = 0; place < window.node_count(); ++place)
    if (state.known_blocked(node_of(place))) obstacles.push_back({place, true});
  window.apply(obstacles);
  const NodeId from = window.node(Cell{at.x - low.x, at.y - low.y, at.z - low.z});
  std::vector<Offer> all;
  for (auto rest = static_cast<std::uint32_t>(window.moves(from)); rest != 0; rest &= rest - 1) {
    const int d = std::countr_zero(rest);
    const NodeId there = node_of(window.neighbour(from, d));
    const Cost g = state.g(there), step = BoxLattice<D>::step_cost(d);
    const Cost dist = state.dist(entered(view.info, there, node));
    all.push_back({there, step, g, dist, step + g + dist});
  }
  if constexpr (D == 2)
    if (view.info.values.interpolated) add_ways_across(window, from, node_of, state, all);
  std::stable_sort(all.begin(), all.end(), [](const Offer& a, const Offer& b) { return a.sum < b.sum; });
  return all;
}

}  // namespace

std::vector<Offer> offers_to(const LogView& view, const SearchState& state, NodeId node) {
  return with_dimensions(view.lattice, [&](auto d) { return offers_in<d()>(view, state, node); });
}

bool too_near(const LogView& view, const SearchState& state, NodeId node) {
  if (view.radius <= 0 || state.known_blocked(node)) return false;
  const Cell at = view.lattice.position(node);
  const std::int64_t limit = limit_of(view.radius);
  bool near = false;
  view.lattice.each_cell_around(at, static_cast<int>(std::ceil(view.radius)), [&](NodeId other) {
    if (near || !state.known_blocked(other)) return;
    const Cell there = view.lattice.position(other);
    near = quarters_of(std::array{there.x - at.x, there.y - at.y, there.z - at.z}) < limit;
  });
  return near;
}

}  // namespace replan
