// ESRI ASCII grids (.asc): heights of the sea floor or of terrain as most sources of them hand them out. The format:
// https://desktop.arcgis.com/en/arcmap/latest/manage-data/raster-and-images/esri-ascii-raster-format.htm
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/formats/height_map.hpp"

namespace replan {

/// The heights of a grid: header lines `ncols`, `nrows`, `xllcorner` or `xllcenter`, `yllcorner` or `yllcenter`,
/// `cellsize` (or `dx` and `dy`), and perhaps `NODATA_value` (-9999 where it is missing), of any case and in any order,
/// then nrows x ncols numbers, the northernmost row first, wherever lines end. The error names `origin` and the line.
Result<HeightGrid> parse_esri_grid(std::string_view text, const std::string& origin);
/// The world of layers over the floor of a file: see world_over().
Result<MapFile> read_esri_grid(const std::string& path, const HeightReading& reading = {});

}  // namespace replan
