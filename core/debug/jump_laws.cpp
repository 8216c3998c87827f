// The laws of jump point searches: those of a best-first search, but that a parent lies a straight jump away, and that
// nobody offers anything to the cells between. What holds at a vertex depends on its own values, on its parent's g and
// whether that waits in the list, and on the moves between them: where a vertex is touched, those that jumped from it
// are looked for along its eight ways, and where the map is, all are.
#include <array>

#include "core/debug/law_book.hpp"

namespace replan {
namespace {

template <int D>
class JumpLaws final : public LawBook<D> {
  using Laws = LawBook<D>;
  using Laws::cell;
  using Laws::find;
  using Laws::follow;
  using Laws::hold;
  using Laws::hold_status;
  using Laws::named;
  using Laws::values_;
  using Coordinates = typename BoxLattice<D>::Coordinates;
  enum Bit : std::uint8_t { kParent = 1, kKey = 2 };

  static constexpr const char* kStartLaw = "g(start) is 0";
  static constexpr const char* kParentLaw =
      "g(s) is its parent's g and the jump, or more while the parent's g has yet to spread";
  static constexpr const char* kWayLaw =
      "parents lead from the goal to the start, by straight jumps over free cells along which g falls";

 public:
  JumpLaws(const LogView& view, LawValues<D>& values)
      : LawBook<D>(values),
        key_law_(view.info.key.law),
        f_(view.info.key.f(view.settings)),
        start_(values.start()),
        goal_(values.goal()) {}

  void step() override {
    follow(start_, values_.start());
    bool all = std::exchange(goal_, values_.goal()) != values_.goal();
    for (const typename LawValues<D>::Touched& each : values_.touched())
      all |= (values_.at(each.node).changed & LawVertex::all) != 0;
    if (all) {
      values_.for_each_page([this](NodeId node, const LawVertex&) { look(node); });
      for (const auto& each : values_.touched()) look(each.node);
      return;
    }
    for (const typename LawValues<D>::Touched& each : values_.touched()) {
      const LawVertex& vertex = values_.at(each.node);
      if (vertex.g != each.g || vertex.queued() != each.queued) look_at_children(each.node);
      look(each.node);
    }
  }

  void plan(PlanStatus status, std::span<const Hop>) override {
    if (!values_.on_map(goal_)) return;
    hold_status(status, "g", goal_, values_.at(goal_).g);
    if (has_path(status)) follow_parents();
  }

  void look(NodeId s) override {
    hold_parent(s);
    hold_key(s);
  }

 private:
  void look_at_children(NodeId u) {
    const BoxLattice<D>& known = values_.known();
    for (int d = 0; d < BoxLattice<D>::kDirections; ++d)
      for (Coordinates at = known.step(known.coordinates(u), d); known.contains(at); at = known.step(at, d))
        if (const NodeId s = known.node(at); values_.at(s).lp == u + 1) hold_parent(s);
  }

  /// What the jump between two cells costs; infinite if no straight way of moves leads from one to the other.
  [[nodiscard]] Cost jump(NodeId from, NodeId to) const {
    const BoxLattice<D>& known = values_.known();
    if (from == to || !values_.on_map(to)) return Cost::infinity();
    const Coordinates a = known.coordinates(from), b = known.coordinates(to);
    std::array<int, D> offset{};
    int steps = 0;
    for (std::size_t axis = 0; axis < D; ++axis) {
      const int by = b[axis] - a[axis];
      offset[axis] = (by > 0) - (by < 0);
      steps = std::max(steps, std::abs(by));
    }
    for (std::size_t axis = 0; axis < D; ++axis)
      if (b[axis] - a[axis] != steps * offset[axis]) return Cost::infinity();
    const int d = Directions<D>::index(offset);
    for (NodeId at = from; at != to; at = known.neighbour(at, d))
      if ((known.moves(at) >> d & 1u) == 0) return Cost::infinity();
    return {steps * BoxLattice<D>::step_cost(d).raw};
  }

  void hold_parent(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    hold(s, kParent, s == start_ ? kStartLaw : kParentLaw, parent_is_right(s), [&] {
      const std::string is = named("g", s) + " is " + cost_text(vertex.g);
      if (vertex.lp == 0) return is + " and it has no parent";
      const NodeId parent = vertex.lp - 1u;
      if (jump(s, parent).is_infinite())
        return is + ", but no jump leads to it from " + named("its parent ", parent);
      return is + ", its parent's, " + named("g", parent) + ", is " + cost_text(values_.at(parent).g);
    });
  }
  [[nodiscard]] bool parent_is_right(NodeId s) const {
    const LawVertex& vertex = values_.at(s);
    if (s == start_) return vertex.g == Cost::zero() && vertex.lp == 0;
    if (vertex.g.is_infinite()) return vertex.lp == 0 && !vertex.queued();
    const Cost way = vertex.lp == 0 ? Cost::infinity() : jump(s, vertex.lp - 1u);
    if (way.is_infinite()) return false;
    const LawVertex& parent = values_.at(vertex.lp - 1u);
    const Cost sum = parent.g + way;
    return vertex.g == sum || (vertex.g > sum && parent.queued());
  }

  void hold_key(NodeId s) {
    const LawVertex& vertex = values_.at(s);
    const bool any = vertex.queued() && values_.on_map(goal_);
    const Cost h = any ? values_.known().bound(values_.heuristic(), s, goal_) : Cost::zero();
    const Cost f = any ? f_(vertex.g, h) : Cost::zero();
    hold(s, kKey, key_law_, !any || vertex.k1() == f, [&] {
      return "the key of " + cell(s) + " is " + cost_text(vertex.k1()) + ", but it should be " +
             cost_text(f) + ": g is " + cost_text(vertex.g) + " and h is " + cost_text(h);
    });
  }

  void follow_parents() {
    for (NodeId s = goal_; s != start_;) {
      const LawVertex& vertex = values_.at(s);
      const NodeId parent = vertex.lp - 1u;
      if (vertex.lp == 0 || jump(s, parent).is_infinite())
        return find(s, kWayLaw, "no jump leads to " + cell(s) + " from its parent");
      if (!(values_.at(parent).g < vertex.g))
        return find(s, kWayLaw,
                    "from " + cell(s) + " to its parent " + cell(parent) + " g goes from " +
                        cost_text(vertex.g) + " to " + cost_text(values_.at(parent).g));
      s = parent;
    }
  }

  const char* key_law_;
  KeyRule::F f_;
  NodeId start_, goal_;  // as of the last step
};

}  // namespace

template <int D>
std::unique_ptr<LawBook<D>> make_jump_laws(const LogView& view, LawValues<D>& values) {
  return std::make_unique<JumpLaws<D>>(view, values);
}

template std::unique_ptr<LawBook<2>> make_jump_laws(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_jump_laws(const LogView&, LawValues<3>&);

}  // namespace replan
