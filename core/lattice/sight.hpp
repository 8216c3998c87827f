// Lines of sight between two nodes, and the cells that a straight segment passes.
//
// Supercover: Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing" (1987), in whole numbers,
// so that passing exactly through a corner is seen as such. Bresenham: the line drawing that the DLD* Lite
// paper uses (Huang & Zhou 2018, doi 10.13195/j.kzyjc.2018.0583, Fig. 2), drawn from the smaller to the
// larger index so that both ends see each other or neither does.
#pragma once

#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/lattice/box_lattice.hpp"
#include "core/lattice/sight_map.hpp"

namespace replan {

/// What both lines share: where they are, and how a step changes the node.
template <int D>
struct Ray {
  using Coordinates = typename BoxLattice<D>::Coordinates;

  Coordinates at, target;
  NodeId node;
  std::array<int, D> sign{};
  std::array<NodeId, D> delta{};  ///< what a step along an axis adds to the node (modulo 2^32)
  std::array<std::int64_t, D> length{};

  Ray(const BoxLattice<D>& lattice, NodeId from, NodeId to)
      : at(lattice.coordinates(from)), target(lattice.coordinates(to)), node(from) {
    NodeId stride = 1;
    for (std::size_t i = 0; i < D; ++i) {
      sign[i] = target[i] > at[i] ? 1 : -1;
      delta[i] = target[i] > at[i] ? stride : 0u - stride;
      length[i] = std::abs(target[i] - at[i]);
      stride *= static_cast<NodeId>(lattice.size()[i]);
    }
  }

  /// Goes `count` cells along an axis.
  void go(std::size_t axis, std::int64_t count) {
    at[axis] += sign[axis] * static_cast<int>(count);
    node += delta[axis] * static_cast<NodeId>(count);
  }
  /// How many cells along an axis are left in the tile of that side.
  [[nodiscard]] std::int64_t room(std::size_t axis, int side) const {
    const int inside = at[axis] & (side - 1);
    return sign[axis] > 0 ? side - 1 - inside : inside;
  }
  [[nodiscard]] std::int64_t left(std::size_t axis) const { return std::abs(target[axis] - at[axis]); }
  /// The direction of a step along the axes whose bits are set.
  [[nodiscard]] int direction(unsigned axes) const {
    std::array<int, D> offset{};
    for (std::size_t i = 0; i < D; ++i) offset[i] = (axes >> i & 1u) != 0 ? sign[i] : 0;
    return Directions<D>::index(offset);
  }
};

/// The cells that the segment touches. Axis i crosses its k-th boundary at time (2k + 1) / (2 d_i); all times
/// are scaled by 2 * (product of the d), so they are whole numbers.
template <int D>
struct SupercoverRay : Ray<D> {
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  std::array<std::int64_t, D> next{}, period{};

  SupercoverRay(const BoxLattice<D>& lattice, NodeId from, NodeId to) : Ray<D>(lattice, from, to) {
    for (std::size_t i = 0; i < D; ++i) {
      std::int64_t others = 1;
      for (std::size_t j = 0; j < D; ++j)
        if (j != i && this->length[j] != 0) others *= this->length[j];
      next[i] = this->length[i] == 0 ? kNever : others;
      period[i] = 2 * others;
    }
  }

  /// Enters the next cell. Returns the axes crossed, a bit each: several where the segment passes through a
  /// corner.
  unsigned step() {
    std::int64_t soonest = next[0];
    for (std::size_t i = 1; i < D; ++i) soonest = std::min(soonest, next[i]);
    unsigned axes = 0;
    for (std::size_t i = 0; i < D; ++i)
      if (next[i] == soonest) {
        axes |= 1u << i;
        next[i] += period[i];
        this->go(i, 1);
      }
    return axes;
  }

  /// Goes to the last cell in the tile of that side. False if the target lies in it.
  bool leap(int side) {
    std::int64_t exit = kNever;
    for (std::size_t i = 0; i < D; ++i)
      if (const std::int64_t room = this->room(i, side); this->left(i) > room)
        exit = std::min(exit, next[i] + room * period[i]);
    if (exit == kNever) return false;
    for (std::size_t i = 0; i < D; ++i) {
      if (next[i] >= exit) continue;
      const std::int64_t crossings = (exit - 1 - next[i]) / period[i] + 1;
      next[i] += crossings * period[i];
      this->go(i, crossings);
    }
    return true;
  }
};

/// The cells that a line drawing fills: one per step along the longest axis.
template <int D>
struct BresenhamRay : Ray<D> {
  std::array<std::int64_t, D> error{};
  std::int64_t longest = 0;

  BresenhamRay(const BoxLattice<D>& lattice, NodeId from, NodeId to) : Ray<D>(lattice, from, to) {
    for (const std::int64_t cells : this->length) longest = std::max(longest, cells);
  }

  /// As SupercoverRay::step().
  unsigned step() {
    unsigned axes = 0;
    for (std::size_t i = 0; i < D; ++i) {
      error[i] += 2 * this->length[i];
      if (error[i] < longest) continue;
      error[i] -= 2 * longest;
      axes |= 1u << i;
      this->go(i, 1);
    }
    return axes;
  }

  /// As SupercoverRay::leap(). After k steps axis i has gone floor((error + 2 k length + longest) / (2
  /// longest)) cells.
  bool leap(int side) {
    std::int64_t steps = std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = 0; i < D; ++i)
      if (const std::int64_t room = this->room(i, side); this->left(i) > room)
        steps = std::min(steps, (2 * longest * (room + 1) - longest - error[i] - 1) / (2 * this->length[i]));
    if (steps == std::numeric_limits<std::int64_t>::max()) return false;
    for (std::size_t i = 0; i < D; ++i) {
      const std::int64_t cells = (error[i] + 2 * steps * this->length[i] + longest) / (2 * longest);
      error[i] += 2 * steps * this->length[i] - 2 * longest * cells;
      this->go(i, cells);
    }
    return true;
  }
};

/// Walks the cells that the segment from `from` to `to` touches, in order. `step(node, direction)` is called
/// for each cell entered (not for `from`), with the direction of entry; it returns false to stop. Where the
/// segment passes exactly through a corner or an edge the direction is diagonal. Returns false if stopped.
template <int D, class Step>
bool walk_supercover(const BoxLattice<D>& lattice, NodeId from, NodeId to, Step&& step) {
  for (SupercoverRay<D> ray(lattice, from, to); ray.node != to;) {
    const unsigned axes = ray.step();
    if (!step(ray.node, ray.direction(axes))) return false;
  }
  return true;
}

/// As walk_supercover(), over the cells of a Bresenham line.
template <int D, class Step>
bool walk_bresenham(const BoxLattice<D>& lattice, NodeId from, NodeId to, Step&& step) {
  for (BresenhamRay<D> ray(lattice, from, to); ray.node != to;) {
    const unsigned axes = ray.step();
    if (!step(ray.node, ray.direction(axes))) return false;
  }
  return true;
}

/// Follows a ray to `to` over good cells only; at a step along several axes at most `allowed` of the cells
/// that it squeezes past may be bad.
template <class SomeRay, class Bad, class Tiles>
bool ray_is_clear(SomeRay ray, NodeId to, int allowed, Bad&& bad, const Tiles& tiles) {
  while (ray.node != to) {
    if (const int side = tiles.empty_tile(ray.at); side > 1 && !ray.leap(side)) return true;
    const NodeId before = ray.node;
    const unsigned axes = ray.step();
    if (bad(ray.node)) return false;
    if ((axes & (axes - 1)) == 0) continue;
    int squeezed = 0;
    for (unsigned subset = (axes - 1) & axes; subset != 0; subset = (subset - 1) & axes) {
      NodeId beside = before;
      for (std::size_t i = 0; i < ray.delta.size(); ++i)
        if ((subset >> i & 1u) != 0) beside += ray.delta[i];
      squeezed += bad(beside) ? 1 : 0;
    }
    if (squeezed > allowed) return false;
  }
  return true;
}

/// True if `a` and `b` see each other: no cell on the way is bad, both ends included, and at each diagonal
/// step no more bad cells are squeezed past than the lattice's corner rule allows. `bad(node)` says which
/// cells are bad; `tiles` lets rays leap where none is.
template <int D, class Bad, class Tiles = NoSightMap>
bool line_of_sight(const BoxLattice<D>& lattice, SightRule rule, NodeId a, NodeId b, Bad&& bad,
                   const Tiles& tiles = {}) {
  if (bad(a) || bad(b)) return false;
  if (a > b) std::swap(a, b);
  const CornerRule corners = lattice.rules().corners;
  const int allowed = corners == CornerRule::none ? 0 : corners == CornerRule::one ? 1 : 8;
  return rule == SightRule::supercover ? ray_is_clear(SupercoverRay<D>(lattice, a, b), b, allowed, bad, tiles)
                                       : ray_is_clear(BresenhamRay<D>(lattice, a, b), b, allowed, bad, tiles);
}

}  // namespace replan
