#include "core/plan/navigator.hpp"

#include <vector>

#include "core/lattice/nearest.hpp"
#include "core/lattice/way_out.hpp"
#include "core/plan/registry.hpp"
#include "core/plan/stage.hpp"
#include "core/trace/search_state.hpp"

namespace replan {
namespace {

std::vector<Point> points_along(const Box& box, const std::vector<NodeId>& way, const Path& path) {
  std::vector<Point> points;
  for (const NodeId node : way) points.push_back(centre_of(box.position(node)));
  for (std::size_t i = 1; i < path.size(); ++i) points.push_back(path.point(i));
  return points;
}

/// The path, which begins where the way ends, from the way's beginning on.
Path out_along(const Box& box, const std::vector<NodeId>& way, Path path) {
  if (way.empty() || path.empty()) return path;
  if (path.nodes().empty()) {
    Path whole(points_along(box, way, path));
    whole.touches = path.touches;
    whole.loops = path.loops;
    whole.unchecked = path.unchecked;
    whole.spline = std::move(path.spline);
    return whole;
  }
  std::vector<NodeId> nodes(way.begin(), way.end() - 1);
  nodes.insert(nodes.end(), path.nodes().begin(), path.nodes().end());
  Path whole(box, std::move(nodes), path.sight());
  whole.loops = path.loops;
  whole.unchecked = path.unchecked;
  return whole;
}

/// A planner on a lattice.
template <int D, class T>
class LatticeNavigator final : public Navigator {
 public:
  LatticeNavigator(const PlannerChoice& choice, const Box& box, const SharedBytes& known, double radius,
                   T& tracer)
      : choice_(choice),
        tracer_(tracer),
        known_(box.sides<D>(), known.plain(), move_rules(choice.settings, radius)),
        planner_(new_planner()) {}

  [[nodiscard]] Box box() const override { return known_.box(); }
  [[nodiscard]] std::span<const std::uint8_t> known() const override { return known_.obstacles(); }

  void begin(const Point& start, const Point& goal) override {
    goal_ = node(goal);
    planner_->begin(leave(node(start)), goal_);
  }
  bool advance(std::int64_t iterations) override { return planner_->advance(iterations); }
  void learn(std::span<const CellEdit> edits) override {
    edits_.assign(edits.begin(), edits.end());
    moves_ = known_.apply(edits);
  }
  void update(const Point& start) override {
    planner_->update({.cells = known_.turned_by(edits_), .moves = moves_}, leave(node(start)));
  }

  [[nodiscard]] PlanStatus status() const override { return planner_->status(); }
  [[nodiscard]] Cost cost() const override { return planner_->cost(); }
  [[nodiscard]] Cost best_so_far() const override { return planner_->best_so_far(); }
  bool settle() override { return planner_->settle(); }
  Path path() override {
    return out_along(known_.box(), way_out_, through_stages(known_, planner_->path(), choice_.stages));
  }
  [[nodiscard]] Counters counters() const override { return planner_->counters(); }
  [[nodiscard]] Cost number(Scalar which) const override { return planner_->number(which); }
  [[nodiscard]] std::size_t memory_bytes() const override { return planner_->memory_bytes(); }
  [[nodiscard]] bool blind() const override { return find_planner(choice_.id)->blind; }
  [[nodiscard]] NodeId nearest_reachable(NodeId robot, NodeId goal) const override {
    const std::vector<NodeId> way = way_out(known_, robot, goal);
    return replan::nearest_reachable(known_, way.empty() ? robot : way.back(), goal, impassable());
  }

  void restore(const SearchState& state, const Counters& counters) override {
    known_ = Lattice(known_.size(), state.known_map().plain(), known_.rules());
    goal_ = state.node(Scalar::goal);
    leave(state.node(Scalar::robot));
    planner_ = new_planner();
    planner_->restore(state, counters);
  }

 private:
  using Lattice = BoxLattice<D>;

  [[nodiscard]] std::unique_ptr<Planner<Lattice>> new_planner() {
    return make_planner(*find_planner(choice_.id), known_, choice_.settings, tracer_);
  }
  [[nodiscard]] NodeId node(const Point& point) const { return known_.node(cell_of(point)); }
  /// Cells that the planner enters at no price; empty if there are none.
  [[nodiscard]] std::vector<bool> impassable() const {
    const auto clearance = find_planner(choice_.id)->clearance;
    const ClearanceRules rules = clearance == nullptr ? ClearanceRules{} : clearance(choice_.settings);
    if (!rules.threat || !rules.threat->impassable) return {};
    const ClearanceField<D> field(known_, rules);
    std::vector<bool> closed(known_.node_count());
    for (NodeId n = 0; n < closed.size(); ++n) closed[n] = field.penalty(n).is_infinite();
    return closed;
  }
  /// Where the planner plans from when the robot is there.
  NodeId leave(NodeId robot) {
    way_out_ = way_out(known_, robot, goal_);
    return way_out_.empty() ? robot : way_out_.back();
  }

  const PlannerChoice choice_;
  T& tracer_;
  Lattice known_;
  std::unique_ptr<Planner<Lattice>> planner_;
  NodeId goal_ = kNoNode;
  std::vector<NodeId>
      way_out_;  // from the robot's cell to where the planner plans from; empty if that is the same
  // The latest change of the map.
  std::vector<CellEdit> edits_;
  std::span<const typename Lattice::MoveChange> moves_;
};

template <class T>
std::unique_ptr<Navigator> navigator_with(const PlannerChoice& choice, const Box& box,
                                          const SharedBytes& known, double radius, T& tracer) {
  return with_dimensions(box, [&](auto d) -> std::unique_ptr<Navigator> {
    return std::make_unique<LatticeNavigator<d(), T>>(choice, box, known, radius, tracer);
  });
}

}  // namespace

std::unique_ptr<Navigator> make_navigator(const PlannerChoice& choice, const Box& box,
                                          const SharedBytes& known, double radius, Recorder* recorder) {
  static NoTrace nobody;
  return recorder == nullptr ? navigator_with(choice, box, known, radius, nobody)
                             : navigator_with(choice, box, known, radius, *recorder);
}

PlanStatus finish(Navigator& navigator) {
  while (!navigator.advance(std::int64_t{1} << 20)) {
  }
  return navigator.status();
}

}  // namespace replan
