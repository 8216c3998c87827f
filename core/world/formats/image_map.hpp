// Maps from and to pictures: a pixel is a cell, dark is an obstacle; or it is a column, bright is high.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/formats/height_map.hpp"
#include "core/world/formats/picture.hpp"
#include "core/world/grid_map.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

/// The picture's pixels as cells.
GridMap image_cells(const Picture& picture, const ImageMapOptions& options = {});
/// The picture's pixels as heights, 0 for black to 255 for white, or the other way round if `invert`.
HeightGrid image_heights(const DeepPicture& picture, bool invert = false);
/// The world of layers over the floor that a picture shows: see world_over().
Result<MapFile> read_height_picture(const std::string& path, const HeightReading& reading,
                                    bool invert = false);
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
