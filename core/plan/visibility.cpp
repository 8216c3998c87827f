#include "core/plan/visibility.hpp"

namespace replan {
namespace {

std::int64_t cross(HalfPoint a, HalfPoint b) {
  return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}

HalfPoint between(HalfPoint from, HalfPoint to) {
  return {to.x - from.x, to.y - from.y};
}

int sign_of(std::int64_t value) {
  return (value > 0) - (value < 0);
}

}  // namespace

void Visibility::look_at_map() {
  const Squares map = squares();
  corners_.clear();
  line_begins_.clear();
  for (int y = 0; y <= map.height(); ++y) {
    line_begins_.push_back(static_cast<std::uint32_t>(corners_.size()));
    for (int x = 0; x <= map.width(); ++x) add_corner(x, y);
  }
  line_begins_.push_back(static_cast<std::uint32_t>(corners_.size()));
  runs_.resize(lattice_.node_count());
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0, end = 0; x < map.width(); x = end + 1) {
      for (end = x; !map.blocked(end, y);) ++end;
      for (int cell = x; cell < end; ++cell) runs_[lattice_.node(Cell{cell, y})] = {x, end};
    }
}

/// If an obstacle has one there that ways can bend round.
void Visibility::add_corner(int x, int y) {
  const Squares map = squares();
  Corner corner{{2 * x, 2 * y}};
  int count = 0;
  for (const int qy : {-1, 1})
    for (const int qx : {-1, 1}) {
      if (!map.blocked(x + (qx - 1) / 2, y + (qy - 1) / 2)) continue;
      ++count;
      corner.quadrant_x = qx;
      corner.quadrant_y = qy;
    }
  if (count != 1 && count != 2) return;
  corner.twice = count == 2 && map.pinched(x, y);
  if (count == 1 || (corner.twice && lattice_.rules().corners == CornerRule::any)) corners_.push_back(corner);
}

std::uint32_t Visibility::corner_at(int x, int y) const {
  if (x < 0 || y < 0 || y > lattice_.height()) return kStart;
  const auto at = [this](int line) {
    return corners_.begin() + static_cast<std::ptrdiff_t>(line_begins_[static_cast<std::size_t>(line)]);
  };
  const auto begin = at(y), end = at(y + 1);
  const auto found =
      std::lower_bound(begin, end, 2 * x, [](const Corner& c, int at_x) { return c.at.x < at_x; });
  if (found == end || found->at.x != 2 * x) return kStart;
  return static_cast<std::uint32_t>(found - corners_.begin()) + kFirstCorner;
}

/// Of a corner the one across from its obstacle, or, between two obstacles, beside that.
Cell Visibility::cell_beside(std::uint32_t point) const {
  const HalfPoint p = at(point);
  if (point < kFirstCorner) return {p.x / 2, p.y / 2};
  const Corner& c = corners_[point - kFirstCorner];
  const int x = -c.quadrant_x, y = c.twice ? c.quadrant_y : -c.quadrant_y;
  return {p.x / 2 + (x - 1) / 2, p.y / 2 + (y - 1) / 2};
}

/// A start or goal in a pinch lies on its lower right side.
bool Visibility::may_leave(HalfPoint end, HalfPoint other) const {
  if (end.x % 2 != 0 || end.y % 2 != 0 || !squares().pinched(end.x / 2, end.y / 2)) return true;
  return other.x >= end.x && other.y >= end.y;
}

/// Whether a way from there can bend round the corner's obstacle: it does not head for it, nor come from beyond it.
bool Visibility::may_bend(HalfPoint from, const Corner& corner) {
  const HalfPoint way = between(from, corner.at);
  return sign_of(way.x) * corner.quadrant_x * sign_of(way.y) * corner.quadrant_y <= 0;
}

bool Visibility::bends_taut(std::uint32_t before, std::uint32_t corner, std::uint32_t to) const {
  if (corner < kFirstCorner) return true;
  const Corner& c = corners_[corner - kFirstCorner];
  const HalfPoint in = between(at(before), c.at), out = between(c.at, at(to));
  const HalfPoint obstacle{c.quadrant_x, c.quadrant_y};
  if (sign_of(out.x) * c.quadrant_x * sign_of(out.y) * c.quadrant_y > 0) return false;
  const int turn = sign_of(cross(in, out));
  return turn == 0 || c.twice || turn == sign_of(cross(in, obstacle));
}

bool Visibility::sees(std::uint32_t from, std::uint32_t to) const {
  const HalfPoint a = at(from), b = at(to);
  if ((from == kStart && !may_leave(a, b)) || (to == kGoal && !may_leave(b, a))) return false;
  return squares().clear(a, b, lattice_.rules().corners);
}

/// Of the grid line that the point itself lies on.
Visibility::SeenPart Visibility::seen_sideways(HalfPoint from) const {
  const Squares map = squares();
  const int line = from.y / 2;
  const auto shut = [&](int x) { return map.blocked(x, line - 1) && map.blocked(x, line); };
  int left = from.x / 2, right = (from.x + 1) / 2;
  while (!shut(left - 1)) --left;
  while (!shut(right)) ++right;
  return {static_cast<double>(left), static_cast<double>(right)};
}

/// What is seen of a row's far line, of what is seen of its near one: through each stretch of free cells.
void Visibility::cross_row(HalfPoint from, int row, int sign, const std::vector<SeenPart>& seen,
                           std::vector<SeenPart>& next) const {
  next.clear();
  const Squares map = squares();
  if (row < 0 || row >= map.height()) return;
  const double x = from.x / 2.0, y = from.y / 2.0;
  const double near = sign > 0 ? row : row + 1, far = sign > 0 ? row + 1 : row;
  const bool begins = (near - y) * sign <= 0;  // the point lies on the near line, or in the row
  const double stretch = begins ? 0 : (far - y) / (near - y);
  const auto run = [&](int cell) { return runs_[lattice_.node(Cell{cell, row})]; };
  for (const SeenPart& part : seen)
    for (int cell = std::max(0, static_cast<int>(std::floor(part.left - kSlack)) - 1);
         cell < map.width() && cell <= part.right + kSlack;) {
      if (map.blocked(cell, row)) {
        ++cell;
        continue;
      }
      const double first = run(cell).begin, end = run(cell).end;
      const double low = std::max(first, part.left), high = std::min(end, part.right);
      const auto projected = [&](double at) { return x + (at - x) * stretch; };
      SeenPart out{first, end};
      if (!begins) out = {std::max(first, projected(low - kSlack)), std::min(end, projected(high + kSlack))};
      if (low <= high + kSlack && out.left <= out.right + kSlack) next.push_back(out);
      cell = run(cell).end;
    }
}

std::size_t Visibility::memory_bytes() const {
  return corners_.capacity() * sizeof(Corner) + line_begins_.capacity() * sizeof(std::uint32_t) +
         runs_.capacity() * sizeof(FreeRun);
}

}  // namespace replan
