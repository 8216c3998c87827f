// Worlds as plain text: one letter a cell, start and goal in place, to paste into a report or a test; or a
// matrix of numbers as other programs print them. Not the MovingAI `.map`, where S is swamp and G is ground.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

/// Reads rows of cells. As letters: `.` `0` `-` `_` and the blank are free, `@` `#` `X` `x` `1` obstacles,
/// `?` an obstacle that nobody has mapped, `S` the start and `G` the goal (each at most once, on free cells).
/// As numbers, one digit a cell or parted (see text_cells.hpp), S and G among them: number_cells.hpp says
/// which number is the obstacle if not `occupied`. A note tells what parts the cells if something does.
///
/// A byte order mark and empty lines before and after are passed over. Empty lines between rows part layers, from z = 0
/// up. All rows must be equally long, and all layers equally high: what a short one lacks is not guessed at. The error names line and column.
Result<MapFile> parse_ascii_map(std::string_view text, const std::string& origin,
                                std::optional<double> occupied = {});
/// As parse_ascii_map() from a file.
Result<MapFile> read_ascii_map(const std::string& path, std::optional<double> occupied = {});

/// The world as text: `.` free, `@` obstacle, `?` unmapped, `S`, `G`; layers are parted by an empty line. An end that lies in an obstacle, and a
/// goal that is the start, does not show.
std::string ascii_text(const MapFile& world);
/// As ascii_text(), of a part: what of it lies on the map.
std::string ascii_text(const MapFile& world, const CellBox& part);

}  // namespace replan
