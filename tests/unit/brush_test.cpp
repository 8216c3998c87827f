// Which cells brushes, lines and fills cover.
#include "core/world/brush.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/world/grid_map.hpp"

namespace replan::brush_test {
namespace {

std::set<std::pair<int, int>> cells_of(const std::vector<CellSpan>& spans) {
  std::set<std::pair<int, int>> cells;
  for (const CellSpan& span : spans)
    for (int x = span.first; x <= span.last; ++x) EXPECT_TRUE(cells.emplace(x, span.y).second);
  return cells;
}

TEST(Brush, ASquareHasItsMiddleAtTheCell) {
  EXPECT_EQ(brush_spans({1, false}, {5, 7}), (std::vector<CellSpan>{{7, 5, 5}}));
  EXPECT_EQ(brush_spans({3, false}, {5, 7}), (std::vector<CellSpan>{{6, 4, 6}, {7, 4, 6}, {8, 4, 6}}));
  EXPECT_EQ(brush_spans({2, false}, {5, 7}), (std::vector<CellSpan>{{7, 5, 6}, {8, 5, 6}}));
}

TEST(Brush, RoundOnesAreDiscs) {
  EXPECT_EQ(brush_spans({1, true}, {0, 0}), (std::vector<CellSpan>{{0, 0, 0}}));
  EXPECT_EQ(brush_spans({3, true}, {0, 0}), (std::vector<CellSpan>{{-1, 0, 0}, {0, -1, 1}, {1, 0, 0}}));
  EXPECT_EQ(brush_spans({4, true}, {1, 1}),
            (std::vector<CellSpan>{{0, 1, 2}, {1, 0, 3}, {2, 0, 3}, {3, 1, 2}}));
  for (int side = 1; side <= 64; ++side) {
    const auto cells = cells_of(brush_spans({side, true}, {100, 100}));
    const double area = 3.14159265 * side * side / 4;
    EXPECT_NEAR(static_cast<double>(cells.size()), area, side + 1.0) << side;
    // The same from all four sides.
    const int low = 100 - (side - 1) / 2, twice = 2 * low + side - 1;
    for (const auto& [x, y] : cells) {
      EXPECT_TRUE(cells.contains({twice - x, y}) && cells.contains({x, twice - y}) && cells.contains({y, x}));
    }
  }
}

TEST(Brush, ALineJoinsItsEnds) {
  for (const Cell to : {Cell{9, 0}, Cell{9, 4}, Cell{-7, 3}, Cell{0, -6}, Cell{-5, -5}, Cell{0, 0}}) {
    const std::vector<Cell> line = line_cells({0, 0}, to);
    EXPECT_EQ(line.front(), (Cell{0, 0}));
    EXPECT_EQ(line.back(), to);
    for (std::size_t i = 1; i < line.size(); ++i) {
      EXPECT_LE(std::abs(line[i].x - line[i - 1].x), 1);
      EXPECT_LE(std::abs(line[i].y - line[i - 1].y), 1);
    }
  }
}

TEST(Brush, AStrokeIsTheBrushAtEveryCellOfItsLine) {
  for (const Brush brush : {Brush{1, false}, Brush{5, true}, Brush{4, false}, Brush{8, true}})
    for (const Cell to : {Cell{20, 7}, Cell{3, 12}, Cell{-9, 9}, Cell{0, 0}}) {
      std::set<std::pair<int, int>> wanted;
      for (const Cell at : line_cells({0, 0}, to))
        for (const CellSpan& span : brush_spans(brush, at))
          for (int x = span.first; x <= span.last; ++x) wanted.emplace(x, span.y);
      EXPECT_EQ(cells_of(stroke_spans(brush, {0, 0}, to)), wanted) << brush.side << " to " << to.x;
    }
}

TEST(Fill, TakesTheConnectedRegionAndNoMore) {
  // Two rooms that touch at a corner only, and a winding corridor in the right one.
  const std::vector<std::string> rows = {
      "...@....", "...@.@@.", "@@@..@..", "..@.@@.@", "..@....@",
  };
  GridMap map(8, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 8; ++x)
      map.set({x, y}, rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '@');
  const auto region = [&](Cell from) {
    const bool wall = map.at(from);
    return cells_of(connected_spans(8, 5, from, [&](Cell cell) { return map.at(cell) == wall; }));
  };
  EXPECT_EQ(region({1, 1}).size(), 6u);
  EXPECT_EQ(region({0, 4}).size(), 4u);
  const auto winding = region({4, 0});
  EXPECT_EQ(winding.size(), 4u + 2u + 4u + 2u + 4u);
  EXPECT_TRUE(winding.contains({6, 3}) && winding.contains({7, 2}));
  EXPECT_FALSE(winding.contains({0, 4}));
  EXPECT_EQ(region({7, 3}).size(), 2u);  // an obstacle: what is joined to it by sides
  EXPECT_TRUE(connected_spans(8, 5, {8, 0}, [](Cell) { return true; }).empty());
}

TEST(Fill, CoversAnOpenWorldInAsManySpansAsRows) {
  const auto spans = connected_spans(500, 300, {250, 150}, [](Cell) { return true; });
  EXPECT_EQ(spans.size(), 300u);
  EXPECT_EQ(cells_of(spans).size(), 150000u);
}

TEST(Fill, GivesUpOnceItHasEnough) {
  const auto anywhere = [](Cell) { return true; };
  const std::size_t some = count_cells(connected_spans(500, 300, {250, 150}, anywhere, 5000));
  EXPECT_GT(some, 5000u);
  EXPECT_LT(some, 10000u);
  EXPECT_EQ(count_cells(connected_spans(500, 300, {250, 150}, anywhere, 150000)), 150000u);
}

}  // namespace
}  // namespace replan::brush_test
