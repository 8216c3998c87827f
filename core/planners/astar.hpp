// A* and Dijkstra's algorithm: best-first search from the start, afresh for each plan.
//
//  A*        Hart, Nilsson & Raphael, "A formal basis for the heuristic determination of minimum cost paths",
//            IEEE Trans. Systems Science and Cybernetics 4(2), 1968, doi 10.1109/TSSC.1968.300136
//  Dijkstra  "A note on two problems in connexion with graphs", Numerische Mathematik 1, 1959,
//            doi 10.1007/BF01386390: the same with no estimate
//
// Line numbers are those of assets/planners/astar.md. Settled here: among equal f the larger g is taken first
// (it is nearer to the goal and saves most of the expansions on open ground), then the smaller index. With an
// inconsistent heuristic (Manhattan on a lattice with diagonals) settled nodes are opened again when a
// shorter way to them shows.
#pragma once

#include <algorithm>
#include <bit>
#include <numbers>
#include <vector>

#include "core/plan/common_parameters.hpp"
#include "core/plan/open_list.hpp"
#include "core/plan/planner.hpp"
#include "core/plan/registry.hpp"
#include "core/planners/visits.hpp"
#include "core/trace/search_state.hpp"
#include "core/trace/tracer.hpp"

namespace replan {

struct AStarSwitches {
  bool estimate = true;  ///< off: Dijkstra
};

inline PlannerInfo describe(AStarSwitches switches) {
  PlannerInfo info;
  info.name = switches.estimate ? "A*" : "Dijkstra";
  info.summary =
      switches.estimate
          ? "Best-first search from the start, drawn to the goal by an estimate; plans afresh each time."
          : "Searches in all directions by cost; plans afresh each time.";
  info.source = switches.estimate ? "Hart, Nilsson & Raphael 1968, doi 10.1109/TSSC.1968.300136"
                                  : "Dijkstra 1959, doi 10.1007/BF01386390";
  if (switches.estimate) info.parameters = {parameters::kAnyHeuristic};
  // No plan is longer by more than the estimate is too long, and that of Manhattan on a lattice with diagonals
  // is so by the root of the number of axes.
  info.length_bound = [](const Settings& settings) {
    const bool manhattan =
        settings.get(parameters::kAnyHeuristic) == static_cast<double>(Heuristic::manhattan);
    return !manhattan || settings.get(parameters::kMoves) == 1 ? 1 : std::numbers::sqrt3;
  };
  return info;
}

template <Lattice L, Tracer T>
class AStar final : public Planner<L> {
 public:
  AStar(const L& lattice, const Settings& settings, T& tracer, AStarSwitches switches)
      : lattice_(lattice), tr_(tracer), nodes_(lattice.node_count()), visits_(lattice.node_count()) {
    heuristic_ = switches.estimate
                     ? static_cast<Heuristic>(static_cast<int>(settings.get(parameters::kAnyHeuristic)))
                     : Heuristic::zero;
  }

  void begin(NodeId start, NodeId goal) override {
    counters_ = {};
    visits_.begin();
    set_scalar(Scalar::goal, goal_, goal);
    begin_search(start);
  }

  bool advance(std::int64_t iterations) override {
    for (; iterations > 0; --iterations)
      if (!step()) return true;
    return !search_needed();
  }

  void update(const MapChange<L>&, NodeId start) override { begin_search(start); }

  [[nodiscard]] PlanStatus status() const override {
    if (lattice_.blocked(start_)) return PlanStatus::start_blocked;
    if (lattice_.blocked(goal_)) return PlanStatus::goal_blocked;
    if (search_needed()) return PlanStatus::searching;
    return g(goal_).is_infinite() ? PlanStatus::no_path : PlanStatus::found;
  }
  [[nodiscard]] Cost cost() const override {
    return status() == PlanStatus::found ? g(goal_) : Cost::infinity();
  }
  [[nodiscard]] Counters counters() const override { return counters_; }
  [[nodiscard]] std::size_t memory_bytes() const override {
    return nodes_.capacity() * sizeof(Node) + open_.peak_bytes();
  }

  Path path() override {
    if (status() != PlanStatus::found) return {};
    std::vector<NodeId> nodes;
    for (NodeId s = goal_; s != start_; s = parent(s)) nodes.push_back(s);
    nodes.push_back(start_);
    std::reverse(nodes.begin(), nodes.end());
    return Path(lattice_.box(), std::move(nodes));
  }

  void restore(const SearchState& state, const Counters& counters) override {
    counters_ = counters;
    start_ = state.node(Scalar::start);
    goal_ = state.node(Scalar::goal);
    goal_at_ = lattice_.coordinates(goal_);
    open_.clear(nodes_);
    ++search_;
    visits_.restore(state, counters.expansions);
    for (NodeId n = 0; n < nodes_.size(); ++n) restore_node(state, n);
  }

 private:
  static constexpr std::uint32_t kNoDirection = 31;

  struct Node {
    Cost g = Cost::infinity();
    std::uint32_t search = 0;                 // the search that wrote this node; older ones are forgotten
    std::uint32_t slot : 27 = 0;              // place in the open list + 1
    std::uint32_t parent : 5 = kNoDirection;  // direction towards the start
  };
  struct Nodes : std::vector<Node> {
    using std::vector<Node>::vector;
    [[nodiscard]] std::size_t get(NodeId n) const { return (*this)[n].slot; }
    void set(NodeId n, std::uint32_t slot) { (*this)[n].slot = slot & 0x7FFFFFFu; }
  };

  void set_scalar(Scalar which, NodeId& held, NodeId node) {
    tr_.change(which, std::uint64_t{held + 1u}, std::uint64_t{node + 1u});
    held = node;
  }

  // Lines 1-3.
  void begin_search(NodeId start) {
    tr_.line(1);
    if (search_ > 0) tr_.note(EventKind::epoch, start);
    visits_.forget();
    open_.clear(nodes_);
    ++search_;
    set_scalar(Scalar::start, start_, start);
    goal_at_ = lattice_.coordinates(goal_);
    tr_.line(2);
    reach(start_, kNoDirection, Cost::zero(), lattice_.coordinates(start_));
  }

  [[nodiscard]] bool search_needed() const {
    if (lattice_.blocked(start_) || lattice_.blocked(goal_)) return false;
    return !open_.empty() && open_.top().node != goal_;
  }

  // Lines 4-12: one expansion.
  bool step() {
    if (!search_needed()) return false;
    const NodeId u = open_.top().node;
    tr_.line(5);
    tr_.note(EventKind::pop, u);
    note_queue(u, open_.top().key.k1.raw + 1, 0);
    open_.pop(nodes_);
    ++counters_.expansions;
    visits_.record(tr_, u);
    const Cost g_u = nodes_[u].g;
    const auto u_at = lattice_.coordinates(u);
    for (std::uint32_t rest = lattice_.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId s = lattice_.neighbour(u, d);
      const Cost sum = g_u + L::step_cost(d);
      if (!(sum < g(s))) continue;
      reach(s, static_cast<std::uint32_t>(L::reverse(d)), sum, L::step(u_at, d));
    }
    return true;
  }

  // Lines 9-12: a shorter way to s.
  void reach(NodeId s, std::uint32_t parent_direction, Cost sum, const typename L::Coordinates& at) {
    Node& node = nodes_[s];
    if (node.search != search_) node = {.search = search_};
    tr_.line(10);
    tr_.change(EventKind::g, s, node.g, sum);
    node.g = sum;
    tr_.line(11);
    const NodeId before = parent(s);
    node.parent = parent_direction & 31u;
    tr_.change(EventKind::lp, s, std::uint64_t{before + 1u}, std::uint64_t{parent(s) + 1u});
    const Cost h = lattice_.bound(heuristic_, at, goal_at_);
    const Key key{sum + h, h};
    tr_.line(12);
    if (node.slot != 0) {
      if constexpr (T::kEnabled)
        note_queue(s, open_.entries()[node.slot - 1].key.k1.raw + 1, key.k1.raw + 1);
      else
        ++counters_.queue_operations;
      open_.update(nodes_, key, s);
    } else {
      note_queue(s, 0, key.k1.raw + 1);
      open_.push(nodes_, key, s);
    }
  }

  [[nodiscard]] Cost g(NodeId s) const {
    return nodes_[s].search == search_ ? nodes_[s].g : Cost::infinity();
  }
  [[nodiscard]] NodeId parent(NodeId s) const {
    const Node& node = nodes_[s];
    return node.search != search_ || node.parent == kNoDirection
               ? kNoNode
               : lattice_.neighbour(s, static_cast<int>(node.parent));
  }

  void note_queue(NodeId s, std::int64_t before, std::int64_t after) {
    ++counters_.queue_operations;
    tr_.note(EventKind::queue, s, static_cast<std::uint64_t>(before) ^ static_cast<std::uint64_t>(after));
  }

  void restore_node(const SearchState& state, NodeId n) {
    if (state.g(n).is_infinite()) return;
    nodes_[n] = {.g = state.g(n), .search = search_};
    if (const NodeId from = state.lp(n); from != kNoNode)
      for (std::uint32_t rest = lattice_.moves(n); rest != 0; rest &= rest - 1)
        if (const int d = std::countr_zero(rest); lattice_.neighbour(n, d) == from)
          nodes_[n].parent = static_cast<std::uint32_t>(d) & 31u;
    const Cost h = lattice_.bound(heuristic_, lattice_.coordinates(n), goal_at_);
    if (state.queued(n)) open_.push(nodes_, {state.k1(n), h}, n);
  }

  const L& lattice_;
  T& tr_;
  Nodes nodes_;
  OpenList<Key> open_;
  Heuristic heuristic_ = Heuristic::octile;
  std::uint32_t search_ = 0;
  NodeId start_ = kNoNode, goal_ = kNoNode;
  typename L::Coordinates goal_at_{};
  Counters counters_;
  Visits<T> visits_;
};

}  // namespace replan
