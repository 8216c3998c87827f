// A map of cells as read from a file, drawn or generated: the plain data that every reader and writer shares.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/base/shared_array.hpp"
#include "core/lattice/box.hpp"

namespace replan {

/// One cell that is or becomes an obstacle (or free).
struct CellChange {
  Cell cell;
  bool blocked = false;
  friend constexpr auto operator<=>(const CellChange&, const CellChange&) = default;
};

/// What stands in a cell of a GridMap; whatever is not kFree is an obstacle in the world.
inline constexpr std::uint8_t kFree = 0;
inline constexpr std::uint8_t kObstacle = 1;
/// An obstacle that nobody has mapped: the robot takes the cell for free until it senses it.
inline constexpr std::uint8_t kUnmapped = 2;

/// What files may say of a map's resolution and origin.
inline constexpr double kMinResolution = 1e-6, kMaxResolution = 1e6, kMaxOrigin = 1e9;

/// A box of cells, one layer deep in the plane: x runs fastest, then y, then z. Copies share their cells
/// until one of them is written to.
struct GridMap {
  int width = 0;
  int height = 0;
  int depth = 1;
  SharedBytes blocked;    ///< kFree, kObstacle or kUnmapped
  double resolution = 1;  ///< length of a cell's side; metres in ROS maps, 1 where the source says nothing
  /// Pose of the lower left corner in the source's own frame (ROS): x and y in the resolution's unit, yaw in
  /// radians.
  std::array<double, 3> origin{};

  GridMap() = default;
  /// An all-free map.
  GridMap(int columns, int rows, int layers = 1)
      : width(columns), height(rows), depth(layers), blocked(box().node_count()) {}

  [[nodiscard]] Box box() const { return {width, height, depth}; }
  [[nodiscard]] bool contains(Cell c) const { return box().contains(c); }
  [[nodiscard]] std::size_t index(Cell c) const { return box().node(c); }
  [[nodiscard]] bool at(Cell c) const { return blocked[index(c)] != 0; }
  void set(Cell c, bool value) { blocked[index(c)] = value ? kObstacle : kFree; }
  friend bool operator==(const GridMap&, const GridMap&) = default;
};

/// Whether a world can have that size: the error names the limits, which are others for several layers.
Result<void> check_world_size(const Box& size);

/// Whether a stretch of cells has kUnmapped in it.
bool has_unmapped(std::span<const std::uint8_t> cells);
/// The cells with another value for kUnmapped; chunks without any are shared.
SharedBytes with_unmapped_as(SharedBytes cells, std::uint8_t value);

}  // namespace replan
