// Heights of a floor, column by column, made into a world of layers: sea floors and terrain.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/world/map_reading.hpp"

namespace replan {

/// A height for each column of a world, row 0 at the back (north, in a map); kNoHeight where there is none.
struct HeightGrid {
  int width = 0;
  int height = 0;
  std::vector<float> heights;
  std::vector<std::string> notes = {};  ///< what the file says and the world does not keep

  static constexpr float kNoHeight = std::numeric_limits<float>::infinity();
  [[nodiscard]] float at(int x, int y) const {
    return heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  }
};

/// The world over that floor, layer 0 at the bottom: a voxel is an obstacle where the floor reaches into it, the
/// higher ones are free. Columns without a height are obstacles in all layers. The findings tell between which heights
/// those of the grid and the layers lie, how many columns were read as one, and how many of the world's stick out of the
/// layers or have no height. The error begins with `origin`.
Result<MapFile> world_over(HeightGrid grid, const HeightReading& reading, const std::string& origin);

}  // namespace replan
