#include "core/sim/route.hpp"

#include <algorithm>
#include <utility>

#include "core/lattice/segment.hpp"
#include "core/lattice/sight.hpp"
#include "core/lattice/squares.hpp"

namespace replan {
namespace {

std::vector<NodeId> cells_between(const Box& box, NodeId from, NodeId to, SightRule sight) {
  std::vector<NodeId> cells;
  const auto collect = [&](NodeId node) {
    cells.push_back(node);
    return true;
  };
  if (sight == SightRule::supercover) {
    walk_supercover(box, from, to, collect);
  } else if (from < to) {
    walk_bresenham(box, from, to, collect);
  } else {
    // Lines of sight are drawn from the smaller index; the robot drives the same cells the other way.
    walk_bresenham(box, to, from, collect);
    std::reverse(cells.begin(), cells.end());
    if (!cells.empty()) {
      cells.erase(cells.begin());
      cells.push_back(to);
    }
  }
  return cells;
}

/// Those of a segment that may touch obstacles, from the cell `in` on.
std::vector<NodeId> cells_beside(const Box& box, std::span<const std::uint8_t> known, const Point& a,
                                 const Point& b, NodeId in) {
  std::vector<NodeId> cells;
  for (const Cell cell : Squares(box, known).cells_along(half_point(a), half_point(b), box.position(in)))
    cells.push_back(box.node(cell));
  return cells;
}

/// The cells of the path's segment that ends at point i, from the cell `in` on.
std::vector<NodeId> cells_of_segment(const Box& box, std::span<const std::uint8_t> known, const Path& path,
                                     std::size_t i, NodeId in) {
  if (path.touches) return cells_beside(box, known, path.point(i - 1), path.point(i), in);
  if (!path.nodes().empty()) return cells_between(box, path.nodes()[i - 1], path.nodes()[i], path.sight());
  std::vector<NodeId> cells;
  walk_segment(box, path.point(i - 1), path.point(i), [&](NodeId node) {
    cells.push_back(node);
    return true;
  });
  return cells;
}

/// How far along the segment from `a` to `b` the point `c` is, between its ends.
double projection(const Point& a, const Point& b, double length, const Point& c) {
  const double product = (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y) + (b.z - a.z) * (c.z - a.z);
  return std::clamp(product / length, 0.0, length);
}

/// The stretch of the segment from `a` to `b` that lies in the cell, as ways along it.
std::pair<double, double> stretch_inside(const Point& a, const Point& b, double length, const Cell& cell) {
  const double from[] = {a.x, a.y, a.z}, to[] = {b.x, b.y, b.z};
  const int low[] = {cell.x, cell.y, cell.z};
  double first = 0, last = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double by = to[axis] - from[axis];
    if (by == 0) continue;
    const double near = (low[axis] - from[axis]) / by, far = (low[axis] + 1 - from[axis]) / by;
    first = std::max(first, std::min(near, far));
    last = std::min(last, std::max(near, far));
  }
  return {first * length, std::max(first, last) * length};
}

}  // namespace

Route::Way Route::way_to(const Path& path, std::size_t i, const Point& at) const {
  Way way{{at}, {}};
  const auto add = [&way](const Point& point, std::size_t piece) {
    if (point == way.points.back()) return;
    way.points.push_back(point);
    way.pieces.push_back(piece);
  };
  for (std::size_t piece = i == 0 ? 1 : pieces[i - 1]; piece < pieces[i]; ++piece)
    add(path.point(piece), piece);
  add(points[i], pieces[i]);
  return way;
}

Route lay_out(const Box& box, std::span<const std::uint8_t> known, const Path& path) {
  Route route;
  const bool of_points = path.nodes().empty() && !path.touches;
  double walked = 0;
  NodeId in = path.empty() ? kNoNode : box.node(cell_of(path.point(0)));
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point a = path.point(i - 1), b = path.point(i);
    const double length = distance(a, b);
    for (const NodeId node : cells_of_segment(box, known, path, i, in)) {
      double way = projection(a, b, length, centre_of(box.position(node)));
      if (of_points) {  // what passes a cell at its corner is nearest to its centre outside
        const auto [first, last] = stretch_inside(a, b, length, box.position(node));
        way = std::clamp(way, first, last);
      }
      const double share = way / length;
      route.cells.push_back(node);
      route.pieces.push_back(i);
      route.along.push_back(walked + way);
      route.points.push_back(
          {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)});
    }
    walked += length;
    if (!route.cells.empty()) in = route.cells.back();
    if (!path.nodes().empty() || route.cells.empty()) continue;
    route.along.back() = walked;
    route.pieces.back() = i;
    route.points.back() = b;
  }
  return route;
}

}  // namespace replan
