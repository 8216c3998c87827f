// What is shown of a world before it is opened: a small picture and its facts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/stop.hpp"
#include "core/world/map_reading.hpp"
#include "core/world/scenario.hpp"
#include "ui/theme.hpp"

namespace replan::ui {

/// A world seen from afar, without colours, so that it fits any theme.
struct Thumbnail {
  int width = 0;  ///< pixels; one for each cell if the world is small enough
  int height = 0;
  std::vector<std::uint8_t> walls;  ///< row by row: how much of the pixel's cells are obstacles, 0 to 255
  std::optional<Cell> start, goal;  ///< in pixels
};

/// The most pixels of a thumbnail's longer side.
inline constexpr int kThumbnailSide = 384;

/// Shrinks a world to at most `side` pixels each way; each pixel tells of all of its cells.
Thumbnail thumbnail_of(const GridMap& map, std::optional<Cell> start, std::optional<Cell> goal,
                       int side = kThumbnailSide);
/// Its pixels as a texture takes them. Start and goal are not in it: they are drawn over it, at the size of
/// the screen.
std::vector<std::uint32_t> coloured(const Thumbnail& thumbnail, const Theme& theme);

struct Preview {
  std::string error;  ///< why there is nothing to be seen; else empty
  std::string name, caption;
  int width = 0, height = 0, depth = 1;
  std::size_t obstacles = 0;
  double resolution = 1;
  std::vector<std::string> planners;   ///< their names
  std::vector<std::string> notes;      ///< what the reader has to say
  std::vector<double> numbers;         ///< where the cells are numbers: those there are
  std::optional<HeightRange> heights;  ///< of a height map: from its deepest to its highest place
  Thumbnail thumbnail;
};

/// The largest file that a preview reads.
inline constexpr std::uint64_t kMostPreviewBytes = 48u << 20;

/// Reads a scenario or a map for its preview. Slow for large files: not for the drawing thread.
Preview make_preview(const std::string& path, const MapReading& reading, const StopToken& stop);

/// Of an experiment, or of a file in a folder of results: no world, and opened it is shown in Run > Batch.
Preview preview_of_batch(const std::string& path);

}  // namespace replan::ui
