// The laws of jump point searches: those of a best-first search, but that a parent lies a straight jump away, and that
// nobody offers anything to the cells between. What holds at a vertex depends on its own values, on its parent's g and
// whether that waits in the list, and on the moves between them: where a vertex is touched, those that jumped from it
// are looked for along its eight ways, and where the map is, all are.
#include <array>

#include "core/debug/parent_laws.hpp"

namespace replan {
namespace {

template <int D>
class JumpLaws final : public ParentLaws<D> {
  using Laws = ParentLaws<D>;
  using Laws::goal_;
  using Laws::start_;
  using Laws::values_;
  using Coordinates = typename BoxLattice<D>::Coordinates;

 public:
  JumpLaws(const LogView& view, LawValues<D>& values)
      : Laws(view, values,
             {.parent_law =
                  "g(s) is its parent's g and the jump, or more while the parent's g has yet to spread",
              .way_law = "parents lead from the goal to the start, by straight jumps over free cells along "
                         "which g falls",
              .hop = "jump"}) {}

  void step() override {
    this->follow(start_, values_.start());
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

  void look(NodeId s) override {
    this->hold_parent(s);
    this->hold_key(s);
  }

 private:
  void look_at_children(NodeId u) {
    const BoxLattice<D>& known = values_.known();
    for (int d = 0; d < BoxLattice<D>::kDirections; ++d)
      for (Coordinates at = known.step(known.coordinates(u), d); known.contains(at); at = known.step(at, d))
        if (const NodeId s = known.node(at); values_.at(s).lp == u + 1) this->hold_parent(s);
  }

  /// What the jump between the two costs, if a straight way of moves leads from one to the other.
  [[nodiscard]] Cost way(NodeId from, NodeId to) const override {
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
};

}  // namespace

template <int D>
std::unique_ptr<LawBook<D>> make_jump_laws(const LogView& view, LawValues<D>& values) {
  return std::make_unique<JumpLaws<D>>(view, values);
}

template std::unique_ptr<LawBook<2>> make_jump_laws(const LogView&, LawValues<2>&);
template std::unique_ptr<LawBook<3>> make_jump_laws(const LogView&, LawValues<3>&);

}  // namespace replan
