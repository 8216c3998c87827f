// How a view lays out a world's cells: in columns and rows, layer behind layer.
#pragma once

#include <algorithm>

#include "core/base/point.hpp"
#include "core/lattice/box.hpp"

namespace replan {

/// A world as it is seen along one of its axes. Its cells have two kinds of coordinates: the world's, and those of the
/// view, which are the column to the right, the row down and the layer. Along z both are the same. Along the other two
/// the world stands upright: z grows upwards, x (seen along y) or y (seen along x) to the right, and the layer is that
/// of the axis itself.
class SeenBox {
 public:
  SeenBox() = default;
  SeenBox(const Box& world, Axis along)
      : world_(world), along_(along), seen_(turned({world.width(), world.height(), world.depth()})) {
    const Cell from = this->world(Cell{0, 0, 0});
    const auto step = [this](Cell cell) { return world_.node(this->world(cell)) - origin_; };
    origin_ = world_.node(from);
    // Modulo 2^32: a step upwards is one to a lower node.
    column_ = step({1, 0, 0});
    row_ = step({0, 1, 0});
    layer_ = step({0, 0, 1});
  }

  [[nodiscard]] const Box& box() const { return world_; }
  [[nodiscard]] Axis along() const { return along_; }
  [[nodiscard]] int width() const { return seen_.x; }
  [[nodiscard]] int height() const { return seen_.y; }
  /// Layers, one behind the other.
  [[nodiscard]] int depth() const { return seen_.z; }
  /// Whether the world has more than one layer along z.
  [[nodiscard]] bool solid() const { return world_.solid(); }
  [[nodiscard]] std::size_t node_count() const { return world_.node_count(); }

  // Of cells by the view's coordinates.
  [[nodiscard]] bool contains(Cell cell) const { return world_.contains(world(cell)); }
  [[nodiscard]] NodeId node(Cell cell) const {
    return origin_ + static_cast<NodeId>(cell.x) * column_ + static_cast<NodeId>(cell.y) * row_ +
           static_cast<NodeId>(cell.z) * layer_;
  }
  /// From a node to that of the next column.
  [[nodiscard]] NodeId column_step() const { return column_; }
  /// How many columns from a node on have their nodes on its page, where nodes are kept in pages of that size.
  [[nodiscard]] int columns_on_page(NodeId node, std::size_t page) const {
    return static_cast<int>((page - node % page + column_ - 1) / column_);
  }
  [[nodiscard]] Cell position(NodeId node) const { return seen(world_.position(node)); }

  /// From the world's coordinates to those of the view.
  [[nodiscard]] Cell seen(Cell world) const {
    const int up = world_.depth() - 1 - world.z;
    switch (along_) {
      case Axis::x:
        return {world.y, up, world.x};
      case Axis::y:
        return {world.x, up, world.y};
      case Axis::z:
        break;
    }
    return world;
  }
  [[nodiscard]] Point seen(const Point& world) const {
    const double up = world_.depth() - world.z;
    switch (along_) {
      case Axis::x:
        return {world.y, up, world.x};
      case Axis::y:
        return {world.x, up, world.y};
      case Axis::z:
        break;
    }
    return world;
  }
  /// And back.
  [[nodiscard]] Cell world(Cell seen) const {
    const int z = world_.depth() - 1 - seen.y;
    switch (along_) {
      case Axis::x:
        return {seen.z, seen.x, z};
      case Axis::y:
        return {seen.x, seen.z, z};
      case Axis::z:
        break;
    }
    return seen;
  }
  [[nodiscard]] Point world(const Point& seen) const {
    const double z = world_.depth() - seen.y;
    switch (along_) {
      case Axis::x:
        return {seen.z, seen.x, z};
      case Axis::y:
        return {seen.x, seen.z, z};
      case Axis::z:
        break;
    }
    return seen;
  }
  /// Of a box with that size in the world: how many columns, rows and layers it has.
  [[nodiscard]] Cell turned(Cell size) const {
    switch (along_) {
      case Axis::x:
        return {size.y, size.z, size.x};
      case Axis::y:
        return {size.x, size.z, size.y};
      case Axis::z:
        break;
    }
    return size;
  }

  friend bool operator==(const SeenBox&, const SeenBox&) = default;

 private:
  Box world_;
  Axis along_ = Axis::z;
  Cell seen_{0, 0, 1};
  NodeId origin_ = 0, column_ = 1, row_ = 0, layer_ = 0;
};

/// A layer of a world, across one of its axes.
struct Slice {
  Axis along = Axis::z;
  int layer = 0;  ///< the coordinate of its cells along that axis
  friend bool operator==(const Slice&, const Slice&) = default;
};

/// As a view shows it.
struct Sheet {
  SeenBox box;
  int layer = 0;

  /// The world's cell in a column and a row.
  [[nodiscard]] Cell cell(int column, int row) const { return box.world(Cell{column, row, layer}); }
  /// Whether a cell of the world lies in it.
  [[nodiscard]] bool has(Cell cell) const { return box.seen(cell).z == layer; }
};

/// What a slice of a world shows; of a layer that there is not the nearest that there is.
inline Sheet sheet_of(const Box& world, const Slice& slice) {
  const SeenBox box(world, world.solid() ? slice.along : Axis::z);
  return {box, std::clamp(slice.layer, 0, box.depth() - 1)};
}

}  // namespace replan
