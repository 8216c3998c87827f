// The laws of searches with a lookahead: the D* Lite family, from the goal to the start, and LPA*, from the start to the
// goal, in one file for one derivation. The *root* is the end that g is a distance from, the *target* the other one.
//
// Only what a step touched is looked at. That this is enough: let the laws have held before the step. rhs(s)
// and lp(s) depend on the offers c + g + dist of its successors. An offer that changed is held against rhs(s)
// and lp(s); those that did not change were at least the old rhs(s), so they matter only if rhs(s) went up or
// lp(s) moved on among equals. Keys in U depend on start and km besides: as long as km grows by h(last,
// start) they stay lower bounds (law 6 in lattice.hpp), else all of U is looked through.
#pragma once

#include <bit>
#include <string>
#include <unordered_set>
#include <utility>

#include "core/debug/law_book.hpp"
#include "core/lattice/sight.hpp"
#include "core/plan/common_parameters.hpp"

namespace replan {

template <int D>
class LookaheadLaws : public LawBook<D> {
  using Laws = LawBook<D>;
  using Laws::cell;
  using Laws::direction;
  using Laws::find;
  using Laws::follow;
  using Laws::hold;
  using Laws::hold_status;
  using Laws::named;
  enum Bit : std::uint8_t {
    kRhs = 1,
    kParent = 2,
    kQueue = 4,
    kKey = 8,
    kDist = 16,
    kSide = 32,
    kWay = kRhs | kParent | kSide
  };

  static constexpr const char* kRhsLaw = "rhs(s) is the least c + g + dist of its successors";
  static constexpr const char* kGoalLaw = "rhs(goal) is 0";
  static constexpr const char* kStartLaw = "rhs(start) is 0";
  static constexpr const char* kParentLaw =
      "lp(s) is the successor that offers the least, of equal ones the first";
  static constexpr const char* kSideLaw =
      "side(s) is the other end that its way leads between, if there is one";
  static constexpr const char* kQueueLaw = "s is in U exactly if g(s) and rhs(s) differ";
  static constexpr const char* kKeyLaw =
      "a key is CalculateKey(s) when it is written, and never above it while in U";
  static constexpr const char* kDistLaw = "dist(s) is the penalty of the known map";
  static constexpr const char* kWayLaw =
      "local parents lead from the start to the goal, by moves along which g falls";
  static constexpr const char* kWayBackLaw =
      "parents lead from the goal to the start, by moves along which g falls";
  static constexpr const char* kPathLaw = "a path crosses no obstacle that the robot knows";
  static constexpr const char* kCircleLaw = "a path leads to the goal and not round in a circle";
  static constexpr const char* kLengthLaw = "a path is no longer than the way along local parents";

 public:
  LookaheadLaws(const LogView& view, LawValues<D>& values)
      : LawBook<D>(values),
        sight_(view.info.sight),
        along_path_(view.info.sight && parameters::checks_along_path(view.settings)),
        printed_(view.info.sight && !along_path_ && view.settings.get(parameters::kRemoteParents) != 0),
        sight_rule_(static_cast<SightRule>(static_cast<int>(view.settings.get(parameters::kSight)))),
        from_goal_(view.info.from_goal),
        target_(target_now()),
        root_(root_now()),
        km_(values.km()) {}

  void step() override {
    if (values_.has_clearance() && !penalties_seen_) touch_wrong_penalties();
    follow(root_, root_now());
    const bool any_key = keys_may_be_too_large();
    // What is touched no longer changes; nothing below touches anything.
    for (const typename LawValues<D>::Touched& each : values_.touched()) {
      const std::uint8_t changed = values_.at(each.node).changed;
      if ((changed & (LawVertex::offer | LawVertex::all)) != 0) look_at_predecessors(each.node);
      look_at_touched(each);
    }
    if (any_key)
      values_.for_each_page([this](NodeId node, const LawVertex& vertex) {
        if (vertex.queued() && (vertex.changed & LawVertex::key) == 0) hold_key(node);
      });
  }

  void plan(PlanStatus status, std::span<const Hop> hops) override {
    const NodeId target = target_now();
    if (!values_.on_map(target)) return;
    hold_status(status, "rhs", target, values_.at(target).rhs);
    if (!has_path(status)) return;
    const Cost way = follow_local_parents();
    if (sight_) follow_path(hops, way);
  }

  void look(NodeId node) override {
    look_at_successors(node);
    hold_own(node);
  }

 protected:
  using Laws::values_;
  /// What rhs, lp and side of a vertex ought to be that is not the root.
  struct Right {
    Cost rhs = Cost::infinity();
    NodeId parent = kNoNode, side = kNoNode;
  };

  [[nodiscard]] Cost offer_of(NodeId node) const { return values_.at(node).g + values_.at(node).dist; }
  [[nodiscard]] virtual Right right_of(NodeId s) const {
    Right right;
    const BoxLattice<D>& known = values_.known();
    for (std::uint32_t rest = known.moves(s); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const Cost sum = BoxLattice<D>::step_cost(d) + offer_of(known.neighbour(s, d));
      if (!(sum < right.rhs)) continue;
      right.rhs = sum;
      right.parent = known.neighbour(s, d);
    }
    return right;
  }
  /// Whether rhs is the offer of one successor, which can be held against it alone.
  [[nodiscard]] virtual bool of_single_offers() const { return true; }
  /// That law in words.
  [[nodiscard]] virtual const char* rhs_law() const { return kRhsLaw; }
  [[nodiscard]] virtual Cost estimate(NodeId a, NodeId b) const {
    return values_.known().bound(values_.heuristic(), a, b);
  }
  [[nodiscard]] virtual Cost estimate_up(NodeId a, NodeId b) const {
    return values_.known().bound_up(values_.heuristic(), a, b);
  }

 private:
  [[nodiscard]] NodeId target_now() const { return from_goal_ ? values_.start() : values_.goal(); }
  [[nodiscard]] NodeId root_now() const { return from_goal_ ? values_.goal() : values_.start(); }
  /// The planner writes dist before its first step; what it left out was touched by nobody.
  void touch_wrong_penalties() {
    penalties_seen_ = true;
    for (NodeId node = 0; node < values_.known().node_count(); ++node)
      if (values_.at(node).dist != values_.penalty(node)) values_.touch(node, LawVertex::offer);
  }

  [[nodiscard]] bool keys_may_be_too_large() {
    const NodeId before = std::exchange(target_, target_now());
    const Cost km_before = std::exchange(km_, values_.km());
    if (before == target_ && km_before == km_) return false;
    if (any_key_broken_ || !values_.on_map(before) || !values_.on_map(target_)) return true;
    return km_ < km_before + estimate_up(before, target_);
  }

  /// What u offers has changed.
  void look_at_predecessors(NodeId u) {
    const BoxLattice<D>& known = values_.known();
    const Cost through = offer_of(u);
    for (std::uint32_t rest = known.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId s = known.neighbour(u, d);
      const LawVertex& vertex = values_.at(s);
      const Cost sum = BoxLattice<D>::step_cost(d) + through;
      const bool fits = vertex.lp == u + 1 ? sum == vertex.rhs && !sum.is_infinite()
                                           : sum > vertex.rhs || (sum == vertex.rhs &&
                                                                  (sum.is_infinite() || u + 1 > vertex.lp));
      if (!fits || !of_single_offers() || (vertex.broken & kWay) != 0) look_at_successors(s);
    }
  }

  void look_at_touched(const typename LawValues<D>::Touched& before) {
    const LawVertex& vertex = values_.at(before.node);
    const bool worse = vertex.rhs > before.rhs || (vertex.rhs == before.rhs && vertex.lp > before.lp);
    const bool all = (vertex.changed & LawVertex::all) != 0 || (vertex.broken & kWay) != 0;
    if (all || before.node == root_ || worse ||
        ((vertex.changed & LawVertex::own) != 0 && !parent_offers_rhs(before.node)))
      look_at_successors(before.node);
    hold_own(before.node);
  }

  [[nodiscard]] bool parent_offers_rhs(NodeId s) const {
    const LawVertex& vertex = values_.at(s);
    if (!of_single_offers()) return false;
    if (vertex.rhs.is_infinite()) return vertex.lp == 0;
    const int d = direction(s, vertex.lp - 1u);
    return d >= 0 && BoxLattice<D>::step_cost(d) + offer_of(vertex.lp - 1u) == vertex.rhs;
  }

  void look_at_successors(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const Right right = s == root_ ? Right{Cost::zero(), s, kNoNode} : right_of(s);
    hold(s, kRhs,
         s != root_   ? rhs_law()
         : from_goal_ ? kGoalLaw
                      : kStartLaw,
         vertex.rhs == right.rhs, [&] { return rhs_words(s, right.rhs, right.parent); });
    hold(s, kParent, kParentLaw, vertex.lp == right.parent + 1u,
         [&] { return parent_words(s, right.rhs, right.parent); });
    hold(s, kSide, kSideLaw, vertex.side == right.side + 1u, [&] {
      return named("side", s) + " is " + cell_or_none(vertex.side) + ", but it should be " +
             cell_or_none(right.side + 1u);
    });
  }
  [[nodiscard]] std::string cell_or_none(std::uint32_t next) const {
    return next == 0 ? "none" : cell(next - 1u);
  }

  void hold_own(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    hold(s, kQueue, kQueueLaw, vertex.queued() == (vertex.g != vertex.rhs), [&] {
      return cell(s) + (vertex.queued() ? " is in U" : " is not in U") + ", though g is " +
             cost_text(vertex.g) + " and rhs is " + cost_text(vertex.rhs);
    });
    hold_key(s);
    hold(s, kDist, kDistLaw, vertex.dist == values_.penalty(s), [&] {
      return named("dist", s) + " is " + cost_text(vertex.dist) + ", but on the known map it is " +
             cost_text(values_.penalty(s));
    });
  }

  void hold_key(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const bool any = vertex.queued() && values_.on_map(target_);
    const Cost right = any ? right_key(s) : Cost::zero();
    const bool written = (vertex.changed & LawVertex::key) != 0;
    hold(s, kKey, kKeyLaw, !any || vertex.k1() <= right, [&] {
      any_key_broken_ = true;
      return key_words(s, right);
    });
    // A key that is too small does no harm later on, but nobody should write one.
    if (any && written && vertex.k1() < right) find(s, kKeyLaw, key_words(s, right));
  }
  [[nodiscard]] Cost right_key(NodeId s) const { return values_.at(s).least() + estimate(target_, s) + km_; }

  [[nodiscard]] std::string rhs_words(NodeId s, Cost best, NodeId parent) const {
    const Cost rhs = values_.at(s).rhs;
    const std::string is = named("rhs", s) + " is " + cost_text(rhs) + ", but ";
    if (s == root_) return is + (from_goal_ ? "it is the goal" : "it is the start");
    if (parent == kNoNode) return is + "none of its successors offers anything";
    return is + (best < rhs ? "its successor " : "the least that is offered, by ") + cell(parent) +
           (best < rhs ? " offers " : ", is ") + cost_text(best);
  }
  [[nodiscard]] std::string key_words(NodeId s, Cost right) const {
    const LawVertex& vertex = values_.at(s);
    return "the key of " + cell(s) + " is " + cost_text(vertex.k1()) + ", but min(g, rhs) + h + km is " +
           cost_text(vertex.least()) + " + " + cost_text(estimate(target_, s)) + " + " + cost_text(km_) +
           " = " + cost_text(right);
  }
  [[nodiscard]] std::string parent_words(NodeId s, Cost best, NodeId parent) const {
    const std::uint32_t lp = values_.at(s).lp;
    const std::string is = named("lp", s) + " is " + cell_or_none(lp) + ", but ";
    if (parent == kNoNode) return is + "none of its successors offers anything";
    return is + cell(parent) + " offers " + cost_text(best);
  }

  /// Returns how long they make the way; infinite where they do not lead to the root.
  Cost follow_local_parents() {
    Cost way = Cost::zero();
    for (NodeId s = target_now(); s != root_;) {
      const LawVertex& vertex = values_.at(s);
      const NodeId next = vertex.lp - 1u;
      const int d = vertex.lp == 0 ? -1 : direction(s, next);
      if (d < 0 || !(values_.at(next).g < vertex.g)) {
        find(s, from_goal_ ? kWayLaw : kWayBackLaw, way_words(s, next, d >= 0));
        return Cost::infinity();
      }
      way = way + BoxLattice<D>::step_cost(d);
      s = next;
    }
    return way;
  }
  [[nodiscard]] std::string way_words(NodeId s, NodeId next, bool is_move) const {
    const LawVertex& vertex = values_.at(s);
    if (vertex.lp == 0) return cell(s) + " has no local parent";
    if (!is_move) return "the known map allows no move from " + cell(s) + " to " + named("lp = ", next);
    return "from " + cell(s) + " to " + cell(next) + " g goes from " + cost_text(vertex.g) + " to " +
           cost_text(values_.at(next).g);
  }

  /// The path as the planner reads it out: along remote parents where sight is checked along the path, else
  /// where it saw one (or trusts it unseen).
  /// `way`: how long the way along local parents is.
  void follow_path(std::span<const Hop> hops, Cost way) {
    std::unordered_set<NodeId> passed;
    Cost length = Cost::zero();
    for (NodeId s = values_.start(); s != root_;) {
      if (!passed.insert(s).second) return find(s, kCircleLaw, "the path comes to " + cell(s) + " again");
      NodeId next = values_.at(s).lp - 1u;
      if (printed_ || along_path_) next = values_.at(s).rp - 1u;
      for (; !printed_ && !hops.empty() && hops.front().from == s; hops = hops.subspan(1))
        next = hops.front().to;
      if (!values_.on_map(next)) return find(s, kCircleLaw, "the path ends at " + cell(s));
      if (direction(s, next) < 0 && !sees(s, next)) return find(s, kPathLaw, crossing_words(s, next));
      length = length + euclidean_floor(values_.known().squared_distance(s, next));
      s = next;
    }
    if (!printed_ && way < length)
      find(values_.start(), kLengthLaw,
           "the path is " + cost_text(length) + " long, but the way along local parents only " +
               cost_text(way));
  }
  [[nodiscard]] bool sees(NodeId a, NodeId b) const {
    const BoxLattice<D>& known = values_.known();
    return line_of_sight(
        known, sight_rule_, a, b, [&known](NodeId c) { return known.blocked(c); }, NoSightMap{});
  }
  [[nodiscard]] std::string crossing_words(NodeId s, NodeId next) const {
    const BoxLattice<D>& known = values_.known();
    NodeId obstacle = kNoNode;
    walk_supercover(known, s, next, [&](NodeId node, int) {
      if (known.blocked(node)) obstacle = node;
      return obstacle == kNoNode;
    });
    const std::string way = "the path goes straight from " + cell(s) + " to " + cell(next);
    return obstacle == kNoNode
               ? way + ", past a corner that the rules do not allow"
               : way + ", through " + cell(obstacle) + ", which the robot knows as an obstacle";
  }

  bool sight_, along_path_, printed_;
  SightRule sight_rule_;
  bool penalties_seen_ = false;
  bool any_key_broken_ = false;
  bool from_goal_;
  NodeId target_, root_;  // as of the last step
  Cost km_;
};

}  // namespace replan
