// The path of a D* Lite search that leaves sight out of it (`sight_checks=path`), in leaps from a vertex to one
// that it sees. What is settled about that is in sight_along.hpp.
//
// Line numbers are those of Algorithm 3 in assets/planners/dld-star-lite.md, + 200.
#pragma once

#include <cstddef>
#include <vector>

#include "core/plan/planner.hpp"
#include "core/planners/kept_leaps.hpp"
#include "core/planners/sight_along.hpp"

namespace replan {

/// A search's leaps: the remote parents of its vertices, but for the goal's.
template <class Search, std::size_t D>
class LeapingPath {
 public:
  explicit LeapingPath(Search& search) : search_(search) {}

  [[nodiscard]] std::size_t memory_bytes() const { return kept_.memory_bytes(); }
  void clear() { kept_.clear(); }
  void keep(Leap leap) {
    kept_.add(leap, search_.lattice_.coordinates(leap.from), search_.lattice_.coordinates(leap.to));
  }

  // Lines 1-8: along the leaps that are kept, and where there is none a new one.
  Path read() {
    chain_.clear();
    leads_ = kNoNode;
    std::vector<NodeId> nodes = {search_.start_};
    nodes.reserve(kept_.size() + 1);
    for (NodeId s = search_.start_; s != search_.goal_; nodes.push_back(s)) {
      if (!leads_ahead(s)) set_leap(s);
      s = rp(s);
    }
    if (kept_.size() > kMostKept + 2 * nodes.size()) {
      search_.tr_.line(207);
      forget(kept_.take_others(nodes));
    }
    return search_.path_over(std::move(nodes));
  }

  /// A cell that the change of the map made good or bad for sight, or may have.
  void turn(NodeId cell) { turned_.push_back(cell); }

  // Lines 17-19: sight is a matter of the cells in the box that both ends span. Where none of them changed a
  // leap need not be looked at again.
  void forget_turned() {
    std::vector<typename KeptLeaps<D>::Place> places;
    places.reserve(turned_.size());
    for (const NodeId cell : turned_) places.push_back(search_.lattice_.coordinates(cell));
    turned_.clear();
    search_.tr_.line(219);
    forget(kept_.take_touched(places));
  }

 private:
  static constexpr std::size_t kMostKept = 64;  // leaps that a path does not take, besides twice its own

  [[nodiscard]] NodeId rp(NodeId s) const { return search_.nodes_[s].rp; }

  // Line 4: whether s has a leap, and it ends on the way from s along local parents, on which g falls.
  // The last answer is remembered: the path often goes on from there.
  [[nodiscard]] bool leads_ahead(const NodeId s) {
    const auto& nodes = search_.nodes_;
    const NodeId end = rp(s);
    if (s == leads_ || end == kNoNode) return s == leads_;
    const Cost g = nodes[end].g;
    NodeId next = s;
    do {
      next = search_.lattice_.neighbour(next, static_cast<int>(nodes[next].parent));
    } while (next != end && g < nodes[next].g);
    if (next != end) return false;
    leads_ = s;
    return true;
  }

  // Line 5.
  void set_leap(NodeId s) {
    const NodeId end = farthest_seen(s);
    search_.tr_.line(205);
    if (rp(s) != kNoNode) kept_.remove(s, search_.lattice_.coordinates(s));  // it leads ahead no more
    search_.set_rp(s, end);
    keep({s, end});
  }

  // Lines 9-17.
  NodeId farthest_seen(NodeId s) {
    const NodeId goal = search_.goal_;
    const auto sees = [&](int line, NodeId n) {
      search_.tr_.line(line);
      return search_.in_sight(n, s);
    };
    if (search_.lp(s) == goal || sees(210, goal)) return goal;
    read_chain(s);
    const NodeId* const chain = &chain_[at_];
    const std::size_t last = chain_.size() - 1 - at_;
    NodeId end = chain[last];
    if (end == goal || (last > 1 && !sees(212, end))) {
      at_ += leap_along(straight_along(last), last,
                        [&](int line, std::size_t k) { return sees(line, chain[k]); });
      return chain_[at_];
    }
    while (end != goal && leads_ahead(end) && sees(213, rp(end))) end = rp(end);
    return end;
  }

  /// Line 11: the chain of local parents from s to the next vertex with a leap that leads ahead, or to the
  /// goal. What was read for the leap before goes on from its end.
  void read_chain(NodeId s) {
    if (at_ < chain_.size() && chain_[at_] == s) return;
    at_ = 0;
    chain_.assign(1, s);
    do chain_.push_back(s = search_.lp(s));
    while (s != search_.goal_ && !leads_ahead(s));
  }

  /// How far sight along the chain needs no check, up to number `last` of it. Moves that go on in one
  /// direction ask no less of the map than sight does; but with clearance a move may lead past an obstacle,
  /// sight not.
  std::size_t straight_along(std::size_t last) const {
    const auto& nodes = search_.nodes_;
    std::size_t k = 1;
    if (!search_.switches_.clearance)
      while (k < last && nodes[chain_[at_ + k]].parent == nodes[chain_[at_]].parent) ++k;
    return k;
  }

  void forget(const std::vector<Leap>& leaps) {
    for (const Leap& leap : leaps) search_.set_rp(leap.from, kNoNode);
  }

  Search& search_;
  KeptLeaps<D> kept_;          // of the vertices whose rp is set
  std::vector<NodeId> chain_;  // of local parents, as far as a leap may go
  std::size_t at_ = 0;         // where that leap begins
  NodeId leads_ = kNoNode;     // the last vertex whose leap was found to lead ahead, on the path that is read
  std::vector<NodeId> turned_;
};

}  // namespace replan
