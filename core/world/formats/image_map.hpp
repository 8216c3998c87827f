// Maps from and to pictures: a pixel is a cell, dark is an obstacle.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/formats/picture.hpp"
#include "core/world/grid_map.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

/// The picture's pixels as cells.
GridMap image_cells(const Picture& picture, const ImageMapOptions& options = {});
/// Reads a picture (PNG, BMP, JPEG, TGA, PGM, PPM) as a map; decode_picture() says what is refused. The error
/// names the file and the reason.
Result<GridMap> read_image_map(const std::string& path, const ImageMapOptions& options = {});
/// As read_image_map() from a picture's bytes; `origin` names it in errors.
Result<GridMap> decode_image_map(std::string_view bytes, const std::string& origin,
                                 const ImageMapOptions& options = {});
/// Writes the map as a grey picture, obstacles black and free cells white, atomically. The name's end tells
/// the format: .png, .bmp, .tga or .pgm.
Result<void> write_image_map(const GridMap& map, const std::string& path);

}  // namespace replan
