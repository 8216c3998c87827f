#include "core/plan/any_angle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <utility>

namespace replan {
namespace {

constexpr std::uint32_t kStart = 0, kGoal = 1, kFirstCorner = 2;
constexpr double kSlack = 1e-7;  // cells, by which what is seen is taken too wide

double distance(HalfPoint a, HalfPoint b) {
  const double x = a.x - b.x, y = a.y - b.y;
  return std::sqrt(x * x + y * y) / 2;
}

std::int64_t cross(HalfPoint a, HalfPoint b) {
  return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}

HalfPoint between(HalfPoint from, HalfPoint to) {
  return {to.x - from.x, to.y - from.y};
}

int sign_of(std::int64_t value) {
  return (value > 0) - (value < 0);
}

/// Floor and ceiling of a quotient; the divisor is positive.
std::int64_t floor_of(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}
std::int64_t ceiling_of(std::int64_t a, std::int64_t b) {
  return -floor_of(-a, b);
}

}  // namespace

AnyAngle::AnyAngle(const Grid2& lattice)
    : lattice_(lattice), width_(lattice.width()), height_(lattice.height()) {
  line_begins_.assign(static_cast<std::size_t>(height_) + 2, 0);
  for (int y = 0; y <= height_; ++y) {
    line_begins_[static_cast<std::size_t>(y)] = static_cast<std::uint32_t>(corners_.size());
    for (int x = 0; x <= width_; ++x) {
      int count = 0, quadrant_x = 0, quadrant_y = 0;
      for (const int qy : {-1, 1})
        for (const int qx : {-1, 1}) {
          if (!blocked(x + (qx - 1) / 2, y + (qy - 1) / 2)) continue;
          ++count;
          quadrant_x = qx;
          quadrant_y = qy;
        }
      const bool twice = pinched(x, y);
      if (count == 1 || (twice && lattice.rules().corners == CornerRule::any))
        corners_.push_back({{2 * x, 2 * y}, quadrant_x, quadrant_y, twice});
    }
  }
  line_begins_.back() = static_cast<std::uint32_t>(corners_.size());
  points_.resize(corners_.size() + kFirstCorner);
  runs_.resize(lattice.node_count());
  for (int y = 0; y < height_; ++y)
    for (int x = 0, end = 0; x < width_; x = end + 1) {
      for (end = x; end < width_ && !blocked(end, y);) ++end;
      for (int cell = x; cell < end; ++cell) runs_[lattice.node(Cell{cell, y})] = {x, end};
    }
}

/// Whether two obstacles meet diagonally at that corner of cells.
bool AnyAngle::pinched(int x, int y) const {
  const bool a = blocked(x - 1, y - 1), b = blocked(x, y - 1), c = blocked(x - 1, y), d = blocked(x, y);
  return (a && d && !b && !c) || (b && c && !a && !d);
}

HalfPoint AnyAngle::at(std::uint32_t point) const {
  return point == kStart ? start_ : point == kGoal ? goal_ : corners_[point - kFirstCorner].at;
}

/// Along a row or a column: through cells, or on a grid line with one of the cells beside it free.
bool AnyAngle::sees_along_axis(HalfPoint a, HalfPoint b) const {
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
    if (inner && lattice_.rules().corners != CornerRule::any &&
        (across ? pinched(cell, line / 2) : pinched(line / 2, cell)))
      return false;
  }
  return true;
}

// The cells of each row that the segment's open part passes through, in whole numbers; then the corners on it.
bool AnyAngle::sees(HalfPoint a, HalfPoint b) const {
  if (a == b) return true;
  if (a.x == b.x || a.y == b.y) return sees_along_axis(a, b);
  if (a.y > b.y) std::swap(a, b);
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  for (int row = static_cast<int>(floor_of(a.y, 2)); 2 * row < b.y; ++row) {
    // Where it enters and leaves the row, times dy.
    const std::int64_t top = std::max(2 * row, a.y), bottom = std::min(2 * row + 2, b.y);
    const std::int64_t enters = a.x * dy + (top - a.y) * dx, leaves = a.x * dy + (bottom - a.y) * dx;
    const std::int64_t left = std::min(enters, leaves), right = std::max(enters, leaves);
    const std::int64_t first = floor_of(left, 2 * dy), last = ceiling_of(right, 2 * dy) - 1;
    for (std::int64_t x = first; x <= last; ++x)
      if (blocked(static_cast<int>(x), row)) return false;
    const bool at_corner = top > a.y && top % 2 == 0 && enters % (2 * dy) == 0;
    if (at_corner && lattice_.rules().corners != CornerRule::any &&
        pinched(static_cast<int>(enters / (2 * dy)), row))
      return false;
  }
  return true;
}

/// A start or goal in a pinch lies on its lower right side.
bool AnyAngle::may_leave(HalfPoint end, HalfPoint other) const {
  if (end.x % 2 != 0 || end.y % 2 != 0 || !pinched(end.x / 2, end.y / 2)) return true;
  return other.x >= end.x && other.y >= end.y;
}

/// Whether a string pulled tight over these points bends round the corner's obstacle.
bool AnyAngle::bends_taut(std::uint32_t before, std::uint32_t corner, HalfPoint next) const {
  if (corner < kFirstCorner) return true;
  const Corner& c = corners_[corner - kFirstCorner];
  const HalfPoint in = between(at(before), c.at), out = between(c.at, next);
  const HalfPoint obstacle{c.quadrant_x, c.quadrant_y};
  if (sign_of(out.x) * c.quadrant_x * sign_of(out.y) * c.quadrant_y > 0) return false;
  const int turn = sign_of(cross(in, out));
  return turn == 0 || c.twice || turn == sign_of(cross(in, obstacle));
}

void AnyAngle::offer(std::uint32_t from, std::uint32_t to) {
  if (from == to) return;
  const HalfPoint a = at(from), b = at(to);
  if (to >= kFirstCorner) {
    const Corner& c = corners_[to - kFirstCorner];
    if (sign_of(b.x - a.x) * c.quadrant_x * sign_of(b.y - a.y) * c.quadrant_y > 0) return;
  }
  Reached& point = points_[to];
  if (point.search != search_) point = {.g = HUGE_VAL, .parent = from, .search = search_, .done = false};
  const double g = points_[from].g + distance(a, b);
  if (point.done || !(g < point.g) || !bends_taut(points_[from].parent, from, b)) return;
  if ((from == kStart && !may_leave(a, b)) || (to == kGoal && !may_leave(b, a)) || !sees(a, b)) return;
  point.g = g;
  point.parent = from;
  open_.push_back({g + distance(b, goal_), g, to});
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
}

void AnyAngle::offer_corners(std::uint32_t from, int line, Interval part) {
  const auto begin = corners_.begin() + line_begins_[static_cast<std::size_t>(line)];
  const auto end = corners_.begin() + line_begins_[static_cast<std::size_t>(line) + 1];
  const auto first = std::lower_bound(begin, end, part.left - kSlack,
                                      [](const Corner& c, double x) { return c.at.x < 2 * x; });
  for (auto c = first; c != end && c->at.x <= 2 * (part.right + kSlack); ++c)
    offer(from, static_cast<std::uint32_t>(c - corners_.begin()) + kFirstCorner);
}

/// Corners on the grid line that the point itself lies on.
void AnyAngle::look_sideways(std::uint32_t from) {
  const HalfPoint p = at(from);
  if (p.y % 2 != 0) return;
  const int line = p.y / 2;
  const auto shut = [&](int x) { return blocked(x, line - 1) && blocked(x, line); };
  int left = static_cast<int>(floor_of(p.x, 2)), right = static_cast<int>(ceiling_of(p.x, 2));
  while (!shut(left - 1)) --left;
  while (!shut(right)) ++right;
  offer_corners(from, line, {static_cast<double>(left), static_cast<double>(right)});
}

/// What is seen of a row's far line, of what is seen of its near one: through each stretch of free cells.
void AnyAngle::cross_row(std::uint32_t from, int row, int sign, const std::vector<Interval>& seen,
                         std::vector<Interval>& next) const {
  next.clear();
  if (row < 0 || row >= height_) return;
  const double x = at(from).x / 2.0, y = at(from).y / 2.0;
  const double near = sign > 0 ? row : row + 1, far = sign > 0 ? row + 1 : row;
  const bool begins = (near - y) * sign <= 0;  // the point lies on the near line, or in the row
  const double stretch = begins ? 0 : (far - y) / (near - y);
  const auto run = [&](int cell) { return runs_[lattice_.node(Cell{cell, row})]; };
  for (const Interval& part : seen)
    for (int cell = std::max(0, static_cast<int>(std::floor(part.left - kSlack)) - 1);
         cell < width_ && cell <= part.right + kSlack;) {
      if (blocked(cell, row)) {
        ++cell;
        continue;
      }
      const double first = run(cell).begin, end = run(cell).end;
      const double low = std::max(first, part.left), high = std::min(end, part.right);
      const auto projected = [&](double at) { return x + (at - x) * stretch; };
      Interval out{first, end};
      if (!begins) out = {std::max(first, projected(low - kSlack)), std::min(end, projected(high + kSlack))};
      if (low <= high + kSlack && out.left <= out.right + kSlack) next.push_back(out);
      cell = run(cell).end;
    }
}

void AnyAngle::look_vertically(std::uint32_t from, int sign) {
  const HalfPoint p = at(from);
  seen_.assign(1, {p.x / 2.0, p.x / 2.0});
  int row = static_cast<int>(sign > 0 ? floor_of(p.y, 2) : ceiling_of(p.y, 2) - 1);
  for (; !seen_.empty(); row += sign) {
    cross_row(from, row, sign, seen_, next_);
    for (const Interval& part : next_) offer_corners(from, sign > 0 ? row + 1 : row, part);
    std::swap(seen_, next_);
  }
}

void AnyAngle::expand(std::uint32_t point) {
  ++expansions_;
  offer(point, kGoal);
  look_sideways(point);
  look_vertically(point, 1);
  look_vertically(point, -1);
}

Path AnyAngle::shortest(HalfPoint from, HalfPoint to) {
  start_ = from;
  goal_ = to;
  ++search_;
  open_.clear();
  points_[kStart] = {.g = 0, .parent = kStart, .search = search_, .done = false};
  const auto inside = [this](HalfPoint p) { return p.x % 2 != 0 && blocked((p.x - 1) / 2, (p.y - 1) / 2); };
  if (inside(from) || inside(to)) return {};
  const auto as_point = [](HalfPoint p) { return Point{p.x / 2.0, p.y / 2.0, 0.5}; };
  if (from == to) return Path(std::vector<Point>{as_point(from)});
  open_.push_back({distance(from, to), 0, kStart});
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    const std::uint32_t point = open_.back().point;
    open_.pop_back();
    if (point == kGoal) break;
    if (std::exchange(points_[point].done, true)) continue;
    expand(point);
  }
  if (points_[kGoal].search != search_ || std::isinf(points_[kGoal].g)) return {};
  std::vector<Point> way = {as_point(to)};
  for (std::uint32_t point = kGoal; point != kStart; way.push_back(as_point(at(point))))
    point = points_[point].parent;
  std::reverse(way.begin(), way.end());
  return Path(std::move(way));
}

}  // namespace replan
