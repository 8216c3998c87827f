// RRT, RRT* and Informed RRT*: a tree of random places that grows into the free space.
//
//  LaValle S. M., "Rapidly-exploring random trees: a new tool for path planning", Iowa State University, TR 98-11, 1998
//  Karaman S. & Frazzoli E., "Sampling-based algorithms for optimal motion planning", IJRR 30(7), 2011,
//  doi 10.1177/0278364911406761, algorithms 3 and 6
//  Gammell J. D., Srinivasa S. S. & Barfoot T. D., "Informed RRT*", IROS 2014, doi 10.1109/IROS.2014.6942976
//
// Line numbers are those of assets/planners/rrt-star.md.
//
// What is settled here:
//  * One iteration is one sample. Samples are numbered, and what is random about one is drawn from its number and the seed
//    alone: a search that is taken up goes on with the same ones.
//  * Places are whole numbers of 1 / 16384 of a cell, and ways are held against the obstacles' squares (cubes) and the
//    robot's radius in whole numbers (core/lattice/body_way.hpp), the last one to the goal too.
//  * The goal becomes a vertex once the tree is joined to it. Informed samples are drawn from then on.
//  * RRT ends with the first path. RRT* draws all its samples, or ends when so many of them have gained nothing.
//  * The map or the start changes: lines 14-18. What an obstacle cuts off goes, with all that hangs on it; the rest is kept
//    and hung on the new start; and `samples_again` samples are drawn, or as many as at first if the path is
//    lost. Vertices of the path count as near the new start, however far away.  Where nothing of the tree sees the new start, a
//    new one is grown.
//  * Without a path when the samples have run out, none was found: that is no proof that there is none.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/logarithm.hpp"
#include "core/planners/tree_search.hpp"

namespace replan {

struct RrtSwitches {
  bool rewire = false;    ///< RRT*: the cheapest parent in the ball, and others hung on the new vertex
  bool informed = false;  ///< samples from where the path could become shorter
  bool greedy = false;    ///< any vertex that sees the goal is joined to it
};

inline PlannerInfo describe(RrtSwitches switches) {
  PlannerInfo info = describe_tree();
  if (switches.informed) {
    info.name = "Informed RRT*";
    info.summary = "RRT* whose samples, once it has a path, come from where a shorter one could lead.";
    info.source = "Gammell, Srinivasa & Barfoot 2014, doi 10.1109/IROS.2014.6942976";
  } else if (switches.rewire) {
    info.name = "RRT*";
    info.summary =
        "A random tree that hangs its vertices where the way to them is shortest: its path becomes the "
        "shortest one.";
    info.source = "Karaman & Frazzoli 2011, doi 10.1177/0278364911406761";
  } else {
    info.name = "RRT";
    info.summary = "A random tree that grows from the start into the free space until it meets the goal.";
    info.source = "LaValle 1998, TR 98-11, Iowa State University";
  }
  info.informed = switches.informed;
  info.parameters.insert(info.parameters.begin() + 1, parameters::kGoalBias);
  if (!switches.greedy) info.parameters.insert(info.parameters.begin() + 1, parameters::kGoalReach);
  if (switches.rewire)
    info.parameters.insert(info.parameters.end(), {parameters::kBall, parameters::kNoGain});
  return info;
}

template <Lattice L, Tracer T>
class Rrt : public TreeSearch<L, T> {
 public:
  Rrt(const L& lattice, const Settings& settings, T& tracer, RrtSwitches switches)
      : TreeSearch<L, T>(lattice, settings, tracer, settings.get(parameters::kGoalBias)),
        switches_(switches),
        goal_reach_(switches.greedy ? kAnywhere : Base::units(settings.get(parameters::kGoalReach))),
        no_gain_(static_cast<std::int64_t>(settings.get(parameters::kNoGain))),
        shrinking_(settings.get(parameters::kBall) != 0) {}

 protected:
  using Base = TreeSearch<L, T>;
  using Base::D;
  using Base::space_;
  using Base::step_;
  using Base::tr_;
  using Base::tree_;
  using typename Base::Offshoot;

  void grow_towards(const Place& sample) override {
    if (const auto grown = this->offshoot(sample)) add(*grown);
  }

 private:
  static constexpr std::int64_t kAnywhere = std::int64_t{1} << 31;  // units: more than any world is wide

  // Lines 7-12.
  void add(const Offshoot& offshoot) {
    const auto& [place, nearest] = offshoot;
    std::vector<std::uint32_t> near;
    if (switches_.rewire) {
      const std::int64_t reach = ball();
      this->tell_ball(reach);
      near = tree_.within(place, reach);
    }
    const std::uint32_t parent = switches_.rewire ? cheapest_parent(place, nearest, near) : nearest;
    tr_.line(9);
    const std::uint32_t added = tree_.grow(place, parent);
    for (const std::uint32_t v : near)
      if (v != parent) tree_.hang_if_shorter(v, added, 11);
    tree_.join_goal(added, goal_reach_);
    tree_.take_gain();
  }
  // Lines 7 and 8.
  std::uint32_t cheapest_parent(const Place& place, std::uint32_t nearest,
                                const std::vector<std::uint32_t>& near) {
    tr_.line(8);
    std::uint32_t parent = nearest;
    Cost least = tree_.cost_over(nearest, place);
    tell_candidate(nearest, least);
    for (const std::uint32_t v : near) {
      if (v == nearest) continue;
      const Cost sum = tree_.cost_over(v, place);
      const bool better = sum < least && !tree_.hit_from(v, place);
      tell_candidate(v, sum < least && !better ? Cost::infinity() : sum);
      if (!better) continue;
      parent = v;
      least = sum;
    }
    return parent;
  }
  /// Infinite: the way is blocked.
  void tell_candidate(std::uint32_t v, Cost sum) {
    tr_.note(EventKind::candidate, v, static_cast<std::uint64_t>(sum.raw));
  }
  [[nodiscard]] Place sample_with_path(std::int64_t number) const override {
    if (!switches_.informed) return this->sampler_.anywhere(number);
    return this->sampler_.within(InformedSet<D>(tree_.start_place(), tree_.goal_place(), tree_.best()),
                                 number);
  }
  [[nodiscard]] bool path_could_gain() const override {
    return switches_.rewire && (no_gain_ == 0 || this->without_gain() < no_gain_);
  }

  /// Karaman & Frazzoli: gamma (log n / n)^(1/D), where gamma is 2 (1 + 1/D)^(1/D) (volume / that of the unit ball)^(1/D),
  /// which they ask of RRG and which is more than they ask of RRT*; the world's volume for that of its free part.
  [[nodiscard]] std::int64_t ball() const {
    const auto n = static_cast<double>(tree_.alive());
    if (!shrinking_ || n < 2) return step_;
    double volume = 1;
    for (std::size_t i = 0; i < D; ++i) volume *= static_cast<double>(space_.extent(i));
    constexpr double kPi = 3.141592653589793, kUnitBall = D == 2 ? kPi : 4 * kPi / 3;
    const double inside = (1 + 1.0 / D) * volume / kUnitBall * natural_log(n) / n;
    const double radius = 2 * (D == 2 ? std::sqrt(inside) : cube_root(inside));
    return std::min(step_, static_cast<std::int64_t>(radius));
  }
  /// By Newton's method: the C library's differs between machines.
  static double cube_root(double x) {
    double root = std::sqrt(std::sqrt(x)) + 1;
    for (int i = 0; i < 60; ++i) root -= (root - x / (root * root)) / 3;
    return root;
  }

  const RrtSwitches switches_;
  const std::int64_t goal_reach_, no_gain_;
  const bool shrinking_;
};

}  // namespace replan
