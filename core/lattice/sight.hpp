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
#include <type_traits>
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
      : Ray(lattice.size(), lattice.coordinates(from), lattice.coordinates(to), from) {}
  /// In a box of any depth.
  Ray(const Box& box, NodeId from, NodeId to) requires(D == 3)
      : Ray(box.sides<3>(), BoxLattice<3>::to_coordinates(box.position(from)),
            BoxLattice<3>::to_coordinates(box.position(to)), from) {}
  Ray(const Coordinates& sides, const Coordinates& from, const Coordinates& to, NodeId first)
      : at(from), target(to), node(first) {
    NodeId stride = 1;
    for (std::size_t i = 0; i < D; ++i) {
      sign[i] = target[i] > at[i] ? 1 : -1;
      delta[i] = target[i] > at[i] ? stride : 0u - stride;
      length[i] = std::abs(target[i] - at[i]);
      stride *= static_cast<NodeId>(sides[i]);
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

/// The cells that the segment touches. Axis i crosses its k-th boundary at time
/// (2k + 1) / (2 d_i); all times are scaled by 2 * (product of the d), so they
/// are whole numbers.
template <int D>
struct SupercoverRay : Ray<D> {
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  std::array<std::int64_t, D> next{}, period{};

  template <class World>
  SupercoverRay(const World& world, NodeId from, NodeId to) : Ray<D>(world, from, to) {
    for (std::size_t i = 0; i < D; ++i) {
      std::int64_t others = 1;
      for (std::size_t j = 0; j < D; ++j)
        if (j != i && this->length[j] != 0) others *= this->length[j];
      next[i] = this->length[i] == 0 ? kNever : others;
      period[i] = 2 * others;
    }
  }

  /// Enters the next cell. Returns the axes crossed, a bit each: several where
  /// the segment passes through a corner.
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

  /// Goes to the last cell in the tile of that side. False if the target lies
  /// in it.
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

  template <class World>
  BresenhamRay(const World& world, NodeId from, NodeId to) : Ray<D>(world, from, to) {
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

  /// As SupercoverRay::leap(). After k steps axis i has gone floor((error + 2 k
  /// length + longest) / (2 longest)) cells.
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

/// Walks the cells that the segment from `from` to `to` touches, in order.
/// `step(node, direction)` is called for each cell entered (not for `from`),
/// with the direction of entry; it returns false to stop. Where the segment
/// passes exactly through a corner or an edge the direction is diagonal.
/// Returns false if stopped.
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

/// The same in a box of any depth; `visit(node)` is not told the direction.
template <class Visit>
bool walk_supercover(const Box& box, NodeId from, NodeId to, Visit&& visit) {
  for (SupercoverRay<3> ray(box, from, to); ray.node != to;) {
    ray.step();
    if (!visit(ray.node)) return false;
  }
  return true;
}
template <class Visit>
bool walk_bresenham(const Box& box, NodeId from, NodeId to, Visit&& visit) {
  for (BresenhamRay<3> ray(box, from, to); ray.node != to;) {
    ray.step();
    if (!visit(ray.node)) return false;
  }
  return true;
}

/// Follows a ray to `to` over good cells only; at a step along several axes at
/// most `allowed` of the cells that it squeezes past may be bad.
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

/// A segment between two cells of the plane as runs of cells, one for each line
/// that it crosses: rows, or columns if it is steep. It is followed along
/// growing places on its lines.
///
/// With l cells along and c lines across, the segment leaves line k at the
/// place (2k + 1) l / (2c), counted from where it begins. Supercover: line k
/// ends with the cell ceil(((2k + 1) l - c) / (2c)), and the next one begins
/// there too, or one cell on if the line is left exactly through a corner.
/// Bresenham: line k + 1 begins with the cell ceil((2k + 1) l / (2c)), each
/// step to the next line is diagonal, and what is drawn the other way has its
/// ties the other way.
template <bool kDrawn>
struct LineRuns {
  int axis = 0;                       // 0: rows
  int begin = 0, end = 0, lines = 0;  // places of both ends, l apart, and c
  int tie = 0;                        // 1: drawn the other way
  int sign = 1;                       // the way that the lines are crossed
  int line = 0, left = 0;             // the line at hand, and how many follow
  // Where it begins; where the next one does, rounded up, and by how much.
  int first = 0, next = 0, rest = 0;

  LineRuns(Grid2::Coordinates from, Grid2::Coordinates to) {
    axis = std::abs(to[1] - from[1]) > std::abs(to[0] - from[0]) ? 1 : 0;
    if (axis == 1) {
      std::swap(from[0], from[1]);
      std::swap(to[0], to[1]);
    }
    tie = kDrawn && to[0] < from[0] ? 1 : 0;
    if (to[0] < from[0]) std::swap(from, to);
    first = begin = from[0];
    end = to[0];
    line = from[1];
    sign = to[1] < line ? -1 : 1;
    lines = left = std::abs(to[1] - line);
  }

  /// Whether no cell is bad and at corners no more than `allowed` are squeezed
  /// past.
  [[nodiscard]] bool clear(const SightMap<2>& map, int allowed) {
    // So many lines are worth looking for open ground, and again after some.
    constexpr int kMany = 64, kLook = 16;
    const BitLines& bits = map.lines(axis);
    if (left == 0) return BitLines::clear(bits.line(line), begin, end);
    set_out(0);
    while (left > kMany) {
      // A leap passes over the rest of this line; what was squeezed past on the
      // way here lies before it.
      if (kDrawn && allowed == 0 && first != begin && BitLines::test(bits.line(line), first - 1))
        return false;
      leap(map);
      if (!follow(bits, std::max(left - kLook, 1), allowed)) return false;
    }
    return follow(bits, 0, allowed) &&
           BitLines::clear(bits.line(line), kDrawn && allowed == 0 ? first - 1 : first, end);
  }

  /// The end of line k.
  void set_out(std::int64_t k) {
    const std::int64_t l = end - begin, c = lines, above = (2 * k + 1) * l + (kDrawn ? tie : -c);
    const std::int64_t quotient = k == 0 ? static_cast<int>(above + 2 * c - 1) / static_cast<int>(2 * c)
                                         : (above + 2 * c - 1) / (2 * c);
    next = begin + static_cast<int>(quotient);
    rest = static_cast<int>(quotient * 2 * c - above);
  }

  /// Goes over lines until only so many are left.
  [[gnu::always_inline]] inline bool follow(const BitLines& bits, int until, int allowed) {
    const int whole = (end - begin) / lines, part = 2 * (end - begin - whole * lines);
    const std::ptrdiff_t stride = sign * bits.stride();
    const std::uint64_t* words = bits.line(line);
    const std::uint64_t* const past = words + (left - until) * stride;
    int at = first, until_at = next, short_of = rest;
    for (; words != past; words += stride) {
      const int last = kDrawn ? until_at - 1 : until_at;
      if (kDrawn && allowed == 0) {
        // What is squeezed past lies in the same lines, before the first cell
        // and after the last.
        if (!BitLines::clear(words, at == begin ? at : at - 1, last + 1)) return false;
        at = last + 1;
      } else {
        if (!BitLines::clear(words, at, last)) return false;
        at = last;
        if (kDrawn || short_of == 0) {
          ++at;
          if (int{BitLines::test(words, at)} + int{BitLines::test(words + stride, last)} > allowed)
            return false;
        }
      }
      until_at += whole;
      short_of -= part;
      // Without a branch: whether a line is a cell longer is a coin toss.
      const int carry = short_of >> 31;
      short_of += carry & (2 * lines);
      until_at -= carry;
    }
    first = at;
    next = until_at;
    rest = short_of;
    line += sign * (left - until);
    left = until;
    return true;
  }

  /// Over open ground: goes on to the last line that begins in the same empty
  /// tile.
  void leap(const SightMap<2>& map) {
    const int side =
        map.empty_tile(axis == 0 ? Grid2::Coordinates{first, line} : Grid2::Coordinates{line, first});
    if (side == 1) return;
    const int inside = line & (side - 1), room = sign > 0 ? side - 1 - inside : inside;
    const std::int64_t l = end - begin, c = lines, edge = (first | (side - 1)) - begin, now = lines - left;
    // The last line whose first cell is not beyond the edge.
    const std::int64_t reach = kDrawn ? 2 * c * edge - tie : 2 * c * (edge + 1) - c - 1;
    const std::int64_t k = std::min({(reach / l + 1) / 2, now + room, c - 1});
    if (k <= now) return;
    set_out(k - 1);
    first = kDrawn || rest != 0 ? next : next + 1;
    set_out(k);
    line += sign * static_cast<int>(k - now);
    left -= static_cast<int>(k - now);
  }
};

/// Follows the segment over the boxes between centres that it passes through; none of their corners may be bad.
///
/// So a robot with a size keeps its distance from obstacles all along: what a point of such a box is away from an
/// obstacle's square along an axis, one of the two centres beside it is at most; so no point of the box is nearer than
/// all of its corners. As with cells alone, sight depends on no cell outside the box that both ends span.
template <int D, class Bad>
bool wide_line_is_clear(const BoxLattice<D>& lattice, NodeId from, NodeId to, Bad&& bad) {
  constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
  Ray<D> ray(lattice, from, to);
  // Axis i passes its k-th centre at the time k / length_i, scaled by the product of the lengths.
  std::array<std::int64_t, D> next{}, period{};
  unsigned axes = 0;
  for (std::size_t i = 0; i < D; ++i) {
    if (ray.length[i] != 0) axes |= 1u << i;
    period[i] = 1;
    for (std::size_t j = 0; j < D; ++j)
      if (j != i && ray.length[j] != 0) period[i] *= ray.length[j];
    next[i] = ray.length[i] == 0 ? kNever : period[i];
  }
  while (ray.node != to) {
    for (unsigned subset = axes; subset != 0; subset = (subset - 1) & axes) {
      NodeId corner = ray.node;
      for (std::size_t i = 0; i < D; ++i)
        if ((subset >> i & 1u) != 0) corner += ray.delta[i];
      if (bad(corner)) return false;
    }
    const std::int64_t soonest = *std::min_element(next.begin(), next.end());
    for (std::size_t i = 0; i < D; ++i)
      if (next[i] == soonest) {
        next[i] += period[i];
        ray.go(i, 1);
      }
  }
  return true;
}

/// True if `a` and `b` see each other: no cell on the way is bad, both ends
/// included, and at each diagonal step no more bad cells are squeezed past than
/// the lattice's corner rule allows. `bad(node)` says which cells are bad;
/// `tiles` knows the same of many cells at once. To a robot with a size both
/// rules are one: wide_line_is_clear().
template <int D, class Bad, class Tiles = NoSightMap>
bool line_of_sight(const BoxLattice<D>& lattice, SightRule rule, NodeId a, NodeId b, Bad&& bad,
                   const Tiles& tiles = {}) {
  if (bad(a) || bad(b)) return false;
  if (a > b) std::swap(a, b);
  if (lattice.has_size()) return wide_line_is_clear(lattice, a, b, bad);
  const CornerRule corners = lattice.rules().corners;
  const int allowed = corners == CornerRule::none ? 0 : corners == CornerRule::one ? 1 : 8;
  if constexpr (std::is_same_v<Tiles, SightMap<2>>) {
    const auto from = lattice.coordinates(a), to = lattice.coordinates(b);
    const int across = to[0] - from[0], down = to[1] - from[1];
    // Neighbours, as most are that are asked about in a narrow maze.
    if (std::abs(across) <= 1 && down <= 1)
      return across == 0 || down == 0 ||
             int{bad(a + static_cast<NodeId>(across))} + int{bad(b - static_cast<NodeId>(across))} <= allowed;
    return rule == SightRule::supercover ? LineRuns<false>(from, to).clear(tiles, allowed)
                                         : LineRuns<true>(from, to).clear(tiles, allowed);
  } else {
    return rule == SightRule::supercover
               ? ray_is_clear(SupercoverRay<D>(lattice, a, b), b, allowed, bad, tiles)
               : ray_is_clear(BresenhamRay<D>(lattice, a, b), b, allowed, bad, tiles);
  }
}

}  // namespace replan
