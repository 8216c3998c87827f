// Which node is which cell: all that most readers of a run need to know of its world.
#pragma once

#include <array>
#include <cstddef>

#include "core/base/cell.hpp"

namespace replan {

/// A rectangle of cells, numbered row by row from the upper left one, as the nodes of a Grid2 are.
class Box {
 public:
  Box() = default;
  Box(int width, int height) : size_{width, height} {}

  [[nodiscard]] const std::array<int, 2>& size() const { return size_; }
  [[nodiscard]] int width() const { return size_[0]; }
  [[nodiscard]] int height() const { return size_[1]; }
  [[nodiscard]] std::size_t node_count() const {
    return static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]);
  }
  [[nodiscard]] bool contains(Cell cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.x < size_[0] && cell.y < size_[1];
  }
  [[nodiscard]] NodeId node(Cell cell) const {
    return static_cast<NodeId>(cell.y) * static_cast<NodeId>(size_[0]) + static_cast<NodeId>(cell.x);
  }
  [[nodiscard]] Cell position(NodeId node) const {
    const auto width = static_cast<NodeId>(size_[0]);
    return {static_cast<int>(node % width), static_cast<int>(node / width)};
  }

 private:
  std::array<int, 2> size_{};
};

}  // namespace replan
