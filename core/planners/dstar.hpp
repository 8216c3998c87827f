// The D* family: one machine for three planners, and therefore longer than other files here. A search from the goal is
// repaired by two kinds of waves. Where a way became dearer RAISE states tell all that relied on it; where one became
// cheaper, or a raised state finds another, LOWER states do.
//
//   D*          Stentz, "Optimal and efficient path planning for partially-known environments", ICRA 1994
//   Focused D*  Stentz, "The focussed D* algorithm for real-time replanning", IJCAI 1995
//   Threat D*   Zhu, Sun & Zhu, "Three-dimensional dynamic path planning of AUV based on improved D* algorithm", Control
//               Engineering of China 28(4), 2021, doi 10.14107/j.cnki.kzgc.20190179
//
// Line numbers are those of the pages assets/planners/dstar.md and so on, which have the same: MOVE_ROBOT has 100 added.
//
// What is settled here:
//  * Both are one text: the first is the second with GVAL = 0 and no bias, where f_B = f = k.
//  * A move that is not allowed costs infinity, and not some large number. No state is opened without a way, so k is
//    always finite; h is not, where a RAISE wave has passed and found nothing. Such waves end: who has h = infinity offers
//    nothing, and is no worse off if what it relied on gets worse. Its back-pointer is dropped then.
//  * PROCESS_STATE looks at neighbours by moves that are gone, too, if their back-pointer still leads along it.
//  * The search stops as soon as val >= COST(R), at the first plan too, where the papers wait until R is CLOSED.
//  * A state is of an older focus if its bias f_B - f is not the present one. The paper compares where the robot stood
//    then, by which a key would pass for a new one that is older than a way there and back, though its bias is less.
//  * The bias grows by the heuristic rounded up and one unit of cost, the paper's epsilon: so a key in OPEN is below that
//    of the same state for the present focus (law 6 in lattice.hpp), and old ones come out first.
//  * MODIFY_COST is called for each end of a move that has changed, once for all its moves.
//  * The threat paper adds j(X) to f alone. Here entering X costs j(X), too, or the path would not bend: c(X, Y) is the move
//    and j(X). States are ordered, and told apart as RAISE and LOWER, by h + j, and k is the least of that. So f = h + g + j
//    as the paper has it, g + j is consistent with those costs, and a state whose threat has risen comes out as early as
//    what it used to promise. Where j of a state in OPEN falls, so does its k: it may come to cost less than it ever did.
//  * While the start or the goal lies inside an obstacle the search rests: no work could find a path.
#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "core/plan/node_table.hpp"
#include "core/plan/search_record.hpp"
#include "core/planners/dstar_family.hpp"
#include "core/planners/dstar_state.hpp"
#include "core/planners/ground.hpp"

namespace replan {

template <Lattice L, Tracer T>
class DStar final : public SearchRecord<L, T, NodeTable<DStarNode>, FocusedKey> {
  using Base = SearchRecord<L, T, NodeTable<DStarNode>, FocusedKey>;

 public:
  DStar(const L& lattice, const Settings& settings, T& tracer, DStarSwitches switches)
      : Base(lattice, tracer),
        focused_(switches.focused),
        heuristic_(switches.focused ? heuristic_of(describe(switches), settings) : Heuristic::zero),
        ground_(lattice, settings, describe(switches).clearance, false) {}

  // MOVE_ROBOT, lines 1-3.
  void begin(NodeId start, NodeId goal) override {
    tr_.line(101);
    this->forget_search(start);
    this->begin_counting();
    if (focused_ && T::kEnabled) logged_f_.assign(nodes_.size(), Cost::infinity());
    set_scalar(Scalar::start, start_, start);
    if (focused_) set_scalar(Scalar::last, last_, start);
    set_scalar(Scalar::goal, goal_, goal);
    tr_.line(102);
    set_d_curr(Cost::zero());
    start_at_ = lattice_.coordinates(start_);
    ground_.make(
        [this](NodeId n, Cost before, Cost after) { tr_.change(EventKind::dist, n, before, after); });
    tr_.line(103);
    insert(goal_, lattice_.coordinates(goal_), Cost::zero());
  }

  bool advance(std::int64_t iterations) override {
    for (; iterations > 0; --iterations)
      if (!process_state()) return true;
    return !search_needed();
  }

  // MOVE_ROBOT, lines 8-10.
  void update(const MapChange<L>& change, NodeId start) override {
    tr_.line(108);
    if (focused_ && start != start_) {
      constexpr Cost kEpsilon{1};
      set_d_curr(d_curr_ + lattice_.bound_up(heuristic_, start, start_) + kEpsilon);
      set_scalar(Scalar::last, last_, start);
    }
    set_scalar(Scalar::start, start_, start);
    start_at_ = lattice_.coordinates(start_);
    tr_.line(109);
    for (const ClearanceChange& changed : ground_.update(change.cells)) {
      tr_.change(EventKind::dist, changed.node, changed.before, j(changed.node));
      modify_threat(changed.node, changed.before);
    }
    for (const auto& move : change.moves) modify_cost(move.node);
  }

  [[nodiscard]] PlanStatus status() const override { return this->status_with(search_needed(), h(start_)); }
  [[nodiscard]] Cost cost() const override { return this->ends_blocked() ? Cost::infinity() : h(start_); }

  [[nodiscard]] std::size_t memory_bytes() const override {
    return Base::memory_bytes() + ground_.memory_bytes() + logged_f_.capacity() * sizeof(Cost);
  }

  // MOVE_ROBOT, line 6, from the start on.
  Path path() override {
    tr_.line(106);
    if (status() != PlanStatus::found) return {};
    std::vector<NodeId> nodes = {start_};
    while (nodes.back() != goal_) nodes.push_back(this->parent(nodes.back()));
    return Path(lattice_.box(), std::move(nodes));
  }

  void restore(const SearchState& state, const Counters& counters) override {
    if (focused_) last_ = state.node(Scalar::last);
    d_curr_ = state.km();
    ground_.make();
    if (focused_ && T::kEnabled) logged_f_.assign(nodes_.size(), Cost::infinity());
    this->restore_record(state, counters, [&](NodeId n, Node& node) {
      const auto cost = [&](EventKind kind) { return Cost{static_cast<std::int64_t>(state.value(kind, n))}; };
      node.k = cost(fields::kLowest.kind);
      node.tag = static_cast<Tag>(state.value(fields::kTag.kind, n));
      node.parent = direction_of(n, state.lp(n)) & 31u;
      if (!focused_) return FocusedCost{node.k, node.k};
      if constexpr (T::kEnabled) logged_f_[n] = cost(fields::kFocused.kind);
      return FocusedCost{cost(fields::kFocused.kind), node.k};
    });
    start_at_ = lattice_.coordinates(start_);
  }

 private:
  using Base::goal_, Base::lattice_, Base::nodes_, Base::open_, Base::start_, Base::tr_;
  using Base::kNoDirection, Base::raw, Base::set_g, Base::set_parent, Base::set_scalar;
  using typename Base::Coordinates, typename Base::Node;
  using Tag = fields::StateTag;

  [[nodiscard]] Cost h(NodeId X) const { return nodes_[X].g; }
  [[nodiscard]] Tag t(NodeId X) const { return nodes_[X].tag; }
  /// Whether b(Y) is the neighbour of Y that lies in that direction.
  [[nodiscard]] bool leads(NodeId Y, int direction) const {
    return nodes_[Y].parent == static_cast<std::uint32_t>(direction);
  }

  /// The estimate from the robot, which stands at the present focus; 0 without one.
  [[nodiscard]] Cost gval(const Coordinates& X) const {
    return focused_ ? lattice_.bound(heuristic_, start_at_, X) : Cost::zero();
  }
  /// j(X): what entering X costs besides the move; 0 without threats.
  [[nodiscard]] Cost j(NodeId X) const { return ground_.dist(X); }
  /// h(X) and j(X), by which states are ordered. Where nobody may enter, j does not count: the robot may stand there.
  [[nodiscard]] Cost whole(NodeId X) const { return h(X) + counted(j(X)); }
  static Cost counted(Cost j) { return j.is_infinite() ? Cost::zero() : j; }
  [[nodiscard]] FocusedCost cost_of(NodeId X, const Coordinates& at) const {
    return {whole(X) + gval(at), whole(X)};
  }
  [[nodiscard]] FocusedKey key_by(const FocusedCost& cost) const { return {cost.f + d_curr_, cost}; }

  /// MOVE_ROBOT, lines 4 and 10: whether val < COST(R), so that the plan is not yet known to be right. An old key is a
  /// lower bound.
  [[nodiscard]] bool search_needed() const {
    if (this->ends_blocked() || open_.empty()) return false;
    return open_.top().key < key_by(cost_of(start_, start_at_));
  }

  // PROCESS_STATE, with MIN_STATE: at most one state of an older focus. False if there was nothing left to do.
  bool process_state() {
    if (!search_needed()) return false;
    const FocusedKey top = open_.top().key;
    const bool is_of_older_focus = top.k1 != top.k2.f + d_curr_;
    tr_.line(is_of_older_focus ? 33 : 2);
    const NodeId X = this->take_out_top();
    const Coordinates at = lattice_.coordinates(X);
    if (is_of_older_focus) {
      put_in_open(X, at);
      return true;
    }
    set_tag(X, Tag::closed);
    this->count_expansion(X);
    const FocusedCost val = top.k2;
    if (val.k < whole(X)) look_about(X, at, val);
    if (val.k == whole(X))
      lower_neighbours(X, at);
    else
      raise_neighbours(X, at, val);
    return true;
  }

  // Lines 3-5: X is a RAISE state. It takes the best way over a neighbour whose cost is right.
  void look_about(NodeId X, const Coordinates& X_at, const FocusedCost& val) {
    for (std::uint32_t rest = lattice_.moves(X); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId Y = lattice_.neighbour(X, d);
      const Cost sum = h(Y) + L::step_cost(d) + j(Y);
      if (t(Y) == Tag::fresh || !(sum < h(X)) || val < cost_of(Y, L::step(X_at, d))) continue;
      tr_.line(5);
      set_parent(X, static_cast<std::uint32_t>(d));
      set_g(X, sum);
    }
    if (h(X).is_infinite()) set_parent(X, kNoDirection);
  }

  // Lines 6-9: X is a LOWER state, and its cost is right.
  void lower_neighbours(NodeId X, const Coordinates& X_at) {
    for (std::uint32_t rest = lattice_.moves(X); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest), back = L::reverse(d);
      const NodeId Y = lattice_.neighbour(X, d);
      const Cost sum = h(X) + L::step_cost(d) + j(X);
      if (leads(Y, back) ? h(Y) == sum : h(Y) <= sum) continue;
      tr_.line(9);
      lead_to(Y, back);
      insert(Y, L::step(X_at, d), sum);
    }
    raise_cut_off(X, X_at, 9);
  }

  // Lines 10-16: X costs more than it did, and more may be known of it later.
  void raise_neighbours(NodeId X, const Coordinates& X_at, const FocusedCost& val) {
    for (std::uint32_t rest = lattice_.moves(X); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest), back = L::reverse(d);
      const NodeId Y = lattice_.neighbour(X, d);
      const Cost sum = h(X) + L::step_cost(d) + j(X);
      if (t(Y) == Tag::fresh ? !sum.is_infinite() : leads(Y, back) && h(Y) != sum) {
        tr_.line(12);
        lead_to(Y, back);
        insert(Y, L::step(X_at, d), sum);
      } else if (!leads(Y, back) && h(Y) > sum && t(X) == Tag::closed) {
        tr_.line(14);
        insert(X, X_at, h(X));
      } else if (!leads(Y, back) && h(X) > h(Y) + L::step_cost(d) + j(Y) && t(Y) == Tag::closed &&
                 val < cost_of(Y, L::step(X_at, d))) {
        tr_.line(16);
        insert(Y, L::step(X_at, d), h(Y));
      }
    }
    raise_cut_off(X, X_at, 12);
  }

  // Lines 8 and 11 for neighbours without a move to X, whose back-pointer led along one: c(X, Y) is infinite.
  void raise_cut_off(NodeId X, const Coordinates& X_at, int line) {
    constexpr std::uint32_t kAll = (std::uint32_t{1} << L::kDirections) - 1;
    for (std::uint32_t rest = kAll & ~std::uint32_t{lattice_.moves(X)}; rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const Coordinates Y_at = L::step(X_at, d);
      if (!lattice_.contains(Y_at)) continue;
      const NodeId Y = lattice_.neighbour(X, d);
      if (!leads(Y, L::reverse(d)) || h(Y).is_infinite()) continue;
      tr_.line(line);
      insert(Y, Y_at, Cost::infinity());
    }
  }

  // Lines 41-42. A state without a way offers nothing, whatever the move costs.
  void modify_cost(NodeId X) {
    if (t(X) != Tag::closed || h(X).is_infinite()) return;
    tr_.line(42);
    insert(X, lattice_.coordinates(X), h(X));
  }

  // The same where j(X), and with it the cost of all moves to X, has changed from `before`.
  void modify_threat(NodeId X, Cost before) {
    if (t(X) == Tag::fresh || (t(X) == Tag::closed && h(X).is_infinite())) return;
    tr_.line(42);
    insert(X, lattice_.coordinates(X), h(X), counted(before));
  }

  // Lines 21-26.
  void insert(NodeId X, const Coordinates& at, Cost h_new) { insert(X, at, h_new, counted(j(X))); }
  void insert(NodeId X, const Coordinates& at, Cost h_new, Cost j_before) {
    Node& node = nodes_.write(X);
    const Cost now = h_new + counted(j(X));
    const Cost k = node.tag == Tag::fresh  ? now
                   : node.tag == Tag::open ? std::min(lowest_in_open(X, j_before), now)
                                           : std::min(node.g + j_before, now);
    tr_.change(fields::kLowest.kind, X, node.k, k);
    node.k = k;
    tr_.change(EventKind::g, X, node.g, h_new);
    node.g = h_new;
    put_in_open(X, at);
    set_tag(X, Tag::open);
  }
  /// k(X), which stays below all that X may come to cost: by as much as j(X) has fallen that may be less, too.
  [[nodiscard]] Cost lowest_in_open(NodeId X, Cost j_before) const {
    const Cost k = nodes_[X].k, j_now = counted(j(X));
    return j_before <= j_now ? k : std::min(k, std::max(Cost{k.raw - (j_before.raw - j_now.raw)}, j_now));
  }

  // Line 26 (33 of MIN_STATE): into OPEN for the present focus, or to where it belongs there.
  void put_in_open(NodeId X, const Coordinates& at) {
    const Cost k = nodes_[X].k;
    const FocusedKey key = key_by({k + gval(at), k});
    if (focused_) note_f(X, key.k2.f);
    this->queue(X, key);
  }

  void lead_to(NodeId Y, int direction) {
    nodes_.write(Y);
    set_parent(Y, static_cast<std::uint32_t>(direction));
  }

  // As set_g() and set_parent(): every write of a value, so that the log misses none.
  void set_tag(NodeId X, Tag tag) {
    Node& node = nodes_.held(X);
    tr_.change(fields::kTag.kind, X, static_cast<std::uint64_t>(node.tag), static_cast<std::uint64_t>(tag));
    node.tag = tag;
  }
  void set_d_curr(Cost bias) {
    tr_.change(Scalar::km, raw(d_curr_), raw(bias));
    d_curr_ = bias;
  }
  /// OPEN knows f(X); what the log says of it is kept for the log alone.
  void note_f(NodeId X, Cost f) {
    if constexpr (T::kEnabled) {
      tr_.change(fields::kFocused.kind, X, logged_f_[X], f);
      logged_f_[X] = f;
    }
  }

  /// The direction in which a neighbour lies, though there may be no move to it; kNoDirection if none does.
  [[nodiscard]] std::uint32_t direction_of(NodeId from, NodeId to) const {
    if (to == kNoNode) return kNoDirection;
    const Coordinates at = lattice_.coordinates(from), there = lattice_.coordinates(to);
    for (int d = 0; d < L::kDirections; ++d)
      if (L::step(at, d) == there) return static_cast<std::uint32_t>(d);
    return kNoDirection;
  }

  bool focused_;
  Heuristic heuristic_;
  Ground<L> ground_;       // of threats
  NodeId last_ = kNoNode;  // R_curr
  Coordinates start_at_{};
  Cost d_curr_ = Cost::zero();
  std::vector<Cost> logged_f_;
};

}  // namespace replan
