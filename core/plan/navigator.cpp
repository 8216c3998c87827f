#include "core/plan/navigator.hpp"

#include <vector>

#include "core/lattice/nearest.hpp"
#include "core/plan/registry.hpp"
#include "core/plan/stage.hpp"
#include "core/trace/search_state.hpp"

namespace replan {
namespace {

/// A planner on a lattice.
template <int D, class T>
class LatticeNavigator final : public Navigator {
 public:
  LatticeNavigator(const PlannerChoice& choice, const Box& box, const SharedBytes& known, T& tracer)
      : choice_(choice),
        tracer_(tracer),
        known_(box.sides<D>(), known.plain(), move_rules(choice.settings)),
        planner_(new_planner()) {}

  [[nodiscard]] Box box() const override { return known_.box(); }
  [[nodiscard]] std::span<const std::uint8_t> known() const override { return known_.cells(); }

  void begin(const Point& start, const Point& goal) override { planner_->begin(node(start), node(goal)); }
  bool advance(std::int64_t iterations) override { return planner_->advance(iterations); }
  void learn(std::span<const CellEdit> edits) override {
    edits_.assign(edits.begin(), edits.end());
    moves_ = known_.apply(edits);
  }
  void update(const Point& start) override {
    planner_->update({.cells = edits_, .moves = moves_}, node(start));
  }

  [[nodiscard]] PlanStatus status() const override { return planner_->status(); }
  [[nodiscard]] Cost cost() const override { return planner_->cost(); }
  Path path() override { return through_stages(known_, planner_->path(), choice_.stages); }
  [[nodiscard]] Counters counters() const override { return planner_->counters(); }
  [[nodiscard]] Cost number(Scalar which) const override { return planner_->number(which); }
  [[nodiscard]] std::size_t memory_bytes() const override { return planner_->memory_bytes(); }
  [[nodiscard]] NodeId nearest_reachable(NodeId robot, NodeId goal) const override {
    return replan::nearest_reachable(known_, robot, goal);
  }

  void restore(const SearchState& state, const Counters& counters) override {
    known_ = Lattice(known_.size(), state.known_map().plain(), known_.rules());
    planner_ = new_planner();
    planner_->restore(state, counters);
  }

 private:
  using Lattice = BoxLattice<D>;

  [[nodiscard]] std::unique_ptr<Planner<Lattice>> new_planner() {
    return make_planner(*find_planner(choice_.id), known_, choice_.settings, tracer_);
  }
  [[nodiscard]] NodeId node(const Point& point) const { return known_.node(cell_of(point)); }

  const PlannerChoice choice_;
  T& tracer_;
  Lattice known_;
  std::unique_ptr<Planner<Lattice>> planner_;
  // The latest change of the map.
  std::vector<CellEdit> edits_;
  std::span<const typename Lattice::MoveChange> moves_;
};

template <class T>
std::unique_ptr<Navigator> navigator_with(const PlannerChoice& choice, const Box& box,
                                          const SharedBytes& known, T& tracer) {
  return with_dimensions(box, [&](auto d) -> std::unique_ptr<Navigator> {
    return std::make_unique<LatticeNavigator<d(), T>>(choice, box, known, tracer);
  });
}

}  // namespace

std::unique_ptr<Navigator> make_navigator(const PlannerChoice& choice, const Box& box,
                                          const SharedBytes& known, Recorder* recorder) {
  static NoTrace nobody;
  return recorder == nullptr ? navigator_with(choice, box, known, nobody)
                             : navigator_with(choice, box, known, *recorder);
}

PlanStatus finish(Navigator& navigator) {
  while (!navigator.advance(std::int64_t{1} << 20)) {
  }
  return navigator.status();
}

}  // namespace replan
