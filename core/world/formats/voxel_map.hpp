// Maps and problems in three dimensions: the Moving AI Lab's `.3dmap` and `.3dscen`. D. Brewer and
// N. R. Sturtevant, "Benchmarks for Pathfinding in 3D Voxel Space", SoCS 2018.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/world/formats/movingai.hpp"
#include "core/world/grid_map.hpp"

namespace replan {

/// Reads a `.3dmap`. More than kMaxVoxels voxels are refused before memory is taken for them; a voxel outside
/// the box is an error that names the line.
Result<GridMap> read_voxel_map(const std::string& path);
/// As read_voxel_map() from text; `origin` names it in errors.
Result<GridMap> parse_voxel_map(std::string_view text, const std::string& origin);
/// The box as `.3dmap` text: its obstacles in the order of x, y, z, as the published files have them.
std::string voxel_map_text(const GridMap& map);
/// Writes a `.3dmap` atomically.
Result<void> write_voxel_map(const GridMap& map, const std::string& path);

/// The plane of all voxels with that z, as a map with the same x and y. The error names the range of z.
Result<GridMap> voxel_slice(const GridMap& map, int z);

/// Reads a `.3dscen` (version 1) from text; `origin` names it in errors.
Result<ScenFile> parse_voxel_scen(std::string_view text, const std::string& origin);

}  // namespace replan
