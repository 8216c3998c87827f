// Maps from and to files of any known format, told apart by the file name's extension.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/world/grid_map.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

struct Scenario;

/// A format of map files, how it is read and written, and what it can hold besides free cells and obstacles.
struct MapFormat {
  std::string_view extension;  ///< lower case, with its dot
  std::string_view name;       ///< "MovingAI map"
  Result<MapFile> (*read)(const std::string& path, const MapReading& reading) = nullptr;
  Result<void> (*write)(const MapFile& file, const std::string& path) = nullptr;  ///< nullptr: only read
  bool solid = false;       ///< holds more than one layer
  bool picture = false;     ///< MapReading::image applies
  bool heights = false;     ///< MapReading::heights applies
  bool unknown = false;     ///< MapReading::unknown applies
  bool numbers = false;     ///< MapReading::occupied applies
  bool resolution = false;  ///< holds resolution and origin
  bool unmapped = false;    ///< holds kUnmapped cells
  bool ends = false;        ///< holds start and goal
};

/// All formats of map files, in the order in which they are listed to a user.
std::span<const MapFormat> map_formats();
/// The format of a file by its name, or nullptr.
const MapFormat* find_map_format(std::string_view path);
/// What is done with a map's file.
enum class MapUse : std::uint8_t { read, write };
/// The extensions of the formats for that, as a text: ".map, .png or .yaml".
std::string map_extensions(MapUse use);

/// Reads a map with whatever its file holds. An option of `reading` that is not the default and has no
/// meaning for the format is an error.
Result<MapFile> read_map_file(const std::string& path, const MapReading& reading = {});
/// As read_map_file(), the map alone.
Result<GridMap> read_map(const std::string& path, const MapReading& reading = {});
/// Whether the options of `reading` have a meaning for a file of that name; the error names the one that has
/// not.
Result<void> check_reading(const std::string& path, const MapReading& reading);

/// Writes a map with start and goal where the format holds them, atomically. What gets lost is not said here:
/// see lost_in().
Result<void> write_map_file(const MapFile& file, const std::string& path);
/// Writes a map without start and goal.
Result<void> write_map(const GridMap& map, const std::string& path);

/// What a file with that extension (of a map format) cannot hold of a map, a sentence each: ".map
/// cannot hold the resolution (0.05 per cell)". Empty if the file would hold it all.
std::vector<std::string> lost_in(std::string_view extension, const MapFile& file);
/// As lost_in() for a scenario: its planners, surprises and so on as well. A scenario file (.json) holds all
/// but that cells were unknown in a map that is now inside it.
std::vector<std::string> lost_in(std::string_view extension, const Scenario& scenario);

}  // namespace replan
