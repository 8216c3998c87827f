// The Lattice concept: what a search may know about the world it searches.
//
// Laws, tested for every model (tests/unit/lattice_laws_test.cpp):
//  1. Nodes are 0 .. node_count()-1. Direction d from n leads to neighbour(n, d) only where bit d of moves(n)
//     is set.
//  2. Directions are ordered so that neighbour(n, d) grows with d: "the smallest index" is "the lowest bit".
//  3. Moves are undirected: bit d of moves(n) is set exactly if bit reverse(d) of moves(neighbour(n, d)) is.
//     So Succ(s) = Pred(s), and step_cost(d) == step_cost(reverse(d)).
//  4. A blocked node has no moves and is nobody's neighbour.
//  5. Lower bounds are consistent over step costs: bound(a, c) <= step(a, b) + bound(b, c). Step costs are
//     rounded up and lower bounds down: bound is the floor of a metric, floor(x + y) <= floor(x) + ceil(y).
//  6. bound_up(a, b) is the same bound rounded up, so that bound(a, c) <= bound_up(a, b) + bound(b, c): what
//     km must grow by in D* Lite (a sum of floors alone can fall one unit short).
//  7. Sight is symmetric in its two ends (sight.hpp).
//  8. After apply(), moves() equals that of a lattice built afresh from the same cells, and the reported
//     nodes are exactly those whose moves changed.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "core/base/cell.hpp"
#include "core/base/cost.hpp"

namespace replan {

/// Which diagonals are allowed, named after what may be blocked beside them. In 3D "one" counts over all
/// cells of the box that the move spans.
enum class CornerRule : std::uint8_t {
  none,  ///< every cell that the diagonal squeezes past must be free (the rule of the MovingAI benchmarks)
  one,   ///< at most one of them may be blocked
  any,   ///< only the two ends must be free
};

/// Which cells a line of sight needs.
enum class SightRule : std::uint8_t {
  supercover,  ///< every cell that the segment between the two centres touches
  bresenham,   ///< the cells that a line drawing fills, plus the corner rule at its diagonal steps
};

/// Distance estimates. On a lattice with diagonal moves all but `manhattan` are consistent lower bounds.
enum class Heuristic : std::uint8_t {
  octile,     ///< the exact distance on an empty lattice (Manhattan where only straight moves exist)
  euclidean,  ///< straight line
  chebyshev,  ///< the longest axis
  manhattan,  ///< the sum of the axes; too long where diagonals are allowed: fast, not optimal
  zero,       ///< no estimate
};

/// How a lattice's moves are made.
struct MoveRules {
  CornerRule corners = CornerRule::none;  ///< of a robot without a size; one with a size cuts no corners
  bool diagonals = true;                  ///< 8 or 4 neighbours in 2D, 26 or 6 in 3D
  /// Of the robot, in cells; 0: a point. Obstacles are grown by it (inflation.hpp).
  double radius = 0;
  static constexpr double kMostRadius = 32;
  friend constexpr bool operator==(const MoveRules&, const MoveRules&) = default;
};

/// A cell that turns into an obstacle or becomes free.
struct CellEdit {
  NodeId node = 0;
  bool blocked = false;
  friend constexpr bool operator==(const CellEdit&, const CellEdit&) = default;
};

template <class L>
concept Lattice = requires(const L lattice, NodeId node, int direction, Heuristic heuristic) {
  { L::kDimensions } -> std::convertible_to<int>;
  { L::kDirections } -> std::convertible_to<int>;
  { lattice.node_count() } -> std::same_as<std::size_t>;
  { lattice.blocked(node) } -> std::same_as<bool>;
  { lattice.moves(node) } -> std::convertible_to<std::uint32_t>;
  lattice.fetch_moves(node);
  { lattice.neighbour(node, direction) } -> std::same_as<NodeId>;
  { L::reverse(direction) } -> std::same_as<int>;
  { L::step_cost(direction) } -> std::same_as<Cost>;
  { lattice.bound(heuristic, node, node) } -> std::same_as<Cost>;
  { lattice.bound_up(heuristic, node, node) } -> std::same_as<Cost>;
  { lattice.squared_distance(node, node) } -> std::same_as<std::int64_t>;
  { lattice.revision() } -> std::same_as<std::uint64_t>;
};

}  // namespace replan
