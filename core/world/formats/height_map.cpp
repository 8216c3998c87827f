#include "core/world/formats/height_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/words.hpp"
#include "core/world/json_reader.hpp"

namespace replan {
namespace {

/// With two places after the point, and where that leaves less, with two digits: "95.84", "0.0031".
std::string height_text(double height) {
  const double size = std::abs(height);
  const int places = size > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(size))), 2, 300) : 2;
  const double parts = std::pow(10.0, places);
  return plain_number(std::round(height * parts) / parts).dump();
}

int blocks_of(int cells, int side) {
  return (cells + side - 1) / side;
}

/// The smallest number of columns each way that have to be one, if a world is to have room for them.
int fitting_reduction(const HeightGrid& grid, int layers) {
  int side = 1;
  while (std::int64_t{blocks_of(grid.width, side)} * blocks_of(grid.height, side) * layers > kMaxVoxels)
    ++side;
  return side;
}

/// Blocks of `side` columns each way as one column each, as high as the highest in it that has a height; only a block
/// without any has none.
HeightGrid reduced(const HeightGrid& grid, int side) {
  HeightGrid small{blocks_of(grid.width, side), blocks_of(grid.height, side), {}, grid.notes};
  small.heights.reserve(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  for (int row = 0; row < small.height; ++row)
    for (int column = 0; column < small.width; ++column) {
      std::optional<float> highest;
      for (int y = row * side; y < std::min(grid.height, (row + 1) * side); ++y)
        for (int x = column * side; x < std::min(grid.width, (column + 1) * side); ++x)
          if (const float height = grid.at(x, y); height != HeightGrid::kNoHeight)
            highest = std::max(highest.value_or(height), height);
      small.heights.push_back(highest.value_or(HeightGrid::kNoHeight));
    }
  return small;
}

/// The deepest and the highest place; nothing if no column has a height.
std::optional<HeightRange> extremes(const HeightGrid& grid) {
  std::optional<HeightRange> range;
  for (const float height : grid.heights) {
    if (height == HeightGrid::kNoHeight) continue;
    if (!range) range = HeightRange{height, height};
    range->low = std::min<double>(range->low, height);
    range->high = std::max<double>(range->high, height);
  }
  return range;
}

/// Where the layers lie, by what was asked for and what there is.
Result<HeightRange> range_of(const HeightRange& found, const HeightReading& reading,
                             const std::string& origin) {
  const double top = found.low < 0 ? 0 : found.high;
  const HeightRange range{reading.low.value_or(found.low), reading.high.value_or(top)};
  if (range.low < range.high) return range;
  const std::string low = plain_number(range.low).dump(), high = plain_number(range.high).dump();
  return Error{origin + ": no layers fit between the heights " + low + " and " + high + ": give " +
               (reading.low && reading.high ? "a lowest height that is below the highest"
                : reading.low               ? "a lowest height below " + high + ", or a highest above " + low
                : reading.high              ? "a highest height above " + low + ", or a lowest below " + high
                                            : "a lowest and a highest height")};
}

/// How many layers of a column the floor reaches into.
int layers_below(float height, const HeightRange& range, int layers) {
  if (height == HeightGrid::kNoHeight) return layers;
  const double reach = std::ceil((height - range.low) * layers / (range.high - range.low));
  return static_cast<int>(std::clamp(reach, 0.0, static_cast<double>(layers)));
}

GridMap filled(const HeightGrid& grid, const HeightRange& range, int layers) {
  GridMap map(grid.width, grid.height, layers);
  std::vector<std::uint8_t> cells(map.blocked.size(), kFree);
  const std::size_t columns = grid.heights.size();
  std::vector<int> reach(columns);
  for (std::size_t column = 0; column < columns; ++column)
    reach[column] = layers_below(grid.heights[column], range, layers);
  for (int z = 0; z < layers; ++z)
    for (std::size_t column = 0; column < columns; ++column)
      if (z < reach[column]) cells[static_cast<std::size_t>(z) * columns + column] = kObstacle;
  map.blocked = cells;
  return map;
}

/// What the reader took for granted, a sentence each: what the file has, and what came of it in the columns of the world.
std::vector<std::string> notes_of(const HeightGrid& grid, const HeightRange& found, const HeightRange& range,
                                  int layers, int side) {
  std::vector<std::string> notes;
  if (side > 1)
    notes.push_back(
        "every " + std::to_string(side) + " x " + std::to_string(side) +
        " columns of the file are one of the world, as high as the highest of them, and without a "
        "height only if none of them has one");
  notes.push_back("heights go from " + height_text(found.low) + " to " + height_text(found.high) + "; the " +
                  std::to_string(layers) + " layers reach from " + height_text(range.low) + " up to " +
                  height_text(range.high) + ", " + height_text((range.high - range.low) / layers) + " each");
  const auto columns = [side](std::int64_t count) {
    return counted(count, "column") + (side > 1 ? " of the world" : "");
  };
  const auto above = std::count_if(grid.heights.begin(), grid.heights.end(), [&](float height) {
    return height != HeightGrid::kNoHeight && height > range.high;
  });
  if (above > 0)
    notes.push_back(columns(above) + (above == 1 ? " rises" : " rise") + " above " + height_text(range.high) +
                    (above == 1 ? " and is an obstacle" : " and are obstacles") + " in all layers");
  const auto none = std::count(grid.heights.begin(), grid.heights.end(), HeightGrid::kNoHeight);
  if (none > 0)
    notes.push_back(columns(none) +
                    (none == 1 ? " has no height and is an obstacle" : " have no height and are obstacles") +
                    " in all layers");
  notes.insert(notes.end(), grid.notes.begin(), grid.notes.end());
  return notes;
}

}  // namespace

Result<MapFile> world_over(HeightGrid grid, const HeightReading& reading, const std::string& origin) {
  const int least = fitting_reduction(grid, reading.layers);
  const int side = reading.reduce == 0 ? least : reading.reduce;
  if (side < least)
    return Error{origin + ": " + std::to_string(grid.width) + " x " + std::to_string(grid.height) +
                 " columns in " + std::to_string(reading.layers) + " layers are more than " +
                 std::to_string(kMaxVoxels) + " voxels: give fewer layers, or let every " +
                 std::to_string(least) + " columns each way be one"};
  const auto found = extremes(grid);
  if (!found)
    return Error{
        origin +
        ": no column has a height, since every number in it stands for no data: mend NODATA_value in "
        "its header (-9999 if that says nothing), or take another file"};
  if (side > 1) grid = reduced(grid, side);
  const auto range = range_of(*found, reading, origin);
  if (!range) return Error{range.error()};
  MapFile file{filled(grid, *range, reading.layers)};
  file.found.heights = *found;
  file.found.notes = notes_of(grid, *found, *range, reading.layers, side);
  return file;
}

}  // namespace replan
