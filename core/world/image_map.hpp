// Maps from and to pictures: a pixel is a cell, dark is an obstacle.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// How pixels become cells. Colours count by their brightness, seen on a white ground where they are
/// transparent.
struct ImageMapOptions {
  int threshold = 128;  ///< brightness 0..255; darker than this is an obstacle (1..255 part anything at all)
  bool invert = false;  ///< brighter is an obstacle instead
};

/// Reads a picture (PNG, BMP, JPEG, PGM, PPM) as a map. A picture of more than kMaxCells pixels is refused
/// before it is decoded. The error names the file and the reason.
Result<GridMap> read_image_map(const std::string& path, const ImageMapOptions& options = {});
/// As read_image_map() from a picture's bytes; `origin` names it in errors.
Result<GridMap> decode_image_map(std::string_view bytes, const std::string& origin,
                                 const ImageMapOptions& options = {});
/// Writes the map as a grey PNG, obstacles black and free cells white, atomically.
Result<void> write_map_png(const GridMap& map, const std::string& path);

}  // namespace replan
