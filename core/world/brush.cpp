#include "core/world/brush.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace replan {
std::vector<CellSpan> brush_spans(const Brush& brush, Cell at) {
  const int before = (brush.side - 1) / 2;
  const double middle = (brush.side - 1) / 2.0;
  // A quarter of a cell less than half its side, so that small brushes come out round too.
  const double radius = brush.side / 2.0 - 0.25;
  std::vector<CellSpan> spans;
  for (int row = 0; row < brush.side; ++row) {
    const double reach = brush.round ? std::sqrt(radius * radius - (row - middle) * (row - middle)) : middle;
    const int first = static_cast<int>(std::ceil(middle - reach - 1e-9));
    spans.push_back({at.y - before + row, at.x - before + first, at.x - before + brush.side - 1 - first});
  }
  return spans;
}

std::vector<CellSpan> stroke_spans(const Brush& brush, Cell from, Cell to) {
  const std::vector<CellSpan> tip = brush_spans(brush, {0, 0});
  const int top = std::min(from.y, to.y) + tip.front().y, bottom = std::max(from.y, to.y) + tip.back().y;
  std::vector<CellSpan> spans;
  for (int y = top; y <= bottom; ++y) spans.push_back({y, 1, 0});  // empty yet
  // The tip is one piece and moves by one cell at a time, so that each row stays in one piece.
  for (const Cell at : line_cells(from, to))
    for (const CellSpan& row : tip) {
      CellSpan& span = spans[static_cast<std::size_t>(at.y + row.y - top)];
      const bool empty = span.first > span.last;
      span.first = empty ? at.x + row.first : std::min(span.first, at.x + row.first);
      span.last = empty ? at.x + row.last : std::max(span.last, at.x + row.last);
    }
  return spans;
}

std::size_t count_cells(std::span<const CellSpan> spans) {
  std::size_t count = 0;
  for (const CellSpan& span : spans) count += static_cast<std::size_t>(span.last - span.first) + 1;
  return count;
}

std::vector<CellSpan> rectangle_spans(Cell a, Cell b) {
  std::vector<CellSpan> spans;
  for (int y = std::min(a.y, b.y); y <= std::max(a.y, b.y); ++y)
    spans.push_back({y, std::min(a.x, b.x), std::max(a.x, b.x)});
  return spans;
}

std::vector<Cell> line_cells(Cell from, Cell to) {
  const int dx = to.x - from.x, dy = to.y - from.y, dz = to.z - from.z;
  const int steps = std::max({std::abs(dx), std::abs(dy), std::abs(dz)});
  // In whole numbers: halves are rounded up, whichever machine it is.
  const auto between = [steps](int start, int whole, int i) {
    const std::int64_t twice = std::int64_t{2} * whole * i + steps;
    const std::int64_t floor = twice >= 0 ? twice / (2 * steps) : -((-twice + 2 * steps - 1) / (2 * steps));
    return start + static_cast<int>(floor);
  };
  std::vector<Cell> cells = {from};
  for (int i = 1; i <= steps; ++i)
    cells.push_back({between(from.x, dx, i), between(from.y, dy, i), between(from.z, dz, i)});
  return cells;
}

}  // namespace replan
