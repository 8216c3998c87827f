// Best-first search from the start, afresh for each plan: what A* and its kin have in common.
//
//  Hart, Nilsson & Raphael, "A formal basis for the heuristic determination of minimum cost paths", IEEE Trans.
//  Systems Science and Cybernetics 4(2), 1968, doi 10.1109/TSSC.1968.300136
//
// Line numbers are those of assets/planners/astar.md. Settled here: among equal f the larger g is taken first
// (it is nearer to the goal and saves most of the expansions on open ground), then the smaller index. With an
// inconsistent heuristic (Manhattan on a lattice with diagonals, or one that is weighted) settled nodes are
// opened again when a shorter way to them shows, but for a rule that says `kOnce`.
//
// What a planner brings:
//  * F, how f is made of g and h. It is built from the settings, and `describe()` declares it as
//    PlannerInfo::key, so that search, laws and tests go by one text.
//  * Self, if it does more: a class that derives from BestFirst, has it for a friend and hides expand(),
//    relax(), estimate(), parent_of() or one of the functions below them. Which one is meant is known at compile
//    time.
//  * Node, if it remembers more of a node than g and a parent next to it.
#pragma once

#include <algorithm>
#include <bit>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/plan/common_parameters.hpp"
#include "core/plan/node_table.hpp"
#include "core/plan/registry.hpp"
#include "core/plan/search_record.hpp"

namespace replan {

/// What a best-first search remembers of a node.
struct BestFirstNode {
  Cost g = Cost::infinity();
  std::uint32_t search = 0;       // that wrote it
  std::uint32_t slot : 27 = 0;    // in the open list
  std::uint32_t parent : 5 = 31;  // direction towards the start
};
static_assert(sizeof(BestFirstNode) == 16, "a large map has many of them");

template <Lattice L, Tracer T, class F, class Self = void, class Node = BestFirstNode>
class BestFirst : public SearchRecord<L, T, NumberedTable<Node>> {
 public:
  template <class Switches>
  BestFirst(const L& lattice, const Settings& settings, T& tracer, Switches switches)
      : Record(lattice, tracer), f_(settings), heuristic_(heuristic_of(describe(switches), settings)) {}

  void begin(NodeId start, NodeId goal) override {
    this->begin_counting();
    set_scalar(Scalar::goal, goal_, goal);
    plan(start);
  }

  bool advance(std::int64_t iterations) override {
    for (; iterations > 0; --iterations)
      if (!step()) return true;
    return !search_needed();
  }

  void update(const MapChange<L>&, NodeId start) override { plan(start); }

  [[nodiscard]] PlanStatus status() const override {
    return this->status_with(search_needed(), nodes_[goal_].g);
  }
  [[nodiscard]] Cost cost() const override {
    return status() == PlanStatus::found ? nodes_[goal_].g : Cost::infinity();
  }

  Path path() override {
    if (status() != PlanStatus::found) return {};
    std::vector<NodeId> nodes;
    for (NodeId s = goal_; s != start_; s = self().parent_of(s)) nodes.push_back(s);
    nodes.push_back(start_);
    std::reverse(nodes.begin(), nodes.end());
    return self().path_over(std::move(nodes));
  }

  void restore(const SearchState& state, const Counters& counters) override {
    this->restore_record(state, counters, [&](NodeId n, Node& node) {
      self().restore_node(state, n, node);
      return Cost{state.k1(n).raw - state.g(n).raw};
    });
    goal_at_ = lattice_.coordinates(goal_);
  }

 protected:
  using Record = SearchRecord<L, T, NumberedTable<Node>>;
  using Record::goal_, Record::lattice_, Record::nodes_, Record::open_, Record::set_scalar, Record::start_,
      Record::tr_;
  using typename Record::Coordinates;

  /// A vertex that is expanded.
  struct Expanded {
    NodeId node;
    Coordinates at;
    Cost g;
  };

  // Line 6.
  void expand(const Expanded& u) {
    for (std::uint32_t rest = lattice_.moves(u.node); rest != 0; rest &= rest - 1)
      self().relax(u, std::countr_zero(rest));
  }

  // Lines 7-8, for the neighbour of u in direction d.
  void relax(const Expanded& u, int d) {
    const NodeId s = lattice_.neighbour(u.node, d);
    const Cost sum = u.g + L::step_cost(d);
    if constexpr (takes_once<F>())
      if (nodes_[s].slot == 0 && !nodes_[s].g.is_infinite()) return;
    if (sum < nodes_[s].g) reach(s, static_cast<std::uint32_t>(L::reverse(d)), sum, L::step(u.at, d));
  }

  // Lines 9-12: a shorter way to s.
  void reach(NodeId s, std::uint32_t parent_direction, Cost sum, const Coordinates& at) {
    nodes_.write(s);
    tr_.line(10);
    this->set_g(s, sum);
    tr_.line(11);
    this->set_parent(s, parent_direction);
    const Key key = self().key_of(s, sum, at);
    tr_.line(12);
    this->queue(s, key);
  }
  /// f(s) with such a g, and what decides among equals.
  [[nodiscard]] Key key_of(NodeId s, Cost g, const Coordinates& at) const {
    const Cost f = made_by(f_, g, self().estimate(s, at), self().weight());
    return {f, {f.raw - g.raw}};
  }

  /// h(s).
  [[nodiscard]] Cost estimate(NodeId, const Coordinates& at) const {
    return lattice_.bound(heuristic_, at, goal_at_);
  }

  [[nodiscard]] NodeId parent_of(NodeId s) const { return this->parent(s); }

  /// The search begins from start_, and nothing is in the list yet.
  void prepare() {}
  /// Of h, for a rule that takes one from the search.
  [[nodiscard]] Cost weight() const { return Cost::cells(1); }
  /// Whether a vertex just taken from the list is to be expanded; if not, it has been put back.
  bool confirm(NodeId) { return true; }
  /// Whether the way to the goal is known, while the list is not empty.
  [[nodiscard]] bool at_goal() const { return open_.top().node == goal_; }
  /// What a node holds besides, as restore() finds it in the log.
  void restore_node(const SearchState&, NodeId, Node&) {}
  [[nodiscard]] Path path_over(std::vector<NodeId> nodes) const {
    return Path(lattice_.box(), std::move(nodes));
  }

 private:
  // Lines 1-3.
  void plan(NodeId start) {
    tr_.line(1);
    this->forget_search(start);
    set_scalar(Scalar::start, start_, start);
    goal_at_ = lattice_.coordinates(goal_);
    self().prepare();
    tr_.line(2);
    reach(start_, Record::kNoDirection, Cost::zero(), lattice_.coordinates(start_));
  }

  [[nodiscard]] bool search_needed() const {
    if (this->ends_blocked()) return false;
    return !open_.empty() && !self().at_goal();
  }

  // Lines 4-8: one expansion.
  bool step() {
    if (!search_needed()) return false;
    tr_.line(5);
    // On a large map its moves are far away in memory: they come while the heap is put in order.
    lattice_.fetch_moves(open_.top().node);
    const NodeId u = this->take_out_top();
    if (!self().confirm(u)) return true;
    this->count_expansion(u);
    self().expand({u, lattice_.coordinates(u), nodes_[u].g});
    return true;
  }

  using Derived = std::conditional_t<std::is_void_v<Self>, BestFirst, Self>;
  [[nodiscard]] Derived& self() { return static_cast<Derived&>(*this); }
  [[nodiscard]] const Derived& self() const { return static_cast<const Derived&>(*this); }

  const F f_;
  Heuristic heuristic_;
  Coordinates goal_at_{};
};

/// The most that the estimates of these settings exceed the truth by, as a factor: that of Manhattan on a
/// lattice with diagonals is too long by up to the root of the number of axes. No plan by f = g + h is longer by
/// more.
inline double overestimate(const Settings& settings) {
  const bool manhattan = settings.get(parameters::kAnyHeuristic) == static_cast<double>(Heuristic::manhattan);
  return !manhattan || settings.get(parameters::kMoves) == 1 ? 1 : std::numbers::sqrt3;
}

}  // namespace replan
