#include "core/lattice/nearest.hpp"

#include <bit>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace replan {
namespace {

template <int D, class Visit>
void each_move(const BoxLattice<D>& known, NodeId from, const Visit& visit) {
  for (std::uint32_t rest = known.moves(from); rest != 0; rest &= rest - 1) {
    const int d = std::countr_zero(rest);
    visit(known.neighbour(from, d), BoxLattice<D>::step_cost(d));
  }
}

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
Nearest flood(const BoxLattice<D>& known, NodeId robot, NodeId goal) {
  Nearest nearest;
  std::vector<bool> reached(known.node_count());
  std::vector<NodeId> rim = {robot};
  reached[robot] = true;
  for (std::size_t next = 0; next < rim.size() && nearest.squared > 0; ++next) {
    nearest.offer(rim[next], known.squared_distance(rim[next], goal));
    each_move(known, rim[next], [&](NodeId node, Cost) {
      if (reached[node]) return;
      reached[node] = true;
      rim.push_back(node);
    });
  }
  return nearest;
}

/// The cell at that distance from the goal which the shortest way leads to. There must be one.
template <int D>
NodeId first_at(const BoxLattice<D>& known, NodeId robot, NodeId goal, std::int64_t squared) {
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
    each_move(known, u, [&, so_far = Cost{cost}](NodeId node, Cost step) {
      const Cost sum = so_far + step;
      if (!(sum < costs[node])) return;
      costs[node] = sum;
      open.push({sum.raw, node});
    });
  }
}

}  // namespace

template <int D>
NodeId nearest_reachable(const BoxLattice<D>& known, NodeId robot, NodeId goal) {
  const Nearest nearest = flood(known, robot, goal);
  return nearest.count == 1 ? nearest.cell : first_at(known, robot, goal, nearest.squared);
}

template NodeId nearest_reachable<2>(const BoxLattice<2>&, NodeId, NodeId);
template NodeId nearest_reachable<3>(const BoxLattice<3>&, NodeId, NodeId);

}  // namespace replan
