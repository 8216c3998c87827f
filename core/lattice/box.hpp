// Which node is which cell: all that most readers of a run need to know of its world.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "core/base/cell.hpp"

namespace replan {

/// A box of cells, one layer deep in the plane, numbered as the nodes of a lattice are: x runs fastest, then
/// y, then z.
class Box {
 public:
  Box() = default;
  Box(int width, int height, int depth = 1) : size_{width, height, depth} {}

  [[nodiscard]] int width() const { return size_[0]; }
  [[nodiscard]] int height() const { return size_[1]; }
  [[nodiscard]] int depth() const { return size_[2]; }
  /// Whether it has more than one layer.
  [[nodiscard]] bool solid() const { return size_[2] > 1; }
  /// As a lattice of D dimensions has them.
  template <int D>
  [[nodiscard]] std::array<int, D> sides() const {
    std::array<int, D> sides{};
    for (std::size_t axis = 0; axis < D; ++axis) sides[axis] = size_[axis];
    return sides;
  }
  [[nodiscard]] std::size_t node_count() const {
    return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
           static_cast<std::size_t>(size_[2]);
  }
  [[nodiscard]] bool contains(Cell cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < size_[0] && cell.y < size_[1] &&
           cell.z < size_[2];
  }
  [[nodiscard]] NodeId node(Cell cell) const {
    return (static_cast<NodeId>(cell.z) * static_cast<NodeId>(size_[1]) + static_cast<NodeId>(cell.y)) *
               static_cast<NodeId>(size_[0]) +
           static_cast<NodeId>(cell.x);
  }
  [[nodiscard]] Cell position(NodeId node) const {
    const auto width = static_cast<NodeId>(size_[0]), height = static_cast<NodeId>(size_[1]);
    const NodeId row = node / width;
    return {static_cast<int>(node % width), static_cast<int>(row % height), static_cast<int>(row / height)};
  }

  /// Calls `visit(node)` for the cells at most `reach` away from `middle` along each axis, itself included, in the
  /// order of their nodes.
  template <class Visit>
  void each_cell_around(Cell middle, int reach, Visit&& visit) const {
    const auto low = [reach](int at) { return std::max(0, at - reach); };
    const auto high = [reach](int at, int size) { return std::min(size - 1, at + reach); };
    for (int z = low(middle.z); z <= high(middle.z, depth()); ++z)
      for (int y = low(middle.y); y <= high(middle.y, height()); ++y)
        for (int x = low(middle.x); x <= high(middle.x, width()); ++x) visit(node({x, y, z}));
  }
  friend bool operator==(const Box&, const Box&) = default;

 private:
  std::array<int, 3> size_{0, 0, 1};
};

/// Calls `work` with the number of dimensions that a lattice for the box has, as a constant of its type: the
/// one place where a world's dimension, known when it runs, becomes that of a template.
template <class Work>
decltype(auto) with_dimensions(const Box& box, Work&& work) {
  if (box.solid()) return std::forward<Work>(work)(std::integral_constant<int, 3>{});
  return std::forward<Work>(work)(std::integral_constant<int, 2>{});
}

}  // namespace replan
