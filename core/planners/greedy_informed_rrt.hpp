// The improved Informed RRT*: greedy at the goal, and then better along its path instead of over the whole tree.
//
//  Dai J., Li Z., Li Y. & Zhao J., "Robot path planning based on improved Informed-RRT* algorithm", 2022 (in Chinese)
//
// Line numbers are those of assets/planners/greedy-informed-rrt-star.md; up to 18 they are those of RRT*.
//
// What is settled here:
//  * The first phase is RRT*'s, but for line 12: a new vertex is joined to the goal from wherever it sees it, which ends
//    the phase.
//  * In the second one, the place that takes a vertex's place on the path is a vertex of its own, hung between that one's
//    neighbours; the vertex itself stays in the tree with what else hangs on it, for plans to come.
//  * Both new ways have to be free, which the paper does not ask for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/planners/rrt.hpp"

namespace replan {

struct GreedyInformedRrtSwitches {};

inline PlannerInfo describe(GreedyInformedRrtSwitches) {
  PlannerInfo info = describe(RrtSwitches{.rewire = true, .informed = true, .greedy = true});
  info.name = "Greedy Informed RRT*";
  info.summary =
      "Joins the goal as soon as it is in sight, and then pulls its path straight by samples around it.";
  info.source = "Dai, Li, Li & Zhao 2022, the improved Informed RRT*";
  return info;
}

template <Lattice L, Tracer T>
class GreedyInformedRrt final : public Rrt<L, T> {
 public:
  GreedyInformedRrt(const L& lattice, const Settings& settings, T& tracer, GreedyInformedRrtSwitches)
      : Rrt<L, T>(lattice, settings, tracer, {.rewire = true, .informed = true, .greedy = true}) {}

 private:
  using Base = Rrt<L, T>;
  using Base::kNone;
  using Base::space_;
  using Base::tr_;
  using Base::tree_;

  void grow_towards(const Place& sample) override {
    if (this->has_path())
      pull(sample);
    else
      Base::grow_towards(sample);
  }

  [[nodiscard]] int sampling_line() const override { return this->has_path() ? 20 : 3; }

  // Lines 19-27: one sample of the second phase.
  void pull(const Place& sample) {
    if (const auto hit = space_.hit(sample, sample))
      return this->reject(SampleFault::blocked, space_.known().node(*hit));
    tr_.line(21);
    const std::uint32_t c = nearest_on_path(sample);
    this->tell_nearest(c);
    tr_.line(22);
    const Place place = this->steer_from(c, sample);
    tr_.line(23);
    const std::uint32_t before = tree_.parent(c), after = below_on_path(c);
    if (before == kNone || after == kNone) return this->reject(SampleFault::path_end, space_.node(place));
    tr_.line(24);
    const Cost now = tree_.cost_over(before, tree_.place(c)) +
                     length_between(tree_.place(c), tree_.place(after)),
               then = tree_.cost_over(before, place) + length_between(place, tree_.place(after));
    if (!(then < now) || tree_.full()) return this->reject(SampleFault::longer, space_.node(place));
    tr_.line(25);
    for (const std::uint32_t neighbour : {before, after})
      if (const auto hit = tree_.hit_from(neighbour, place))
        return this->reject(SampleFault::blocked, space_.known().node(*hit));
    tr_.line(26);
    tr_.note(EventKind::rewired, after, static_cast<std::uint64_t>(now.raw - then.raw));
    tree_.hang(after, tree_.grow(place, before));
    tr_.line(27);
    tree_.take_gain();
  }

  /// Of the vertices of the path; of equally near ones the one nearer to the goal.
  [[nodiscard]] std::uint32_t nearest_on_path(const Place& sample) const {
    std::uint32_t nearest = tree_.goal_vertex();
    for (std::uint32_t v = nearest; v != kNone; v = tree_.parent(v))
      if (squared_between(tree_.place(v), sample) < squared_between(tree_.place(nearest), sample))
        nearest = v;
    return nearest;
  }
  /// The next vertex of the path towards the goal; kNone for the goal itself.
  [[nodiscard]] std::uint32_t below_on_path(std::uint32_t vertex) const {
    std::uint32_t below = kNone;
    for (std::uint32_t v = tree_.goal_vertex(); v != vertex; v = tree_.parent(v)) below = v;
    return below;
  }
};

}  // namespace replan
