// The D* Lite family: one machine with two switches, and therefore longer than other files here.
//
//   line of sight | clearance |
//        off      |    off    | D* Lite        Koenig & Likhachev, "D* Lite", AAAI 2002
//        on       |    off    | Los D* Lite
//        off      |    on     | Dist D* Lite
//        on       |    on     | DLD* Lite      Huang & Zhou, "Path planning of moving robot based on path
//                                              optimization of D* Lite algorithm", Control and Decision 2018,
//                                              doi 10.13195/j.kzyjc.2018.0583
//
// Line numbers are those of the DLD* Lite paper: Algorithm 2 (helper functions) as printed, Algorithm 1
// (main) + 100.
//
// What the print leaves open, and what holds here:
//  * rhs is updated incrementally (lookahead_search.hpp).
//  * A change of clearance is a change of edge costs: every predecessor of a vertex whose dist changed is
//    updated.
//  * km grows by the heuristic rounded *up* (law 6 in lattice.hpp), so that keys in U stay lower bounds.
//  * A remote parent goes stale when the map changes after its sight check. It is checked when it is used
//    (next()): it must be in sight now, consistent, nearer to the goal, settled (key <= U.TopKey()), and no
//    detour: the leap and what is left from there no longer than the way along local parents. Else the local
//    parent is taken. `remote_parents=printed` trusts it instead.
//  * `sight_checks=path` leaves sight out of the search, which then is that of the planner without it, and
//    checks it along the path that is read out (sight_along.hpp). rp is set for vertices of such paths only,
//    and kept while no cell that sight to it depends on has changed.
//  * begin() costs what the search before wrote (node_table.hpp); the clearance field and the map of sight
//    are made anew only if the lattice has changed behind the planner's back.
//  * A remote parent that equals the local parent needs no check.
//  * While the start or the goal lies inside an obstacle the search rests: no work could find a path.
#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

#include "core/planners/dstar_lite_family.hpp"
#include "core/planners/ground.hpp"
#include "core/planners/leaping_path.hpp"
#include "core/planners/lookahead_search.hpp"
#include "core/planners/parent_path.hpp"

namespace replan {

/// What D* Lite remembers of a vertex.
struct DStarLiteNode {
  Cost g = Cost::infinity();
  Cost rhs = Cost::infinity();
  NodeId rp = kNoNode;
  std::uint32_t slot : 27 = 0;    // in U
  std::uint32_t parent : 5 = 31;  // lp, as a direction
};
static_assert(sizeof(DStarLiteNode) == 24, "a large map has many of them");

template <Lattice L, Tracer T, class Faults = NoFaults>
class DStarLite final : public LookaheadSearch<L, T, DStarLiteNode, DStarLite<L, T, Faults>> {
  using Base = LookaheadSearch<L, T, DStarLiteNode, DStarLite<L, T, Faults>>;
  friend Base;

 public:
  DStarLite(const L& lattice, const Settings& settings, T& tracer, DStarLiteSwitches switches)
      : Base(lattice, tracer),
        switches_(switches),
        faults_(settings),
        heuristic_(heuristic_of(describe(switches), settings)),
        along_path_(switches.sight && parameters::checks_along_path(settings)),
        in_search_(switches.sight && !along_path_),
        checked_(!in_search_ || settings.get(parameters::kRemoteParents) == 0),
        ground_(lattice, settings, describe(switches).clearance, in_search_) {
    if (switches_.clearance) marked_.resize(nodes_.size());
  }

  void begin(NodeId start, NodeId goal) override {
    tr_.line(6);
    this->forget_search(start);
    this->begin_counting();
    set_scalar(Scalar::start, start_, start);
    set_scalar(Scalar::last, last_, start);
    set_scalar(Scalar::goal, goal_, goal);
    initialize();
  }

  void update(const MapChange<L>& change, NodeId start) override {
    tr_.line(110);
    const Cost km = km_ + lattice_.bound_up(heuristic_, last_, start);
    tr_.change(Scalar::km, raw(km_), raw(km));
    km_ = km;
    tr_.line(111);
    set_scalar(Scalar::start, start_, start);
    set_scalar(Scalar::last, last_, start);
    start_at_ = lattice_.coordinates(start);
    const auto changed = ground_.update(change.cells);
    if (switches_.clearance) {
      costs_changed(change, changed);
    } else {
      tr_.line(115);
      for (const auto& move : change.moves) this->moves_changed(move.node, move.before);
    }
    if (along_path_) {
      for (const CellEdit& cell : change.cells) leaps_.turn(cell.node);
      leaps_.forget_turned();
    }
  }

  [[nodiscard]] PlanStatus status() const override {
    return this->status_with(search_needed(), nodes_[start_].rhs);
  }
  [[nodiscard]] Cost cost() const override {
    return this->ends_blocked() ? Cost::infinity() : nodes_[start_].rhs;
  }
  [[nodiscard]] std::size_t memory_bytes() const override {
    return Base::memory_bytes() + ground_.memory_bytes() + marked_.capacity() + leaps_.memory_bytes();
  }

  /// Algorithm 1, line 6, from the start on.
  Path path() override {
    tr_.line(106);
    if (status() != PlanStatus::found) return {};
    return along_path_ ? leaps_.read() : parents_.read();
  }

  void restore(const SearchState& state, const Counters& counters) override {
    last_ = state.node(Scalar::last);
    km_ = state.km();
    ground_.make();
    leaps_.clear();
    this->restore_record(state, counters, [&](NodeId n, Node& node) {
      node.rhs = state.rhs(n);
      node.rp = state.rp(n);
      if (along_path_ && node.rp != kNoNode && n != goal_) leaps_.keep({n, node.rp});
      return state.k2(n);
    });
    start_at_ = lattice_.coordinates(start_);
  }

 private:
  friend class LeapingPath<DStarLite, L::kDimensions>;
  friend class ParentPath<DStarLite>;
  static constexpr bool kFaulty = Faults::kAny;
  using Base::counters_, Base::goal_, Base::lattice_, Base::nodes_, Base::open_, Base::start_, Base::tr_;
  using Base::kNoDirection, Base::raw, Base::set_g, Base::set_rhs, Base::set_scalar, Base::top_key;
  using typename Base::Coordinates, typename Base::Node;

  [[nodiscard]] NodeId root() const { return goal_; }

  [[nodiscard]] Path path_over(std::vector<NodeId> nodes) const {
    return Path(lattice_.box(), std::move(nodes), ground_.sight_rule());
  }

  // Algorithm 2, lines 5-17.
  void initialize() {
    tr_.line(7);
    tr_.change(Scalar::km, raw(km_), 0);
    km_ = Cost::zero();
    leaps_.clear();
    start_at_ = lattice_.coordinates(start_);
    tr_.line(12);
    ground_.make(
        [this](NodeId n, Cost before, Cost after) { tr_.change(EventKind::dist, n, before, after); });
    tr_.line(13);
    set_rhs(goal_, Cost::zero());
    tr_.line(14);
    tr_.change(EventKind::lp, goal_, 0, std::uint64_t{goal_ + 1u});
    tr_.line(15);
    set_rp(goal_, goal_);
    tr_.line(16);
    update_queue(goal_);
  }

  /// Line 42: whether the plan is not yet known to be right.
  [[nodiscard]] bool search_needed() const {
    if (this->ends_blocked()) return false;
    return top_key() < key_of(start_, Cost::zero()) || nodes_[start_].rhs != nodes_[start_].g;
  }

  // Algorithm 2, lines 41-64: one iteration. False if there was nothing left to do.
  bool compute_shortest_path_step() {
    if (!search_needed()) return false;
    const Key old_key = open_.top().key;
    tr_.line(44);
    const NodeId u = this->take_out_top();
    if (in_search_) set_vertex(u);
    const Coordinates at = lattice_.coordinates(u);
    const Key key = calculate_key(u, at);
    if (old_key < key) {
      tr_.line(47);
      this->put_in(u, key);
      return true;
    }
    this->count_expansion(u);
    if (nodes_[u].g > nodes_[u].rhs)
      lower_vertex(u, at);
    else
      raise_vertex(u);
    return true;
  }

  // Lines 49-57: u is overconsistent and becomes consistent.
  void lower_vertex(NodeId u, const Coordinates& u_at) {
    tr_.line(49);
    set_g(u, nodes_[u].rhs);
    const Cost through_u = nodes_[u].g + dist(u);
    if (through_u.is_infinite()) return;  // nothing may enter it
    const NodeId remote = nodes_[u].rp;
    const auto remote_at = in_search_ ? lattice_.coordinates(remote) : u_at;
    for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId s = lattice_.neighbour(u, d);
      const auto s_at = L::step(u_at, d);
      offer(s, s_at, static_cast<std::uint32_t>(L::reverse(d)), L::step_cost(d) + through_u);
      if (in_search_ && nodes_[s].slot != 0 && nodes_[s].rp != remote)
        offer_remote(s, remote, L::squared_distance(remote_at, s_at));
    }
  }

  // Lines 52-54, the lazy step: sight from s to rp(u) is assumed, and checked when s is taken from U.
  // c(rp(u), s) + rhs(rp(u)) < rhs(s), with c = sqrt(squared), compared without a root.
  void offer_remote(NodeId s, NodeId remote, std::int64_t squared) {
    const Cost slack{nodes_[s].rhs.raw - nodes_[remote].rhs.raw};
    if (slack <= Cost::zero() || compare_to_segment(slack, squared) <= 0) return;
    tr_.line(54);
    set_rp(s, remote);
  }

  // Lines 59-61: u is underconsistent.
  void raise_vertex(NodeId u) {
    tr_.line(59);
    set_g(u, Cost::infinity());
    for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      if constexpr (Faults::kAny)
        if (faults_.forgets_predecessor(d)) continue;
      const NodeId s = lattice_.neighbour(u, d);
      if (nodes_[s].parent == static_cast<std::uint32_t>(L::reverse(d)) && s != goal_) update_vertex(s);
    }
    update_queue(u);  // rhs(u) does not depend on g(u)
  }

  // Lines 19-33, in full.
  void update_vertex(NodeId u) {
    if (u != goal_) {
      Cost best = Cost::infinity();
      std::uint32_t parent = kNoDirection;
      for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
        const int d = std::countr_zero(rest);
        const NodeId s = lattice_.neighbour(u, d);
        const Cost sum = L::step_cost(d) + nodes_[s].g + dist(s);
        if (sum < best) {
          best = sum;
          if constexpr (Faults::kAny)
            if (faults_.keeps_first_parent() && parent != kNoDirection) continue;
          parent = static_cast<std::uint32_t>(d);
        }
      }
      tr_.line(21);
      set_rhs(u, best);
      tr_.line(22);
      this->set_parent(u, parent);
    }
    update_queue(u);
  }

  // Lines 19-33 where only one successor of s improved: s can be reached in direction d at cost `sum`.
  void offer(NodeId s, const Coordinates& at, std::uint32_t d, Cost sum) {
    const Node& node = nodes_[s];
    if (sum > node.rhs || (sum == node.rhs && d >= node.parent) || s == goal_) return;
    const bool better = sum < node.rhs;
    tr_.line(21);
    set_rhs(s, sum);
    tr_.line(22);
    this->set_parent(s, d);
    if (better) update_queue(s, at);
  }

  // Lines 24-32.
  void update_queue(NodeId u) { update_queue(u, lattice_.coordinates(u)); }
  void update_queue(NodeId u, const Coordinates& at) {
    const Node& node = nodes_[u];
    if (node.rp == kNoNode && !along_path_ && node.parent != kNoDirection) {
      tr_.line(25);
      set_rp(u, lp(u));
    }
    bool wanted = node.g != node.rhs;
    if constexpr (Faults::kAny) wanted |= faults_.leaves_in_queue() && node.slot != 0;
    if (wanted) {
      tr_.line(31);
      this->queue(u, calculate_key(u, at));
    } else if (node.slot != 0) {
      tr_.line(28);
      this->take_out(u);
    }
  }

  // Lines 35-39.
  void set_vertex(NodeId u) {
    const NodeId local = lp(u);
    const NodeId remote = nodes_[u].rp;
    if (remote == local || u == goal_) return;
    tr_.line(36);
    if (remote != kNoNode && in_sight(remote, u)) return;
    tr_.line(37);
    set_rp(u, local);
  }

  // Kept out of line: its code would make that of the search slower.
  [[gnu::noinline]] bool in_sight(NodeId n, NodeId s) {
    ++counters_.sight_checks;
    const bool seen = ground_.sees(n, s);
    tr_.note(EventKind::sight, s, std::uint64_t{n} | std::uint64_t{seen} << 32);
    return seen;
  }

  [[nodiscard]] bool settled(NodeId n) const {
    return nodes_[n].g == nodes_[n].rhs && calculate_key(n) <= top_key();
  }

  // Lines 12-15 of Algorithm 1 with clearance on: penalties change around a changed cell, and with them the
  // cost of every edge that leads to such a vertex.
  void costs_changed(const MapChange<L>& change, std::span<const ClearanceChange> dist_changed) {
    affected_.clear();
    const auto affect = [this](NodeId n) {
      if (marked_[n] == 0) affected_.push_back(n);
      marked_[n] = 1;
    };
    for (const auto& move : change.moves) affect(move.node);
    tr_.line(114);
    for (const ClearanceChange& changed : dist_changed) {
      tr_.change(EventKind::dist, changed.node, changed.before, dist(changed.node));
      if (along_path_ && ground_.turned(changed)) leaps_.turn(changed.node);
      for (std::uint32_t rest = lattice_.moves(changed.node); rest != 0; rest &= rest - 1)
        affect(lattice_.neighbour(changed.node, std::countr_zero(rest)));
    }
    tr_.line(115);
    for (const NodeId n : affected_) {
      marked_[n] = 0;
      update_vertex(n);
    }
  }

  [[nodiscard]] Cost dist(NodeId s) const { return ground_.dist(s); }

  // Lines 1-3.
  [[nodiscard]] Key calculate_key(NodeId s) const { return calculate_key(s, lattice_.coordinates(s)); }
  [[nodiscard]] Key calculate_key(NodeId s, const Coordinates& at) const {
    return key_of(s, lattice_.bound(heuristic_, start_at_, at));
  }
  [[nodiscard]] Key key_of(NodeId s, Cost estimate) const {
    const Cost least = this->least(s);
    if constexpr (Faults::kAny)
      if (faults_.forgets_km()) return {least + estimate, least};
    return {least + estimate + km_, least};
  }

  [[nodiscard]] NodeId lp(NodeId s) const { return s == goal_ ? goal_ : this->parent(s); }

  // As set_g(), set_rhs() and set_parent(): every write of a value, so that the log misses none.
  void set_rp(NodeId s, NodeId parent) {
    tr_.change(EventKind::rp, s, std::uint64_t{nodes_[s].rp + 1u}, std::uint64_t{parent + 1u});
    nodes_.held(s).rp = parent;
  }

  DStarLiteSwitches switches_;
  [[no_unique_address]] Faults faults_;
  Heuristic heuristic_;
  bool along_path_, in_search_;  // where sight is checked
  bool checked_;                 // remote parents, when they are used
  Ground<L> ground_;
  NodeId last_ = kNoNode;
  Coordinates start_at_{};
  Cost km_ = Cost::zero();
  LeapingPath<DStarLite, L::kDimensions> leaps_{*this};  // with along_path_
  ParentPath<DStarLite> parents_{*this};                 // else
  std::vector<NodeId> affected_;
  std::vector<std::uint8_t> marked_;  // 1 while a node is among affected_
};

}  // namespace replan
