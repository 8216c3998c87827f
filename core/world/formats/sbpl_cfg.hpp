// The environments of SBPL (`.cfg`): a grid of costs with start and end, in cells (nav2d) or as poses in
// metres (x, y, theta). https://github.com/sbpl/sbpl, env_examples/nav2d and nav3d.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

/// Reads a `.cfg`: words parted by blanks or line ends, the header in SBPL's order. A cost of at least
/// `obsthresh` is an obstacle; lower ones are free, and a note says how many of them are not 0, since all
/// cells cost the same here. Of an (x, y, theta) environment the grid is read, its cell size as resolution,
/// start and end as the cells that SBPL puts them in; a note says what is left out. The error names the line.
Result<MapFile> parse_sbpl_cfg(std::string_view text, const std::string& origin);
/// As parse_sbpl_cfg() from a file.
Result<MapFile> read_sbpl_cfg(const std::string& path);
/// The world as `.cfg` text, obstacles as 1; start and goal must be there.
std::string sbpl_cfg_text(const MapFile& world);
/// Writes a `.cfg` atomically. The format cannot do without start and goal: that they are missing is an
/// error.
Result<void> write_sbpl_cfg(const MapFile& world, const std::string& path);

}  // namespace replan
