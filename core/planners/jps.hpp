// Jump point search: A* on a uniform plane that passes over all cells but those where a shortest way may turn.
//
//  Harabor & Grastien, "Online Graph Pruning for Pathfinding on Grid Maps", AAAI 2011 (corner rules `any` and `one`)
//  Harabor & Grastien, "The JPS Pathfinding System", SoCS 2012 (corner rule `none`: no corner is cut)
//
// Line numbers are those of assets/planners/jps.md.
//
// What is settled here:
//  * Of ways of equal cost the search keeps those whose diagonal steps come first; what can be reached as cheaply
//    without the vertex in hand is pruned. With `none` a vertex has forced neighbours one cell behind an obstacle
//    that it has passed, with the other two beside its last cell. `one` takes the rules of `any`: the ways that they
//    compare lead past free cells alone, but for the diagonal round an obstacle, which the move mask decides.
//  * Straight jumps go 64 cells at a time (jump_rows.hpp), and the same cells are told to the log as if they had been
//    passed one by one: `scanned` holds the number of the expansion whose jump passed over the cell last.
//  * A diagonal jump looks along both its axes at each cell, and stops where one of them finds a jump point.
//  * The parent of a vertex is the jump point that it was reached from; the path is laid out in moves.
//  * It plans in the plane alone, and with eight neighbours: the rules are those of the eight.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/planners/best_first.hpp"
#include "core/planners/jump_rows.hpp"

namespace replan {

struct JpsSwitches {};

inline PlannerInfo describe(JpsSwitches) {
  PlannerInfo info;
  info.name = "JPS";
  info.summary =
      "Jump point search: A* in the plane that passes over cells where no shortest way need turn; plans "
      "afresh "
      "each time.";
  info.source = "Harabor & Grastien, AAAI 2011 and SoCS 2012";
  info.parameters = {parameters::kHeuristic};
  info.length_bound = [](const Settings&) { return 1.0; };
  info.planar = info.eight_neighbours = true;
  info.values.fields.push_back({.kind = own_field(0),
                                .name = "scanned",
                                .type = FieldType::count,
                                .label = "scanned",
                                .help = "The number of the expansion whose jumps passed over it last."});
  info.values.laws = "jumps";
  return info;
}

/// What a jump point search remembers of a vertex.
struct JpsNode : BestFirstNode {
  NodeId jumped_from = kNoNode;
};

template <Lattice L, Tracer T>
requires(L::kDimensions == 2) class Jps final : public BestFirst<L, T, GPlusH, Jps<L, T>, JpsNode> {
  using Base = BestFirst<L, T, GPlusH, Jps<L, T>, JpsNode>;
  friend Base;

 public:
  Jps(const L& lattice, const Settings& settings, T& tracer, JpsSwitches switches)
      : Base(lattice, settings, tracer, switches),
        cuts_corners_(lattice.rules().corners != CornerRule::none) {
    if constexpr (T::kEnabled) scanned_.resize(lattice.node_count());
  }

  void begin(NodeId start, NodeId goal) override {
    look_at(goal);
    Base::begin(start, goal);
  }
  void update(const MapChange<L>& change, NodeId start) override {
    rows_.update(lattice_, change.cells);
    forget_scans();
    Base::update(change, start);
  }

  Path path() override {
    if (this->status() != PlanStatus::found) return {};
    std::vector<NodeId> nodes = {goal_};
    for (NodeId s = goal_; s != start_; s = nodes_[s].jumped_from)
      for (NodeId at = s; at != nodes_[s].jumped_from; nodes.push_back(at))
        at = lattice_.neighbour(at, static_cast<int>(nodes_[s].parent));
    std::reverse(nodes.begin(), nodes.end());
    return Path(lattice_.box(), std::move(nodes));
  }

  [[nodiscard]] std::size_t memory_bytes() const override {
    return Base::memory_bytes() + rows_.memory_bytes() + scanned_.capacity() * sizeof(std::uint32_t);
  }

  void restore(const SearchState& state, const Counters& counters) override {
    Base::restore(state, counters);
    look_at(goal_);
    for (NodeId n = 0; n < lattice_.node_count(); ++n) {
      if constexpr (T::kEnabled) scanned_[n] = static_cast<std::uint32_t>(state.value(own_field(0), n));
      const NodeId from = state.lp(n);
      if (from == kNoNode) continue;
      JpsNode& node = nodes_.write(n);
      node.jumped_from = from;
      node.parent = direction_to(lattice_.coordinates(n), lattice_.coordinates(from)) & 31u;
    }
  }

 private:
  using Base::goal_, Base::lattice_, Base::nodes_, Base::start_, Base::tr_;
  using typename Base::Coordinates, typename Base::Expanded;
  using Dirs = Directions<2>;

  static std::uint32_t direction_to(const Coordinates& from, const Coordinates& to) {
    const auto sign = [](int by) { return (by > 0) - (by < 0); };
    return static_cast<std::uint32_t>(Dirs::index({sign(to[0] - from[0]), sign(to[1] - from[1])}));
  }
  static constexpr std::uint32_t bit(int x, int y) { return 1u << Dirs::index({x, y}); }

  void look_at(NodeId goal) {
    rows_.make(lattice_);
    goal_at_ = lattice_.coordinates(goal);
    forget_scans();
  }
  /// The epoch that a new search begins with makes them zero in the log.
  void forget_scans() {
    if constexpr (T::kEnabled) std::fill(scanned_.begin(), scanned_.end(), 0u);
  }

  // Lines 6-7.
  void expand(const Expanded& u) {
    for (std::uint32_t rest = successors(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      tr_.line(7);
      const int steps = jump(u.at, u.node, d);
      if (steps > 0) relax(u, d, steps);
    }
  }

  // Line 6: the directions in which u is not pruned.
  [[nodiscard]] std::uint32_t successors(const Expanded& u) const {
    const std::uint32_t moves = lattice_.moves(u.node);
    const std::uint32_t back = nodes_[u.node].parent;
    if (back == Base::Record::kNoDirection) return moves;
    const auto [x, y] = u.at;
    const auto [dx, dy] = Dirs::offset(L::reverse(static_cast<int>(back)));
    std::uint32_t kept = bit(dx, dy);
    if (dx != 0 && dy != 0) {
      kept |= bit(dx, 0) | bit(0, dy);
      if (cuts_corners_ && rows_.blocked(x - dx, y)) kept |= bit(-dx, dy);
      if (cuts_corners_ && rows_.blocked(x, y - dy)) kept |= bit(dx, -dy);
      return kept & moves;
    }
    for (const int side : {-1, 1}) {
      // Beside the way, and the diagonal on from there.
      const int px = dx == 0 ? side : 0, py = dx == 0 ? 0 : side;
      if (cuts_corners_ && rows_.blocked(x + px, y + py)) kept |= bit(dx + px, dy + py);
      if (!cuts_corners_ && rows_.blocked(x - dx + px, y - dy + py))
        kept |= bit(px, py) | bit(dx + px, dy + py);
    }
    return kept & moves;
  }

  // Lines 8-12.
  void relax(const Expanded& u, int d, int steps) {
    const Cost sum{u.g.raw + steps * L::step_cost(d).raw};
    const auto [dx, dy] = Dirs::offset(d);
    const Coordinates at = {u.at[0] + steps * dx, u.at[1] + steps * dy};
    const NodeId s = lattice_.node(at);
    if (!(sum < nodes_[s].g)) return;
    JpsNode& node = nodes_.write(s);
    tr_.line(10);
    this->set_g(s, sum);
    tr_.line(11);
    tr_.change(EventKind::lp, s, std::uint64_t{node.jumped_from + 1u}, std::uint64_t{u.node + 1u});
    node.jumped_from = u.node;
    node.parent = static_cast<std::uint32_t>(L::reverse(d)) & 31u;
    const Key key = this->key_of(s, sum, at);
    tr_.line(12);
    this->queue(s, key);
  }

  // Lines 14-22: how many steps it is from u to the next jump point in direction d; 0 if there is none.
  int jump(const Coordinates& u, NodeId node, int d) {
    const auto [dx, dy] = Dirs::offset(d);
    if (dx == 0 || dy == 0) return jump_straight(u, dx == 0 ? 1 : 0, dx + dy);
    Coordinates at = u;
    for (int steps = 1;; ++steps) {
      if ((lattice_.moves(node) >> d & 1u) == 0) return 0;
      node = lattice_.neighbour(node, d);
      at = {at[0] + dx, at[1] + dy};
      scan(node);
      if (at == goal_at_ || turns_round(at, dx, dy)) return steps;
      if (jump_straight(at, 0, dx) != 0 || jump_straight(at, 1, dy) != 0) return steps;
    }
  }
  /// Whether a diagonal way may have to turn round an obstacle at its side.
  [[nodiscard]] bool turns_round(const Coordinates& at, int dx, int dy) const {
    if (!cuts_corners_) return false;
    const auto [x, y] = at;
    return (rows_.blocked(x - dx, y) && !rows_.blocked(x - dx, y + dy)) ||
           (rows_.blocked(x, y - dy) && !rows_.blocked(x + dx, y - dy));
  }

  int jump_straight(const Coordinates& from, std::size_t axis, int sign) {
    Coordinates at = from;
    at[axis] = rows_.stop(axis, sign, from[0], from[1]);
    const int goal = goal_at_[axis];
    const bool meets_goal = goal_at_[1 - axis] == from[1 - axis] && sign * (goal - from[axis]) > 0 &&
                            sign * (at[axis] - goal) >= 0;
    if (meets_goal) at[axis] = goal;
    const bool ends = !meets_goal && rows_.blocked(at[0], at[1]);
    if constexpr (T::kEnabled) {
      Coordinates passed = from;
      for (int left = std::abs(at[axis] - from[axis]) - (ends ? 1 : 0); left > 0; --left) {
        passed[axis] += sign;
        scan(lattice_.node(passed));
      }
    }
    return ends ? 0 : std::abs(at[axis] - from[axis]);
  }

  /// A jump passes over the cell.
  void scan(NodeId n) {
    if constexpr (T::kEnabled) {
      const auto now = static_cast<std::uint32_t>(this->counters_.expansions);
      tr_.line(16);
      tr_.change(own_field(0), n, std::uint64_t{scanned_[n]}, std::uint64_t{now});
      scanned_[n] = now;
    }
  }

  bool cuts_corners_;
  JumpRows rows_{cuts_corners_};
  Coordinates goal_at_{};
  std::vector<std::uint32_t> scanned_;  // as in the log, if there is one
};

}  // namespace replan
