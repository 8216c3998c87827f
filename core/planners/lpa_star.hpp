// Lifelong Planning A*: A* that keeps its search and repairs it when edge costs change.
//
//  Koenig, Likhachev & Furcy, "Lifelong Planning A*", Artificial Intelligence 155(1-2), 2004,
//  doi 10.1016/j.artint.2003.12.001
//
// Line numbers are those of assets/planners/lpa-star.md: those of the paper's pseudo-code, its main procedure being
// the mission here (+ 100).
//
// What is settled here:
//  * Every value is a distance from the start, so a search is worth keeping only as long as the start stays where it
//    is. When the robot has moved there is nothing to repair, and the search begins afresh, which its log says by an
//    epoch (PlannerInfo::keeps_start). D* Lite turns the search round for that reason.
//  * rhs is updated incrementally (lookahead_search.hpp).
//  * Moves are undirected (law 3 in lattice.hpp), so Pred(s) = Succ(s). The parent of s is the predecessor that
//    offers the least, of equal ones the first; the start is its own.
//  * While the start or the goal lies inside an obstacle the search rests: no work could find a path.
#pragma once

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "core/plan/common_parameters.hpp"
#include "core/plan/registry.hpp"
#include "core/planners/lookahead_search.hpp"

namespace replan {

struct LpaStarSwitches {};

inline PlannerInfo describe(LpaStarSwitches) {
  PlannerInfo info;
  info.name = "LPA*";
  info.summary = "A* that repairs its plan when the map changes, as long as its start stays where it is.";
  info.source = "Koenig, Likhachev & Furcy 2004, doi 10.1016/j.artint.2003.12.001";
  info.incremental = info.keeps_start = true;
  info.values = lookahead_values();
  info.values.fields = {fields::kG, fields::kRhs, fields::kQueue, fields::kParent, fields::kVisit};
  info.values.cost = {EventKind::rhs, Scalar::goal};
  info.parameters = {parameters::kHeuristic};
  info.length_bound = [](const Settings&) { return 1.0; };
  return info;
}

/// What LPA* remembers of a vertex.
struct LpaStarNode {
  Cost g = Cost::infinity();
  Cost rhs = Cost::infinity();
  std::uint32_t slot : 27 = 0;    // in U
  std::uint32_t parent : 5 = 31;  // direction towards the start
};
static_assert(sizeof(LpaStarNode) == 24, "a large map has many of them");

template <Lattice L, Tracer T>
class LpaStar final : public LookaheadSearch<L, T, LpaStarNode, LpaStar<L, T>> {
  using Base = LookaheadSearch<L, T, LpaStarNode, LpaStar<L, T>>;
  friend Base;

 public:
  LpaStar(const L& lattice, const Settings& settings, T& tracer, LpaStarSwitches switches)
      : Base(lattice, tracer), heuristic_(heuristic_of(describe(switches), settings)) {}

  void begin(NodeId start, NodeId goal) override {
    this->begin_counting();
    set_scalar(Scalar::goal, goal_, goal);
    initialize(start);
  }

  // The main procedure, lines 10 to 14 of the mission.
  void update(const MapChange<L>& change, NodeId start) override {
    tr_.line(110);
    if (start != start_) return initialize(start);
    tr_.line(114);
    for (const auto& move : change.moves) this->moves_changed(move.node, move.before);
  }

  [[nodiscard]] PlanStatus status() const override {
    return this->status_with(search_needed(), nodes_[goal_].rhs);
  }
  [[nodiscard]] Cost cost() const override {
    return this->ends_blocked() ? Cost::infinity() : nodes_[goal_].rhs;
  }

  Path path() override {
    if (status() != PlanStatus::found) return {};
    std::vector<NodeId> nodes;
    for (NodeId s = goal_; s != start_; s = this->parent(s)) nodes.push_back(s);
    nodes.push_back(start_);
    std::reverse(nodes.begin(), nodes.end());
    return Path(lattice_.box(), std::move(nodes));
  }

  void restore(const SearchState& state, const Counters& counters) override {
    this->restore_record(state, counters, [&](NodeId n, Node& node) {
      node.rhs = state.rhs(n);
      return state.k2(n);
    });
    goal_at_ = lattice_.coordinates(goal_);
  }

 private:
  using Base::goal_, Base::lattice_, Base::nodes_, Base::start_, Base::tr_;
  using Base::kNoDirection, Base::least, Base::set_g, Base::set_rhs, Base::set_scalar, Base::top_key;
  using typename Base::Coordinates, typename Base::Node;

  [[nodiscard]] NodeId root() const { return start_; }

  // Line 1.
  [[nodiscard]] Key calculate_key(NodeId s, const Coordinates& at) const {
    return key_of(s, lattice_.bound(heuristic_, at, goal_at_));
  }
  [[nodiscard]] Key key_of(NodeId s, Cost estimate) const { return {least(s) + estimate, least(s)}; }

  // Lines 2-5.
  void initialize(NodeId start) {
    tr_.line(2);
    this->forget_search(start);
    set_scalar(Scalar::start, start_, start);
    goal_at_ = lattice_.coordinates(goal_);
    tr_.line(4);
    set_rhs(start_, Cost::zero());
    tr_.change(EventKind::lp, start_, 0, std::uint64_t{start_ + 1u});
    tr_.line(5);
    update_queue(start_, lattice_.coordinates(start_));
  }

  // Line 6, in full.
  void update_vertex(NodeId u) {
    if (u != start_) {
      Cost best = Cost::infinity();
      std::uint32_t parent = kNoDirection;
      for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
        const int d = std::countr_zero(rest);
        const Cost sum = L::step_cost(d) + nodes_[lattice_.neighbour(u, d)].g;
        if (!(sum < best)) continue;
        best = sum;
        parent = static_cast<std::uint32_t>(d);
      }
      tr_.line(6);
      set_rhs(u, best);
      this->set_parent(u, parent);
    }
    update_queue(u, lattice_.coordinates(u));
  }

  // Line 6 where only one predecessor of s improved: it is reached in direction d, and its way costs `sum`.
  void offer(NodeId s, const Coordinates& at, std::uint32_t d, Cost sum) {
    const Node& node = nodes_[s];
    if (sum > node.rhs || (sum == node.rhs && d >= node.parent) || s == start_) return;
    const bool better = sum < node.rhs;
    tr_.line(6);
    set_rhs(s, sum);
    this->set_parent(s, d);
    if (better) update_queue(s, at);
  }

  // Lines 7-8.
  void update_queue(NodeId u, const Coordinates& at) {
    const Node& node = nodes_[u];
    if (node.g != node.rhs) {
      tr_.line(8);
      this->queue(u, calculate_key(u, at));
    } else if (node.slot != 0) {
      tr_.line(7);
      this->take_out(u);
    }
  }

  /// Line 9: whether the plan is not yet known to be right.
  [[nodiscard]] bool search_needed() const {
    if (this->ends_blocked()) return false;
    return top_key() < key_of(goal_, Cost::zero()) || nodes_[goal_].rhs != nodes_[goal_].g;
  }

  // Lines 9-16: one iteration. False if there was nothing left to do.
  bool compute_shortest_path_step() {
    if (!search_needed()) return false;
    tr_.line(10);
    const NodeId u = this->take_out_top();
    this->count_expansion(u);
    if (nodes_[u].g > nodes_[u].rhs)
      lower_vertex(u, lattice_.coordinates(u));
    else
      raise_vertex(u, lattice_.coordinates(u));
    return true;
  }

  // Lines 12-13: u is overconsistent and becomes consistent.
  void lower_vertex(NodeId u, const Coordinates& u_at) {
    tr_.line(12);
    set_g(u, nodes_[u].rhs);
    const Cost g = nodes_[u].g;
    for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      offer(lattice_.neighbour(u, d), L::step(u_at, d), static_cast<std::uint32_t>(L::reverse(d)),
            L::step_cost(d) + g);
    }
  }

  // Lines 15-16: u is underconsistent. rhs(u) does not depend on g(u).
  void raise_vertex(NodeId u, const Coordinates& u_at) {
    tr_.line(15);
    set_g(u, Cost::infinity());
    for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId s = lattice_.neighbour(u, d);
      if (nodes_[s].parent == static_cast<std::uint32_t>(L::reverse(d)) && s != start_) update_vertex(s);
    }
    update_queue(u, u_at);
  }

  Heuristic heuristic_;
  Coordinates goal_at_{};
};

}  // namespace replan
