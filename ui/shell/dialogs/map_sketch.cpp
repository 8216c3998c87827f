#include "ui/shell/dialogs/map_sketch.hpp"

#include <algorithm>
#include <cmath>

namespace replan::ui {

MapSketch::MapSketch(const GridMap& map, int side)
    : columns_(std::min(map.width, side)), rows_(std::min(map.height, side)) {
  const auto begin = [](int point, int cells, int points) {
    return static_cast<int>(std::int64_t{point} * cells / points);
  };
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const int left = begin(column, map.width, columns_), right = begin(column + 1, map.width, columns_),
                top = begin(row, map.height, rows_), bottom = begin(row + 1, map.height, rows_);
      int walls = 0;
      for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) walls += map.at({x, y}) ? 1 : 0;
      const int cells = (right - left) * (bottom - top);
      walls_.push_back(static_cast<std::uint8_t>((walls * 16 + cells - 1) / cells));
    }
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
