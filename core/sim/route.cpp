#include "core/sim/route.hpp"

#include <algorithm>

namespace replan {
namespace {

std::vector<NodeId> cells_between(const Grid2& lattice, NodeId from, NodeId to, SightRule sight) {
  std::vector<NodeId> cells;
  const auto collect = [&](NodeId node, int) {
    cells.push_back(node);
    return true;
  };
  if (sight == SightRule::supercover) {
    walk_supercover(lattice, from, to, collect);
  } else if (from < to) {
    walk_bresenham(lattice, from, to, collect);
  } else {
    // Lines of sight are drawn from the smaller index; the robot drives the same cells the other way.
    walk_bresenham(lattice, to, from, collect);
    std::reverse(cells.begin(), cells.end());
    if (!cells.empty()) {
      cells.erase(cells.begin());
      cells.push_back(to);
    }
  }
  return cells;
}

}  // namespace

Route lay_out(const Grid2& lattice, const Path& path, SightRule sight) {
  Route route;
  double walked = 0;
  for (std::size_t i = 1; i < path.nodes.size(); ++i) {
    const Cell a = lattice.position(path.nodes[i - 1]), b = lattice.position(path.nodes[i]);
    const double length = distance(a, b);
    for (const NodeId node : cells_between(lattice, path.nodes[i - 1], path.nodes[i], sight)) {
      const Cell c = lattice.position(node);
      const double projection = static_cast<double>(scalar_product(a, b, c)) / length;
      route.cells.push_back(node);
      route.along.push_back(walked + projection);
      const double share = projection / length;
      route.points.push_back({a.x + 0.5 + share * (b.x - a.x), a.y + 0.5 + share * (b.y - a.y)});
    }
    walked += length;
  }
  return route;
}

}  // namespace replan
