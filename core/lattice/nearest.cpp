#include "core/lattice/nearest.hpp"

#include <bit>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace replan {
namespace {

/// The map, and cells of it that are not entered besides.
template <int D>
struct OpenGround {
  const BoxLattice<D>& known;
  const std::vector<bool>& closed;

  template <class Visit>
  void each_move(NodeId from, const Visit& visit) const {
    for (std::uint32_t rest = known.moves(from); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId to = known.neighbour(from, d);
      if (closed.empty() || !closed[to]) visit(to, BoxLattice<D>::step_cost(d));
    }
  }
};

/// How near to the goal the robot can come, and where: any of those cells, and how many they are.
struct Nearest {
  std::int64_t squared = std::numeric_limits<std::int64_t>::max();
  NodeId cell = kNoNode;
  int count = 0;

  void offer(NodeId node, std::int64_t distance) {
    if (distance > squared) return;
    count = distance == squared ? count + 1 : 1;
    squared = distance;
    cell = node;
  }
};

template <int D>
Nearest flood(const OpenGround<D>& ground, NodeId robot, NodeId goal) {
  const BoxLattice<D>& known = ground.known;
  Nearest nearest;
  std::vector<bool> reached(known.node_count());
  std::vector<NodeId> rim = {robot};
  reached[robot] = true;
  for (std::size_t next = 0; next < rim.size() && nearest.squared > 0; ++next) {
    nearest.offer(rim[next], known.squared_distance(rim[next], goal));
    ground.each_move(rim[next], [&](NodeId node, Cost) {
      if (reached[node]) return;
      reached[node] = true;
      rim.push_back(node);
    });
  }
  return nearest;
}

/// The cell at that distance from the goal which the shortest way leads to. There must be one.
template <int D>
NodeId first_at(const OpenGround<D>& ground, NodeId robot, NodeId goal, std::int64_t squared) {
  const BoxLattice<D>& known = ground.known;
  std::vector<Cost> costs(known.node_count(), Cost::infinity());
  using Entry = std::pair<std::int64_t, NodeId>;  // of equal costs the smaller index comes first
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  costs[robot] = Cost::zero();
  open.push({0, robot});
  for (;;) {
    const auto [cost, u] = open.top();
    open.pop();
    if (known.squared_distance(u, goal) == squared) return u;
    if (cost > costs[u].raw) continue;
    ground.each_move(u, [&, so_far = Cost{cost}](NodeId node, Cost step) {
      const Cost sum = so_far + step;
      if (!(sum < costs[node])) return;
      costs[node] = sum;
      open.push({sum.raw, node});
    });
  }
}

}  // namespace

template <int D>
NodeId nearest_reachable(const BoxLattice<D>& known, NodeId robot, NodeId goal,
                         const std::vector<bool>& closed) {
  const OpenGround<D> ground{known, closed};
  const Nearest nearest = flood(ground, robot, goal);
  return nearest.count == 1 ? nearest.cell : first_at(ground, robot, goal, nearest.squared);
}

template NodeId nearest_reachable<2>(const BoxLattice<2>&, NodeId, NodeId, const std::vector<bool>&);
template NodeId nearest_reachable<3>(const BoxLattice<3>&, NodeId, NodeId, const std::vector<bool>&);

}  // namespace replan
