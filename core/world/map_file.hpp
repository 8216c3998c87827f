// Maps from and to files of any known format, told apart by the file name's extension.
#pragma once

#include <string>

#include "core/base/result.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// Reads a map: MovingAI `.map`, or a picture (`.png .bmp .jpg .jpeg .pgm .ppm`) with the default threshold.
Result<GridMap> read_map(const std::string& path);
/// Writes a map atomically: `.map` or `.png`.
Result<void> write_map(const GridMap& map, const std::string& path);

}  // namespace replan
