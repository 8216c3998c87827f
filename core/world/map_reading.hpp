// How a map file is to be read, and what comes of it: shared by the readers of all formats.
#pragma once

#include <cstdint>
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

/// The choices that a reader has. The defaults are right for most files.
struct MapReading {
  ImageMapOptions image;                         ///< for pictures
  UnknownCells unknown = UnknownCells::blocked;  ///< for ROS maps
  friend bool operator==(const MapReading&, const MapReading&) = default;
};

/// What a map file holds.
struct MapFile {
  GridMap map;
  std::optional<Cell> start;  ///< where the format has them
  std::optional<Cell> goal;
  /// What stands in the file and could not be kept, a sentence each. Not part of the map: two files are equal
  /// if their maps and ends are.
  std::vector<std::string> notes = {};

  friend bool operator==(const MapFile& a, const MapFile& b) {
    return a.map == b.map && a.start == b.start && a.goal == b.goal;
  }
};

}  // namespace replan
