#include "ui/shell/dialogs/map_sketch.hpp"

#include <algorithm>
#include <cmath>

namespace replan::ui {

namespace {

/// In which of so many points each of the cells of a row lies.
std::vector<int> points_of(int cells, int points) {
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(cells));
  for (int point = 0; point < points; ++point)
    result.resize(static_cast<std::size_t>(std::int64_t{point + 1} * cells / points), point);
  return result;
}

}  // namespace

MapSketch::MapSketch(const GridMap& map, Axis along, int side) {
  const bool from_above = along == Axis::z;
  const int seen_rows = from_above ? map.height : map.depth;
  columns_ = std::min(map.width, side);
  rows_ = std::min(seen_rows, side);
  const std::vector<int> column_of = points_of(map.width, columns_), row_of = points_of(seen_rows, rows_);
  std::vector<std::int64_t> cells(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      walls(cells.size());
  auto cell = map.blocked.begin();
  for (int z = 0; z < map.depth; ++z)
    for (int y = 0; y < map.height; ++y) {
      const int row = row_of[static_cast<std::size_t>(from_above ? y : map.depth - 1 - z)];
      const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
      for (int x = 0; x < map.width; ++x, ++cell) {
        const std::size_t point = first + static_cast<std::size_t>(column_of[static_cast<std::size_t>(x)]);
        ++cells[point];
        walls[point] += *cell != kFree ? 1 : 0;
      }
    }
  walls_.reserve(cells.size());
  for (std::size_t point = 0; point < cells.size(); ++point)
    walls_.push_back(static_cast<std::uint8_t>((walls[point] * 16 + cells[point] - 1) / cells[point]));
}

void MapSketch::draw(const Look& look, ImDrawList& list, ImVec2 min, ImVec2 max) const {
  list.AddRectFilled(min, max, look.theme.free);
  const auto edge = [](float low, float high, int at, int count) {
    return std::floor(low + (high - low) * static_cast<float>(at) / static_cast<float>(count));
  };
  for (int row = 0; row < rows_; ++row) {
    const std::uint8_t* walls = &walls_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)];
    const float top = edge(min.y, max.y, row, rows_), bottom = edge(min.y, max.y, row + 1, rows_);
    for (int column = 0, end = 0; column < columns_; column = end) {
      for (end = column + 1; end < columns_ && walls[end] == walls[column];) ++end;
      if (walls[column] == 0) continue;
      list.AddRectFilled(
          {edge(min.x, max.x, column, columns_), top}, {edge(min.x, max.x, end, columns_), bottom},
          mix(look.theme.free, look.theme.obstacle, static_cast<float>(walls[column]) / 16.0f));
    }
  }
}

}  // namespace replan::ui
