// The path of a D* Lite search along its vertices' parents, remote ones where they can be trusted.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/plan/planner.hpp"
#include "core/trace/event.hpp"

namespace replan {

template <class Search>
class ParentPath {
 public:
  explicit ParentPath(Search& search) : search_(search) {}

  /// From the start on. Only parents that may be wrong are watched for circles.
  Path read() {
    const NodeId goal = search_.goal_;
    const bool may_be_wrong = Search::kFaulty || !search_.checked_;
    std::vector<NodeId> nodes = {search_.start_};
    std::unordered_set<NodeId> passed;
    unchecked_ = false;
    ways_.clear();
    for (NodeId s = search_.start_; s != goal;) {
      if (may_be_wrong && !passed.insert(s).second) break;
      s = next(s);
      if (s == kNoNode) break;  // printed mode only: a stale parent led where nothing leads on
      nodes.push_back(s);
    }
    const bool arrives = nodes.back() == goal;
    Path path = search_.path_over(std::move(nodes));
    path.loops = !arrives;
    path.unchecked = unchecked_;
    return path;
  }

 private:
  /// Where the robot goes from s: the remote parent if it can be trusted, else the local one.
  NodeId next(NodeId s) {
    const NodeId local = search_.lp(s);
    const NodeId remote = search_.nodes_[s].rp;
    if (!search_.switches_.sight || remote == local) return local;
    if (!search_.checked_) {
      if (remote != kNoNode) search_.tr_.note(EventKind::unchecked, s, remote);
      unchecked_ = true;
      return remote;
    }
    const bool trusted =
        remote != kNoNode && search_.settled(remote) && saves_way(s, remote) && search_.in_sight(remote, s);
    return trusted ? remote : local;
  }

  /// Whether going straight from s to n is no detour: c(s, n) + g(n) <= rhs(s). With clearance g counts
  /// penalties besides, which a longer way may save, so the lengths of both ways are held against each other
  /// too.
  [[nodiscard]] bool saves_way(NodeId s, NodeId n) {
    const std::int64_t squared = search_.lattice_.squared_distance(s, n);
    const auto fits = [squared](Cost from_s, Cost from_n) {
      return from_n < from_s && compare_to_segment({from_s.raw - from_n.raw}, squared) >= 0;
    };
    return fits(search_.nodes_[s].rhs, search_.nodes_[n].g) &&
           (!search_.switches_.clearance || fits(way(s), way(n)));
  }

  /// The length of the way from s along local parents; s is settled. Each stretch is walked once a path.
  Cost way(NodeId s) {
    std::vector<NodeId> passed;
    for (; s != search_.goal_ && !ways_.contains(s); s = search_.lp(s)) passed.push_back(s);
    Cost length = s == search_.goal_ ? Cost::zero() : ways_[s];
    for (std::size_t i = passed.size(); i-- > 0;) {
      length = length + search_.lattice_.step_cost(static_cast<int>(search_.nodes_[passed[i]].parent));
      ways_[passed[i]] = length;
    }
    return length;
  }

  Search& search_;
  bool unchecked_ = false;                 // some parent on the path was taken on trust
  std::unordered_map<NodeId, Cost> ways_;  // of vertices that the path was held against
};

}  // namespace replan
