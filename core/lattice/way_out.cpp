#include "core/lattice/way_out.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

namespace replan {
namespace {

/// The regions of free cells that were looked at.
template <int D>
class Regions {
 public:
  explicit Regions(const BoxLattice<D>& known) : known_(known), seen_(known.node_count()) {}

  /// Whether the goal lies in the region of a cell. A region that was looked at before has it not.
  bool reaches(NodeId from, NodeId goal) {
    if (seen_[from]) return false;
    std::vector<NodeId> rim = {from};
    seen_[from] = true;
    for (std::size_t next = 0; next < rim.size(); ++next) {
      if (rim[next] == goal) return true;
      for (std::uint32_t rest = known_.moves(rim[next]); rest != 0; rest &= rest - 1) {
        const NodeId there = known_.neighbour(rim[next], std::countr_zero(rest));
        if (seen_[there]) continue;
        seen_[there] = true;
        rim.push_back(there);
      }
    }
    return false;
  }

 private:
  const BoxLattice<D>& known_;
  std::vector<bool> seen_;
};

/// The cells too near an obstacle around the robot, by the shortest ways to them.
template <int D>
class NearZone {
 public:
  explicit NearZone(const BoxLattice<D>& known) : known_(known), regions_(known) {}

  /// The way to the nearest free cell in the goal's region, or else to the nearest; empty if there is none.
  std::vector<NodeId> search(NodeId robot, NodeId goal) {
    NodeId nearest = kNoNode;
    reach(robot, robot, Cost::zero());
    while (!open_.empty()) {
      const auto [cost, u] = open_.top();
      open_.pop();
      if (cost > reached_.at(u).cost.raw) continue;
      if (known_.blocked(u)) {
        expand(u, Cost{cost});
        continue;
      }
      if (regions_.reaches(u, goal)) return way_to(u);
      if (nearest == kNoNode) nearest = u;
    }
    return nearest == kNoNode ? std::vector<NodeId>() : way_to(nearest);
  }

 private:
  struct Reached {
    Cost cost = Cost::infinity();
    NodeId from = kNoNode;
  };

  [[nodiscard]] std::vector<NodeId> way_to(NodeId node) const {
    std::vector<NodeId> way = {node};
    while (reached_.at(node).from != node) way.push_back(node = reached_.at(node).from);
    std::reverse(way.begin(), way.end());
    return way;
  }
  void reach(NodeId node, NodeId from, Cost cost) {
    Reached& reached = reached_[node];
    if (!(cost < reached.cost)) return;
    reached = {cost, from};
    open_.push({cost.raw, node});
  }
  void expand(NodeId u, Cost cost) {
    const auto at = known_.coordinates(u);
    const std::int64_t here = known_.inflation().quarters(u);
    for (int d = 0; d < BoxLattice<D>::kDirections; ++d) {
      if (!known_.contains(BoxLattice<D>::step(at, d))) continue;
      if (Directions<D>::axes(d) > 1 && !known_.rules().diagonals) continue;
      if (no_nearer(u, d, here)) reach(known_.neighbour(u, d), u, cost + BoxLattice<D>::step_cost(d));
    }
  }
  /// Whether a move leads over no cell that is nearer to an obstacle.
  [[nodiscard]] bool no_nearer(NodeId u, int d, std::int64_t here) const {
    for (std::uint32_t over = Directions<D>::squeezed(d) | 1u << d; over != 0; over &= over - 1)
      if (known_.inflation().quarters(known_.neighbour(u, std::countr_zero(over))) < here) return false;
    return true;
  }

  using Entry = std::pair<std::int64_t, NodeId>;  // of equal costs the smaller index comes first
  const BoxLattice<D>& known_;
  Regions<D> regions_;
  std::unordered_map<NodeId, Reached> reached_;  // looked up, never gone through
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

template <int D>
std::vector<NodeId> way_out(const BoxLattice<D>& known, NodeId robot, NodeId goal) {
  if (!known.has_size() || robot >= known.node_count() || !known.blocked(robot) ||
      known.obstacles()[robot] != 0)
    return {};
  return NearZone<D>(known).search(robot, goal);
}

template std::vector<NodeId> way_out<2>(const BoxLattice<2>&, NodeId, NodeId);
template std::vector<NodeId> way_out<3>(const BoxLattice<3>&, NodeId, NodeId);

}  // namespace replan
