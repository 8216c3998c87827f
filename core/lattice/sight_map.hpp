// Where a ray may leap: counts of bad cells in tiles of 8 and of 64 cells a side.
//
// A line of sight over open ground passes hundreds of cells to learn that none is bad. In a tile without a
// bad cell it need not look at them: it goes straight to the last cell of the tile that it touches.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/lattice/box_lattice.hpp"

namespace replan {

/// Tile counts over a box lattice. Its owner tells it of every cell that turns bad or good.
template <int D>
class SightMap {
 public:
  using Coordinates = typename BoxLattice<D>::Coordinates;

  SightMap() = default;
  /// Counts the cells for which `bad(node)` holds.
  template <class Bad>
  SightMap(const BoxLattice<D>& lattice, Bad&& bad) {
    std::size_t small = 1, large = 1;
    for (std::size_t axis = 0; axis < D; ++axis) {
      small_stride_[axis] = small;
      large_stride_[axis] = large;
      small *= static_cast<std::size_t>(lattice.size()[axis] + 7) / 8;
      large *= static_cast<std::size_t>(lattice.size()[axis] + 63) / 64;
    }
    small_.resize(small);
    large_.resize(large);
    for (NodeId node = 0; node < lattice.node_count(); ++node)
      if (bad(node)) change(lattice.coordinates(node), true);
  }

  /// A cell has turned bad, or good again.
  void change(const Coordinates& at, bool bad) {
    small_[tile(at, 3, small_stride_)] += bad ? 1 : -1;
    large_[tile(at, 6, large_stride_)] += bad ? 1 : -1;
  }

  /// The side of the largest tile around a cell that has no bad cell in it: 64, 8, or 1 if there is none.
  [[nodiscard]] int empty_tile(const Coordinates& at) const {
    if (large_[tile(at, 6, large_stride_)] == 0) return 64;
    return small_[tile(at, 3, small_stride_)] == 0 ? 8 : 1;
  }

  [[nodiscard]] std::size_t memory_bytes() const {
    return small_.capacity() * sizeof small_[0] + large_.capacity() * sizeof large_[0];
  }

 private:
  static std::size_t tile(const Coordinates& at, int shift, const std::array<std::size_t, D>& stride) {
    std::size_t index = 0;
    for (std::size_t axis = 0; axis < D; ++axis)
      index += static_cast<std::size_t>(at[axis] >> shift) * stride[axis];
    return index;
  }

  std::array<std::size_t, D> small_stride_{}, large_stride_{};
  std::vector<std::int32_t> small_, large_;
};

/// Stands in where there are no tiles: a ray then looks at every cell.
struct NoSightMap {
  template <class Coordinates>
  static constexpr int empty_tile(const Coordinates&) {
    return 1;
  }
};

}  // namespace replan
