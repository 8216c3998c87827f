// Arrays as numpy saves them (`.npy`): two dimensions of booleans or whole numbers, a number a cell.
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

/// Reads an array of shape (rows, columns) of type bool, int8 to int64 or uint8 to uint64, in either byte
/// order, in C's or Fortran's order of cells. number_cells.hpp says which number is the obstacle if not
/// `occupied`. What is not exactly such a file is an error that says how to save one; a shape of more than
/// kMaxCells is refused before memory is taken for it.
Result<MapFile> parse_npy_map(std::string_view bytes, const std::string& origin,
                              std::optional<double> occupied = {});
/// As parse_npy_map() from a file.
Result<MapFile> read_npy_map(const std::string& path, std::optional<double> occupied = {});

}  // namespace replan
