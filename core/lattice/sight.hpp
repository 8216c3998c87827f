// Lines of sight between two nodes, and the cells that a straight segment passes.
//
// Supercover: Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing" (1987), in whole numbers, so
// that passing exactly through a corner is seen as such. Bresenham: the line drawing that the DLD* Lite paper uses
// (Huang & Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, Fig. 2), drawn from the smaller to the larger index so that
// both ends see each other or neither does.
#pragma once

#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/lattice/box_lattice.hpp"

namespace replan {

/// Walks the cells that the segment from `from` to `to` touches, in order. `step(node, direction)` is called for
/// each cell entered (not for `from`), with the direction of entry; it returns false to stop. Where the segment
/// passes exactly through a corner or an edge the direction is diagonal.
/// Returns false if stopped.
template <int D, class Step>
bool walk_supercover(const BoxLattice<D>& lattice, NodeId from, NodeId to, Step&& step) {
  const auto p = lattice.coordinates(from), q = lattice.coordinates(to);
  // Axis i crosses its k-th boundary at time (2k + 1) / (2 d_i); all times are scaled by 2 * (product of the d).
  std::array<std::int64_t, D> next{}, period{};
  std::array<int, D> sign{};
  for (std::size_t i = 0; i < D; ++i) {
    sign[i] = q[i] > p[i] ? 1 : -1;
    next[i] = q[i] == p[i] ? std::numeric_limits<std::int64_t>::max() : 1;
    for (std::size_t j = 0; j < D; ++j)
      if (j != i && next[i] != std::numeric_limits<std::int64_t>::max() && q[j] != p[j])
        next[i] *= std::abs(q[j] - p[j]);
    period[i] = q[i] == p[i] ? 0 : 2 * next[i];
  }
  NodeId node = from;
  while (node != to) {
    std::int64_t soonest = next[0];
    for (std::size_t i = 1; i < D; ++i) soonest = std::min(soonest, next[i]);
    std::array<int, D> offset{};
    for (std::size_t i = 0; i < D; ++i)
      if (next[i] == soonest) {
        offset[i] = sign[i];
        next[i] += period[i];
      }
    const int direction = Directions<D>::index(offset);
    node = lattice.neighbour(node, direction);
    if (!step(node, direction)) return false;
  }
  return true;
}

/// As walk_supercover, over the cells of a Bresenham line.
template <int D, class Step>
bool walk_bresenham(const BoxLattice<D>& lattice, NodeId from, NodeId to, Step&& step) {
  const auto p = lattice.coordinates(from), q = lattice.coordinates(to);
  std::array<std::int64_t, D> length{}, error{};
  std::array<int, D> sign{};
  std::int64_t longest = 0;
  for (std::size_t i = 0; i < D; ++i) {
    length[i] = std::abs(q[i] - p[i]);
    sign[i] = q[i] > p[i] ? 1 : -1;
    longest = std::max(longest, length[i]);
  }
  NodeId node = from;
  for (std::int64_t k = 0; k < longest; ++k) {
    std::array<int, D> offset{};
    for (std::size_t i = 0; i < D; ++i) {
      error[i] += 2 * length[i];
      if (error[i] >= longest) {
        error[i] -= 2 * longest;
        offset[i] = sign[i];
      }
    }
    const int direction = Directions<D>::index(offset);
    node = lattice.neighbour(node, direction);
    if (!step(node, direction)) return false;
  }
  return true;
}

/// True if `a` and `b` see each other: no cell on the way is bad, both ends included, and at each diagonal step no
/// more bad cells are squeezed past than the lattice's corner rule allows. `bad(node)` says which cells are bad.
template <int D, class Bad>
bool line_of_sight(const BoxLattice<D>& lattice, SightRule rule, NodeId a, NodeId b, Bad&& bad) {
  if (bad(a) || bad(b)) return false;
  if (a > b) std::swap(a, b);
  const CornerRule corners = lattice.rules().corners;
  const int allowed = corners == CornerRule::none ? 0 : corners == CornerRule::one ? 1 : 8;
  const auto enter = [&](NodeId node, int direction) {
    if (bad(node)) return false;
    const NodeId left = lattice.neighbour(node, BoxLattice<D>::reverse(direction));
    int squeezed = 0;
    for (std::uint32_t rest = Directions<D>::squeezed(direction); rest != 0; rest &= rest - 1)
      squeezed += bad(lattice.neighbour(left, std::countr_zero(rest))) ? 1 : 0;
    return squeezed <= allowed;
  };
  return rule == SightRule::supercover ? walk_supercover(lattice, a, b, enter) : walk_bresenham(lattice, a, b, enter);
}

}  // namespace replan
