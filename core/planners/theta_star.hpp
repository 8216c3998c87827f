// Theta* and Lazy Theta*: best-first search (best_first.hpp) over a lattice, with parents anywhere in sight.
//
//  Theta*       Nash, Daniel, Koenig & Felner, "Theta*: any-angle path planning on grids", AAAI 2007; Daniel, Nash,
//               Koenig & Felner, Journal of Artificial Intelligence Research 39, 2010, doi 10.1613/jair.2994
//  Lazy Theta*  Nash, Koenig & Tovey, "Lazy Theta*: any-angle path planning and path length analysis in 3D",
//               AAAI 2010: sight is taken for granted and checked once, when the vertex is taken from the list
//
// Line numbers are those of assets/planners/theta-star.md, which has both.
//
// Settled here:
//  * c(a, b) of a straight way is 2^30 times its length, rounded up, as moves are. So the triangle inequality holds
//    in whole numbers, and the way over rp(u) is never longer than that over u: it alone need be looked at first.
//  * A vertex whose g falls after it was expanded is opened again, which the papers' code does not do. With it no
//    path is longer than A*'s, be the estimate consistent or not: along a shortest lattice path each vertex that is
//    expanded gives the next one a g no more than its own and the move, so that one with no more than its right g
//    waits in the list until the goal is reached.
//  * Lazy Theta*: only a vertex that was never expanded takes sight for granted; an expanded one has children that
//    count on its g, so its new parent is checked at once. What is taken and does not see its parent gets the best
//    of its expanded neighbours instead and goes back into the list with its true key, where the paper expands it
//    with the wrong one. The search ends when the goal is expanded, not when it is on top: its own sight is checked
//    like all others'.
//  * Estimates are Euclidean. Octile overestimates straight ways: cells are opened again and again, and paths are
//    longer, though never longer than A*'s.
//  * A parent that is a neighbour by a move needs no check.
#pragma once

#include <bit>
#include <utility>
#include <vector>

#include "core/planners/best_first.hpp"
#include "core/planners/ground.hpp"

namespace replan {

struct ThetaStarSwitches {
  bool lazy = false;
};

inline PlannerInfo describe(ThetaStarSwitches switches) {
  PlannerInfo info;
  info.any_angle = info.sight = true;
  info.values.fields.push_back(fields::kRp);
  info.values.laws = "any-angle";
  info.parameters = {parameters::kStraightHeuristic, parameters::kSight};
  info.length_bound = [](const Settings&) { return 1.0; };
  if (switches.lazy) {
    info.name = "Lazy Theta*";
    info.summary =
        "Theta* with one line of sight for each cell that it takes: any-angle paths, fewer checks.";
    info.source = "Nash, Koenig & Tovey, Lazy Theta*, AAAI 2010";
  } else {
    info.name = "Theta*";
    info.summary = "A* whose parents may be any cell in sight: any-angle paths; plans afresh each time.";
    info.source = "Daniel, Nash, Koenig & Felner 2010, doi 10.1613/jair.2994";
  }
  return info;
}

/// What it remembers of a vertex.
struct ThetaStarNode : BestFirstNode {
  NodeId rp = kNoNode;    // the vertex in sight that it is reached from; none for the start
  bool expanded = false;  // at least once, so it sees rp
};

template <Lattice L, Tracer T>
class ThetaStar final : public BestFirst<L, T, GPlusH, ThetaStar<L, T>, ThetaStarNode> {
  using Base = BestFirst<L, T, GPlusH, ThetaStar<L, T>, ThetaStarNode>;
  friend Base;

 public:
  ThetaStar(const L& lattice, const Settings& settings, T& tracer, ThetaStarSwitches switches)
      : Base(lattice, settings, tracer, switches),
        lazy_(switches.lazy),
        ground_(lattice, settings, nullptr, true) {}

  void begin(NodeId start, NodeId goal) override {
    ground_.make([](NodeId, Cost, Cost) {});
    Base::begin(start, goal);
  }
  void update(const MapChange<L>& change, NodeId start) override {
    ground_.update(change.cells);
    Base::update(change, start);
  }
  void restore(const SearchState& state, const Counters& counters) override {
    ground_.make([](NodeId, Cost, Cost) {});
    Base::restore(state, counters);
  }
  [[nodiscard]] std::size_t memory_bytes() const override {
    return Base::memory_bytes() + ground_.memory_bytes();
  }

 private:
  using Base::counters_, Base::goal_, Base::lattice_, Base::nodes_, Base::open_, Base::tr_;
  using typename Base::Coordinates, typename Base::Expanded, typename Base::Node;

  // Line 6.
  void expand(const Expanded& u) {
    nodes_.held(u.node).expanded = true;
    const NodeId rp = nodes_[u.node].rp;
    const Expanded from = rp == kNoNode ? u : Expanded{rp, lattice_.coordinates(rp), nodes_[rp].g};
    for (std::uint32_t rest = lattice_.moves(u.node); rest != 0; rest &= rest - 1)
      offer(u, from, std::countr_zero(rest));
  }

  // Lines 7-8, for the neighbour of u in direction d; `from` is rp(u), or u if it has none.
  void offer(const Expanded& u, const Expanded& from, int d) {
    const NodeId s = lattice_.neighbour(u.node, d);
    const Coordinates at = L::step(u.at, d);
    const std::int64_t squared = L::squared_distance(from.at, at);
    if (!is_shorter(from.g, squared, nodes_[s].g)) return;
    const Cost straight = from.g + euclidean_ceil(squared);
    const bool granted = from.node == u.node || (lazy_ && !nodes_[s].expanded);
    tr_.line(8);
    if (granted || in_sight(from.node, s)) return reach_from(from.node, s, d, straight, at);
    const Cost sum = u.g + L::step_cost(d);
    if (sum < nodes_[s].g) reach_from(u.node, s, d, sum, at);
  }
  /// Whether g and the straight way are less than that; most are not, and no root need be taken of them.
  static bool is_shorter(Cost g, std::int64_t squared, Cost than) {
    const Cost most{than.raw - g.raw - 1};
    return most >= Cost::zero() && compare_to_segment(most, squared) >= 0;
  }
  void reach_from(NodeId rp, NodeId s, int d, Cost sum, const Coordinates& at) {
    Base::reach(s, static_cast<std::uint32_t>(L::reverse(d)), sum, at);
    tr_.line(14);
    set_rp(s, rp);
  }

  // Lines 18-24. Whether u, just taken from the list, sees its parent; if not, it goes back with the best way over a
  // neighbour. There is one: whoever reached u was expanded.
  bool confirm(NodeId u) {
    const Node& node = nodes_[u];
    if (!lazy_ || node.expanded || node.rp == kNoNode || node.rp == this->parent(u)) return true;
    tr_.line(19);
    if (in_sight(node.rp, u)) return true;
    Cost best = Cost::infinity();
    int towards = 0;
    for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const Node& other = nodes_[lattice_.neighbour(u, d)];
      if (!other.expanded || !(other.g + L::step_cost(d) < best)) continue;
      best = other.g + L::step_cost(d);
      towards = d;
    }
    tr_.line(21);
    this->set_g(u, best);
    tr_.line(22);
    this->set_parent(u, static_cast<std::uint32_t>(towards));
    set_rp(u, lattice_.neighbour(u, towards));
    tr_.line(23);
    this->put_in(u, this->key_of(u, best, lattice_.coordinates(u)));
    return false;
  }

  [[nodiscard]] bool at_goal() const { return lazy_ ? nodes_[goal_].expanded : open_.top().node == goal_; }
  [[nodiscard]] NodeId parent_of(NodeId s) const { return nodes_[s].rp; }
  [[nodiscard]] Path path_over(std::vector<NodeId> nodes) const {
    return Path(lattice_.box(), std::move(nodes), ground_.sight_rule());
  }
  void restore_node(const SearchState& state, NodeId n, Node& node) {
    node.rp = state.rp(n);
    node.expanded = state.times_expanded(n) != 0;
  }

  // Kept out of line: its code would make that of the search slower.
  [[gnu::noinline]] bool in_sight(NodeId n, NodeId s) {
    ++counters_.sight_checks;
    const bool seen = ground_.sees(n, s);
    tr_.note(EventKind::sight, s, std::uint64_t{n} | std::uint64_t{seen} << 32);
    return seen;
  }
  void set_rp(NodeId s, NodeId rp) {
    tr_.change(EventKind::rp, s, std::uint64_t{nodes_[s].rp + 1u}, std::uint64_t{rp + 1u});
    nodes_.held(s).rp = rp;
  }

  const bool lazy_;
  Ground<L> ground_;
};

}  // namespace replan
