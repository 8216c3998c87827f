// The laws of best-first searches. As with the D* Lite family only what a step touched is looked at:
// what holds at a vertex depends on its own values and on its neighbours' g and whether they are in the list.
//
// In an any-angle search a vertex is reached on a straight way from its remote parent. Its g is right when it is
// written; if the remote parent's falls later, it need not follow.
#include <bit>
#include <utility>

#include "core/debug/parent_laws.hpp"
#include "core/lattice/sight.hpp"
#include "core/plan/common_parameters.hpp"

namespace replan {
namespace {

template <int D, bool kAnyAngle>
class BestFirstLaws final : public ParentLaws<D> {
  using Laws = ParentLaws<D>;
  using Laws::cell;
  using Laws::direction;
  using Laws::find;
  using Laws::goal_;
  using Laws::hold;
  using Laws::hold_key;
  using Laws::hold_parent;
  using Laws::named;
  using Laws::start_;
  using Laws::values_;
  enum Bit : std::uint8_t { kSpread = Laws::kFirstOwn, kStraight = kSpread * 2, kDist = kStraight * 2 };

  static constexpr const char* kStraightLaw =
      "g(s) is its remote parent's g and the straight way, when it is written";
  static constexpr const char* kSpreadLaw =
      "a cell that was taken from the list has offered its g to all neighbours";
  static constexpr const char* kDistLaw = "dist(s) is the penalty of the known map";
  static constexpr const char* kSightWayLaw =
      "remote parents lead from the goal to the start, along lines of sight on which g falls";

 public:
  BestFirstLaws(const LogView& view, LawValues<D>& values)
      : Laws(view, values,
             {.parent_law =
                  "g(s) is its parent's g and the move, or more while the parent's g has yet to spread",
              .way_law = "parents lead from the goal to the start, by moves along which g falls",
              .hop = "move"}),
        sight_rule_(static_cast<SightRule>(static_cast<int>(view.settings.get(parameters::kSight)))),
        takes_once_(view.info.key.once) {}

  void step() override {
    if (!std::exchange(penalties_seen_, true)) touch_wrong_penalties();
    this->follow(start_, values_.start());
    const bool other_goal = goal_ != values_.goal();
    goal_ = values_.goal();
    for (const typename LawValues<D>::Touched& each : values_.touched()) {
      const LawVertex& vertex = values_.at(each.node);
      const bool spread = vertex.g != each.g || vertex.queued() != each.queued;
      // A better g of a vertex that waits in the list asks nothing of its neighbours yet.
      const bool waits = vertex.queued() && vertex.g <= each.g && !any_broken_ && !takes_once_;
      if (spread && !waits) look_at_neighbours(each.node);
      look(each.node);
      if constexpr (kAnyAngle)
        if (vertex.g != each.g) hold_straight(each.node);
    }
    if (other_goal)
      values_.for_each_page([this](NodeId node, const LawVertex& vertex) {
        if (vertex.queued()) hold_key(node);
      });
  }

  void look(NodeId s) override {
    hold_parent(s);
    hold_spread(s);
    hold_key(s);
    hold(s, kDist, kDistLaw, values_.at(s).dist == values_.penalty(s), [&] {
      return named("dist", s) + " is " + cost_text(values_.at(s).dist) + ", but on the known map it is " +
             cost_text(values_.penalty(s));
    });
    any_broken_ |= values_.at(s).broken != 0;
  }

 private:
  /// The planner writes dist before its first step; what it left out was touched by nobody.
  void touch_wrong_penalties() {
    for (NodeId s = 0; values_.has_clearance() && s < values_.known().node_count(); ++s)
      if (values_.at(s).dist != values_.penalty(s)) values_.touch(s, LawVertex::offer);
  }
  /// What u offers to a vertex that a move in direction d enters.
  [[nodiscard]] Cost offer(Cost g, int d, const LawVertex& entered) const {
    return g + BoxLattice<D>::step_cost(d) + entered.dist;
  }

  void look_at_neighbours(NodeId u) {
    const BoxLattice<D>& known = values_.known();
    const LawVertex& vertex = values_.at(u);
    for (std::uint32_t rest = known.moves(u); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const NodeId s = known.neighbour(u, d);
      const LawVertex& other = values_.at(s);
      if (!kAnyAngle && other.lp == u + 1) hold_parent(s);
      const bool kept_back = !other.queued() && vertex.g > offer(other.g, d, vertex);
      if (kept_back || (other.broken & kSpread) != 0) hold_spread(s);
      any_broken_ |= other.broken != 0;
    }
  }

  [[nodiscard]] Cost way(NodeId s, NodeId parent) const override {
    const int d = direction(s, parent);
    return d < 0 ? Cost::infinity() : offer(Cost::zero(), d, values_.at(s));
  }
  [[nodiscard]] bool parent_is_right(NodeId s) const override {
    const LawVertex& vertex = values_.at(s);
    if (!kAnyAngle || s == start_ || vertex.g.is_infinite()) return Laws::parent_is_right(s);
    return vertex.lp != 0 && vertex.rp != 0;
  }

  /// Of a vertex whose g the step has written.
  void hold_straight(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const NodeId rp = vertex.rp - 1u;
    const bool any = s != start_ && !vertex.g.is_infinite() && values_.on_map(rp);
    const Cost sum =
        any ? values_.at(rp).g + euclidean_ceil(values_.known().squared_distance(rp, s)) : vertex.g;
    hold(s, kStraight, kStraightLaw, vertex.g == sum, [&] {
      return named("g", s) + " is " + cost_text(vertex.g) + ", but from its remote parent " + cell(rp) +
             " it is " + cost_text(sum);
    });
  }

  void hold_spread(NodeId u) {
    const BoxLattice<D>& known = values_.known();
    const LawVertex& vertex = values_.at(u);
    NodeId behind = kNoNode;
    Cost offered;
    if (!vertex.g.is_infinite() && !vertex.queued())
      for (std::uint32_t rest = known.moves(u); rest != 0 && behind == kNoNode; rest &= rest - 1) {
        const int d = std::countr_zero(rest);
        const LawVertex& other = values_.at(known.neighbour(u, d));
        offered = offer(vertex.g, d, other);
        const bool taken = takes_once_ && !other.queued() && !other.g.is_infinite();
        if (other.g > offered && !taken) behind = known.neighbour(u, d);
      }
    hold(u, kSpread, kSpreadLaw, behind == kNoNode, [&] {
      return cell(u) + " was taken and offers " + cost_text(offered) + " to " + cell(behind) + ", but " +
             named("g", behind) + " is " + cost_text(values_.at(behind).g);
    });
  }

  void follow_parents() override {
    if constexpr (kAnyAngle)
      follow_lines();
    else
      Laws::follow_parents();
  }

  void follow_lines() {
    const BoxLattice<D>& known = values_.known();
    const auto bad = [&known](NodeId c) { return known.blocked(c); };
    for (NodeId s = goal_; s != start_;) {
      const NodeId rp = values_.at(s).rp - 1u;
      if (!values_.on_map(rp)) return find(s, kSightWayLaw, cell(s) + " has no remote parent");
      if (!line_of_sight(known, sight_rule_, rp, s, bad, NoSightMap{}))
        return find(s, kSightWayLaw, cell(s) + " does not see its remote parent " + cell(rp));
      if (!this->g_falls(s, rp, "its remote parent", kSightWayLaw)) return;
      s = rp;
    }
  }

  SightRule sight_rule_;
  bool takes_once_;  // what was taken is offered nothing more
  bool any_broken_ = false;
  bool penalties_seen_ = false;
};

}  // namespace

template <int D>
std::unique_ptr<LawBook<D>> make_best_first_laws(const LogView& view, LawValues<D>& values) {
  return std::make_unique<BestFirstLaws<D, false>>(view, values);
}
template <int D>
std::unique_ptr<LawBook<D>> make_any_angle_laws(const LogView& view, LawValues<D>& values) {
  return std::make_unique<BestFirstLaws<D, true>>(view, values);
}

template std::unique_ptr<LawBook<2>> make_best_first_laws(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_best_first_laws(const LogView&, LawValues<3>&);
template std::unique_ptr<LawBook<2>> make_any_angle_laws(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_any_angle_laws(const LogView&, LawValues<3>&);

}  // namespace replan
