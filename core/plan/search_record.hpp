// What every lattice planner keeps of its search and writes down in its log: values and parents of nodes, the
// open list, visits, both ends, counters. A planner derives from it, and what is left for its header is the
// algorithm.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/plan/open_list.hpp"
#include "core/plan/planner.hpp"
#include "core/plan/visits.hpp"
#include "core/trace/search_state.hpp"
#include "core/trace/tracer.hpp"

namespace replan {

/// `Table` holds a record for each node (node_table.hpp) with at least `Cost g`, a `slot` of 27 bits in the
/// open list and the direction of its `parent` in 5. Every write of a value goes through a function that tells
/// the tracer, so that the log misses none. `K` is what the open list is ordered by, with `Cost k1` and a `k2`.
template <Lattice L, Tracer T, class Table, class K = Key>
class SearchRecord : public Planner<L> {
 public:
  [[nodiscard]] Counters counters() const final { return counters_; }
  [[nodiscard]] std::size_t memory_bytes() const override {
    return nodes_.memory_bytes() + open_.peak_bytes();
  }

 protected:
  using Node = typename Table::Record;
  using Coordinates = typename L::Coordinates;
  static constexpr std::uint32_t kNoDirection = 31;

  SearchRecord(const L& lattice, T& tracer)
      : lattice_(lattice), tr_(tracer), nodes_(lattice.node_count()), visits_(lattice.node_count()) {}

  /// A first plan: work is counted anew.
  void begin_counting() {
    counters_ = {};
    visits_.begin();
  }
  /// Values, parents and the open list back to what they were at first, by one event.
  void forget_search(NodeId start) {
    if (searched_) tr_.note(EventKind::epoch, start);
    searched_ = true;
    visits_.forget();
    open_.clear(nodes_);
    nodes_.reset();
  }

  /// Whether the start or the goal lies inside an obstacle.
  [[nodiscard]] bool ends_blocked() const { return lattice_.blocked(start_) || lattice_.blocked(goal_); }
  /// How the plan stands if the search has found a path of this cost so far.
  [[nodiscard]] PlanStatus status_with(bool searching, Cost cost) const {
    if (lattice_.blocked(start_)) return PlanStatus::start_blocked;
    if (lattice_.blocked(goal_)) return PlanStatus::goal_blocked;
    if (searching) return PlanStatus::searching;
    return cost.is_infinite() ? PlanStatus::no_path : PlanStatus::found;
  }

  static constexpr std::uint64_t raw(Cost cost) { return static_cast<std::uint64_t>(cost.raw); }
  void set_scalar(Scalar which, NodeId& held, NodeId node) {
    tr_.change(which, std::uint64_t{held + 1u}, std::uint64_t{node + 1u});
    held = node;
  }

  // Of a node that this search has written to.
  void set_g(NodeId s, Cost value) {
    tr_.change(EventKind::g, s, nodes_.held(s).g, value);
    nodes_.held(s).g = value;
  }
  void set_parent(NodeId s, std::uint32_t direction) {
    const NodeId before = parent(s);
    nodes_.held(s).parent = direction & 31u;
    tr_.change(EventKind::lp, s, std::uint64_t{before + 1u}, std::uint64_t{parent(s) + 1u});
  }
  [[nodiscard]] NodeId parent(NodeId s) const {
    const std::uint32_t direction = nodes_[s].parent;
    return direction == kNoDirection ? kNoNode : lattice_.neighbour(s, static_cast<int>(direction));
  }

  /// The direction of the move that leads there; kNoDirection if none does.
  [[nodiscard]] std::uint32_t direction_to(NodeId from, NodeId to) const {
    for (std::uint32_t rest = lattice_.moves(from); rest != 0; rest &= rest - 1)
      if (const int d = std::countr_zero(rest); lattice_.neighbour(from, d) == to)
        return static_cast<std::uint32_t>(d);
    return kNoDirection;
  }

  // The open list. The log holds k1 + 1 while a node is in it.
  [[gnu::always_inline]] void put_in(NodeId s, const K& key) {  // see OpenList::push()
    note_queue(s, Cost::zero(), {key.k1.raw + 1});
    open_.push(nodes_, key, s);
  }
  void re_key(NodeId s, const K& key) {
    note_held(s, {key.k1.raw + 1});
    open_.update(nodes_, key, s);
  }
  [[gnu::always_inline]] void queue(NodeId s, const K& key) {
    if (nodes_.get(s) != 0)
      re_key(s, key);
    else
      put_in(s, key);
  }
  void take_out(NodeId s) {
    note_held(s, Cost::zero());
    open_.remove(nodes_, s);
  }
  NodeId take_out_top() {
    const NodeId s = open_.top().node;
    tr_.note(EventKind::pop, s);
    note_queue(s, {open_.top().key.k1.raw + 1}, Cost::zero());
    open_.pop(nodes_);
    return s;
  }

  /// The node is taken from the list for good.
  void count_expansion(NodeId s) {
    ++counters_.expansions;
    visits_.record(tr_, s);
  }

  /// Planner::restore(): the ends, and of each node that may have values g, parent and key. `values_of(n, node)`
  /// restores what else the planner keeps of it, and returns k2, which the log does not hold.
  template <class ValuesOf>
  void restore_record(const SearchState& state, const Counters& counters, ValuesOf&& values_of) {
    counters_ = counters;
    start_ = state.node(Scalar::start);
    goal_ = state.node(Scalar::goal);
    searched_ = true;
    open_.clear(nodes_);
    nodes_.reset();
    visits_.restore(state, counters.expansions);
    for (NodeId n = 0; n < nodes_.size(); ++n) {
      if (n % SearchState::kPage == 0 && !any_written(state, n)) {
        n += SearchState::kPage - 1;
        continue;
      }
      Node& node = nodes_.write(n);
      node.g = state.g(n);
      node.parent = direction_to(n, state.lp(n)) & 31u;
      const auto k2 = values_of(n, node);
      if (state.queued(n)) open_.push(nodes_, {state.k1(n), k2}, n);
    }
  }

  const L& lattice_;
  T& tr_;
  Table nodes_;
  OpenList<K> open_;
  NodeId start_ = kNoNode, goal_ = kNoNode;
  Counters counters_;

 private:
  void note_queue(NodeId s, Cost before, Cost after) {
    ++counters_.queue_operations;
    tr_.note(EventKind::queue, s, raw(before) ^ raw(after));
  }
  /// As above, of a node in the list: where it stands there is looked up for the log alone.
  void note_held(NodeId s, Cost after) {
    if constexpr (T::kEnabled)
      note_queue(s, {open_.entries()[nodes_.get(s) - 1].key.k1.raw + 1}, after);
    else
      ++counters_.queue_operations;
  }

  /// Whether the search has written to any node of the page that begins there.
  static bool any_written(const SearchState& state, NodeId first) {
    constexpr EventKind kKinds[] = {EventKind::g, EventKind::rhs, EventKind::queue, EventKind::lp,
                                    EventKind::rp};
    return std::any_of(std::begin(kKinds), std::end(kKinds),
                       [&](EventKind kind) { return state.touched(kind, first); });
  }

  Visits<T> visits_;
  bool searched_ = false;
};

}  // namespace replan
