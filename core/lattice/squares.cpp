#include "core/lattice/squares.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace replan {
namespace {

/// Floor and ceiling of a quotient; the divisor is positive.
std::int64_t floor_quotient(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}
std::int64_t ceiling_quotient(std::int64_t a, std::int64_t b) {
  return -floor_quotient(-a, b);
}

/// The part of a row of cells that a slanting segment passes through.
struct RowPart {
  int row, first, last;
  int corner = kNone;  ///< where it enters the row exactly at a corner of cells and inside the segment: its x
  static constexpr int kNone = -1;
};

/// Calls visit(part) for each row on the way down; it returns false to stop. Returns false if stopped.
template <class Visit>
bool each_row_part(HalfPoint a, HalfPoint b, Visit&& visit) {
  if (a.y > b.y) std::swap(a, b);
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  for (int row = static_cast<int>(floor_quotient(a.y, 2)); 2 * row < b.y; ++row) {
    // Where it enters and leaves the row, times dy.
    const std::int64_t top = std::max(2 * row, a.y), bottom = std::min(2 * row + 2, b.y);
    const std::int64_t enters = a.x * dy + (top - a.y) * dx, leaves = a.x * dy + (bottom - a.y) * dx;
    RowPart part{row, static_cast<int>(floor_quotient(std::min(enters, leaves), 2 * dy)),
                 static_cast<int>(ceiling_quotient(std::max(enters, leaves), 2 * dy)) - 1};
    if (top > a.y && top % 2 == 0 && enters % (2 * dy) == 0)
      part.corner = static_cast<int>(enters / (2 * dy));
    if (!visit(part)) return false;
  }
  return true;
}

/// The cells whose insides a slanting segment passes through, from a to b.
std::vector<Cell> cells_inside(HalfPoint a, HalfPoint b) {
  std::vector<Cell> cells;
  const bool down = b.y > a.y, backwards = (b.x < a.x) == down;
  each_row_part(a, b, [&](const RowPart& part) {
    for (int i = part.first; i <= part.last; ++i)
      cells.push_back({backwards ? part.last - (i - part.first) : i, part.row});
    return true;
  });
  if (!down) std::reverse(cells.begin(), cells.end());
  return cells;
}

}  // namespace

bool Squares::pinched(int x, int y) const {
  const bool a = blocked(x - 1, y - 1), b = blocked(x, y - 1), c = blocked(x - 1, y), d = blocked(x, y);
  return (a && d && !b && !c) || (b && c && !a && !d);
}

/// Along a row or a column: through cells, or on a grid line with one of the cells beside it free.
bool Squares::clear_along_axis(HalfPoint a, HalfPoint b, CornerRule corners) const {
  const bool across = a.y == b.y;
  const int low = across ? std::min(a.x, b.x) : std::min(a.y, b.y);
  const int high = across ? std::max(a.x, b.x) : std::max(a.y, b.y);
  const int line = across ? a.y : a.x;
  const auto is_blocked = [&](int along, int beside) {
    return across ? blocked(along, beside) : blocked(beside, along);
  };
  const bool on_line = line % 2 == 0;
  for (int cell = low / 2; 2 * cell < high; ++cell) {
    const bool shut = on_line ? is_blocked(cell, line / 2 - 1) && is_blocked(cell, line / 2)
                              : is_blocked(cell, (line - 1) / 2);
    if (shut) return false;
    const bool inner = on_line && 2 * cell > low;
    if (inner && corners != CornerRule::any && (across ? pinched(cell, line / 2) : pinched(line / 2, cell)))
      return false;
  }
  return true;
}

// The cells of each row that the segment's open part passes through; then the corners on it.
bool Squares::clear(HalfPoint a, HalfPoint b, CornerRule corners) const {
  if (a == b) return true;
  if (a.x == b.x || a.y == b.y) return clear_along_axis(a, b, corners);
  return each_row_part(a, b, [&](const RowPart& part) {
    for (int x = part.first; x <= part.last; ++x)
      if (blocked(x, part.row)) return false;
    return part.corner == RowPart::kNone || corners == CornerRule::any || !pinched(part.corner, part.row);
  });
}

/// Along a row or a column. On a grid line on that side of it which is free, and where both are, on the one that the
/// robot is on.
std::vector<Cell> Squares::cells_along_line(HalfPoint a, HalfPoint b, Cell in) const {
  const bool across = a.y == b.y;
  const int from = across ? a.x : a.y, to = across ? b.x : b.y, line = across ? a.y : a.x;
  const int step = to > from ? 1 : -1,
            first = static_cast<int>(floor_quotient(step > 0 ? from : from - 1, 2));
  const auto cell = [across](int along, int beside) {
    return across ? Cell{along, beside} : Cell{beside, along};
  };
  std::vector<Cell> cells;
  int side = across ? in.y : in.x;
  if (line % 2 != 0) side = (line - 1) / 2;
  for (int along = first; step > 0 ? 2 * along < to : 2 * along + 2 > to; along += step) {
    if (line % 2 == 0) {
      const auto is_free = [&](int beside) {
        const Cell at = cell(along, beside);
        return !blocked(at.x, at.y);
      };
      const int other = line - 1 - side;  // line / 2 - 1 and line / 2 make up line - 1
      if (!is_free(side)) side = other;
    }
    cells.push_back(cell(along, side));
  }
  return cells;
}

std::vector<Cell> Squares::cells_along(HalfPoint a, HalfPoint b, Cell in) const {
  std::vector<Cell> cells;
  const auto go_to = [&](Cell next) {
    if (next == in) return;
    if (next.x != in.x && next.y != in.y) {
      const Cell beside[] = {{next.x, in.y}, {in.x, next.y}};
      const bool one = !blocked(beside[0].x, beside[0].y), other = !blocked(beside[1].x, beside[1].y);
      if (one != other) cells.push_back(one ? beside[0] : beside[1]);
    }
    cells.push_back(in = next);
  };
  if (a == b) return cells;
  for (const Cell next : a.x == b.x || a.y == b.y ? cells_along_line(a, b, in) : cells_inside(a, b))
    go_to(next);
  return cells;
}

}  // namespace replan
