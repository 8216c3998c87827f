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
//  * rhs is updated incrementally (Koenig & Likhachev, "Fast replanning for navigation in unknown terrain",
//    IEEE Trans. Robotics 21(3), 2005, "optimised D* Lite"): where one successor improved, the minimum is
//    that of two numbers; where one got worse, it is taken anew only if that successor was the argmin. Costs
//    and parents are those of the plain version.
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
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/field/clearance.hpp"
#include "core/lattice/sight.hpp"
#include "core/plan/common_parameters.hpp"
#include "core/plan/node_table.hpp"
#include "core/plan/open_list.hpp"
#include "core/plan/planner.hpp"
#include "core/plan/registry.hpp"
#include "core/planners/kept_leaps.hpp"
#include "core/planners/sight_along.hpp"
#include "core/planners/visits.hpp"
#include "core/trace/search_state.hpp"
#include "core/trace/tracer.hpp"

namespace replan {

struct DStarLiteSwitches {
  bool sight = false;
  bool clearance = false;
};

inline PlannerInfo describe(DStarLiteSwitches switches) {
  using namespace parameters;
  PlannerInfo info;
  info.incremental = info.from_goal = true;
  info.values = lookahead_values();
  if (switches.sight) info.values.fields.push_back(fields::kRp);
  if (switches.clearance) info.values.fields.push_back(fields::kDist);
  info.any_angle = info.sight = switches.sight;
  info.clearance = switches.clearance;
  info.parameters = {kHeuristic};
  info.source = "Koenig & Likhachev, D* Lite, AAAI 2002";
  if (switches.sight || switches.clearance)
    info.source = "Huang & Zhou, Control and Decision 2018, doi 10.13195/j.kzyjc.2018.0583";
  if (switches.sight) info.parameters.insert(info.parameters.end(), {kSight, kSightChecks, kRemoteParents});
  if (switches.clearance) info.parameters.insert(info.parameters.end(), {kRange, kTransform, kBorder});
  if (switches.sight && switches.clearance) {
    info.name = "DLD* Lite";
    info.summary =
        "D* Lite with a lazy line of sight and a distance transform: smooth, safe, repairable paths.";
  } else if (switches.sight) {
    info.name = "Los D* Lite";
    info.summary = "D* Lite with a lazy line of sight: any-angle paths that hug corners.";
  } else if (switches.clearance) {
    info.name = "Dist D* Lite";
    info.summary = "D* Lite with a penalty near obstacles: lattice paths that keep their distance.";
  } else {
    info.name = "D* Lite";
    info.summary = "Searches from the goal and repairs its plan when the map changes.";
  }
  // A path costs no more than the shortest one, of which each cell costs at most 1 + range times its length.
  static constexpr auto kBound = [](const Settings& settings, double by_clearance) {
    const bool trusts = settings.get(kRemoteParents) != 0 && !checks_along_path(settings);
    return trusts ? std::numeric_limits<double>::infinity() : by_clearance;
  };
  info.length_bound =
      switches.clearance
          ? +[](const Settings& settings) { return kBound(settings, 1 + settings.get(kRange)); }
          : +[](const Settings& settings) { return kBound(settings, 1); };
  return info;
}

/// Nothing is wrong. What a policy that puts mistakes in answers is in broken_dstar_lite.hpp.
struct NoFaults {
  static constexpr bool kAny = false;
  explicit NoFaults(const Settings&) {}
};

template <Lattice L, Tracer T, class Faults = NoFaults>
class DStarLite final : public Planner<L> {
 public:
  DStarLite(const L& lattice, const Settings& settings, T& tracer, DStarLiteSwitches switches)
      : lattice_(lattice),
        tr_(tracer),
        nodes_(lattice.node_count()),
        switches_(switches),
        faults_(settings),
        visits_(lattice.node_count()) {
    using namespace parameters;
    heuristic_ =
        static_cast<Heuristic>(kHeuristicByChoice[static_cast<std::size_t>(settings.get(kHeuristic))]);
    sight_rule_ = static_cast<SightRule>(settings.get(kSight));
    along_path_ = switches_.sight && checks_along_path(settings);
    in_search_ = switches_.sight && !along_path_;
    checked_ = !in_search_ || settings.get(kRemoteParents) == 0;
    clearance_rules_ = clearance_rules_of(settings);
    if (switches_.clearance) marked_.resize(nodes_.size());
  }

  void begin(NodeId start, NodeId goal) override {
    tr_.line(6);
    if (goal_ != kNoNode) tr_.note(EventKind::epoch, start);
    counters_ = {};
    visits_.begin();
    set_scalar(Scalar::start, start_, start);
    set_scalar(Scalar::last, last_, start);
    set_scalar(Scalar::goal, goal_, goal);
    initialize();
  }

  bool advance(std::int64_t iterations) override {
    for (; iterations > 0; --iterations)
      if (!compute_shortest_path_step()) return true;
    return !search_needed();
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
    fields_revision_ = lattice_.revision();
    turned_.clear();
    if (switches_.clearance) {
      costs_changed(change);
    } else {
      tr_.line(115);
      for (const auto& move : change.moves) moves_changed(move.node, move.before);
      if (in_search_)
        for (const CellEdit& cell : change.cells)
          sight_map_.change(lattice_.coordinates(cell.node), cell.blocked);
    }
    if (along_path_) keep_leaps(change);
  }

  [[nodiscard]] PlanStatus status() const override {
    if (lattice_.blocked(start_)) return PlanStatus::start_blocked;
    if (lattice_.blocked(goal_)) return PlanStatus::goal_blocked;
    if (search_needed()) return PlanStatus::searching;
    return nodes_[start_].rhs.is_infinite() ? PlanStatus::no_path : PlanStatus::found;
  }
  [[nodiscard]] Cost cost() const override { return resting() ? Cost::infinity() : nodes_[start_].rhs; }
  [[nodiscard]] Counters counters() const override { return counters_; }
  [[nodiscard]] std::size_t memory_bytes() const override {
    return nodes_.memory_bytes() + open_.peak_bytes() + clearance_.memory_bytes() +
           sight_map_.memory_bytes() + marked_.capacity() + kept_leaps_.memory_bytes();
  }

  /// Algorithm 1, line 6, from the start on. What it calls is marked cold, so that the compiler spends no
  /// inlining on it that the search is in want of: 4 % of its instructions.
  Path path() override {
    tr_.line(106);
    if (status() != PlanStatus::found) return {};
    return along_path_ ? leaping_path() : path_of_parents();
  }

  void restore(const SearchState& state, const Counters& counters) override {
    counters_ = counters;
    start_ = state.node(Scalar::start);
    last_ = state.node(Scalar::last);
    goal_ = state.node(Scalar::goal);
    start_at_ = lattice_.coordinates(start_);
    km_ = state.km();
    open_.clear(nodes_);
    fields_revision_ = lattice_.revision();
    if (switches_.clearance) clearance_ = ClearanceField<L::kDimensions>(lattice_, clearance_rules_);
    if (in_search_) sight_map_ = SightMap<L::kDimensions>(lattice_, [this](NodeId c) { return is_bad(c); });
    kept_leaps_.clear();
    visits_.restore(state, counters.expansions);
    for (NodeId n = 0; n < nodes_.size(); ++n) restore_node(state, n);
  }

 private:
  using Coordinates = typename L::Coordinates;
  static constexpr std::uint32_t kNoDirection = 31;
  static constexpr std::size_t kMostKept = 64;  // leaps that a path does not take, besides twice its own
  static constexpr Heuristic kHeuristicByChoice[] = {Heuristic::octile, Heuristic::euclidean,
                                                     Heuristic::zero};

  struct Node {
    Cost g = Cost::infinity();
    Cost rhs = Cost::infinity();
    NodeId rp = kNoNode;
    std::uint32_t slot : 27 = 0;          // place in U + 1; kMaxCells fits
    std::uint32_t lp : 5 = kNoDirection;  // direction of the local parent
  };

  static constexpr std::uint64_t raw(Cost cost) { return static_cast<std::uint64_t>(cost.raw); }
  void set_scalar(Scalar which, NodeId& held, NodeId node) {
    tr_.change(which, std::uint64_t{held + 1u}, std::uint64_t{node + 1u});
    held = node;
  }

  // Algorithm 2, lines 5-17.
  void initialize() {
    tr_.line(6);
    open_.clear(nodes_);
    tr_.line(7);
    tr_.change(Scalar::km, raw(km_), 0);
    km_ = Cost::zero();
    nodes_.reset();
    kept_leaps_.clear();
    start_at_ = lattice_.coordinates(start_);
    tr_.line(12);
    make_fields();
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
    if (resting()) return false;
    return top_key() < key_of(start_, Cost::zero()) || nodes_[start_].rhs != nodes_[start_].g;
  }
  [[nodiscard]] bool resting() const { return lattice_.blocked(start_) || lattice_.blocked(goal_); }

  // Algorithm 2, lines 41-64: one iteration. False if there was nothing left to do.
  bool compute_shortest_path_step() {
    if (!search_needed()) return false;
    const Key old_key = open_.top().key;
    const NodeId u = open_.top().node;
    tr_.line(44);
    tr_.note(EventKind::pop, u);
    take_out_top();
    if (in_search_) set_vertex(u);
    const Coordinates at = lattice_.coordinates(u);
    const Key key = calculate_key(u, at);
    if (old_key < key) {
      tr_.line(47);
      put_in(u, key);
      return true;
    }
    ++counters_.expansions;
    visits_.record(tr_, u);
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
      if (nodes_[s].lp == static_cast<std::uint32_t>(L::reverse(d)) && s != goal_) update_vertex(s);
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
      set_lp(u, parent);
    }
    update_queue(u);
  }

  // Lines 19-33 where only one successor of s improved: s can be reached in direction d at cost `sum`.
  void offer(NodeId s, const Coordinates& at, std::uint32_t d, Cost sum) {
    Node& node = nodes_[s];
    if (sum > node.rhs || (sum == node.rhs && d >= node.lp) || s == goal_) return;
    const bool better = sum < node.rhs;
    tr_.line(21);
    set_rhs(s, sum);
    tr_.line(22);
    set_lp(s, d);
    if (better) update_queue(s, at);
  }

  // Lines 24-32.
  void update_queue(NodeId u) { update_queue(u, lattice_.coordinates(u)); }
  void update_queue(NodeId u, const Coordinates& at) {
    Node& node = nodes_[u];
    if (node.rp == kNoNode && !along_path_ && node.lp != kNoDirection) {
      tr_.line(25);
      set_rp(u, lp(u));
    }
    bool wanted = node.g != node.rhs;
    if constexpr (Faults::kAny) wanted |= faults_.leaves_in_queue() && node.slot != 0;
    if (wanted) {
      tr_.line(31);
      if (node.slot != 0)
        re_key(u, calculate_key(u, at));
      else
        put_in(u, calculate_key(u, at));
    } else if (node.slot != 0) {
      tr_.line(28);
      take_out(u);
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
  /// Whether n and s see each other: a cell is bad if it is an obstacle or, with clearance on, dist != 0.
  [[gnu::noinline]] bool in_sight(NodeId n, NodeId s) {
    ++counters_.sight_checks;
    const auto bad = [this](NodeId c) { return is_bad(c); };
    const bool seen = along_path_ ? line_of_sight(lattice_, sight_rule_, n, s, bad)
                                  : line_of_sight(lattice_, sight_rule_, n, s, bad, sight_map_);
    tr_.note(EventKind::sight, s, std::uint64_t{n} | std::uint64_t{seen} << 32);
    return seen;
  }

  [[nodiscard]] bool is_bad(NodeId c) const {
    return switches_.clearance ? clearance_.near(c) : lattice_.blocked(c);
  }

  /// Only parents that may be wrong are watched for circles.
  [[gnu::cold]] Path path_of_parents() {
    std::vector<NodeId> nodes = {start_};
    std::unordered_set<NodeId> passed;
    bool unchecked = false;
    ways_.clear();
    for (NodeId s = start_; s != goal_;) {
      if ((Faults::kAny || !checked_) && !passed.insert(s).second) break;
      s = next(s, unchecked);
      if (s == kNoNode) break;  // printed mode only: a stale parent led where nothing leads on
      nodes.push_back(s);
    }
    const bool arrives = nodes.back() == goal_;
    Path path(lattice_.box(), std::move(nodes), sight_rule_);
    path.loops = !arrives;
    path.unchecked = unchecked;
    return path;
  }

  /// Where the robot goes from s: the remote parent if it can be trusted, else the local one.
  NodeId next(NodeId s, bool& unchecked) {
    const NodeId local = lp(s);
    const NodeId remote = nodes_[s].rp;
    if (!switches_.sight || remote == local) return local;
    if (!checked_) {
      if (remote != kNoNode) tr_.note(EventKind::unchecked, s, remote);
      unchecked = true;
      return remote;
    }
    return remote != kNoNode && settled(remote) && saves_way(s, remote) && in_sight(remote, s) ? remote
                                                                                               : local;
  }
  /// Whether going straight from s to n is no detour: c(s, n) + g(n) <= rhs(s). With clearance g counts
  /// penalties besides, which a longer way may save, so the lengths of both ways are held against each other
  /// too.
  [[nodiscard]] bool saves_way(NodeId s, NodeId n) {
    const std::int64_t squared = lattice_.squared_distance(s, n);
    const auto fits = [squared](Cost from_s, Cost from_n) {
      return from_n < from_s && compare_to_segment({from_s.raw - from_n.raw}, squared) >= 0;
    };
    return fits(nodes_[s].rhs, nodes_[n].g) && (!switches_.clearance || fits(way(s), way(n)));
  }
  /// The length of the way from s along local parents; s is settled. Each stretch is walked once a path.
  [[gnu::cold]] Cost way(NodeId s) {
    std::vector<NodeId> passed;
    for (; s != goal_ && !ways_.contains(s); s = lp(s)) passed.push_back(s);
    Cost length = s == goal_ ? Cost::zero() : ways_[s];
    for (std::size_t i = passed.size(); i-- > 0;) {
      length = length + L::step_cost(static_cast<int>(nodes_[passed[i]].lp));
      ways_[passed[i]] = length;
    }
    return length;
  }

  // Algorithm 3, lines 1-8: along the leaps that are kept, and where there is none a new one.
  [[gnu::noinline]] Path leaping_path() {
    chain_.clear();
    leads_ = kNoNode;
    std::vector<NodeId> nodes = {start_};
    nodes.reserve(kept_leaps_.size() + 1);
    for (NodeId s = start_; s != goal_; nodes.push_back(s)) {
      if (!leads_ahead(s)) set_leap(s);
      s = nodes_[s].rp;
    }
    if (kept_leaps_.size() > kMostKept + 2 * nodes.size()) {
      tr_.line(207);
      forget(kept_leaps_.take_others(nodes));
    }
    return Path(lattice_.box(), std::move(nodes), sight_rule_);
  }

  // Line 4: whether s has a leap, and it ends on the way from s along local parents, on which g falls.
  // The last answer is remembered: the path often goes on from there.
  [[nodiscard]] bool leads_ahead(const NodeId s) {
    const NodeId end = nodes_[s].rp;
    if (s == leads_ || end == kNoNode) return s == leads_;
    const Cost g = nodes_[end].g;
    NodeId next = s;
    do {
      next = lattice_.neighbour(next, static_cast<int>(nodes_[next].lp));
    } while (next != end && g < nodes_[next].g);
    if (next != end) return false;
    leads_ = s;
    return true;
  }

  // Line 5.
  [[gnu::cold]] void set_leap(NodeId s) {
    const NodeId end = farthest_seen(s);
    tr_.line(205);
    if (nodes_[s].rp != kNoNode) kept_leaps_.remove(s, lattice_.coordinates(s));  // it leads ahead no more
    set_rp(s, end);
    keep({s, end});
  }

  // Lines 9-17.
  [[gnu::cold]] NodeId farthest_seen(NodeId s) {
    const auto sees = [&](int line, NodeId n) {
      tr_.line(line);
      return in_sight(n, s);
    };
    if (lp(s) == goal_ || sees(210, goal_)) return goal_;
    read_chain(s);
    const NodeId* const chain = &chain_[at_];
    const std::size_t last = chain_.size() - 1 - at_;
    NodeId end = chain[last];
    if (end == goal_ || (last > 1 && !sees(212, end))) {
      at_ += leap_along(straight_along(last), last,
                        [&](int line, std::size_t k) { return sees(line, chain[k]); });
      return chain_[at_];
    }
    while (end != goal_ && leads_ahead(end) && sees(213, nodes_[end].rp)) end = nodes_[end].rp;
    return end;
  }

  /// Line 11: the chain of local parents from s to the next vertex with a leap that leads ahead, or to the
  /// goal. What was read for the leap before goes on from its end.
  [[gnu::cold]] void read_chain(NodeId s) {
    if (at_ < chain_.size() && chain_[at_] == s) return;
    at_ = 0;
    chain_.assign(1, s);
    do chain_.push_back(s = lp(s));
    while (s != goal_ && !leads_ahead(s));
  }

  /// How far sight along the chain needs no check, up to number `last` of it. Moves that go on in one
  /// direction ask no less of the map than sight does; but with clearance a move may lead past an obstacle,
  /// sight not.
  [[gnu::cold]] std::size_t straight_along(std::size_t last) const {
    std::size_t k = 1;
    if (!switches_.clearance)
      while (k < last && nodes_[chain_[at_ + k]].lp == nodes_[chain_[at_]].lp) ++k;
    return k;
  }

  // Lines 17-19: sight is a matter of the cells in the box that both ends span. Where none of them changed a
  // leap need not be looked at again.
  [[gnu::cold]] void keep_leaps(const MapChange<L>& change) {
    for (const CellEdit& edit : change.cells) turned_.push_back(edit.node);
    std::vector<Coordinates> places;
    places.reserve(turned_.size());
    for (const NodeId cell : turned_) places.push_back(lattice_.coordinates(cell));
    tr_.line(219);
    forget(kept_leaps_.take_touched(places));
  }
  [[gnu::cold]] void keep(Leap leap) {
    kept_leaps_.add(leap, lattice_.coordinates(leap.from), lattice_.coordinates(leap.to));
  }
  [[gnu::cold]] void forget(const std::vector<Leap>& leaps) {
    for (const Leap& leap : leaps) set_rp(leap.from, kNoNode);
  }

  [[nodiscard]] bool settled(NodeId n) const {
    return nodes_[n].g == nodes_[n].rhs && calculate_key(n) <= top_key();
  }

  // Lines 12-15 of Algorithm 1 with clearance off: the moves of u have changed.
  void moves_changed(NodeId u, std::uint32_t before) {
    if (u == goal_) return;
    const std::uint32_t now = lattice_.moves(u);
    const Node& node = nodes_[u];
    if (node.lp != kNoDirection && ((before & ~now) >> node.lp & 1u) != 0) {
      update_vertex(u);
      return;
    }
    for (std::uint32_t rest = now & ~before; rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const Cost sum = L::step_cost(d) + nodes_[lattice_.neighbour(u, d)].g;
      if (!sum.is_infinite()) offer(u, lattice_.coordinates(u), static_cast<std::uint32_t>(d), sum);
    }
  }

  // Lines 12-15 of Algorithm 1 with clearance on: penalties change around a changed cell, and with them the
  // cost of every edge that leads to such a vertex.
  void costs_changed(const MapChange<L>& change) {
    affected_.clear();
    const auto affect = [this](NodeId n) {
      if (marked_[n] == 0) affected_.push_back(n);
      marked_[n] = 1;
    };
    for (const auto& move : change.moves) affect(move.node);
    tr_.line(114);
    for (const ClearanceChange& changed : clearance_.update(lattice_, change.cells)) {
      const Cost penalty = clearance_.penalty(changed.node);
      tr_.change(EventKind::dist, changed.node, changed.before, penalty);
      if (changed.before == Cost::zero() || penalty == Cost::zero()) {
        if (along_path_) turned_.push_back(changed.node);
        if (in_search_) sight_map_.change(lattice_.coordinates(changed.node), penalty != Cost::zero());
      }
      for (std::uint32_t rest = lattice_.moves(changed.node); rest != 0; rest &= rest - 1)
        affect(lattice_.neighbour(changed.node, std::countr_zero(rest)));
    }
    tr_.line(115);
    for (const NodeId n : affected_) {
      marked_[n] = 0;
      update_vertex(n);
    }
  }

  // What is known of the whole map is made anew only if the lattice has changed behind the planner's back.
  void make_fields() {
    if (fields_revision_ == lattice_.revision()) return;
    fields_revision_ = lattice_.revision();
    if (switches_.clearance) distance_transform();
    if (in_search_) sight_map_ = SightMap<L::kDimensions>(lattice_, [this](NodeId c) { return is_bad(c); });
  }
  void distance_transform() {
    ClearanceField<L::kDimensions> field(lattice_, clearance_rules_);
    if constexpr (T::kEnabled)
      for (NodeId n = 0; n < nodes_.size(); ++n)
        tr_.change(EventKind::dist, n, clearance_.empty() ? Cost::zero() : dist(n), field.penalty(n));
    clearance_ = std::move(field);
  }
  [[nodiscard]] Cost dist(NodeId s) const {
    return switches_.clearance ? clearance_.penalty(s) : Cost::zero();
  }

  // Lines 1-3.
  [[nodiscard]] Key calculate_key(NodeId s) const { return calculate_key(s, lattice_.coordinates(s)); }
  [[nodiscard]] Key calculate_key(NodeId s, const Coordinates& at) const {
    return key_of(s, lattice_.bound(heuristic_, start_at_, at));
  }
  [[nodiscard]] Key key_of(NodeId s, Cost estimate) const {
    const Cost least = std::min(nodes_[s].g, nodes_[s].rhs);
    if constexpr (Faults::kAny)
      if (faults_.forgets_km()) return {least + estimate, least};
    return {least + estimate + km_, least};
  }
  [[nodiscard]] Key top_key() const { return open_.empty() ? Key{} : open_.top().key; }

  [[nodiscard]] NodeId lp(NodeId s) const {
    if (s == goal_) return goal_;
    return nodes_[s].lp == kNoDirection ? kNoNode : lattice_.neighbour(s, static_cast<int>(nodes_[s].lp));
  }

  // Every write of a value goes through one of these, so that the log misses none.
  void set_g(NodeId s, Cost value) {
    tr_.change(EventKind::g, s, nodes_[s].g, value);
    nodes_[s].g = value;
  }
  void set_rhs(NodeId s, Cost value) {
    nodes_.mark(s);  // rhs is the first value of a vertex that is written
    tr_.change(EventKind::rhs, s, nodes_[s].rhs, value);
    nodes_[s].rhs = value;
  }
  void set_lp(NodeId s, std::uint32_t d) {
    const NodeId before = lp(s);
    nodes_[s].lp = d & 31u;
    tr_.change(EventKind::lp, s, std::uint64_t{before + 1u}, std::uint64_t{lp(s) + 1u});
  }
  void set_rp(NodeId s, NodeId parent) {
    tr_.change(EventKind::rp, s, std::uint64_t{nodes_[s].rp + 1u}, std::uint64_t{parent + 1u});
    nodes_[s].rp = parent;
  }

  // As above for the open list; the log holds k1 + 1 while a node is in it.
  void note_queue(NodeId s, Cost before, Cost after) {
    ++counters_.queue_operations;
    tr_.note(EventKind::queue, s, raw(before) ^ raw(after));
  }
  [[gnu::always_inline]] void put_in(NodeId s, const Key& key) {  // see OpenList::push()
    note_queue(s, Cost::zero(), {key.k1.raw + 1});
    open_.push(nodes_, key, s);
  }
  void re_key(NodeId s, const Key& key) {
    if constexpr (T::kEnabled)
      note_queue(s, {open_.entries()[nodes_.get(s) - 1].key.k1.raw + 1}, {key.k1.raw + 1});
    else
      ++counters_.queue_operations;
    open_.update(nodes_, key, s);
  }
  void take_out(NodeId s) {
    if constexpr (T::kEnabled)
      note_queue(s, {open_.entries()[nodes_.get(s) - 1].key.k1.raw + 1}, Cost::zero());
    else
      ++counters_.queue_operations;
    open_.remove(nodes_, s);
  }
  void take_out_top() {
    note_queue(open_.top().node, {open_.top().key.k1.raw + 1}, Cost::zero());
    open_.pop(nodes_);
  }

  void restore_node(const SearchState& state, NodeId n) {
    Node& node = nodes_[n];
    nodes_.mark(n);
    node.g = state.g(n);
    node.rhs = state.rhs(n);
    node.rp = state.rp(n);
    if (along_path_ && node.rp != kNoNode && n != goal_) keep({n, node.rp});
    node.lp = kNoDirection;
    if (const NodeId parent = state.lp(n); parent != kNoNode && n != goal_)
      for (std::uint32_t rest = lattice_.moves(n); rest != 0; rest &= rest - 1)
        if (const int d = std::countr_zero(rest); lattice_.neighbour(n, d) == parent)
          node.lp = static_cast<std::uint32_t>(d) & 31u;
    if (state.queued(n)) open_.push(nodes_, {state.k1(n), state.k2(n)}, n);
  }

  const L& lattice_;
  T& tr_;
  NodeTable<Node> nodes_;
  OpenList<Key> open_;  // U
  ClearanceField<L::kDimensions> clearance_;
  SightMap<L::kDimensions> sight_map_;
  DStarLiteSwitches switches_;
  [[no_unique_address]] Faults faults_;
  ClearanceRules clearance_rules_;
  Heuristic heuristic_ = Heuristic::octile;
  SightRule sight_rule_ = SightRule::supercover;
  bool in_search_ = false, along_path_ = false;  // where sight is checked
  bool checked_ = true;                          // remote parents, when they are used
  std::uint64_t fields_revision_ = 0;  // of the lattice that the field and the sight map are of; 0: none
  NodeId start_ = kNoNode, last_ = kNoNode, goal_ = kNoNode;
  Coordinates start_at_{};
  Cost km_ = Cost::zero();
  Counters counters_;
  Visits<T> visits_;
  std::unordered_map<NodeId, Cost> ways_;  // of vertices that a path was held against
  KeptLeaps<L::kDimensions>
      kept_leaps_;             // with along_path_: of the vertices whose rp is set, but for the goal
  std::vector<NodeId> chain_;  // of local parents, as far as a leap may go
  std::size_t at_ = 0;         // where that leap begins
  NodeId leads_ = kNoNode;     // the last vertex whose leap was found to lead ahead, on the path that is read
  std::vector<NodeId> turned_;  // cells that the last change made good or bad for sight, or may have
  std::vector<NodeId> affected_;
  std::vector<std::uint8_t> marked_;  // 1 while a node is among affected_
};

}  // namespace replan
