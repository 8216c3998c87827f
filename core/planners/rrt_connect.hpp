// RRT-Connect: two trees, one from the start and one from the goal, that grow towards each other.
//
//  Kuffner J. J. & LaValle S. M., "RRT-Connect: an efficient approach to single-query path planning", ICRA 2000,
//  doi 10.1109/ROBOT.2000.844730
//
// Line numbers are those of assets/planners/rrt-connect.md.
//
// What is settled here:
//  * One iteration is one sample: a tree takes a step towards it, and the other one as many steps towards the new vertex
//    as it can. The trees take turns by the sample's number.
//  * Once they meet, all that grew from the goal hangs on the tree from the start: there is one tree from then on, which is
//    kept as RRT's is when the map changes. Until then both are kept, but for what is cut off; a goal whose tree is
//    gone gets a new one.
#pragma once

#include <cstdint>

#include "core/planners/tree_search.hpp"

namespace replan {

struct RrtConnectSwitches {};

inline PlannerInfo describe(RrtConnectSwitches) {
  PlannerInfo info = describe_tree();
  info.name = "RRT-Connect";
  info.summary =
      "Two random trees, from the start and from the goal, that grow towards each other: soon a path, not a "
      "short one.";
  info.source = "Kuffner & LaValle 2000, doi 10.1109/ROBOT.2000.844730";
  return info;
}

template <Lattice L, Tracer T>
class RrtConnect final : public TreeSearch<L, T> {
 public:
  RrtConnect(const L& lattice, const Settings& settings, T& tracer, RrtConnectSwitches)
      : TreeSearch<L, T>(lattice, settings, tracer) {}

 private:
  using Base = TreeSearch<L, T>;
  using Base::kNone;
  using Base::tr_;
  using Base::tree_;

  void planted() override {
    if (this->has_path() || tree_.full()) return;
    if (tree_.nearest(tree_.goal_place(), TreeSide::goal) == kNone)
      tree_.plant(tree_.goal_place(), TreeSide::goal);
  }

  // Lines 4-12.
  void grow_towards(const Place& sample) override {
    const bool turned = this->counters_.expansions % 2 == 0;
    const TreeSide side = turned ? TreeSide::goal : TreeSide::start,
                   other = turned ? TreeSide::start : TreeSide::goal;
    const std::uint32_t added = extend(side, sample);
    if (added == kNone) return;
    const std::uint32_t met = connect(other, tree_.place(added));
    if (met == kNone) return;
    tr_.line(12);
    if (turned)
      join(met, added);
    else
      join(added, met);
  }

  /// Lines 4-7: a vertex within a step of the tree's nearest one, on the way to a place; kNone if it is in no free way.
  std::uint32_t extend(TreeSide side, const Place& towards) {
    if (tree_.full()) return kNone;
    const auto grown = this->offshoot(towards, side);
    if (!grown) return kNone;
    tr_.line(7);
    return tree_.grow(grown->place, grown->nearest);
  }
  /// The same from the other tree: steps towards a place. The vertex that lies there in the end; kNone if something is in the way.
  /// By value: places that the tree holds move as it grows.
  std::uint32_t connect(TreeSide side, const Place towards) {
    if (const std::uint32_t there = tree_.vertex_at(towards, side); there != kNone) return there;
    for (;;) {
      const std::uint32_t added = extend(side, towards);
      if (added == kNone || tree_.place(added) == towards) return added;
    }
  }
  /// Both lie at one place, `far` in the goal's tree: what hangs on it hangs on `near`.
  void join(std::uint32_t near, std::uint32_t far) {
    tree_.graft(near, far);
    tree_.reach_goal(tree_.vertex_at(tree_.goal_place()));
  }

  [[nodiscard]] Place sample_with_path(std::int64_t number) const override {
    return this->sampler_.anywhere(number);
  }
  [[nodiscard]] bool path_could_gain() const override { return false; }
};

}  // namespace replan
