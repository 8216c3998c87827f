// Which cells a brush, a line and a filled region cover.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/cell.hpp"

namespace replan {

/// A run of cells in one row, both ends included.
struct CellSpan {
  int y = 0;
  int first = 0;
  int last = 0;
  friend bool operator==(const CellSpan&, const CellSpan&) = default;
};

/// What a stroke is drawn with.
struct Brush {
  int side = 1;  ///< cells, at least 1
  bool round = false;
  friend bool operator==(const Brush&, const Brush&) = default;
};

/// The rows of the brush with its middle at a cell; with an even side its middle lies between cells, and it
/// reaches one cell farther to the right and down. They may lie outside any world.
std::vector<CellSpan> brush_spans(const Brush& brush, Cell at);
/// The rows of a straight stroke of the brush between two cells, from the top down, one span each.
std::vector<CellSpan> stroke_spans(const Brush& brush, Cell from, Cell to);
/// The rows of the rectangle with these two corners.
std::vector<CellSpan> rectangle_spans(Cell a, Cell b);

/// How many cells spans have that do not overlap.
std::size_t count_cells(std::span<const CellSpan> spans);

/// The cells that can be reached from `from` by straight steps over cells for which `same(cell)` holds, as
/// runs that are as long as they can be. Works row by row: the cost is that of the region. If there are more than
/// `enough`, some of them, but more than that.
template <class Same>
std::vector<CellSpan> connected_spans(int width, int height, Cell from, const Same& same,
                                      std::size_t enough = SIZE_MAX) {
  std::vector<CellSpan> region;
  std::size_t count = 0;
  std::vector<std::uint8_t> taken(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const auto open = [&](int x, int y) {
    return taken[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)] == 0 &&
           same(Cell{x, y});
  };
  const auto take = [&](int x, int y) {
    CellSpan span{y, x, x};
    while (span.first > 0 && open(span.first - 1, y)) --span.first;
    while (span.last + 1 < width && open(span.last + 1, y)) ++span.last;
    for (int i = span.first; i <= span.last; ++i)
      taken[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)] = 1;
    region.push_back(span);
    count += static_cast<std::size_t>(span.last - span.first) + 1;
  };
  if (from.x < 0 || from.y < 0 || from.x >= width || from.y >= height || !same(from)) return region;
  take(from.x, from.y);
  for (std::size_t i = 0; i < region.size() && count <= enough; ++i) {
    const CellSpan span = region[i];
    for (const int y : {span.y - 1, span.y + 1}) {
      if (y < 0 || y >= height) continue;
      for (int x = span.first; x <= span.last; ++x)
        if (open(x, y)) take(x, y);
    }
  }
  return region;
}

/// The cells of a straight line between two cells (Bresenham), each next to the one before; in space too.
std::vector<Cell> line_cells(Cell from, Cell to);

}  // namespace replan
