// The laws of searches whose costs rise and fall in waves from the goal on: D* and its like. They are those that the papers'
// proofs rest on (Stentz, "Optimal and efficient path planning for unknown and dynamic environments", CMU-RI-TR-93-20).
//
// What holds at a state depends on its own values and on its neighbours'. So after each step those that it touched are
// looked at, and their neighbours; where the robot's place or the bias has changed all keys are, besides.
#include <bit>
#include <string>

#include "core/debug/law_book.hpp"

namespace replan {
namespace {

template <int D>
class BackPointerLaws final : public LawBook<D> {
  using Laws = LawBook<D>;
  using Laws::cell;
  using Laws::direction;
  using Laws::find;
  using Laws::hold;
  using Laws::named;
  using Laws::values_;
  enum Bit : std::uint8_t { kTag = 1, kLowest = 2, kKey = 4, kWay = 8, kSpread = 16, kDist = 32 };
  using Tag = fields::StateTag;

  static constexpr const char* kTagLaw =
      "a cell is OPEN exactly while it is in the open list, and NEW ones have no cost";
  static constexpr const char* kLowestLaw = "k is finite and at most h while a cell is OPEN";
  static constexpr const char* kKeyLaw =
      "a key is that of k and the robot's place when it is written, and never above it while in the open "
      "list";
  static constexpr const char* kWayLaw =
      "h is that of its back-pointer and the move there, unless that is OPEN; without a way both are none";
  static constexpr const char* kGoalLaw = "h(goal) is 0 and it has no back-pointer";
  static constexpr const char* kSpreadLaw = "a CLOSED cell has offered its cost to all neighbours";
  static constexpr const char* kDistLaw = "dist(s) is the penalty of the known map";
  static constexpr const char* kOrderLaw = "no key is written below that of the cell that was taken";
  static constexpr const char* kEndLaw = "a plan stands once no key is below what the robot's place costs";
  static constexpr const char* kPathLaw =
      "back-pointers lead from the start to the goal, by moves along each of which h falls by its cost";

 public:
  BackPointerLaws(const LogView& view, LawValues<D>& values)
      : LawBook<D>(values),
        focused_(view.info.values.declares(fields::kFocused.kind)),
        start_(values.start()),
        goal_(values.goal()),
        bias_(values.km()) {}

  void step() override {
    if (values_.has_clearance() && !penalties_seen_) touch_wrong_penalties();
    this->follow(goal_, values_.goal());
    const bool moved = start_ != values_.start() || bias_ != values_.km();
    start_ = values_.start();
    bias_ = values_.km();
    const LawVertex* taken = values_.taken();
    for (const typename LawValues<D>::Touched& each : values_.touched()) {
      look(each.node);
      if (taken != nullptr) hold_order(each.node, *taken);
      const BoxLattice<D>& known = values_.known();
      const auto at = known.coordinates(each.node);
      for (int d = 0; d < BoxLattice<D>::kDirections;
           ++d)  // by a move that is gone, too, back-pointers may lead here
        if (known.contains(BoxLattice<D>::step(at, d))) hold_ways(known.neighbour(each.node, d));
    }
    if (moved)
      values_.for_each_page([this](NodeId node, const LawVertex& vertex) {
        if (vertex.queued()) hold_key(node);
      });
  }

  void plan(PlanStatus status, std::span<const Hop>) override {
    if (!values_.on_map(start_) || !values_.on_map(goal_)) return;
    const bool promised = this->ends_free() && !values_.at(start_).g.is_infinite();
    if (has_path(status) != promised) return this->hold_status(status, "h", start_, values_.at(start_).g);
    if (this->ends_free() && !holds_end()) return;
    if (has_path(status)) follow_back_pointers();
  }

  void look(NodeId s) override {
    hold_tag(s);
    hold_lowest(s);
    hold_key(s);
    hold_ways(s);
    hold(s, kDist, kDistLaw, values_.at(s).dist == values_.penalty(s), [&] {
      return named("dist", s) + " is " + cost_text(values_.at(s).dist) + ", but on the known map it is " +
             cost_text(values_.penalty(s));
    });
  }

 private:
  /// The planner writes dist before its first step; what it left out was touched by nobody.
  void touch_wrong_penalties() {
    penalties_seen_ = true;
    for (NodeId node = 0; node < values_.known().node_count(); ++node)
      if (values_.at(node).dist != values_.penalty(node)) values_.touch(node, LawVertex::offer);
  }
  [[nodiscard]] static Cost step_cost(int d) { return BoxLattice<D>::step_cost(d); }
  [[nodiscard]] Cost estimate(NodeId s) const {
    return focused_ ? values_.known().bound(values_.heuristic(), start_, s) : Cost::zero();
  }
  /// What it costs to go on to a neighbour and from there.
  [[nodiscard]] Cost through(NodeId next, int d) const {
    return values_.at(next).g + step_cost(d) + values_.at(next).dist;
  }

  void hold_tag(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const bool fresh = vertex.tag == Tag::fresh;
    const bool holds = vertex.queued() == (vertex.tag == Tag::open) && (!fresh || vertex.g.is_infinite());
    hold(s, kTag, kTagLaw, holds, [&] {
      const auto tag = static_cast<std::size_t>(vertex.tag);
      return cell(s) + " is " +
             (tag < std::size(fields::kTagNames) ? std::string(fields::kTagNames[tag]) : "of no tag") +
             ", but it is " + (vertex.queued() ? "in" : "not in") + " the open list, and h is " +
             cost_text(vertex.g);
    });
  }

  /// h and the penalty of the cell itself, which keys hold, too.
  [[nodiscard]] Cost whole(const LawVertex& vertex) const {
    return vertex.dist.is_infinite() ? vertex.g : vertex.g + vertex.dist;
  }

  void hold_lowest(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const bool holds = !vertex.queued() || (vertex.k <= whole(vertex) && !vertex.k.is_infinite());
    hold(s, kLowest, kLowestLaw, holds,
         [&] { return named("k", s) + " is " + cost_text(vertex.k) + ", and h is " + cost_text(vertex.g); });
  }

  void hold_key(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const bool any = vertex.queued() && (!focused_ || values_.on_map(start_));
    const Cost f = any ? vertex.k + estimate(s) : Cost::zero();
    const Cost right = any && focused_ ? f + values_.km() : f;
    const bool written = (vertex.changed & LawVertex::key) != 0;
    const bool f_is_right = !focused_ || !written || vertex.f == f;
    const auto words = [&] {
      return "the key of " + cell(s) + " is " + cost_text(vertex.k1()) + ", but it should be " +
             cost_text(right) + ": k is " + cost_text(vertex.k);
    };
    hold(s, kKey, kKeyLaw, !any || vertex.k1() <= right, words);
    // A key that is too small does no harm later on, but nobody should write one.
    if (any && written && (vertex.k1() < right || !f_is_right)) find(s, kKeyLaw, words());
  }

  void hold_ways(NodeId s) {
    hold(s, kWay, s == goal_ ? kGoalLaw : kWayLaw, way_holds(s), [&] { return way_words(s); });
    const NodeId left_out = left_out_by(s);
    hold(s, kSpread, kSpreadLaw, left_out == kNoNode, [&] {
      return cell(s) + " is CLOSED and h is " + cost_text(values_.at(s).g) + ", but " + named("h", left_out) +
             " is " + cost_text(values_.at(left_out).g);
    });
  }

  /// Whether they touch, be there a move or not.
  [[nodiscard]] bool is_beside(NodeId s, NodeId next) const {
    const BoxLattice<D>& known = values_.known();
    return values_.on_map(next) && next != s && known.squared_distance(s, next) <= D;
  }

  [[nodiscard]] bool way_holds(NodeId s) const {
    const LawVertex& vertex = values_.at(s);
    if (s == goal_) return vertex.g == Cost::zero() && vertex.lp == 0;
    const bool settled = vertex.tag != Tag::open;
    if (vertex.lp == 0) return vertex.g.is_infinite();
    if (vertex.g.is_infinite() && settled) return false;
    const NodeId next = vertex.lp - 1u;
    if (!is_beside(s, next)) return false;
    if (values_.at(next).tag == Tag::open) return true;
    const int d = direction(s, next);
    return vertex.g == (d < 0 ? Cost::infinity() : through(next, d));
  }
  [[nodiscard]] std::string way_words(NodeId s) const {
    const LawVertex& vertex = values_.at(s);
    const std::string is = named("h", s) + " is " + cost_text(vertex.g);
    if (vertex.lp == 0) return is + ", and it has no back-pointer";
    const NodeId next = vertex.lp - 1u;
    if (!is_beside(s, next)) return is + ", and its back-pointer leads to no neighbour";
    if (direction(s, next) < 0) return is + ", but no move leads to " + named("its back-pointer ", next);
    return is + ", and its back-pointer's, " + named("h", next) + ", is " + cost_text(values_.at(next).g);
  }

  /// A neighbour that could do better by a CLOSED cell and is not about to; kNoNode if there is none.
  [[nodiscard]] NodeId left_out_by(NodeId s) const {
    const LawVertex& vertex = values_.at(s);
    const BoxLattice<D>& known = values_.known();
    if (vertex.tag != Tag::closed || vertex.g.is_infinite()) return kNoNode;
    for (std::uint32_t rest = known.moves(s); rest != 0; rest &= rest - 1) {
      const int d = std::countr_zero(rest);
      const LawVertex& other = values_.at(known.neighbour(s, d));
      if (other.tag != Tag::open && other.g > through(s, d)) return known.neighbour(s, d);
    }
    return kNoNode;
  }

  /// What a step writes comes after what it began with, or the search would have to go back.
  void hold_order(NodeId s, const LawVertex& taken) {
    const LawVertex& vertex = values_.at(s);
    if (!vertex.queued() || (vertex.changed & LawVertex::key) == 0 || vertex.k1() >= taken.k1()) return;
    find(s, kOrderLaw,
         "the key of " + cell(s) + " is " + cost_text(vertex.k1()) + ", and that of the cell taken was " +
             cost_text(taken.k1()));
  }

  bool holds_end() {
    const LawVertex& robot = values_.at(start_);
    const Cost end = focused_ ? whole(robot) + values_.km() : whole(robot);
    NodeId before = kNoNode;
    values_.for_each_page([&](NodeId node, const LawVertex& vertex) {
      if (before == kNoNode && vertex.queued() && vertex.k1() < end) before = node;
    });
    if (before == kNoNode) return true;
    find(before, kEndLaw,
         "the key of " + cell(before) + " is " + cost_text(values_.at(before).k1()) + ", less than " +
             cost_text(end));
    return false;
  }

  void follow_back_pointers() {
    for (NodeId s = start_; s != goal_;) {
      const LawVertex& vertex = values_.at(s);
      const NodeId next = vertex.lp - 1u;
      const int d = vertex.lp == 0 ? -1 : direction(s, next);
      if (d < 0 || vertex.g != through(next, d)) return find(s, kPathLaw, way_words(s));
      s = next;
    }
  }

  bool focused_;
  bool penalties_seen_ = false;
  NodeId start_, goal_;  // as of the last step
  Cost bias_;
};

}  // namespace

template <int D>
std::unique_ptr<LawBook<D>> make_back_pointer_laws(const LogView& view, LawValues<D>& values) {
  return std::make_unique<BackPointerLaws<D>>(view, values);
}

template std::unique_ptr<LawBook<2>> make_back_pointer_laws(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_back_pointer_laws(const LogView&, LawValues<3>&);

}  // namespace replan
