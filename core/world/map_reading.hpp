// How a map file is to be read, and what comes of it: shared by the readers of all formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cell.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// How pixels become cells. Colours count by their brightness, seen on a white ground where they are
/// transparent.
struct ImageMapOptions {
  int threshold = 128;  ///< brightness 0..255; darker than this is an obstacle (1..255 part anything at all)
  bool invert = false;  ///< brighter is an obstacle instead
  friend bool operator==(const ImageMapOptions&, const ImageMapOptions&) = default;
};

/// What becomes of cells that a map (ROS) says are unknown. Blocked is the default: a plan through places
/// that nobody has seen is the one that may fail.
enum class UnknownCells : std::uint8_t {
  blocked,   ///< obstacles
  free,      ///< free cells
  unmapped,  ///< kUnmapped: obstacles that the robot takes for free until it senses them
};

/// How heights become layers: a voxel is an obstacle where the floor reaches into it, so the deepest place is free
/// down to the lowest layer.
struct HeightReading {
  int layers = 64;  ///< 2 to 512
  /// The heights between which the layers lie, in the file's own unit (of a picture: 0 black to 255 white). Nothing:
  /// from the deepest place to sea level, 0, or to the highest place of a file with nothing below 0.
  std::optional<double> low = std::nullopt, high = std::nullopt;
  /// So many columns each way are read as one, as high as the highest of them. 0: as few as a world has room for.
  int reduce = 0;
  friend bool operator==(const HeightReading&, const HeightReading&) = default;
};
struct HeightRange {
  double low = 0, high = 0;
};
inline constexpr int kLeastHeightLayers = 2, kMostHeightLayers = 512, kMostReduced = 1024;
/// The largest height that counts as one, above and below 0.
inline constexpr double kMaxHeight = 1e9;

/// The largest number that MapReading::occupied can be, above and below 0: that of 64 bits.
inline constexpr double kMaxOccupied = 18446744073709551615.0;

/// The choices that a reader has. The defaults are right for most files.
struct MapReading {
  ImageMapOptions image;                         ///< for pictures
  UnknownCells unknown = UnknownCells::blocked;  ///< for ROS maps
  /// For files of numbers: the one that is the obstacle. Nothing: see number_cells.hpp.
  std::optional<double> occupied = std::nullopt;
  /// For height maps, and for pictures that are to be read as one: bright is high, and ImageMapOptions::invert turns
  /// that round. Nothing: a picture is a map of the plane.
  std::optional<HeightReading> heights = std::nullopt;
  friend bool operator==(const MapReading&, const MapReading&) = default;
};

/// What was found when a map was read and is not part of it: any two are equal.
struct MapFindings {
  /// What stands in the file and could not be kept, and what was taken for granted, a sentence each.
  std::vector<std::string> notes = {};
  /// Which cells the file calls unknown, one for each; nothing: none of them.
  std::shared_ptr<const std::vector<bool>> unknown = nullptr;
  std::uint8_t unknown_as = kObstacle;  ///< what these were read as
  std::vector<double> numbers = {};     ///< where the cells are numbers: those there are, the smallest first
  std::optional<HeightRange> heights =
      std::nullopt;  ///< of a height map: from its deepest to its highest place

  /// Whether a cell is unknown still: nobody has made it anything else since.
  [[nodiscard]] bool is_unknown(const GridMap& map, std::size_t cell) const {
    return unknown != nullptr && cell < unknown->size() && (*unknown)[cell] &&
           map.blocked[cell] == unknown_as;
  }
  /// What somebody who is going to plan on the map is told: the notes, and how many unknown cells count as blocked.
  [[nodiscard]] std::vector<std::string> notes_for_planning() const;
  friend bool operator==(const MapFindings&, const MapFindings&) { return true; }
};

/// What a map file holds.
struct MapFile {
  GridMap map;
  std::optional<Cell> start = std::nullopt;  ///< where the format has them
  std::optional<Cell> goal = std::nullopt;
  MapFindings found = {};

  friend bool operator==(const MapFile&, const MapFile&) = default;
};

}  // namespace replan
