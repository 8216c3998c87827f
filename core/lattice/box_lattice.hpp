// Rectangular grids of cells in two and three dimensions, from one text: Grid2 and Voxel3.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "core/lattice/box.hpp"
#include "core/lattice/inflation.hpp"
#include "core/lattice/lattice.hpp"

namespace replan {

/// The 3^D - 1 directions of a D-dimensional box lattice, in order of growing node index.
template <int D>
struct Directions {
  static constexpr int kCount = D == 2 ? 8 : 26;
  using Offset = std::array<int, D>;

  /// Offset of direction d along each axis: -1, 0 or 1.
  static constexpr Offset offset(int d) {
    int code = d < kCount / 2 ? d : d + 1;  // the middle code is standing still
    Offset result{};
    for (int axis = 0; axis < D; ++axis, code /= 3) result[static_cast<std::size_t>(axis)] = code % 3 - 1;
    return result;
  }
  /// The direction with that offset; the offset must not be zero.
  static constexpr int index(const Offset& offset) {
    int code = 0;
    for (int axis = D - 1; axis >= 0; --axis) code = code * 3 + offset[static_cast<std::size_t>(axis)] + 1;
    return code > kCount / 2 ? code - 1 : code;
  }
  /// How many axes direction d moves along.
  static constexpr int axes(int d) {
    int count = 0;
    for (const int part : offset(d)) count += part != 0;
    return count;
  }
  /// The directions to the cells that a move along d squeezes past: those of the box it spans but for its
  /// ends.
  static constexpr std::uint32_t squeezed(int d) {
    const Offset whole = offset(d);
    std::uint32_t mask = 0;
    for (unsigned subset = 1; subset < (1u << D) - 1u; ++subset) {
      Offset part{};
      for (unsigned axis = 0; axis < D; ++axis) part[axis] = (subset >> axis & 1u) != 0 ? whole[axis] : 0;
      if (part != Offset{} && part != whole) mask |= 1u << index(part);
    }
    return mask;
  }
};

/// A box of cells. Move masks are kept per cell, so that a search reads one byte (2D) or word (3D) per
/// expansion.
///
/// Under rules with a radius its cells are places of the robot's centre: blocked where it would be too near an
/// obstacle. No corners are cut then, whatever the rules say, so that the robot keeps its distance from obstacles
/// on every move: along each axis, what a point between two neighbouring centres is away from an obstacle's square
/// one of the two is at most, so that none of it is nearer than some cell which the move squeezes past.
template <int D>
class BoxLattice {
  static_assert(D == 2 || D == 3);

 public:
  static constexpr int kDimensions = D;
  static constexpr int kDirections = Directions<D>::kCount;
  using Coordinates = std::array<int, D>;
  using MoveMask = std::conditional_t<D == 2, std::uint8_t, std::uint32_t>;

  /// A node whose moves have changed, and what they were before.
  struct MoveChange {
    NodeId node;
    MoveMask before;
  };

  BoxLattice() = default;
  /// An all-free box of the given size (cells along each axis; positive, at most kMaxCells in all, kMaxVoxels
  /// in 3D).
  explicit BoxLattice(Coordinates size, MoveRules rules = {});
  /// A box with the given cells of the map, row-major, nonzero = obstacle.
  BoxLattice(Coordinates size, std::vector<std::uint8_t> blocked, MoveRules rules = {});

  [[nodiscard]] const Coordinates& size() const { return size_; }
  [[nodiscard]] Box box() const {
    if constexpr (D == 2)
      return {size_[0], size_[1]};
    else
      return {size_[0], size_[1], size_[2]};
  }
  [[nodiscard]] int width() const { return size_[0]; }
  [[nodiscard]] int height() const { return size_[1]; }
  [[nodiscard]] const MoveRules& rules() const { return rules_; }
  [[nodiscard]] std::size_t node_count() const { return blocked_.size(); }
  /// Nonzero = blocked; and the map that they were made of, nonzero = obstacle: the same without a radius.
  [[nodiscard]] std::span<const std::uint8_t> cells() const { return blocked_; }
  [[nodiscard]] std::span<const std::uint8_t> obstacles() const {
    return inflation_ ? inflation_->obstacles() : cells();
  }
  [[nodiscard]] bool blocked(NodeId node) const { return blocked_[node] != 0; }
  /// Whether the robot has a size, and the obstacles as they look to its centre.
  [[nodiscard]] bool has_size() const { return inflation_.has_value(); }
  [[nodiscard]] const Inflation<D>& inflation() const { return *inflation_; }
  [[nodiscard]] std::uint32_t moves(NodeId node) const { return moves_[node]; }
  /// Brings near what moves() will read, while something else is done. Nothing changes but the time.
  void fetch_moves(NodeId node) const { __builtin_prefetch(&moves_[node]); }
  [[nodiscard]] NodeId neighbour(NodeId node, int direction) const {
    return node + static_cast<NodeId>(delta_[static_cast<std::size_t>(direction)]);
  }
  static constexpr int reverse(int direction) { return kDirections - 1 - direction; }
  static constexpr Cost step_cost(int direction) { return kStepCosts[static_cast<std::size_t>(direction)]; }
  /// The place one step from `at`, which need not be inside.
  static constexpr Coordinates step(Coordinates at, int direction) {
    for (std::size_t axis = 0; axis < D; ++axis)
      at[axis] += kOffsets[static_cast<std::size_t>(direction)][axis];
    return at;
  }

  [[nodiscard]] bool contains(const Coordinates& at) const {
    for (std::size_t axis = 0; axis < D; ++axis)
      if (at[axis] < 0 || at[axis] >= size_[axis]) return false;
    return true;
  }
  [[nodiscard]] NodeId node(const Coordinates& at) const {
    NodeId index = 0;
    for (std::size_t axis = D; axis-- > 0;)
      index = index * static_cast<NodeId>(size_[axis]) + static_cast<NodeId>(at[axis]);
    return index;
  }
  [[nodiscard]] Coordinates coordinates(NodeId node) const {
    Coordinates at{};
    for (std::size_t axis = 0; axis + 1 < D; ++axis) {
      // A multiplication instead of a division. Exact: (n + 0.5) / size keeps 0.5 / size >= 2^-27 away from
      // every whole number (2^-28 in 3D), far more than the error of a double.
      const auto quotient = static_cast<NodeId>((static_cast<double>(node) + 0.5) * inverse_[axis]);
      at[axis] = static_cast<int>(node - quotient * static_cast<NodeId>(size_[axis]));
      node = quotient;
    }
    at[D - 1] = static_cast<int>(node);
    return at;
  }
  [[nodiscard]] Cell position(NodeId node) const {
    const Coordinates at = coordinates(node);
    if constexpr (D == 2)
      return {at[0], at[1]};
    else
      return {at[0], at[1], at[2]};
  }
  [[nodiscard]] bool contains(Cell at) const { return (D == 3 || at.z == 0) && contains(to_coordinates(at)); }
  [[nodiscard]] NodeId node(Cell at) const { return node(to_coordinates(at)); }
  static constexpr Coordinates to_coordinates(Cell at) {
    if constexpr (D == 2)
      return {at.x, at.y};
    else
      return {at.x, at.y, at.z};
  }

  [[nodiscard]] Cost bound(Heuristic heuristic, const Coordinates& p, const Coordinates& q) const;
  [[nodiscard]] Cost bound(Heuristic heuristic, NodeId a, NodeId b) const {
    return bound(heuristic, coordinates(a), coordinates(b));
  }
  [[nodiscard]] Cost bound_up(Heuristic heuristic, NodeId a, NodeId b) const;
  [[nodiscard]] std::int64_t squared_distance(NodeId a, NodeId b) const {
    return squared_distance(coordinates(a), coordinates(b));
  }
  static std::int64_t squared_distance(const Coordinates& p, const Coordinates& q) {
    std::int64_t sum = 0;
    for (std::size_t axis = 0; axis < D; ++axis) sum += std::int64_t{p[axis] - q[axis]} * (p[axis] - q[axis]);
    return sum;
  }

  /// Writes cells of the map and brings the moves up to date. Edits that change nothing are passed over; of
  /// several edits of one cell the last one holds. Returns the nodes whose moves changed, valid until the next
  /// call.
  std::span<const MoveChange> apply(std::span<const CellEdit> edits);
  /// The cells that these edits, the latest that were applied, have blocked or freed: the edits themselves without
  /// a radius. Valid until the next apply().
  [[nodiscard]] std::span<const CellEdit> turned_by(std::span<const CellEdit> edits) const {
    return inflation_ ? inflation_->turned() : edits;
  }
  /// Builds all moves anew under other rules.
  void set_rules(MoveRules rules);

  /// Another number after every change of cells or rules, and one that no other map ever had in this process:
  /// what was made of the lattice is up to date as long as the number is the same.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  static constexpr auto kStepCosts = [] {
    std::array<Cost, kDirections> costs{};
    for (int d = 0; d < kDirections; ++d)
      costs[static_cast<std::size_t>(d)] = kStepCost[Directions<D>::axes(d)];
    return costs;
  }();

  static constexpr auto kOffsets = [] {
    std::array<Coordinates, kDirections> offsets{};
    for (int d = 0; d < kDirections; ++d) offsets[static_cast<std::size_t>(d)] = Directions<D>::offset(d);
    return offsets;
  }();

  void prepare();
  void inflate();
  [[nodiscard]] Cost other_bound(Heuristic heuristic, const Coordinates& p, const Coordinates& q) const;
  [[nodiscard]] std::uint32_t blocked_around(NodeId node) const;
  [[nodiscard]] MoveMask moves_for(NodeId node) const;

  Coordinates size_{};
  std::array<double, D> inverse_{};
  std::array<std::int32_t, kDirections> delta_{};
  MoveRules rules_;
  std::vector<std::uint8_t> blocked_;
  std::vector<MoveMask> moves_;
  MoveMask open_moves_ = 0;                      // of a cell with nothing blocked around it
  std::vector<MoveMask> masks_by_surroundings_;  // 2D only: the moves for each of the 256 surroundings
  std::vector<NodeId> touched_;
  std::vector<MoveChange> changes_;
  std::uint64_t revision_ = 0;
  std::optional<Inflation<D>> inflation_;  // with a radius
};

/// A plane of cells: 8 or 4 neighbours.
using Grid2 = BoxLattice<2>;
/// A box of voxels: 26 or 6 neighbours.
using Voxel3 = BoxLattice<3>;

extern template class BoxLattice<2>;
extern template class BoxLattice<3>;

// The default heuristic is asked for at every key; the others stay out of the way.
template <int D>
inline Cost BoxLattice<D>::bound(Heuristic heuristic, const Coordinates& p, const Coordinates& q) const {
  if (heuristic != Heuristic::octile || !rules_.diagonals) return other_bound(heuristic, p, q);
  if constexpr (D == 2) {
    const std::int64_t a = std::abs(p[0] - q[0]), b = std::abs(p[1] - q[1]);
    return {std::min(a, b) * (kStepCost[2].raw - 2 * kStepCost[1].raw) + (a + b) * kStepCost[1].raw};
  } else {
    std::array<std::int64_t, D> d{};
    for (std::size_t axis = 0; axis < D; ++axis) d[axis] = std::abs(p[axis] - q[axis]);
    const std::int64_t low = std::min({d[0], d[1], d[2]}), high = std::max({d[0], d[1], d[2]});
    const std::int64_t middle = d[0] + d[1] + d[2] - low - high;
    return {low * kStepCost[3].raw + (middle - low) * kStepCost[2].raw + (high - middle) * kStepCost[1].raw};
  }
}

template <int D>
inline Cost BoxLattice<D>::bound_up(Heuristic heuristic, NodeId a, NodeId b) const {
  return heuristic == Heuristic::euclidean ? euclidean_ceil(squared_distance(a, b)) : bound(heuristic, a, b);
}

}  // namespace replan
