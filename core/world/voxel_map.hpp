// Maps and problems in three dimensions: the Moving AI Lab's `.3dmap` and `.3dscen`. D. Brewer and
// N. R. Sturtevant, "Benchmarks for Pathfinding in 3D Voxel Space", SoCS 2018.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/cell.hpp"
#include "core/base/result.hpp"
#include "core/world/grid_map.hpp"
#include "core/world/movingai.hpp"

namespace replan {

/// A box of voxels, row-major: x runs fastest, then y, then z, as in the lattice Voxel3.
struct VoxelMap {
  int width = 0;                      ///< along x
  int height = 0;                     ///< along y
  int depth = 0;                      ///< along z
  std::vector<std::uint8_t> blocked;  ///< nonzero = obstacle

  VoxelMap() = default;
  /// An all-free box.
  VoxelMap(int along_x, int along_y, int along_z)
      : width(along_x),
        height(along_y),
        depth(along_z),
        blocked(static_cast<std::size_t>(along_x) * static_cast<std::size_t>(along_y) *
                static_cast<std::size_t>(along_z)) {}

  [[nodiscard]] bool contains(Voxel v) const {
    return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < width && v.y < height && v.z < depth;
  }
  [[nodiscard]] std::size_t index(Voxel v) const {
    return (static_cast<std::size_t>(v.z) * static_cast<std::size_t>(height) +
            static_cast<std::size_t>(v.y)) *
               static_cast<std::size_t>(width) +
           static_cast<std::size_t>(v.x);
  }
  [[nodiscard]] bool at(Voxel v) const { return blocked[index(v)] != 0; }
  friend bool operator==(const VoxelMap&, const VoxelMap&) = default;
};

/// Reads a `.3dmap`. More than kMaxVoxels voxels are refused before memory is taken for them; a voxel outside
/// the box is an error that names the line.
Result<VoxelMap> read_voxel_map(const std::string& path);
/// As read_voxel_map() from text; `origin` names it in errors.
Result<VoxelMap> parse_voxel_map(std::string_view text, const std::string& origin);
/// The box as `.3dmap` text: its obstacles in the order of x, y, z, as the published files have them.
std::string voxel_map_text(const VoxelMap& map);
/// Writes a `.3dmap` atomically.
Result<void> write_voxel_map(const VoxelMap& map, const std::string& path);

/// The plane of all voxels with that z, as a map with the same x and y. The error names the range of z.
Result<GridMap> voxel_slice(const VoxelMap& map, int z);
/// A map as a box one voxel high.
VoxelMap voxels_of(const GridMap& map);

/// One problem of a `.3dscen` file.
struct VoxelProblem {
  int line = 0;  ///< in the file, from 1
  Voxel start;
  Voxel goal;
  double length = 0;          ///< optimal length, in voxels
  std::string printed;        ///< `length` as it stands in the file
  std::string printed_ratio;  ///< of the length to that of the empty box
};

/// A `.3dscen` file.
struct VoxelScen {
  std::string path;      ///< as opened; names the file in errors
  std::string map_name;  ///< as written in the file
  std::vector<VoxelProblem> problems;
  LengthFormat lengths;
};

/// Reads a `.3dscen` (version 1). Errors name file, line and what is wrong.
Result<VoxelScen> read_voxel_scen(const std::string& path);
/// As read_voxel_scen() from text; `origin` names it in errors.
Result<VoxelScen> parse_voxel_scen(std::string_view text, const std::string& origin);
/// The problems as `.3dscen` text, numbers as they were printed.
std::string voxel_scen_text(const VoxelScen& scen);
/// Checks that starts and goals lie in the box. The error names the line.
Result<void> check_scen_fits(const VoxelScen& scen, const VoxelMap& map, const std::string& map_path);

}  // namespace replan
