// Field D*: D* Lite whose paths cross the grid between the centres of cells, by interpolated costs.
//
//  Ferguson & Stentz, "Using Interpolation to Improve Path Planning: The Field D* Algorithm", Journal of Field Robotics
//  23(2), 2006, doi 10.1002/rob.20109
//
// Line numbers are those of assets/planners/field-dstar.md: the mission has 100 added.
//
// What is settled here:
//  * Vertices are centres of cells and not their corners, and what a way crosses is the square between four of them, open
//    or closed (core/lattice/interpolation.hpp). So ComputeCost has two cases left of the paper's five: a move, and a way
//    across an open square. Corner rules hold for moves; squares are crossed only where all four cells are free.
//  * Costs are whole numbers, and the way across is rounded up. rhs is then a strictly weakly superior function of g, so
//    that repairs end with the values of a search from scratch, bit for bit.
//  * The heuristic is the lattice's, divided by sqrt 2. A way across may lead to its straight neighbour with a g that is
//    less by 1 / sqrt 2 alone, so that a plain distance is not consistent, and the search would end too early.
//  * lp(s) is the straight end of the far side that the way across leads to, or where the move leads; `side` is the other
//    end. Both have a g below rhs(s), so that lp alone leads to the goal too.
//  * rhs is updated incrementally (lookahead_search.hpp), as in the paper's second version of UpdateState.
//  * km grows by the heuristic rounded up, as in D* Lite.
//  * The path is read out by interpolation between settled vertices alone (interpolated_path.hpp).
//  * While the start or the goal lies inside an obstacle the search rests: no work could find a path.
#pragma once

#include <algorithm>
#include <bit>
#include <utility>

#include "core/lattice/interpolation.hpp"
#include "core/plan/common_parameters.hpp"
#include "core/plan/registry.hpp"
#include "core/planners/interpolated_path.hpp"
#include "core/planners/lookahead_search.hpp"

namespace replan {

struct FieldDStarSwitches {};

inline PlannerInfo describe(FieldDStarSwitches) {
  PlannerInfo info;
  info.name = "Field D*";
  info.summary =
      "D* Lite with interpolated costs: its path crosses the grid in any direction, and it is repaired.";
  info.source = "Ferguson & Stentz 2006, doi 10.1002/rob.20109";
  info.incremental = info.from_goal = info.any_angle = true;
  info.planar = info.eight_neighbours = true;
  info.values = lookahead_values();
  info.values.least_cost = false;
  info.values.interpolated = true;
  info.values.laws = "interpolated";
  info.values.fields.push_back(fields::kSide);
  info.parameters = {parameters::kHeuristic};
  // InterpolatedPath::along_moves() has the proof.
  info.length_bound = [](const Settings&) { return kMostOverInterpolated; };
  return info;
}

/// What Field D* remembers of a vertex.
struct FieldDStarNode {
  Cost g = Cost::infinity();
  Cost rhs = Cost::infinity();
  std::uint32_t slot : 27 = 0;              // in U
  std::uint32_t parent : 5 = WayOn::kNone;  // lp, as a direction
  std::uint32_t side = WayOn::kNone;        // the other end, as a direction
};
static_assert(sizeof(FieldDStarNode) == 24, "a large map has many of them");

template <Lattice L, Tracer T>
requires(L::kDimensions == 2) class FieldDStar final
    : public LookaheadSearch<L, T, FieldDStarNode, FieldDStar<L, T>> {
  using Base = LookaheadSearch<L, T, FieldDStarNode, FieldDStar<L, T>>;
  friend Base;

 public:
  FieldDStar(const L& lattice, const Settings& settings, T& tracer, FieldDStarSwitches switches)
      : Base(lattice, tracer), heuristic_(heuristic_of(describe(switches), settings)) {}

  // Lines 2-6.
  void begin(NodeId start, NodeId goal) override {
    tr_.line(2);
    this->forget_search(start);
    this->begin_counting();
    set_scalar(Scalar::start, start_, start);
    set_scalar(Scalar::last, last_, start);
    set_scalar(Scalar::goal, goal_, goal);
    tr_.change(Scalar::km, raw(km_), 0);
    km_ = Cost::zero();
    start_at_ = lattice_.coordinates(start_);
    tr_.line(5);
    set_rhs(goal_, Cost::zero());
    tr_.change(EventKind::lp, goal_, 0, std::uint64_t{goal_ + 1u});
    tr_.line(6);
    update_queue(goal_, lattice_.coordinates(goal_));
  }

  // Lines 10-15 of the mission.
  void update(const MapChange<L>& change, NodeId start) override {
    tr_.line(110);
    const Cost km = km_ + interpolated_bound_up(lattice_.bound_up(heuristic_, last_, start));
    tr_.change(Scalar::km, raw(km_), raw(km));
    km_ = km;
    set_scalar(Scalar::start, start_, start);
    set_scalar(Scalar::last, last_, start);
    start_at_ = lattice_.coordinates(start);
    tr_.line(115);
    for (const auto& move : change.moves) update_state(move.node);
  }

  [[nodiscard]] PlanStatus status() const override {
    return this->status_with(search_needed(), nodes_[start_].rhs);
  }
  /// By interpolation; its path may be a little longer or shorter.
  [[nodiscard]] Cost cost() const override {
    return this->ends_blocked() ? Cost::infinity() : nodes_[start_].rhs;
  }

  Path path() override {
    tr_.line(106);
    if (status() != PlanStatus::found) return {};
    return InterpolatedPath(*this).read();
  }

  void restore(const SearchState& state, const Counters& counters) override {
    last_ = state.node(Scalar::last);
    km_ = state.km();
    this->restore_record(state, counters, [&](NodeId n, Node& node) {
      node.rhs = state.rhs(n);
      node.side = this->direction_to(n, static_cast<NodeId>(state.value(fields::kSide.kind, n)) - 1u);
      return state.k2(n);
    });
    start_at_ = lattice_.coordinates(start_);
  }

 private:
  friend class InterpolatedPath<FieldDStar>;
  using Base::goal_, Base::lattice_, Base::nodes_, Base::start_, Base::tr_;
  using Base::least, Base::raw, Base::set_g, Base::set_rhs, Base::set_scalar, Base::top_key;
  using typename Base::Coordinates, typename Base::Node;

  // Line 1.
  [[nodiscard]] Key calculate_key(NodeId s, const Coordinates& at) const {
    return key_of(s, interpolated_bound(lattice_.bound(heuristic_, start_at_, at)));
  }
  [[nodiscard]] Key key_of(NodeId s, Cost estimate) const { return {least(s) + estimate + km_, least(s)}; }

  /// The g of the neighbours of s, by their directions.
  [[nodiscard]] auto g_around(NodeId s) const {
    return [this, s](int d) { return nodes_[lattice_.neighbour(s, d)].g; };
  }

  // Line 7, in full.
  void update_state(NodeId u) {
    if (u != goal_) {
      const WayOn way = best_way_on(lattice_.moves(u), g_around(u));
      tr_.line(8);
      set_rhs(u, way.cost);
      set_way(u, way);
    }
    update_queue(u, lattice_.coordinates(u));
  }

  // Line 8 where only one neighbour of s improved, which lies in direction d.
  void offer(NodeId s, const Coordinates& at, int d) {
    if (s == goal_) return;
    const Node& node = nodes_[s];
    const WayOn before{node.rhs, node.parent, node.side};
    const WayOn best = better_way_over(d, lattice_.moves(s), g_around(s), before);
    if (!(best < before)) return;
    tr_.line(8);
    set_rhs(s, best.cost);
    set_way(s, best);
    if (best.cost < before.cost) update_queue(s, at);
  }

  // Lines 9-10.
  void update_queue(NodeId u, const Coordinates& at) {
    const Node& node = nodes_[u];
    if (node.g != node.rhs) {
      tr_.line(10);
      this->queue(u, calculate_key(u, at));
    } else if (node.slot != 0) {
      tr_.line(9);
      this->take_out(u);
    }
  }

  /// Line 12: whether the plan is not yet known to be right.
  [[nodiscard]] bool search_needed() const {
    if (this->ends_blocked()) return false;
    return top_key() < key_of(start_, Cost::zero()) || nodes_[start_].rhs != nodes_[start_].g;
  }

  // Lines 12-23: one iteration. False if there was nothing left to do.
  bool compute_shortest_path_step() {
    if (!search_needed()) return false;
    const Key old_key = this->open_.top().key;
    tr_.line(13);
    const NodeId u = this->take_out_top();
    const Coordinates at = lattice_.coordinates(u);
    if (const Key key = calculate_key(u, at); old_key < key) {
      tr_.line(15);
      this->put_in(u, key);
      return true;
    }
    this->count_expansion(u);
    if (nodes_[u].g > nodes_[u].rhs)
      lower_state(u, at);
    else
      raise_state(u, at);
    return true;
  }

  // Lines 17-19: u is overconsistent and becomes consistent.
  void lower_state(NodeId u, const Coordinates& u_at) {
    tr_.line(17);
    set_g(u, nodes_[u].rhs);
    for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      offer(lattice_.neighbour(u, d), L::step(u_at, d), L::reverse(d));
    }
  }

  // Lines 21-23: u is underconsistent. rhs(u) does not depend on g(u).
  void raise_state(NodeId u, const Coordinates& u_at) {
    tr_.line(21);
    set_g(u, Cost::infinity());
    for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const Node& s = nodes_[lattice_.neighbour(u, d)];
      const auto back = static_cast<std::uint32_t>(L::reverse(d));
      if (s.parent == back || s.side == back) update_state(lattice_.neighbour(u, d));
    }
    update_queue(u, u_at);
  }

  /// lp and side, of a vertex whose rhs is written.
  void set_way(NodeId s, const WayOn& way) {
    this->set_parent(s, way.to);
    const auto logged = [this, s](std::uint32_t d) {
      return d == WayOn::kNone ? std::uint64_t{0}
                               : std::uint64_t{lattice_.neighbour(s, static_cast<int>(d)) + 1u};
    };
    tr_.change(fields::kSide.kind, s, logged(nodes_[s].side), logged(way.and_to));
    nodes_.held(s).side = way.and_to;
  }

  /// Whether g(n) is known to be right.
  [[nodiscard]] bool settled(NodeId n) const {
    return nodes_[n].g == nodes_[n].rhs && calculate_key(n, lattice_.coordinates(n)) <= top_key();
  }

  Heuristic heuristic_;
  NodeId last_ = kNoNode;
  Coordinates start_at_{};
  Cost km_ = Cost::zero();
};

}  // namespace replan
